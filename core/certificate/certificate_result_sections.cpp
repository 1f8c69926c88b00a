// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_result_sections.h"

#include "core/base/constants.h"
#include "core/base/rounding.h"
#include "core/certificate/certificate_budget.h"
#include "core/certificate/certificate_key_section.h"
#include "core/certificate/certificate_monte_carlo.h"
#include "core/certificate/certificate_nuisance.h"
#include "core/certificate/certificate_sensitivity.h"
#include "core/certificate/certificate_templates.h"
#include "core/certificate/certificate_words.h"
#include "core/model_analysis/stated_characteristics.h"
#include "core/uncertainty/stated_poles.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

constexpr double kMostDecibels = 1e4; ///< of a ratio of two doubles

Message riseCell(const WindowedResponse &response)
{
    const StatedValue rise = statedRise(response);
    return rise.value || rise.below ? rise.words : dash();
}

std::vector<Message> shotRow(
    const CalibrationResults &results, const WindowedResponse &response, CalibrationKind kind)
{
    std::vector<Message> row{inNumbers(std::to_string(response.shot)), levelWord(response.level),
        setting(response.sampleRate_Hz, "Hz"),
        inNumbers(roundedText(response.step, kUnknown, response.unit)),
        std::abs(response.snr_dB) < kMostDecibels ? inNumbers(fixedText(response.snr_dB, 1) + " dB")
                                                  : dash()};
    if (kind == CalibrationKind::FreeDecay)
        return row;
    row.push_back(riseCell(response));
    row.push_back(printed(statedOvershoot_percent(response), "%", dash()));
    row.push_back(printed(response.settlingTime_s, "s", dash()));
    if (kind != CalibrationKind::UnknownStep)
        row.push_back(shotSensitivityText(results, response.shot));
    return row;
}

std::vector<CertificateColumn> shotColumns(CalibrationKind kind)
{
    const bool isDecay = kind == CalibrationKind::FreeDecay;
    std::vector<CertificateColumn> columns{{{DYNCAL_TEXT("core", "Shot"), {}}, true},
        {{DYNCAL_TEXT("core", "Level"), {}}, false},
        {{DYNCAL_TEXT("core", "Sample rate"), {}}, true},
        {isDecay ? Message{DYNCAL_TEXT("core", "Largest deflection"), {}}
                 : Message{DYNCAL_TEXT("core", "Output step"), {}},
            true},
        {{DYNCAL_TEXT("core", "Signal to noise"), {}}, true}};
    if (isDecay)
        return columns;
    columns.push_back({{DYNCAL_TEXT("core", "Rise time"), {}}, true});
    columns.push_back({{DYNCAL_TEXT("core", "Overshoot"), {}}, true});
    columns.push_back({{DYNCAL_TEXT("core", "Settling time"), {}}, true});
    if (kind != CalibrationKind::UnknownStep)
        columns.push_back({{DYNCAL_TEXT("core", "Sensitivity"), {}}, true});
    return columns;
}

Message poleWord(PoleClass poleClass)
{
    switch (poleClass) {
    case PoleClass::Sensor:
        return {DYNCAL_TEXT("core", "sensor"), {}};
    case PoleClass::Step:
        return {DYNCAL_TEXT("core", "step"), {}};
    case PoleClass::Nyquist:
        return {DYNCAL_TEXT("core", "Nyquist"), {}};
    case PoleClass::Unstable:
        return {DYNCAL_TEXT("core", "unstable"), {}};
    case PoleClass::Other:
        break;
    }
    return {DYNCAL_TEXT("core", "other"), {}};
}

/// Standard uncertainty of z = exp(s T) from those of |s| and of its angle: |dz| = |z| |ds| T.
double uncertaintyInZ(const Pole &pole)
{
    return std::abs(pole.z) * std::abs(std::log(pole.z))
        * std::hypot(pole.u_frequency_Hz / pole.frequency_Hz, pole.u_dampingRatio);
}

/// Both coordinates to the digits that frequency and damping ratio are known to.
std::string complexText(const Pole &pole)
{
    const double expanded = printedCoverage(pole.coverageFactor) * uncertaintyInZ(pole);
    const bool pair = pole.z.imag() != 0.0;
    return roundedText(pole.z.real(), expanded, "")
        + (pair ? " \xC2\xB1 j" + roundedText(pole.z.imag(), expanded, "") : "");
}

/// A dash where FIT is unknown or the simulation diverges.
std::string fitText(double percent, bool diverges = false)
{
    return diverges || !(std::abs(percent) < kMostPercent) ? english(dash())
                                                           : fixedText(percent, 2);
}

/// Unit of the responses as analysed, which c0 has; "1" where they are remapped.
std::string gainUnit(const CalibrationResults &results)
{
    if (!results.window || results.window->responses.empty())
        return {};
    const WindowedResponse &response = results.window->responses.front();
    return response.valueScale == response.step ? "1" : response.unit;
}

/// `amplitudeUnit`: of the responses as analysed; "" where they are remapped.
std::vector<Message> poleRow(
    const Pole &pole, const PoleUncertainty &with, const std::string &amplitudeUnit)
{
    const double k = printedCoverage(with.kFrequency);
    const double kDamping = printedCoverage(with.kDamping);
    const double kAmplitude = printedCoverage(with.kAmplitude);
    const double u_Hz = printableU(with.u_frequency_Hz, k, with.leastFrequency_Hz);
    const double u_zeta = printableU(with.u_dampingRatio, kDamping, with.leastDamping);
    return {poleWord(pole.poleClass), inNumbers(complexText(pole)),
        valueCell(pole.frequency_Hz, u_Hz, "Hz", k), expandedCell(pole.frequency_Hz, u_Hz, "Hz", k),
        valueCell(pole.dampingRatio, u_zeta, "", kDamping),
        expandedCell(pole.dampingRatio, u_zeta, "", kDamping),
        valueCell(pole.amplitude, with.u_amplitude, amplitudeUnit, kAmplitude),
        expandedCell(pole.amplitude, with.u_amplitude, amplitudeUnit, kAmplitude)};
}

