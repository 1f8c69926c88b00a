// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_method_sections.h"

#include "core/base/constants.h"
#include "core/base/number_text.h"
#include "core/base/rounding.h"
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

/// Range of one recorded environmental quantity over the included shots.
Message environmentRange(
    const CalibrationResults &results, double Environment::*quantity, std::string_view unit)
{
    std::optional<double> lowest;
    std::optional<double> highest;
    if (results.captures)
        for (const Shot &shot : results.captures->set.shots) {
            const double value = shot.environment.*quantity;
            if (!shot.included || !std::isfinite(value))
                continue;
            lowest = std::min(lowest.value_or(value), value);
            highest = std::max(highest.value_or(value), value);
        }
    if (!lowest)
        return {DYNCAL_TEXT("core", "not determined (not recorded)"), {}};
    const std::string low = roundedText(*lowest, kUnknown, unit);
    const std::string high = roundedText(*highest, kUnknown, unit);
    return verbatim(low == high ? low : low + " \xE2\x80\xA6 " + high);
}

ShotLevel levelOf(const CalibrationResults &results, Index shot)
{
    const auto position = static_cast<std::size_t>(shot - 1);
    if (!results.captures || shot < 1 || position >= results.captures->set.shots.size())
        return ShotLevel::None;
    return results.captures->set.shots[position].level;
}

/// The step, its U and the coverage factor k of U.
struct StepCells
{
    Message step;
    Message expanded{DYNCAL_TEXT("core", "not determined"), {}};
    Message k = dash();
};

std::optional<double> stepUncertainty_Pa(const ShockConditions &shot)
{
    const bool computed = shot.uncertainty && shot.step_Pa && !shot.stepTyped;
    return computed ? shot.uncertainty->u(StepResult::Step) : std::nullopt;
}

StepCells stepCells(const ShockConditions &shot, double coverage)
{
    StepCells cells{printed(shot.step_Pa, "Pa", {DYNCAL_TEXT("core", "not determined"), {}})};
    const auto u_Pa = stepUncertainty_Pa(shot);
    if (!u_Pa)
        return cells;
    const double k = coverageFactor(
        shot.uncertainty->budget.dof[static_cast<Index>(StepResult::Step)], coverage);
    const RoundedValue rounded = roundedValue(*shot.step_Pa, k * *u_Pa, "Pa");
    if (rounded.u.empty()) // u is zero or not known
        return cells;
    cells.step = verbatim(rounded.value + " " + rounded.unit);
    cells.expanded = verbatim(rounded.u + " " + rounded.unit);
    cells.k = verbatim(factorText(k));
    return cells;
}

std::vector<Message> conditionsRow(
    const CalibrationResults &results, const ShockConditions &shot, double coverage)
{
    const StepCells cells = stepCells(shot, coverage);
    const bool known = shot.states.has_value();
    const auto ofStates = [&](auto pick) {
        return known ? std::optional<double>(pick(*shot.states)) : std::nullopt;
    };
    return {verbatim(std::to_string(shot.shot)), levelWord(levelOf(results, shot.shot)),
        printed(ofStates([](const ShockStates &s) { return s.driven.pressure_Pa; }), "Pa", dash()),
        printed(ofStates([](const ShockStates &s) { return s.driven.temperature_K; }), "K", dash()),
        printed(ofStates([](const ShockStates &s) { return s.velocity_m_s; }), "m/s", dash()),
        printed(ofStates([](const ShockStates &s) { return s.mach; }), "", dash()), cells.step,
        shot.step_Pa ? (shot.stepTyped ? Message{DYNCAL_TEXT("core", "stated"), {}}
                                       : Message{DYNCAL_TEXT("core", "computed"), {}})
                     : dash(),
        cells.expanded, cells.k, printed(shot.plateau_s, "s", dash())};
}

