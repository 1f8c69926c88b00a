// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/project/recipe.h"
#include "ui/session/stage_status.h"

#include <QListWidget>

namespace dyncal {

/// All findings of the job, most severe first: glyph, word, id and sentence. A click (or Enter)
/// goes to the stage; the menu of a caution takes the reason for accepting it; Ctrl+C copies the
/// lines selected, or all.
class FindingsPanel : public QListWidget
{
    Q_OBJECT

public:
    explicit FindingsPanel(QWidget *parent = nullptr);

    void setFindings(const Findings &findings, const std::vector<Acknowledgement> &acknowledged);

signals:
    void stageRequested(dyncal::StageId stage);
    void reasonRequested(const dyncal::Finding &finding); ///< the operator wants to accept it

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    void request(const QListWidgetItem *item);
    Findings m_shown; ///< one per row
};

} // namespace dyncal