CertificateTable poleTable(const CalibrationResults &results)
{
    CertificateTable table;
    table.id = "poles";
    table.caption = {DYNCAL_TEXT("core", "Poles of the model (a conjugate pair is one line)"), {}};
    table.columns = {{{DYNCAL_TEXT("core", "Class"), {}}, false},
        {{DYNCAL_TEXT("core", "z-plane"), {}}, true},
        {{DYNCAL_TEXT("core", "Undamped frequency"), {}}, true},
        {{DYNCAL_TEXT("core", "U (k = 2)"), {}}, true},
        {{DYNCAL_TEXT("core", "Damping ratio"), {}}, true},
        {{DYNCAL_TEXT("core", "U (k = 2)"), {}}, true},
        {{DYNCAL_TEXT("core", "Amplitude"), {}}, true},
        {{DYNCAL_TEXT("core", "U (k = 2)"), {}}, true}};
    const std::vector<Pole> &poles = polesOf(*results.model, results.assessment.get());
    const std::vector<PoleUncertainty> with
        = statedPoles(*results.model, results.assessment.get(), results.uncertainty.get());
    const std::string unit = gainUnit(results);
    for (std::size_t i = 0; i < poles.size(); ++i)
        if (!(poles[i].z.imag() < 0.0))
            table.rows.push_back(poleRow(poles[i], with[i], unit == "1" ? "" : unit));
    return table;
}

} // namespace

CertificateSection resultsSection(
    const CalibrationResults &results, const Recipe &recipe, const CertificateTemplate &layout)
{
    const CalibrationKind kind = calibrationKind(results, recipe);
    CertificateSection section;
    section.id = "results";
    section.title = {DYNCAL_TEXT("core", "Results in detail"), {}};
    if (kind != CalibrationKind::FreeDecay)
        addSensitivityDetails(results, section);
    if (auto table = monteCarloTable(results, keyQuantities(results, recipe, layout)))
        section.tables.push_back(std::move(*table));
    if (kind != CalibrationKind::FreeDecay && results.uncertainty
        && results.uncertainty->sensitivity)
        if (auto table = budgetTable(*results.uncertainty->sensitivity))
            section.tables.push_back(std::move(*table));
    section.notes.push_back(uncertaintyNote(kind));
    return section;
}

CertificateSection shotsSection(const CalibrationResults &results, const Recipe &recipe)
{
    const CalibrationKind kind = calibrationKind(results, recipe);
    CertificateSection section;
    section.id = "shots";
    section.title = {DYNCAL_TEXT("core", "Shots"), {}};
    if (!results.window || results.window->responses.empty()) {
        section.paragraphs.push_back(
            {DYNCAL_TEXT("core", "No shot could be evaluated; see the remarks."), {}});
        return section;
    }
    CertificateTable table;
    table.id = "shots";
    table.caption = {DYNCAL_TEXT("core", "Measured responses, shot by shot"), {}};
    table.columns = shotColumns(kind);
    for (const WindowedResponse &response : results.window->responses)
        table.rows.push_back(shotRow(results, response, kind));
    section.tables.push_back(std::move(table));
    section.notes.push_back(shotsNote(kind));
    return section;
}

CertificateSection modelSection(const CalibrationResults &results, const Recipe &recipe)
{
    CertificateSection section;
    section.id = "model";
    section.title = {DYNCAL_TEXT("core", "Model of the sensor"), {}};
    if (!results.model) {
        section.paragraphs.push_back(
            {DYNCAL_TEXT("core", "No model could be determined; see the remarks."), {}});
        return section;
    }
    const SensorModel &model = *results.model;
    const bool suggested = recipe.realization.order.isAuto();
    section.fields = {
        {"order", {DYNCAL_TEXT("core", "Order"), {}},
            suggested ? Message{DYNCAL_TEXT("core", "%1 (as suggested from the data)"),
                {std::to_string(model.order)}}
                      : Message{DYNCAL_TEXT("core", "%1 (chosen by the operator)"),
                          {std::to_string(model.order)}},
            false},
        {"fit", {DYNCAL_TEXT("core", "Fit"), {}},
            {DYNCAL_TEXT("core", "%1 %; in this noise the true model would reach %2 % on average"),
                {fitText(model.fit_percent, model.diverges), fitText(model.fitAttainable_percent)}},
            false}};
    if (model.fitListing_percent)
        section.fields.push_back(
            {"fit_listing", {DYNCAL_TEXT("core", "Fit as in the listing (lagged)"), {}},
                inNumbers(fitText(*model.fitListing_percent, model.diverges) + " %"), false});
    if (results.decomposition && suggested)
        section.paragraphs.push_back(results.decomposition->suggestion.reason);
    if (model.diverges)
        section.paragraphs.push_back(
            {DYNCAL_TEXT(
                 "core", "The model has a pole outside the unit circle: its simulation diverges."),
                {}});
    section.tables.push_back(poleTable(results));
    addNuisance(model, results.assessment.get(), gainUnit(results), section);
    if (results.input)
        addLeftOut(*results.input, section);
    return section;
}

} // namespace dyncal