/// How much the sensor's resonance depends on the choice of the order.
std::optional<Message> orderSpread(const CalibrationResults &results)
{
    const Pole *main = results.model ? mainPole(*results.model, results.assessment.get()) : nullptr;
    if (!main || !results.evidence)
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
    section.paragraphs.push_back(
        {DYNCAL_TEXT("core",
             "The sensitivity S(f) is the complex ratio of the item's output to the change of pressure at the sensor's face in the end-wall plane of a shock tube; phase of output over input, lag negative, relative to the sensor's own onset."),
            {}});
    if (!results.input)
        return section;
    const ModelInput &input = *results.input;
    section.paragraphs.push_back(treatmentSentence(input.treatment));
    section.fields.push_back({"series", {DYNCAL_TEXT("core", "Shots combined"), {}},
        input.combine == CombineMethod::Stacked
            ? Message{DYNCAL_TEXT("core", "stacked, each with its own amplitude (%1 series)"),
                {std::to_string(input.series.size())}}
            : Message{DYNCAL_TEXT(
                          "core", "average of the reconstructions from principal components"),
                {}},
        false});
    section.fields.push_back({"model_rate", {DYNCAL_TEXT("core", "Sample rate of the model"), {}},
        verbatim(roundedText(input.sampleRate_Hz, kUnknown, "Hz")), false});
    section.fields.push_back({"model_samples", {DYNCAL_TEXT("core", "Samples per series"), {}},
        verbatim(std::to_string(input.samples)), false});
    section.fields.push_back(
        {"model_offset", {DYNCAL_TEXT("core", "Start of the model input after the onset"), {}},
            verbatim(roundedText(input.offset_s, kUnknown, "s")), false});
    addChoiceOfOrder(results, recipe, section);
    return section;
}

CertificateSection conditionsSection(const CalibrationResults &results, const Recipe &recipe)
{
    CertificateSection section;
    section.id = "conditions";
    section.title = {DYNCAL_TEXT("core", "Conditions"), {}};
    section.fields = {{"ambient_temperature", {DYNCAL_TEXT("core", "Ambient temperature"), {}},
                          environmentRange(results, &Environment::ambientT_K, "K"), false},
        {"ambient_pressure", {DYNCAL_TEXT("core", "Ambient pressure"), {}},
            environmentRange(results, &Environment::ambientPressure_Pa, "Pa"), false},
        {"relative_humidity", {DYNCAL_TEXT("core", "Relative humidity (ratio)"), {}},
            environmentRange(results, &Environment::relativeHumidity, ""), false}};
    CertificateTable table;
    table.id = "shock";
    table.caption = {DYNCAL_TEXT("core", "Pressure steps"), {}};
    table.columns
        = {{{DYNCAL_TEXT("core", "Shot"), {}}, true}, {{DYNCAL_TEXT("core", "Level"), {}}, false},
            {{DYNCAL_TEXT("core", "Initial pressure"), {}}, true},
            {{DYNCAL_TEXT("core", "Initial temperature"), {}}, true},
            {{DYNCAL_TEXT("core", "Shock velocity"), {}}, true},
            {{DYNCAL_TEXT("core", "Mach number"), {}}, true},
            {{DYNCAL_TEXT("core", "Pressure step"), {}}, true},
            {{DYNCAL_TEXT("core", "Step is"), {}}, false},
            {{DYNCAL_TEXT("core", "U of the step"), {}}, true},
            {{DYNCAL_TEXT("core", "k"), {}}, true}, {{DYNCAL_TEXT("core", "Plateau"), {}}, true}};
    bool stepMissing = !results.shock || results.shock->shots.empty();
    bool stepUncertain = false;
    if (results.shock)
        for (const ShockConditions &shot : results.shock->shots) {
            table.rows.push_back(conditionsRow(results, shot, recipe.uncertainty.coverage));
            stepMissing = stepMissing || !shot.step_Pa;
            stepUncertain = stepUncertain || stepUncertainty_Pa(shot);
        }
    if (!table.rows.empty())
        section.tables.push_back(std::move(table));
    if (stepUncertain)
        section.notes.push_back(
            {DYNCAL_TEXT("core",
                 "U of the step is its expanded uncertainty with the coverage factor k of the same line, for a coverage probability of %1 %. It follows from the uncertainties of the shock velocity, the initial pressure and temperature and the gas, and holds for an ideal shock tube. It is contained in the uncertainty of the sensitivity, not in those of the frequency response."),
                {numberText(100.0 * recipe.uncertainty.coverage, 4)}});
    if (stepMissing)
        section.notes.push_back(
            {DYNCAL_TEXT("core",
                 "The pressure step is not determined for every shot: neither a step nor a shock velocity with initial pressure and temperature was given. A sensitivity in the unit of pressure cannot be stated for those shots."),
                {}});
    return section;
}

} // namespace dyncal
