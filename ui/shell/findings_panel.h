// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "ui/session/stage_status.h"

#include <QListWidget>

namespace dyncal {

/// All findings of the job, most severe first: glyph, word, id and sentence. A click (or Enter)
/// goes to the stage; Ctrl+C copies the lines selected, or all.
class FindingsPanel : public QListWidget
{
    Q_OBJECT

public:
    explicit FindingsPanel(QWidget *parent = nullptr);

    void setFindings(const Findings &findings);

signals:
    void stageRequested(dyncal::StageId stage);

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void request(const QListWidgetItem *item);
};

} // namespace dyncal
