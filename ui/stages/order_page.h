// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/stage_page.h"

class QCheckBox;
class QPushButton;

namespace dyncal {

class AutoEdit;
class QuantityEdit;
class ValueTable;

/// Stage 7: how many states the model gets. The cut through the singular values is dragged,
/// clicked, typed or moved by keys, and everything beside it follows.
class OrderPage : public StagePage
{
    Q_OBJECT

public:
    explicit OrderPage(Session &session);

    /// What follows the cut at once; the measured response comes when the hand rests.
    StageId focus() const override { return StageId::Shock; }

protected:
    void showRecipe() override;
    void showResults() override;
    void keyPressEvent(QKeyEvent *event) override;
    /// The order's keys work while a plot has the focus, too.
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void buildPlots();
    void buildInspector();
    bool takeKey(const QKeyEvent &event);
    void setOrder(double order, const QString &mergeKey);
    Index shownOrder() const;
    Index largestOrder() const;
    void showReadouts();
    std::shared_ptr<const ResponseResult> shownResponse() const;

    PlotWidget *m_values;
    PlotWidget *m_bic;
    PlotWidget *m_fit;
    PlotWidget *m_bode;
    PlotWidget *m_poles;
    ValueTable *m_table;
    bool m_dragging = false;

    AutoEdit *m_order;
    QLabel *m_suggestion;
    QPushButton *m_useSuggestion;
    QLabel *m_score;
    QLabel *m_gap;
    QLabel *m_resonance;
    QLabel *m_outside;
    QuantityEdit *m_largest;
    AutoEdit *m_rows;
    QCheckBox *m_refine;
};

} // namespace dyncal
