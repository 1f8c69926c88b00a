// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/uncertainty/budgets.h"
#include "core/uncertainty/wanted_u.h"
#include "ui/stages/frame/stage_page.h"
#include "ui/stages/uncertainty/drawn_words.h"

class QComboBox;
class QTabWidget;

namespace dyncal {

class EarlierPanel;
class Prompts;
class QuantityEdit;
class ValueTable;
class WhatIfPanel;

/// Stage 10: the budget of every value that is stated, and what would make its uncertainty smaller.
class UncertaintyPage : public StagePage
{
    Q_OBJECT

public:
    UncertaintyPage(Session &session, Prompts &prompts);

protected:
    void showRecipe() override;
    void showResults() override;

private:
    void buildContent();
    ValueTable *addTable(const QString &title, const QString &objectName);
    void buildChoice();
    void buildWanted();
    void showBudgets(); ///< as computed, and as tried
    void showQuantities();
    void showFrequencies();
    void showChosen();
    void showLines(const Budget &budget);
    void showPlot();
    void showNothing();
    void chooseInput();
    WantedU wanted() const;
    /// Position of the value on show in m_budgets; none without results.
    std::optional<std::size_t> chosen() const;

    std::vector<Budget> m_budgets;
    std::vector<DrawnBudget> m_drawn; ///< by Monte Carlo, of each of m_budgets
    std::vector<Budget> m_tried; ///< the same with other u; as long as m_budgets
    QLabel *m_result;
    QLabel *m_drawnResult;
    QLabel *m_whatIf;
    QTabWidget *m_tabs;
    ValueTable *m_lines;
    ValueTable *m_all;
    ValueTable *m_shots;
    PlotWidget *m_plot;
    QComboBox *m_quantity;
    QComboBox *m_frequency;
    WhatIfPanel *m_panel;
    EarlierPanel *m_earlier;
    QuantityEdit *m_wantedU;
    QuantityEdit *m_wantedK;
    QLabel *m_wantedNote;
    QLabel *m_shotsNote;
};

} // namespace dyncal
