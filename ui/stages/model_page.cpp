// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/model_page.h"

#include "ui/plot/model_curves.h"
#include "ui/stages/model_text.h"
#include "ui/stages/tube_mode_choice.h"
#include "ui/stages/value_table.h"
#include "ui/text/quantity_format.h"

#include <QSplitter>

namespace dyncal {

ModelPage::ModelPage(Session &session)
    : StagePage(session,
        {"modelPage", tr("Model"), tr("Judge the model of the chosen order against the data.")},
        {StageId::Model, StageId::Response})
{
    buildPlots();
    buildInspector();
}

void ModelPage::buildPlots()
{
    m_fit = makePlot("modelFitPlot", tr("Data and model"));
    m_error = makePlot("modelErrorPlot", tr("Error of the model"));
    m_magnitude = makePlot("magnitudePlot", tr("Magnitude of the frequency response"));
    m_phase = makePlot("phasePlot", tr("Phase of the frequency response"));
    m_poles = makePlot("polePlot", tr("Poles and zeros"));
    m_table = new ValueTable("poleTable", tr("Poles"), this);

    auto *left = new QSplitter(Qt::Vertical);
    left->addWidget(m_fit);
    left->addWidget(m_error);
    left->addWidget(m_table);
    left->setSizes({1000, 800, 500});
    auto *right = new QSplitter(Qt::Vertical);
    right->addWidget(m_magnitude);
    right->addWidget(m_phase);
    right->addWidget(m_poles);
    auto *split = new QSplitter(Qt::Horizontal, this);
    split->addWidget(left);
    split->addWidget(right);
    split->setSizes({1000, 1000});
    content()->addWidget(split);
}

void ModelPage::buildInspector()
{
    InspectorForm *form = inspector();
    form->addSection(tr("Model"));
    m_order = form->addReadout(tr("Order"), "modelOrder");
    m_score = form->addReadout(tr("FIT"), "modelFit");
    m_perShot = form->addReadout(tr("Per series"), "modelFitPerShot");
    m_listing = form->addReadout(tr("FIT, thesis"), "modelFitListing");
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

void ModelPage::showResults()
{
    const auto &model = results().model;
    const auto &input = results().input;
    const auto &response = results().response;
    const auto &window = results().window;
    const bool drawn = model && input && window;
    m_fit->setContent(drawn ? simulationCurves(*input, *model, *window) : nothingYet());
    m_error->setContent(drawn ? errorCurves(*input, *model, *window) : nothingYet());
    m_tubeModes->set(results());
    m_magnitude->setContent(
        response ? m_tubeModes->with(bodeMagnitudeCurves(*response)) : nothingYet());
    m_phase->setContent(response ? bodePhaseCurves(*response) : nothingYet());
    m_poles->setContent(model ? poleZeroCurves(*model) : nothingYet());
    m_table->setValues(poleHeaders(PoleColumns::All), poleRows(model.get(), PoleColumns::All));

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
    showCharacteristics();
}

void ModelPage::showCharacteristics()
{
    const auto &response = results().response;
    const StepCharacteristics none;
    const StepCharacteristics &c = response ? response->characteristics : none;
    m_rise->setText(shownQuantity(c.riseTime_s, "s", 3));
    m_overshoot->setText(c.overshoot_percent ? shownNumber(*c.overshoot_percent, 3) + " %" : "–");
    m_settling->setText(shownQuantity(c.settlingTime_s, "s", 3));
    m_within5->setText(shownQuantity(c.within5percent_Hz, "Hz", 3));
    m_within10->setText(shownQuantity(c.within10percent_Hz, "Hz", 3));
    m_minus3->setText(shownQuantity(c.minus3dB_Hz, "Hz", 3));
    m_band->setText(response ? tr("%1 to %2")
                                   .arg(shownQuantity(response->fLow_Hz, "Hz", 3),
                                       shownQuantity(response->fHigh_Hz, "Hz", 3))
                             : "–");
}

} // namespace dyncal
