// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_result_sections.h"

#include "core/base/constants.h"
#include "core/base/rounding.h"
#include "core/certificate/certificate_nuisance.h"
#include "core/certificate/certificate_sensitivity.h"
#include "core/certificate/certificate_words.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

constexpr double kDegreesPerRadian = 57.295779513082320877;
constexpr double kMostDecibels = 1e4; ///< of a ratio of two doubles

Message noModel()
{
    return {DYNCAL_TEXT("core", "not determined (no model)"), {}};
}

Message notReached()
{
    return {DYNCAL_TEXT("core", "not determined (outside the range of the model)"), {}};
}

/// k = 2, or a larger Student's k where the scatter of few shots decides, so that the interval has
/// 95 % there too; a k other than 2 is printed.
double coverageOf(const Pole &pole)
{
    return pole.coverageFactor > kCoverageFactor ? pole.coverageFactor : kCoverageFactor;
}

void addResonance(const CalibrationResults &results, CertificateSection &section)
{
    const Pole *pole = results.model ? mainPole(*results.model, results.assessment.get()) : nullptr;
    const Message none = results.model
        ? Message{DYNCAL_TEXT("core", "not determined (the model does not oscillate)"), {}}
        : noModel();
    section.fields.push_back(
        {"natural_frequency", {DYNCAL_TEXT("core", "Undamped natural frequency"), {}},
            pole ? printedWithUncertainty(
                pole->frequency_Hz, pole->u_frequency_Hz, "Hz", coverageOf(*pole))
                 : none,
            false});
    section.fields.push_back({"damping_ratio", {DYNCAL_TEXT("core", "Damping ratio"), {}},
        pole ? printedWithUncertainty(
            pole->dampingRatio, pole->u_dampingRatio, "", coverageOf(*pole))
             : none,
        false});
}

void addCharacteristics(const CalibrationResults &results, CertificateSection &section)
{
    const StepCharacteristics none;
    const StepCharacteristics &found = results.response ? results.response->characteristics : none;
    const Message otherwise = results.response ? notReached() : noModel();
    const auto add = [&](const char *id, Message label, const std::optional<double> &value,
                         const char *unit) {
        section.fields.push_back({id, std::move(label), printed(value, unit, otherwise), false});
    };
    add("rise_time", {DYNCAL_TEXT("core", "Rise time, 10 % to 90 %"), {}}, found.riseTime_s, "s");
    add("overshoot", {DYNCAL_TEXT("core", "Overshoot"), {}}, found.overshoot_percent, "%");
    add("settling_time", {DYNCAL_TEXT("core", "Settling time, within 5 %"), {}},
        found.settlingTime_s, "s");
    add("within_5_percent", {DYNCAL_TEXT("core", "Magnitude within 5 % up to"), {}},
        found.within5percent_Hz, "Hz");
    add("within_10_percent", {DYNCAL_TEXT("core", "Magnitude within 10 % up to"), {}},
        found.within10percent_Hz, "Hz");
    add("minus_3_db", {DYNCAL_TEXT("core", "Magnitude above -3 dB up to"), {}}, found.minus3dB_Hz,
        "Hz");
}

std::vector<Message> shotRow(const CalibrationResults &results, const WindowedResponse &response)
{
    return {verbatim(std::to_string(response.shot)), levelWord(response.level),
        verbatim(roundedText(response.sampleRate_Hz, kUnknown, "Hz")),
        verbatim(roundedText(response.step, kUnknown, response.unit)),
        std::abs(response.snr_dB) < kMostDecibels ? verbatim(fixedText(response.snr_dB, 1) + " dB")
                                                  : dash(),
        printed(response.riseTime_s, "s", dash()), printed(response.overshoot_percent, "%", dash()),
        printed(response.settlingTime_s, "s", dash()), shotSensitivityText(results, response.shot)};
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

/// A k other than the column's is printed beside the value.
Message expanded(double value, double u, std::string_view unit, double k = kCoverageFactor)
{
    const RoundedValue rounded = roundedValue(value, k * u, unit);
    if (rounded.u.empty())
        return dash();
    return verbatim(rounded.u + (rounded.unit.empty() ? "" : " " + rounded.unit)
        + (k == kCoverageFactor ? "" : coverageText(k)));
}

Message withRounding(double value, double u, std::string_view unit, double k = kCoverageFactor)
{
    return verbatim(roundedText(value, k * u, unit));
}

/// Six decimals, except for absurdly large coordinates.
std::string coordinateText(double x)
{
    return std::abs(x) < 1e6 ? fixedText(x, 6) : roundedText(x, kUnknown, "");
}

std::string complexText(std::complex<double> z)
{
    const bool pair = z.imag() != 0.0;
    return coordinateText(z.real()) + (pair ? " \xC2\xB1 j" + coordinateText(z.imag()) : "");
}

/// A dash where FIT is unknown or the simulation diverges.
std::string fitText(double percent, bool diverges = false)
{
    return diverges || !(std::abs(percent) < kMostPercent) ? english(dash())
                                                           : fixedText(percent, 2);
}

CertificateTable poleTable(const std::vector<Pole> &poles)
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
        {{DYNCAL_TEXT("core", "Amplitude"), {}}, true}};
    for (const Pole &pole : poles) {
        if (pole.z.imag() < 0.0)
            continue;
        const double k = coverageOf(pole);
        table.rows.push_back({poleWord(pole.poleClass), verbatim(complexText(pole.z)),
            withRounding(pole.frequency_Hz, pole.u_frequency_Hz, "Hz", k),
            expanded(pole.frequency_Hz, pole.u_frequency_Hz, "Hz", k),
            withRounding(pole.dampingRatio, pole.u_dampingRatio, "", k),
            expanded(pole.dampingRatio, pole.u_dampingRatio, "", k),
            verbatim(roundedText(pole.amplitude, kUnknown, ""))});
    }
    return table;
}

