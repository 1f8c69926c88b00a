// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/model/model_page.h"

#include "core/model_analysis/stated_characteristics.h"
#include "ui/plot/curves/model_curves.h"
#include "ui/plot/curves/model_residual_curves.h"
#include "ui/session/order_candidates.h"
#include "ui/stages/candidates/candidate_rows.h"
#include "ui/stages/frame/folding_splitter.h"
#include "ui/stages/frame/tube_mode_choice.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/model/model_text.h"
#include "ui/text/core_text.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QSplitter>
#include <QTabWidget>

namespace dyncal {

ModelPage::ModelPage(Session &session)
    : StagePage(session,
        {"modelPage", tr("Model"), tr("Judge the model of the chosen order against the data.")},
        Page::Model)
{
    buildPlots();
    buildInspector();
    connect(&this->session().candidates(), &OrderCandidates::changed, this, [this] {
        if (isVisible())
            showResults();
    });
}

void ModelPage::buildPlots()
{
    m_fit = makePlot("modelFitPlot", tr("Data and model"));
    m_error = makePlot("modelErrorPlot", tr("Error of the model"));
    m_residual = makePlot("modelResidualPlot", tr("Residual autocorrelation"), StageId::Assessment);
    m_magnitude
        = makePlot("magnitudePlot", tr("Magnitude of the frequency response"), StageId::Response);
    m_phase = makePlot("phasePlot", tr("Phase of the frequency response"), StageId::Response);
    m_poles = makePlot("polePlot", tr("Poles and zeros"));
    auto *left = new QSplitter(Qt::Vertical);
    for (QWidget *widget : {m_fit, m_error, m_residual})
        left->addWidget(widget);
    left->setSizes({1000, 800, 800});
    auto *right = new QSplitter(Qt::Vertical);
    for (QWidget *widget : std::initializer_list<QWidget *>{m_magnitude, m_phase, buildTables()})
        right->addWidget(widget);
    right->setSizes({900, 700, 1000});
    auto *split = new FoldingSplitter(this);
    split->addWidget(left);
    split->addWidget(right);
    split->setSizes({1000, 1000});
    content()->addWidget(split);
    shareCursors(CursorAxis::Frequency, {m_magnitude, m_phase});
    shareCursors(CursorAxis::ResponseTime, {m_fit, m_error});
}

QTabWidget *ModelPage::buildTables()
{
    m_table = new ValueTable("poleTable", tr("Poles"), this);
    m_trend
        = new ValueTable("trendTable", tr("Resonance and plateau of each shot and level"), this);
    m_secondOrder = new ValueTable("secondOrderTable", tr("Second-order sensor"), this);
    m_nuisance = new ValueTable("nuisanceTable", tr("Modes taken out of the model"), this);
    m_tabs = new QTabWidget(this);
    m_tabs->setObjectName("modelTabs");
    m_tabs->setAccessibleName(tr("Poles, trend and other tables"));
    m_tabs->setDocumentMode(true);
    m_tabs->addTab(m_poles, tr("Pole map"));
    m_tabs->addTab(m_table, tr("Poles"));
    m_tabs->addTab(m_trend, tr("Shots, levels"));
    m_tabs->addTab(m_secondOrder, tr("2nd order"));
    m_tabs->addTab(m_nuisance, tr("Not the sensor"));
    return m_tabs;
}

void ModelPage::buildInspector()
{
    InspectorForm *form = inspector();
    form->addSection(tr("Shown"));
    m_series = form->addChoice(tr("Series"), "modelSeries", {tr("all")});
    connect(m_series, &QComboBox::activated, this, &ModelPage::showTime);
    m_candidates = new WrappedCheckBox(tr("Draw the pinned orders"));
    m_candidates->setObjectName("drawCandidates");
    m_candidates->setChecked(true);
    m_drawSecondOrder = new WrappedCheckBox(tr("Draw the 2nd-order sensor"));
    m_drawSecondOrder->setObjectName("drawSecondOrder");
    for (QCheckBox *box : {m_candidates, m_drawSecondOrder}) {
        form->addWide(box);
        connect(box, &QCheckBox::toggled, this, &ModelPage::showResults);
    }
    form->addSection(tr("Model"));
    m_order = form->addReadout(tr("Order"), "modelOrder");
    m_score = form->addReadout(tr("FIT"), "modelFit");
    m_perShot = form->addReadout(tr("Per series"), "modelFitPerShot");
    m_listing = form->addReadout(tr("FIT, thesis"), "modelFitListing");
    m_uncertainty = form->addReadout(tr("Noise in u"), "modelUncertainty");
    m_shared = form->addNote("modelHomogeneity");
    m_second = form->addReadout(tr("2nd order"), "modelSecondOrder");
    form->addSection(tr("Characteristics"));
    m_rise = form->addReadout(tr("Rise 10–90 %"), "modelRise");
    m_overshoot = form->addReadout(tr("Overshoot"), "modelOvershoot");
    m_settling = form->addReadout(tr("Settling ±5 %"), "modelSettling");
    m_within5 = form->addReadout(tr("Flat ±5 % to"), "modelWithin5");
    m_within10 = form->addReadout(tr("Flat ±10 % to"), "modelWithin10");
    m_minus3 = form->addReadout(tr("−3 dB at"), "modelMinus3");
    m_band = form->addReadout(tr("Usable band"), "usableBand");
    m_tubeModes = new TubeModeChoice(*form, this, false);
    connect(m_tubeModes, &TubeModeChoice::changed, this, &ModelPage::showResults);
}

std::optional<std::size_t> ModelPage::series() const
{
    if (m_series->currentIndex() <= 0)
        return std::nullopt;
    return static_cast<std::size_t>(m_series->currentIndex() - 1);
}

void ModelPage::showResults()
{
    showSeries();
    showTime();
    showResponse();
    showTables();
    showReadouts();
    showCharacteristics();
}

void ModelPage::showSeries()
{
    QStringList names{tr("all")};
    if (results().input)
        for (const ModelSeries &series : results().input->series)
            names << (series.shot > 0 ? tr("Shot %1").arg(series.shot) : tr("Average"));
    QStringList now;
    for (int i = 0; i < m_series->count(); ++i)
        now << m_series->itemText(i);
    if (names == now)
        return;
    m_series->clear();
    m_series->addItems(names);
}

void ModelPage::showTime()
{
    const auto &model = results().model;
    const auto &input = results().input;
    const auto &window = results().window;
    if (!model || !input || !window) {
        for (PlotWidget *plot : {m_fit, m_error, m_residual})
            plot->setContent(nothingYet());
        return;
    }
    const auto candidates
        = m_candidates->isChecked() ? overlaidModels(session()) : std::vector<OverlaidModel>();
    PlotContent fit = simulationCurves(*input, *model, *window, series());
    overlaySimulations(fit, *input, candidates, series());
    m_fit->setContent(fit);
    PlotContent error = errorCurves(*input, *model, *window, series());
    overlayErrors(error, *input, candidates, series());
    m_error->setContent(error);
    m_residual->setContent(modelResidualCurves(*input, *model, *window, recipe().pca, series()));
}

void ModelPage::showResponse()
{
    const auto &model = results().model;
    const auto response = session().isShowable(StageId::Response) ? results().response : nullptr;
    const auto candidates
        = m_candidates->isChecked() ? overlaidModels(session()) : std::vector<OverlaidModel>();
    PlotContent magnitude = response ? bodeMagnitudeCurves(*response) : nothingYet();
    PlotContent phase = response ? bodePhaseCurves(*response) : nothingYet();
    if (response) {
        overlayMagnitudes(magnitude, candidates);
        overlayPhases(phase, candidates);
        const auto &assessment = results().assessment;
        if (model && assessment && assessment->secondOrder && m_drawSecondOrder->isChecked())
            addSecondOrder(magnitude, *model, *assessment->secondOrder, *response);
    }
    m_tubeModes->set(results());
    m_magnitude->setContent(response ? m_tubeModes->with(magnitude) : magnitude);
    m_phase->setContent(phase);
    PlotContent poles = model ? poleZeroCurves(*model) : nothingYet();
    if (model)
        overlayPoles(poles, candidates);
    m_poles->setContent(poles);
}

void ModelPage::showTables()
{
    const SensorModel *model = results().model.get();
    const ModelAssessment *assessment = results().assessment.get();
    const UncertaintyReport *report = results().uncertainty.get();
    m_table->setValues(poleHeaders(),
        model ? poleRows(polesOf(*model, assessment), statedPoles(*model, assessment, report))
              : QVector<QStringList>());
    const auto show = [](ValueTable *target, const ShownTable &table) {
        target->setValues(table.headers, table.rows);
    };
    show(m_nuisance, nuisanceTable(model, assessment));
    m_tabs->setTabVisible(m_tabs->indexOf(m_nuisance), model && !model->nuisance.empty());
    // Until the assessment is there, the tables of an earlier one stay, greyed.
    const bool isPending = model && !assessment;
    m_trend->setEnabled(!isPending);
    m_secondOrder->setEnabled(!isPending);
    if (isPending)
        return;
    show(m_trend, trendTable(assessment));
    show(m_secondOrder, secondOrderTable(assessment));
    m_tabs->setTabVisible(m_tabs->indexOf(m_secondOrder), assessment && assessment->secondOrder);
}

void ModelPage::showReadouts()
{
    const auto &model = results().model;
    m_order->setText(model ? QString::number(model->order) : "–");
    m_score->setText(model ? fitText(*model) : "–");
    QStringList perShot;
    if (model && !model->diverges)
        for (const SeriesFit &fit : model->series)
            perShot << (fit.shot > 0 ? tr("Shot %1").arg(fit.shot) : tr("Average")) + ": "
                    + shownNumber(fit.fit_percent, 3) + " %";
    m_perShot->setText(perShot.isEmpty() ? "–" : perShot.join("\n"));
    m_listing->setText(model && model->fitListing_percent
            ? tr("%1 % (one sample late)").arg(shownNumber(*model->fitListing_percent, 3))
            : "–");
    m_uncertainty->setText(model && !model->uncertaintyMethod.empty() ? noiseText(*model) : "–");
    showAssessment();
}

void ModelPage::showAssessment()
{
    const auto &assessment = results().assessment;
    const bool isPending = results().model && !assessment;
    m_shared->setText(
        isPending ? tr(
            "Uncertainties of the poles, comparison of the shots and second-order sensor: not yet.")
            : assessment ? homogeneityText(*assessment)
                         : QString());
    const SecondOrderModel *fit
        = assessment && assessment->secondOrder ? &*assessment->secondOrder : nullptr;
    m_drawSecondOrder->setEnabled(fit != nullptr);
    m_second->setText(fit ? tr("%1, ζ %2, FIT %3 %%4")
                                .arg(shownResult(fit->f0_Hz, fit->u_f0_Hz, "Hz").value,
                                    shownResult(fit->zeta, fit->u_zeta, {}).value,
                                    shownNumber(fit->fit_percent, 3),
                                    fit->describes ? QString() : tr(": does not describe the data"))
            : isPending ? tr("not yet")
                        : "–");
}

void ModelPage::showCharacteristics()
{
    const auto &response = results().response;
    const StatedCharacteristics found
        = response ? statedCharacteristics(*response) : StatedCharacteristics();
    const auto show = [&](QLabel *label, const StatedValue &value, const char *of) {
        const UncertaintyReport *report = results().uncertainty.get();
        const ReportedValue *reported = report ? report->find(of) : nullptr;
        const bool known = value.value && reported && reported->u;
        label->setText(!response ? "–"
                : known ? shownWithStandardU(*value.value, *reported->u, shownText(reported->unit))
                        : translated(value.words));
    };
    show(m_rise, found.riseTime_s, "rise_time_s");
    show(m_overshoot, found.overshoot_percent, "overshoot_percent");
    show(m_settling, found.settlingTime_s, "settling_time_s");
    show(m_within5, found.within5percent_Hz, "within_5_percent_hz");
    show(m_within10, found.within10percent_Hz, "within_10_percent_hz");
    show(m_minus3, found.minus3dB_Hz, "minus_3_db_hz");
    m_band->setText(response ? tr("%1 to %2")
                                   .arg(shownQuantity(response->fLow_Hz, "Hz", 3),
                                       shownQuantity(response->fHigh_Hz, "Hz", 3))
                             : "–");
}

} // namespace dyncal
