// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/project/recipe.h"
#include "ui/session/stage_status.h"
#include "ui/shell/findings/finding_corrections.h"

#include <QListWidget>

namespace dyncal {

/// All findings of the job, most severe first: glyph, word, id and sentence. A click (or Enter)
/// goes to the stage; the menu of a caution takes the reason for accepting it; Ctrl+C copies the
/// lines selected, or all. Below a finding that can be corrected by an edit stand its buttons.
class FindingsPanel : public QListWidget
{
    Q_OBJECT

public:
    explicit FindingsPanel(QWidget *parent = nullptr);

    /// `captures`: the recordings on show, which say what corrections there are.
    void setFindings(const Findings &findings, const std::vector<Acknowledgement> &acknowledged,
        const CaptureSet &captures);

signals:
    void stageRequested(dyncal::StageId stage);
    void reasonRequested(const dyncal::Finding &finding); ///< the operator wants to accept it
    void correctionRequested(const dyncal::OfferedCorrection &correction);

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    void request(const QListWidgetItem *item);
    void fill();
    void addButtons(std::size_t shown);
    const Finding *findingAt(int row) const;

    Findings m_shown; ///< the most severe first
    std::vector<std::vector<OfferedCorrection>> m_corrections; ///< of each of them
    QStringList m_words; ///< of the rows: line by line, and labels of their buttons
    std::vector<std::size_t> m_rows; ///< position in m_shown of each row: findings and buttons
};

} // namespace dyncal
