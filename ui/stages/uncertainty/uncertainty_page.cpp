// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/uncertainty/uncertainty_page.h"

#include "ui/plot/curves/uncertainty_curves.h"
#include "ui/stages/frame/layout_scale.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/uncertainty/budget_sentences.h"
#include "ui/stages/uncertainty/budget_table.h"
#include "ui/stages/uncertainty/budget_words.h"
#include "ui/stages/uncertainty/capability_panel.h"
#include "ui/stages/uncertainty/correlation_panel.h"
#include "ui/stages/uncertainty/earlier_panel.h"
#include "ui/stages/uncertainty/share_bar.h"
#include "ui/stages/uncertainty/stated_panel.h"
#include "ui/stages/uncertainty/what_if_panel.h"
#include "ui/text/quantity_format.h"

#include <QComboBox>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTabWidget>

#include <algorithm>

namespace dyncal {

namespace {

constexpr double kPercent = 0.01;
constexpr double kLargestWanted = 10.0; ///< 1000 %: anything
constexpr double kLargestK = 100.0;

void fill(QComboBox &box, const QStringList &texts)
{
    QStringList now;
    for (int i = 0; i < box.count(); ++i)
        now << box.itemText(i);
    if (texts == now)
        return;
    const QSignalBlocker quiet(&box);
    const QString before = box.currentText();
    box.clear();
    box.addItems(texts);
    box.setCurrentIndex(std::max(0, box.findText(before)));
}

} // namespace

UncertaintyPage::UncertaintyPage(Session &session, Prompts &prompts)
    : StagePage(session,
        {"uncertaintyPage", tr("Uncertainty"),
            tr("The budget of every value that is stated, and what would make its uncertainty smaller.")},
        Page::Uncertainty)
{
    buildContent();
    buildChoice();
    m_panel = new WhatIfPanel(session, *inspector(), this);
    buildWanted();
    m_earlier = new EarlierPanel(session, prompts, *inspector(), this);
    new StatedPanel(session, *inspector(), this);
    new CorrelationPanel(session, *inspector(), this);
    new CapabilityPanel(session, *inspector(), this);
    connect(m_panel, &WhatIfPanel::changed, this, &UncertaintyPage::showBudgets);
    connect(m_earlier, &EarlierPanel::changed, this, &UncertaintyPage::showPlot);
    connect(m_lines, &QTableWidget::itemSelectionChanged, this, &UncertaintyPage::chooseInput);
}

void UncertaintyPage::buildContent()
{
    m_result = new QLabel(this);
    m_result->setObjectName("uncertaintyResult");
    m_drawnResult = new QLabel(this);
    m_drawnResult->setObjectName("drawnResult");
    m_whatIf = new QLabel(this);
    m_whatIf->setObjectName("whatIfResult");
    for (QLabel *label : {m_result, m_drawnResult, m_whatIf}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        content()->addWidget(label);
    }
    m_result->setFont(scale::heading(m_result->font()));
    m_tabs = new QTabWidget(this);
    m_tabs->setObjectName("uncertaintyTables");
    m_lines = addTable(tr("Budget"), "budgetTable");
    m_lines->setItemDelegateForColumn(kShareColumn, new ShareBar(m_lines));
    m_all = addTable(tr("All values"), "allUncertainties");
    m_shots = addTable(tr("More shots"), "shotsTable");
    m_plot = makePlot(
        "uncertaintyPlot", tr("Magnitude of the frequency response with its uncertainty"));
    shareCursors(CursorAxis::Frequency, {m_plot});
    auto *split = new QSplitter(Qt::Vertical, this);
    split->addWidget(m_tabs);
    split->addWidget(m_plot);
    split->setSizes({1000, 800});
    content()->addWidget(split, 1);
}

ValueTable *UncertaintyPage::addTable(const QString &title, const QString &objectName)
{
    auto *table = new ValueTable(objectName, title, this);
    m_tabs->addTab(table, title);
    return table;
}

void UncertaintyPage::buildChoice()
{
    m_quantity = inspector()->addChoice(tr("Quantity"), "uncertaintyQuantity", {});
    m_frequency = inspector()->addChoice(tr("Frequency"), "uncertaintyFrequency", {});
    for (QComboBox *box : {m_quantity, m_frequency})
        connect(box, &QComboBox::activated, this, &UncertaintyPage::showChosen);
}

void UncertaintyPage::buildWanted()
{
    const WantedU usual;
    inspector()->addSection(tr("Wanted uncertainty"));
    m_wantedU = inspector()->add(
        tr("U, wanted"), "wantedU", new QuantityEdit({"%", kPercent}, 1e-6, kLargestWanted, 4));
    m_wantedK
        = inspector()->add(tr("k"), "wantedK", new QuantityEdit({{}, 1.0}, 1.0, kLargestK, 2));
    m_wantedU->setSi(usual.relative);
    m_wantedK->setSi(usual.k);
    for (QuantityEdit *edit : {m_wantedU, m_wantedK})
        connect(edit, &QuantityEdit::edited, this, &UncertaintyPage::showChosen);
    m_wantedNote = inspector()->addNote("wantedNote");
    inspector()->addSection(tr("More shots"));
    m_shotsNote = inspector()->addNote("shotsNote");
}

WantedU UncertaintyPage::wanted() const
{
    return {m_wantedU->si(), m_wantedK->si()};
}

void UncertaintyPage::showRecipe()
{
    m_panel->showRecipe();
}

void UncertaintyPage::showResults()
{
    const auto &report = results().uncertainty;
    const auto &response = results().response;
    m_budgets = report && response ? allBudgets(*report, *response) : std::vector<Budget>();
    m_drawn = drawnOf(m_budgets,
        session().isOfThisRun(StageId::ChainMonteCarlo) ? results().chainMonteCarlo.get()
                                                        : nullptr);
    m_panel->keepThoseOf(m_budgets);
    showQuantities();
    showFrequencies();
    showBudgets();
}

void UncertaintyPage::showQuantities()
{
    QStringList names;
    for (const Budget &budget : m_budgets)
        if (names.isEmpty() || names.back() != quantityName(budget))
            names << quantityName(budget);
    fill(*m_quantity, names);
}

void UncertaintyPage::showFrequencies()
{
    QStringList names;
    for (const Budget &budget : m_budgets)
        if (budget.kind == BudgetOf::Magnitude)
            names << shownQuantity(budget.frequency_Hz, QStringLiteral("Hz"), 4);
    fill(*m_frequency, names);
}

void UncertaintyPage::showBudgets()
{
    const TriedChanges &tried = m_panel->tried();
    m_tried = tried.appliedTo(m_budgets);
    const ShownTable all
        = allValues(m_budgets, tried.isEmpty() ? std::vector<Budget>() : m_tried, m_drawn);
    m_all->setValues(all.headers, all.rows);
    showChosen();
}

std::optional<std::size_t> UncertaintyPage::chosen() const
{
    const auto found = std::ranges::find(m_budgets, m_quantity->currentText(), quantityName);
    if (found == m_budgets.end())
        return std::nullopt;
    const auto first = static_cast<std::size_t>(found - m_budgets.begin());
    // All frequencies of a quantity follow each other, in the order of their choice.
    return found->isOverFrequency()
        ? first + static_cast<std::size_t>(std::max(0, m_frequency->currentIndex()))
        : first;
}

void UncertaintyPage::showChosen()
{
    const auto at = chosen();
    m_quantity->setEnabled(at.has_value());
    m_frequency->setEnabled(at && m_budgets[*at].isOverFrequency());
    m_panel->show(at ? &m_budgets[*at] : nullptr);
    m_whatIf->setVisible(at && !m_panel->tried().isEmpty());
    showPlot();
    if (!at) {
        showNothing();
        return;
    }
    m_result->setText(resultSentence(m_budgets[*at]));
    m_drawnResult->setText(drawnSentence(m_drawn[*at], m_budgets[*at]));
    m_whatIf->setText(tr("What if: %1").arg(resultSentence(m_tried[*at])));
    showLines(m_tried[*at]);
}

void UncertaintyPage::showLines(const Budget &budget)
{
    const auto way
        = budget.kind == BudgetOf::Phase ? std::nullopt : wayToU(budget.reported, wanted());
    const ShownTable lines = budgetLines(budget, m_panel->tried(), way);
    const QSignalBlocker quiet(m_lines);
    m_lines->setValues(lines.headers, lines.rows);
    const auto order = byContribution(budget.reported.lines);
    for (std::size_t row = 0; row < order.size(); ++row)
        m_lines->item(static_cast<int>(row), kShareColumn)
            ->setData(ShareBar::kShareRole,
                kPercent * budget.reported.sharePercent(budget.reported.lines[order[row]]));
    const ShownTable shots = shotsTable(budget);
    m_shots->setValues(shots.headers, shots.rows);
    m_wantedNote->setText(wantedSentence(budget, wanted(), way));
    m_shotsNote->setText(shotsSentence(budget));
}

/// Also where no value is stated: the model's response remains.
void UncertaintyPage::showPlot()
{
    const auto &response = results().response;
    const auto at = chosen();
    const bool isMarked = at && m_budgets[*at].isOverFrequency();
    if (!response) {
        m_plot->setContent(nothingYet());
        return;
    }
    PlotContent content = expandedMagnitudeCurves(*response, m_budgets,
        m_panel->tried().isEmpty() ? std::vector<Budget>() : m_tried,
        isMarked ? std::optional(m_budgets[*at].frequency_Hz) : std::nullopt);
    m_earlier->compareWith(rowsOf(m_budgets), response->unit);
    if (const auto &earlier = m_earlier->earlier(); earlier && earlier->unit == response->unit)
        layOver(*earlier, m_earlier->name(), content);
    m_plot->setContent(content);
}

void UncertaintyPage::showNothing()
{
    for (QLabel *label : {m_result, m_drawnResult, m_wantedNote, m_shotsNote})
        label->clear();
    m_lines->setValues({tr("Input")}, {});
    m_shots->setValues({tr("Shots")}, {});
}

/// A row that is selected is the input that is tried.
void UncertaintyPage::chooseInput()
{
    const auto at = chosen();
    const int row = m_lines->currentRow();
    if (!at || row < 0)
        return;
    const auto &lines = m_tried[*at].reported.lines;
    const auto order = byContribution(lines);
    if (row < static_cast<int>(order.size()))
        m_panel->choose(lines[order[static_cast<std::size_t>(row)]].quantity);
}

} // namespace dyncal
