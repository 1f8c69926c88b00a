// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_method_sections.h"

#include "core/base/constants.h"
#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "core/certificate/certificate_monte_carlo.h"
#include "core/certificate/certificate_reference.h"
#include "core/certificate/certificate_templates.h"
#include "core/certificate/certificate_traceability.h"
#include "core/certificate/certificate_words.h"
#include "core/realization/order/order_spread.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

Message treatmentSentence(ResponseTreatment treatment)
{
    switch (treatment) {
    case ResponseTreatment::StepDeflated:
        return {
            DYNCAL_TEXT("core",
                "Response to a pressure step; the pole of the step is removed before the realisation, so that the model describes the sensor alone."),
            {}};
    case ResponseTreatment::StepAsImpulse:
        return {
            DYNCAL_TEXT("core",
                "Response to a pressure step, realised as if it were an impulse response; the model contains the pole of the step."),
            {}};
    case ResponseTreatment::Differenced:
        return {
            DYNCAL_TEXT("core",
                "First difference of the response to a pressure step, realised as an impulse response."),
            {}};
    case ResponseTreatment::Impulse:
        break;
    }
    return {DYNCAL_TEXT("core", "Free decay, realised as an impulse response."), {}};
}

CertificateField methodField(const Recipe &recipe)
{
    const auto typed = recipe.certificate.fields.find("method_id");
    const bool there = typed != recipe.certificate.fields.end() && !isBlank(typed->second);
    return {"method_id", {DYNCAL_TEXT("core", "Method"), {}},
        there ? verbatim(typed->second) : Message{DYNCAL_TEXT("core", "to be filled in"), {}},
        !there};
}

/// How much the sensor's resonance depends on the choice of the order.
std::optional<Message> orderSpread(const CalibrationResults &results)
{
    const Pole *main = results.model ? mainPole(*results.model, results.assessment.get()) : nullptr;
    if (!main || !results.evidence || results.model->secondOrder) // no order has its poles
        return std::nullopt;
    const auto spread = spreadAround(*results.evidence, results.model->order, main->frequency_Hz);
    if (!spread || spread->fromOrder == spread->toOrder)
        return std::nullopt;
    const auto percent = [](double part, double whole) {
        const double share = 100.0 * part / std::abs(whole);
        return std::isfinite(share) ? "\xC2\xB1" + numberText(share, 2) : english(dash());
    };
    return Message{DYNCAL_TEXT("core",
                       "orders %1 to %2: frequency %3 %, damping ratio %4 % (half of the range)"),
        {std::to_string(spread->fromOrder), std::to_string(spread->toOrder),
            percent(spread->frequencySpread_Hz, spread->frequency_Hz),
            percent(spread->dampingSpread, spread->dampingRatio)}};
}

void addChoiceOfOrder(
    const CalibrationResults &results, const Recipe &recipe, CertificateSection &section)
{
    if (!recipe.realization.adoptedReason.empty()) {
        section.fields.push_back(
            {"order_reason", {DYNCAL_TEXT("core", "Reason for the model order"), {}},
                verbatim(recipe.realization.adoptedReason), false});
    }
    if (const auto spread = orderSpread(results)) {
        section.fields.push_back({"order_spread",
            {DYNCAL_TEXT("core", "Variation of the resonance over the orders"), {}}, *spread,
            false});
    }
}

} // namespace

CertificateSection methodSection(const CalibrationResults &results, const Recipe &recipe)
{
    CertificateSection section;
    section.id = "method";
    section.title = {DYNCAL_TEXT("core", "Method"), {}};
    section.fields.push_back(methodField(recipe));
    for (CertificateField &field : traceabilityFields(results, recipe))
        section.fields.push_back(std::move(field));
    const CalibrationKind kind = calibrationKind(results, recipe);
    section.paragraphs.push_back(measurandSentence(kind, recipe.shock.dutPosition));
    if (results.input)
        section.paragraphs.push_back(treatmentSentence(results.input->treatment));
    for (const Message &sentence : stepSentences(kind))
        section.paragraphs.push_back(sentence);
    if (!results.input)
        return section;
    const ModelInput &input = *results.input;
    section.fields.push_back({"series", {DYNCAL_TEXT("core", "Shots combined"), {}},
        input.combine == CombineMethod::Stacked
            ? Message{DYNCAL_TEXT("core", "stacked, each with its own amplitude (%1 series)"),
                {std::to_string(input.series.size())}}
            : Message{DYNCAL_TEXT(
                          "core", "average of the reconstructions from principal components"),
                {}},
        false});
    section.fields.push_back({"model_rate", {DYNCAL_TEXT("core", "Sample rate of the model"), {}},
        inNumbers(settingText(input.sampleRate_Hz, "Hz")), false});
    section.fields.push_back({"model_samples", {DYNCAL_TEXT("core", "Samples per series"), {}},
        inNumbers(std::to_string(input.samples)), false});
    section.fields.push_back(
        {"model_offset", {DYNCAL_TEXT("core", "Start of the model input after the onset"), {}},
            inNumbers(settingText(input.offset_s, "s")), false});
    addChoiceOfOrder(results, recipe, section);
    for (CertificateField &field : referenceFields(results, recipe))
        section.fields.push_back(std::move(field));
    if (auto field = monteCarloField(results))
        section.fields.push_back(std::move(*field));
    return section;
}

} // namespace dyncal
