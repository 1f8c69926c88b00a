// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/frame/stage_page.h"

class QCheckBox;
class QPushButton;

namespace dyncal {

class CandidateCards;
class CandidateTable;
class OrderInspector;

/// Stage 7: how many states the model gets. The cut through the singular values is dragged,
/// clicked, typed or moved by keys, and everything beside it follows; orders are pinned as cards,
/// compared, and one is adopted with a reason.
class OrderPage : public StagePage
{
    Q_OBJECT

public:
    explicit OrderPage(Session &session);

    /// What follows the cut at once; the measured response comes at the next pause.
    StageId focus() const override { return StageId::Shock; }

protected:
    void showRecipe() override;
    void showResults() override;
    void keyPressEvent(QKeyEvent *event) override;
    /// The order's keys work while a plot has the focus, too.
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void buildPlots();
    QWidget *buildCandidates();
    void connectPlots();
    bool takeKey(const QKeyEvent &event);
    void stepToWholePairs(Index by);
    void setOrder(double order, const QString &mergeKey);
    void adopt(const QString &reason);
    void togglePin(Index order);
    void setRemark(Index order, const QString &remark);
    void pinDefaults();
    void setCandidates(std::vector<Index> orders, const QString &label);
    Index shownOrder() const;
    Index largestOrder() const;
    Index modelOrder() const; ///< of the model on show, which all its views and numbers are of
    void showCut();
    void showEvidence();
    void showModel();
    void showCandidates();

    PlotWidget *m_values;
    PlotWidget *m_strip;
    PlotWidget *m_evidence;
    PlotWidget *m_fit;
    PlotWidget *m_bode;
    PlotWidget *m_poles;
    CandidateCards *m_cards;
    CandidateTable *m_table;
    QPushButton *m_pin;
    QPushButton *m_defaults;
    QPushButton *m_compare;
    QCheckBox *m_difference;
    OrderInspector *m_controls;
    std::optional<double> m_endForCut; ///< of the singular values' view, widened to show the cut
    RealizationSettings m_shownSettings; ///< without the order
    std::optional<Index> m_adopted; ///< the last order adopted, also while another is looked at
};

} // namespace dyncal
