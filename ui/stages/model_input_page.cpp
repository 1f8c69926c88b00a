// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/model_input_page.h"

#include "ui/plot/curves/realization_curves.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/text/quantity_format.h"

#include <QComboBox>

#include <cmath>

namespace dyncal {

namespace {

/// Samples per period of the resonance (workbench rule): comfortable from 10, impossible up to 2.
constexpr double kComfortable = 10.0;
constexpr double kSparse = 4.0;
constexpr double kAlias = 2.0;

Auto<double> asDouble(const Auto<Index> &setting)
{
    return setting.value ? Auto<double>(static_cast<double>(*setting.value)) : Auto<double>();
}

} // namespace

ModelInputPage::ModelInputPage(Session &session)
    : StagePage(session,
        {"modelInputPage", tr("Model input"),
            tr("Choose the rate, the stretch and how the step is treated.")},
        Page::ModelInput)
    , m_plot(makePlot("modelInputPlot", tr("What the identification gets")))
{
    shareCursors(CursorAxis::ResponseTime, {m_plot});
    content()->addWidget(m_plot);
    buildInspector();
}

void ModelInputPage::buildInspector()
{
    InspectorForm *form = inspector();
    form->addSection(tr("Treatment"));
    m_treatment = form->addChoice(tr("Response is"), "treatment",
        {tr("a step, its pole deflated"), tr("a step, fed as impulse (thesis)"),
            tr("a step, differenced"), tr("an impulse response")});
    connect(m_treatment, &QComboBox::activated, this, [this](int choice) {
        change(tr("Change the treatment"),
            [&](Recipe &r) { r.input.treatment = static_cast<ResponseTreatment>(choice); });
    });
    m_combine = form->addChoice(tr("Shots are"), "combine",
        {tr("combined by default rule"), tr("stacked"), tr("averaged after PCA")});
    connect(m_combine, &QComboBox::activated, this, [this](int choice) {
        change(tr("Change how shots are combined"), [&](Recipe &r) {
            r.input.combine = choice == 0 ? std::nullopt
                                          : std::optional(static_cast<CombineMethod>(choice - 1));
        });
    });

    form->addSection(tr("Sampling"));
    m_rate = form->add(tr("Rate"), "modelRate", new AutoEdit({"kHz", 1e3}, 1e-3, 1e12, 6));
    connect(m_rate, &AutoEdit::edited, this, [this](const Auto<double> &rate_Hz) {
        change(tr("Change the model rate"), [&](Recipe &r) { r.input.sampleRate_Hz = rate_Hz; });
    });
    m_perPeriod = form->addReadout(tr("Per period"), "samplesPerPeriod");
    m_samples = form->add(tr("Samples"), "modelSamples", new AutoEdit({}, 20, 1e7, 0));
    connect(m_samples, &AutoEdit::edited, this, [this](const Auto<double> &samples) {
        change(tr("Change the number of samples"), [&](Recipe &r) {
            r.input.samples
                = samples.value ? Auto<Index>(std::lround(*samples.value)) : Auto<Index>();
        });
    });
    m_offset = form->add(tr("Offset"), "modelOffset", new AutoEdit({"µs", 1e-6}, 0.0, 10.0, 6));
    connect(m_offset, &AutoEdit::edited, this, [this](const Auto<double> &offset_s) {
        change(tr("Change the offset"), [&](Recipe &r) { r.input.offset_s = offset_s; });
    });
    m_length = form->addReadout(tr("Stretch"), "modelStretch");
    m_lost = form->addReadout(tr("Lost before"), "lostResponse");
}

void ModelInputPage::showRecipe()
{
    const InputSettings &settings = recipe().input;
    const auto &input = results().input;
    m_treatment->setCurrentIndex(static_cast<int>(settings.treatment));
    m_combine->setCurrentIndex(settings.combine ? 1 + static_cast<int>(*settings.combine) : 0);
    m_rate->set(settings.sampleRate_Hz, input ? std::optional(input->sampleRate_Hz) : std::nullopt);
    m_samples->set(asDouble(settings.samples),
        input ? std::optional(static_cast<double>(input->samples)) : std::nullopt);
    m_offset->set(settings.offset_s, input ? std::optional(input->offset_s) : std::nullopt);
}

void ModelInputPage::showResults()
{
    const auto &input = results().input;
    m_plot->setContent(
        input && results().window ? modelInputCurves(*input, *results().window) : nothingYet());
    showSamplesPerPeriod();
    m_length->setText(input && input->sampleRate_Hz > 0.0
            ? shownQuantity(static_cast<double>(input->samples) / input->sampleRate_Hz, "s", 4)
            : "–");
    m_lost->setText(input && input->lostResponse_percent
            ? tr("%1 % of the ringing").arg(shownNumber(*input->lostResponse_percent, 3))
            : "–");
}

/// Shape, word and number; the colour only repeats what the word says.
void ModelInputPage::showSamplesPerPeriod()
{
    const auto &input = results().input;
    if (!input || !input->samplesPerPeriod) {
        m_perPeriod->setText(tr("– (no resonance)"));
        return;
    }
    const double count = *input->samplesPerPeriod;
    QString judgement = tr("● comfortable");
    if (count <= kAlias)
        judgement = tr("■ too few: the resonance is aliased");
    else if (count < kSparse)
        judgement = tr("▲ sparse: damping is uncertain");
    else if (count < kComfortable)
        judgement = tr("▲ enough, more is better");
    m_perPeriod->setText(shownNumber(count, 3) + "  " + judgement);
}

} // namespace dyncal