double valueAt(const Eigen::VectorXd &values, Index i)
{
    return i < values.size() ? values[i] : kUnknown;
}

Message cell(double value, double u, std::string_view unit)
{
    return std::isfinite(value) ? withRounding(value, u, unit) : dash();
}

std::vector<double> sortedFrequencies(const ResponseResult &response)
{
    std::vector<double> sorted(
        response.frequency_Hz.data(), response.frequency_Hz.data() + response.frequency_Hz.size());
    std::erase_if(sorted, [](double f) { return !std::isfinite(f); });
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

/// Distance to the nearest other frequency if five digits might print both alike; else unknown.
double stepToTell(const std::vector<double> &sorted, double frequency_Hz)
{
    constexpr double kFiveDigits = 1e-4;
    double nearest = kFiveDigits * frequency_Hz;
    const auto [same, above] = std::equal_range(sorted.begin(), sorted.end(), frequency_Hz);
    if (same != sorted.begin())
        nearest = std::min(nearest, frequency_Hz - *(same - 1));
    if (above != sorted.end())
        nearest = std::min(nearest, *above - frequency_Hz);
    return nearest < kFiveDigits * frequency_Hz ? nearest : kUnknown;
}

std::vector<Message> frequencyRow(
    const ResponseResult &response, const std::vector<double> &sorted, Index i)
{
    const std::string unit = response.unit == "1" ? "" : response.unit;
    const double magnitude = valueAt(response.magnitude, i);
    const double uMagnitude = valueAt(response.u_magnitude, i);
    const double phase = kDegreesPerRadian * valueAt(response.phase_rad, i);
    const double uPhase = kDegreesPerRadian * valueAt(response.u_phase_rad, i);
    const double frequency = response.frequency_Hz[i];
    return {cell(frequency, stepToTell(sorted, frequency), "Hz"), cell(magnitude, uMagnitude, unit),
        std::isfinite(magnitude) ? expanded(magnitude, uMagnitude, unit) : dash(),
        cell(phase, uPhase, "\xC2\xB0"),
        std::isfinite(phase) ? expanded(phase, uPhase, "\xC2\xB0") : dash(),
        cell(valueAt(response.modelMagnitude, i), uMagnitude, unit),
        cell(kDegreesPerRadian * valueAt(response.modelPhase_rad, i), uPhase, "\xC2\xB0")};
}

/// Unit of the responses as analysed, which c0 has; "1" where they are remapped.
std::string gainUnit(const CalibrationResults &results)
{
    if (!results.window || results.window->responses.empty())
        return {};
    const WindowedResponse &response = results.window->responses.front();
    return response.valueScale == response.step ? "1" : response.unit;
}

} // namespace

CertificateSection resultsSection(const CalibrationResults &results)
{
    CertificateSection section;
    section.id = "results";
    section.title = {DYNCAL_TEXT("core", "Results"), {}};
    addSensitivity(results, section);
    addResonance(results, section);
    addCharacteristics(results, section);
    section.notes.push_back(
        {DYNCAL_TEXT("core",
             "Uncertainties marked U (k = 2) are expanded uncertainties with the coverage factor k = 2 and contain only what the noise of the recordings contributes, not the uncertainty of the pressure step; that of the sensitivity alone contains both. A complete uncertainty budget was not evaluated; where no uncertainty stands beside a value, none is stated. Rise time, overshoot, settling time and band edges are those of the model."),
            {}});
    return section;
}

