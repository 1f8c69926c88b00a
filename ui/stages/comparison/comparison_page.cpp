// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/comparison/comparison_page.h"

#include "ui/plot/curves/comparison_curves.h"
#include "ui/plot/curves/known_curves.h"
#include "ui/stages/comparison/comparison_words.h"
#include "ui/stages/comparison/known_panel.h"
#include "ui/stages/comparison/known_words.h"
#include "ui/stages/comparison/reference_panel.h"
#include "ui/stages/comparison/source_panel.h"
#include "ui/stages/frame/folding_splitter.h"
#include "ui/stages/frame/layout_scale.h"
#include "ui/stages/frame/value_table.h"

#include <QSplitter>

#include <algorithm>

namespace dyncal {

ComparisonPage::ComparisonPage(Session &session, Prompts &prompts)
    : StagePage(session,
        {"comparisonPage", tr("Comparison"),
            tr("A transducer of known sensitivity beside the sensor gives S(f) without the shock; where both ways are known, they check each other.")},
        Page::Comparison)
{
    buildContent();
    buildInspector(prompts);
}

QLabel *ComparisonPage::addSentence(const char *objectName)
{
    auto *label = new QLabel(this);
    label->setObjectName(objectName);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    content()->addWidget(label);
    return label;
}

void ComparisonPage::buildContent()
{
    m_verdict = addSentence("comparisonVerdict");
    m_verdict->setFont(scale::heading(m_verdict->font()));
    m_advice = addSentence("comparisonAdvice");
    m_magnitude = makePlot("comparisonPlot",
        tr("Magnitude against the reference transducer and against the pressure step"));
    m_deviation = makePlot("comparisonDeviationPlot", tr("Both magnitudes less their mean"));
    m_error = makePlot("comparisonErrorPlot", tr("Eₙ of the two over frequency"));
    shareCursors(CursorAxis::Frequency, {m_magnitude, m_deviation, m_error});
    m_table = new ValueTable("comparisonTable", tr("Step and reference transducer"), this);
    m_all = new QSplitter(Qt::Vertical, this);
    auto *values = new FoldingSplitter(this);
    values->addWidget(m_magnitude);
    values->addWidget(m_deviation);
    values->setSizes({1000, 1000});
    m_all->addWidget(values);
    m_all->addWidget(m_error);
    m_knownTable = new ValueTable("knownTable", tr("Values of other calibrations"), this);
    m_all->addWidget(m_table);
    m_all->addWidget(m_knownTable);
    m_all->setSizes({1000, 600, 700, 300});
    content()->addWidget(m_all, 1);
    content()->addStretch(0); // takes the room where there is nothing to show
}

void ComparisonPage::buildInspector(Prompts &prompts)
{
    InspectorForm &form = *inspector();
    form.addSection(tr("Reference transducer"));
    auto *panel = new ReferencePanel(session(), form, this);
    panel->buildUse();
    form.addSection(tr("Its sensitivity"));
    new SourcePanel(session(), prompts, form, referenceSection(), this);
    panel->buildModel();
    panel->buildMounting();
    m_known = new KnownPanel(session(), form, this);
    form.addSection(tr("Amplifier and converter"));
    new SourcePanel(session(), prompts, form, chainSection(), this);
}

void ComparisonPage::showResults()
{
    m_verdict->setText(comparisonVerdict(results()));
    const QString advice = comparisonAdvice(results());
    m_advice->setText(advice);
    m_advice->setVisible(!advice.isEmpty());
    const ComparisonResult *comparison = results().comparison.get();
    showTables(comparison);
    showPlots(comparison && comparison->byTransducer ? comparison : nullptr);
    m_known->suggestUnit();
}

void ComparisonPage::showTables(const ComparisonResult *comparison)
{
    const ShownTable table = comparisonTable(comparison);
    m_table->setValues(table.headers, table.rows);
    const auto &report = results().uncertainty;
    const ShownTable known = knownTable(report ? report->known : std::vector<KnownValue>());
    m_knownTable->setValues(known.headers, known.rows);
    m_knownTable->setVisible(!known.rows.empty());
    m_table->setVisible(!table.rows.empty());
    m_all->setVisible(!table.rows.empty() || !known.rows.empty());
}

void ComparisonPage::showPlots(const ComparisonResult *comparison)
{
    const ResponseResult *response = results().response.get();
    const UncertaintyReport *report = results().uncertainty.get();
    const bool hasKnown = response && report && report->sensitivity
        && std::ranges::any_of(report->known, &KnownValue::isCompared);
    const PlotContent other = hasKnown ? knownMagnitudeCurves(*response, *report) : nothingYet();
    const PlotContent otherDeviation
        = hasKnown ? knownDeviationCurves(*response, *report) : nothingYet();
    m_magnitude->setContent(comparison ? comparedMagnitudeCurves(*comparison) : other);
    m_deviation->setContent(comparison && comparison->againstStep
            ? comparedDeviationCurves(*comparison)
            : otherDeviation);
    m_error->setContent(
        comparison && comparison->againstStep ? normalisedErrorCurves(*comparison) : nothingYet());
    m_error->setVisible(!hasKnown || comparison);
}

} // namespace dyncal
