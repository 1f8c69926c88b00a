// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/candidates/candidate_text.h"

#include <QFrame>
#include <QScrollArea>

class QCheckBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace dyncal {

/// One pinned order as a card: chosen by its heading, taken out by its cross, laid over the plots
/// by its box, which shows the style it is drawn in.
class CandidateCard : public QFrame
{
    Q_OBJECT

public:
    explicit CandidateCard(QWidget *parent);

    void set(const CandidateRow &row, bool mayOverlay);
    Index order() const { return m_order; }

signals:
    void chosen(dyncal::Index order);
    void unpinned(dyncal::Index order);
    void overlayToggled(dyncal::Index order, bool on);
    void remarked(dyncal::Index order, const QString &remark);

private:
    Index m_order = 0;
    QLineEdit *m_remark;
    QToolButton *m_heading;
    QToolButton *m_unpin;
    QCheckBox *m_overlay;
    QLabel *m_text;
};

/// The cards in a row. Cards are kept when their contents change, so that the focus stays.
class CandidateCards : public QScrollArea
{
    Q_OBJECT

public:
    explicit CandidateCards(QWidget *parent = nullptr);

    void setRows(const std::vector<CandidateRow> &rows);

signals:
    void chosen(dyncal::Index order);
    void unpinned(dyncal::Index order);
    void overlayToggled(dyncal::Index order, bool on);
    void remarked(dyncal::Index order, const QString &remark);

private:
    QWidget *m_row;
    QLabel *m_hint; ///< while there are no cards
    std::vector<CandidateCard *> m_cards;
};

} // namespace dyncal