CertificateSection shotsSection(const CalibrationResults &results)
{
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
    table.columns
        = {{{DYNCAL_TEXT("core", "Shot"), {}}, true}, {{DYNCAL_TEXT("core", "Level"), {}}, false},
            {{DYNCAL_TEXT("core", "Sample rate"), {}}, true},
            {{DYNCAL_TEXT("core", "Output step"), {}}, true},
            {{DYNCAL_TEXT("core", "Signal to noise"), {}}, true},
            {{DYNCAL_TEXT("core", "Rise time"), {}}, true},
            {{DYNCAL_TEXT("core", "Overshoot"), {}}, true},
            {{DYNCAL_TEXT("core", "Settling time"), {}}, true},
            {{DYNCAL_TEXT("core", "Sensitivity"), {}}, true}};
    for (const WindowedResponse &response : results.window->responses)
        table.rows.push_back(shotRow(results, response));
    section.tables.push_back(std::move(table));
    section.notes.push_back(
        {DYNCAL_TEXT("core",
             "Signal to noise is the output step over the standard deviation of the noise before it. Rise time 10 % to 90 %; settling to within 5 % of the step."),
            {}});
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
            {DYNCAL_TEXT("core", "%1 % of %2 % attainable with this noise"),
                {fitText(model.fit_percent, model.diverges), fitText(model.fitAttainable_percent)}},
            false}};
    if (model.fitListing_percent)
        section.fields.push_back(
            {"fit_listing", {DYNCAL_TEXT("core", "Fit as in the listing (lagged)"), {}},
                verbatim(fitText(*model.fitListing_percent, model.diverges) + " %"), false});
    if (results.decomposition && suggested)
        section.paragraphs.push_back(results.decomposition->suggestion.reason);
    if (model.diverges)
        section.paragraphs.push_back(
            {DYNCAL_TEXT(
                 "core", "The model has a pole outside the unit circle: its simulation diverges."),
                {}});
    section.tables.push_back(poleTable(polesOf(model, results.assessment.get())));
    addNuisance(model, results.assessment.get(), gainUnit(results), section);
    if (results.input)
        addLeftOut(*results.input, section);
    return section;
}

CertificateSection frequencyResponseSection(const CalibrationResults &results)
{
    CertificateSection section;
    section.id = "frequency-response";
    section.title = {DYNCAL_TEXT("core", "Frequency response"), {}};
    if (!results.response || results.response->frequency_Hz.size() == 0) {
        section.paragraphs.push_back(
            {DYNCAL_TEXT("core", "The frequency response could not be determined."), {}});
        return section;
    }
    const ResponseResult &response = *results.response;
    section.fields = {{"f_low", {DYNCAL_TEXT("core", "Lower frequency limit"), {}},
                          verbatim(roundedText(response.fLow_Hz, kUnknown, "Hz")), false},
        {"f_high", {DYNCAL_TEXT("core", "Upper frequency limit"), {}},
            verbatim(roundedText(response.fHigh_Hz, kUnknown, "Hz")), false}};
    CertificateTable table;
    table.id = "frequency-response";
    table.caption = {
        DYNCAL_TEXT("core",
            "Sensitivity over frequency: from the responses without a model, and from the model"),
        {}};
    table.columns = {{{DYNCAL_TEXT("core", "Frequency"), {}}, true},
        {{DYNCAL_TEXT("core", "Magnitude"), {}}, true},
        {{DYNCAL_TEXT("core", "U (k = 2)"), {}}, true}, {{DYNCAL_TEXT("core", "Phase"), {}}, true},
        {{DYNCAL_TEXT("core", "U (k = 2)"), {}}, true},
        {{DYNCAL_TEXT("core", "Model, magnitude"), {}}, true},
        {{DYNCAL_TEXT("core", "Model, phase"), {}}, true}};
    const std::vector<double> sorted = sortedFrequencies(response);
    for (Index i = 0; i < response.frequency_Hz.size(); ++i)
        table.rows.push_back(frequencyRow(response, sorted, i));
    section.tables.push_back(std::move(table));
    section.notes.push_back(
        {DYNCAL_TEXT("core",
             "The lower limit follows from the length of the window, the upper one from the noise. A dash means that the value was not determined."),
            {}});
    if (response.unit == "1")
        section.notes.push_back(
            {DYNCAL_TEXT(
                 "core", "Without a pressure step the magnitude is relative to the output step."),
                {}});
    return section;
}

CertificateSection figuresSection(const CalibrationResults &results)
{
    CertificateSection section;
    section.id = "figures";
    section.title = {DYNCAL_TEXT("core", "Figures"), {}};
    if (results.decomposition)
        section.figures.push_back(
            {"singular-values", {DYNCAL_TEXT("core", "Singular values of the Hankel matrix"), {}}});
    if (results.model) {
        section.figures.push_back({"model-data", {DYNCAL_TEXT("core", "Responses and model"), {}}});
        section.figures.push_back(
            {"model-error", {DYNCAL_TEXT("core", "Responses minus model"), {}}});
    }
    if (results.response) {
        section.figures.push_back(
            {"magnitude", {DYNCAL_TEXT("core", "Frequency response, magnitude"), {}}});
        section.figures.push_back(
            {"phase", {DYNCAL_TEXT("core", "Frequency response, phase"), {}}});
    }
    if (results.window)
        section.figures.push_back(
            {"spectrum", {DYNCAL_TEXT("core", "Power spectra of the responses"), {}}});
    if (results.model)
        section.figures.push_back({"pole-zero",
            {DYNCAL_TEXT("core", "Poles and zeros of the model in the z-plane"), {}}});
    return section;
}

} // namespace dyncal
