// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/components_page.h"

#include "ui/plot/curves/component_curves.h"
#include "ui/plot/curves/signal_curves.h"
#include "ui/plot/widget/overview_strip.h"
#include "ui/stages/frame/folding_splitter.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/frame/tube_mode_choice.h"
#include "ui/stages/frame/value_table.h"
#include "ui/text/quantity_format.h"

#include <QCheckBox>
#include <QComboBox>
#include <QSplitter>

#include <array>
#include <cmath>

namespace dyncal {

namespace {

constexpr std::array kConfidences{0.90, 0.95, 0.99, 0.999};

/// Below this the exact value no longer matters.
constexpr double kSmallestShown = 0.001;

QString probabilityText(double p)
{
    return p < kSmallestShown ? "< " + shownNumber(kSmallestShown, 1) : shownNumber(p, 2);
}

/// Never "100 %" where the plot beside it shows what is left.
QString shareText(double percent)
{
    constexpr double kMost = 99.999;
    constexpr int kDigits = 5;
    return percent > kMost && percent < 100.0
        ? QStringLiteral("> ") + shownNumber(kMost, kDigits) + QStringLiteral(" %")
        : shownNumber(percent, kDigits) + QStringLiteral(" %");
}

} // namespace

ComponentsPage::ComponentsPage(Session &session)
    : StagePage(session,
        {"componentsPage", tr("PCA"), tr("Separate what the shots share from what they do not.")},
        Page::Components)
{
    buildPlots();
    buildInspector();
}

void ComponentsPage::buildPlots()
{
    m_explained = makePlot("explainedPlot", tr("Left by the first components"));
    m_reconstruction = makePlot("reconstructionPlot", tr("Reconstruction of the shots"));
    m_residual = makePlot("residualPlot", tr("Residuals"));
    m_autocovariance = makePlot("autocovariancePlot", tr("Autocovariance of the residuals"));
    m_spectrum = makePlot("residualSpectrumPlot", tr("Spectrum of the residuals"));
    shareCursors(CursorAxis::ResponseTime, {m_reconstruction, m_residual});
    shareCursors(CursorAxis::Frequency, {m_spectrum});
    m_table = new ValueTable("residualTable", tr("Residuals of every shot"), this);

    auto *left = new QSplitter(Qt::Vertical);
    left->addWidget(m_explained);
    left->addWidget(m_autocovariance);
    left->addWidget(m_table);
    left->setSizes({1000, 1000, 600});
    auto *right = new QSplitter(Qt::Vertical);
    auto *overview = new OverviewStrip(this);
    overview->setObjectName("componentsOverview");
    right->addWidget(overview);
    right->addWidget(m_reconstruction);
    right->addWidget(m_residual);
    right->addWidget(m_spectrum);
    auto *split = new FoldingSplitter(this);
    split->addWidget(left);
    split->addWidget(right);
    overview->follow(m_reconstruction);
    overview->follow(m_residual);
    split->setSizes({800, 1200});
    content()->addWidget(split);
}

void ComponentsPage::buildInspector()
{
    InspectorForm *form = inspector();
    form->addSection(tr("Components"));
    auto *kept = form->add(tr("Kept"), "componentsKept", new QuantityEdit({}, 1, 99, 0));
    form->follow([kept](const Recipe &r) { kept->setSi(static_cast<double>(r.pca.components)); });
    connect(kept, &QuantityEdit::edited, this, [this](double count) {
        change(tr("Keep %1 components").arg(count),
            [&](Recipe &r) { r.pca.components = std::lround(count); });
    });
    auto *centre = new WrappedCheckBox(tr("Take away the mean over the shots first"));
    centre->setObjectName("centre");
    form->addWide(centre);
    form->follow([centre](const Recipe &r) { centre->setChecked(r.pca.centre); });
    connect(centre, &QCheckBox::clicked, this,
        [this](bool on) { change(tr("Centre the shots"), [&](Recipe &r) { r.pca.centre = on; }); });
    m_first = form->addReadout(tr("First explains"), "firstExplains");

    form->addSection(tr("Residuals"));
    auto *lags = form->add(tr("Lags"), "residualLags", new QuantityEdit({}, 1, 100000, 0));
    form->follow([lags](const Recipe &r) { lags->setSi(static_cast<double>(r.pca.residualLags)); });
    connect(lags, &QuantityEdit::edited, this, [this](double count) {
        change(tr("Change the lags"), [&](Recipe &r) { r.pca.residualLags = std::lround(count); });
    });
    QStringList choices;
    for (const double confidence : kConfidences)
        choices << shownNumber(100.0 * confidence, 4) + " %";
    m_confidence = form->addChoice(tr("Confidence"), "residualConfidence", choices);
    connect(m_confidence, &QComboBox::activated, this, [this](int choice) {
        change(tr("Change the confidence"), [&](Recipe &r) {
            r.pca.residualConfidence = kConfidences[static_cast<std::size_t>(choice)];
        });
    });
    m_tubeModes = new TubeModeChoice(*form, this);
    connect(m_tubeModes, &TubeModeChoice::changed, this, &ComponentsPage::showResults);
}

void ComponentsPage::showRecipe()
{
    int choice = -1; // a recipe may hold another value
    for (std::size_t i = 0; i < kConfidences.size(); ++i)
        if (std::abs(kConfidences[i] - recipe().pca.residualConfidence) < 1e-9)
            choice = static_cast<int>(i);
    m_confidence->setCurrentIndex(choice);
}

void ComponentsPage::showOfShots()
{
    const auto components = results().components;
    const auto window = results().window;
    const auto show
        = [&](PlotWidget *plot, auto curves, std::function<PlotContent(PlotContent)> finish = {}) {
              if (components && window)
                  draw(plot,
                      {{components, window}, components->responses.size(),
                          [=] { return curves(*components, *window); }, std::move(finish)});
              else
                  clear(plot);
          };
    const auto onRinging = [window](PlotContent content) {
        content.xMin = 0.0; // the whole plateau is in the strip above
        content.xMax = ringingEnd_s(*window);
        return content;
    };
    show(m_reconstruction, reconstructionCurves, onRinging);
    show(m_residual, residualCurves, onRinging);
    show(m_autocovariance, [](const ComponentResult &result, const WindowResult &responses) {
        return autocovarianceCurves(result, responses);
    });
    show(m_spectrum, residualSpectrumCurves,
        [this](const PlotContent &made) { return m_tubeModes->with(made); });
}

void ComponentsPage::showResults()
{
    const auto &components = results().components;
    m_explained->setContent(components ? remainderCurves(*components) : nothingYet());
    m_tubeModes->set(results());
    showOfShots();

    QVector<QStringList> rows;
    for (std::size_t i = 0; components && i < components->residuals.size(); ++i) {
        const ResidualAnalysis &residual = components->residuals[i];
        rows.push_back({i < components->shots.size() ? QString::number(components->shots[i]) : "–",
            shownNumber(residual.rms, 3), shownNumber(100.0 * residual.outsideFraction, 3) + " %",
            probabilityText(residual.whiteness_p),
            residual.peaks_Hz.empty() ? "–" : shownQuantity(residual.peaks_Hz.front(), "Hz", 4)});
    }
    m_table->setValues(
        {tr("Shot"), tr("RMS"), tr("Lags outside"), tr("White, p"), tr("Top peak")}, rows);
    const bool several = components && components->principal
        && components->principal->explainedCumulative_percent.size() > 0;
    m_first->setText(several ? shareText(components->principal->explainedCumulative_percent[0])
                             : tr("– (one shot)"));
}

} // namespace dyncal
