// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_frequency_section.h"

#include "core/base/constants.h"
#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "core/certificate/certificate_reference.h"
#include "core/certificate/certificate_words.h"
#include "core/pipeline/calibration_kind.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kDegreesPerRadian = 57.295779513082320877;
constexpr double kRoundingOfLimit = 1e-9; ///< the last row lies on the limit

double valueAt(const Eigen::VectorXd &values, Index i)
{
    return i < values.size() ? values[i] : kUnknown;
}

Message cell(double value, double u, std::string_view unit, double k = kCoverageFactor)
{
    return std::isfinite(value) ? valueCell(value, u, unit, k) : dash();
}

/// A value of the model, to the digits of the wider of its uncertainty and that of the measured
/// value beside it; three where its own is not known, or fewer where the measured one asks for
/// fewer.
Message modelCell(double value, double u, double uMeasured, std::string_view unit)
{
    if (std::isfinite(u))
        return cell(value, std::isfinite(uMeasured) ? std::max(u, uMeasured) : u, unit);
    const double U = kCoverageFactor * uMeasured;
    const bool isCoarse
        = value != 0.0 && U >= std::pow(10.0, std::floor(std::log10(std::abs(value))) - 1.0);
    return cell(value, isCoarse ? uMeasured : kUnknown, unit);
}

/// Positions of the rows inside the band of the response.
std::vector<Index> rowsInBand(const ResponseResult &response)
{
    const double low_Hz = (1.0 - kRoundingOfLimit) * response.fLow_Hz;
    const double high_Hz = (1.0 + kRoundingOfLimit) * response.fHigh_Hz;
    std::vector<Index> rows;
    for (Index i = 0; i < response.frequency_Hz.size(); ++i)
        if (const double f_Hz = response.frequency_Hz[i]; !(f_Hz < low_Hz) && !(f_Hz > high_Hz))
            rows.push_back(i);
    return rows;
}

std::vector<double> sortedFrequencies(const ResponseResult &response)
{
    std::vector<double> sorted(
        response.frequency_Hz.data(), response.frequency_Hz.data() + response.frequency_Hz.size());
    std::erase_if(sorted, [](double f) { return !std::isfinite(f); });
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

/// A frequency is a setting: a typed one keeps up to six digits, others (10^(k/10) Hz) have four,
/// and more where four might print neighbours alike.
std::string frequencyText(const std::vector<double> &sorted, double frequency_Hz)
{
    constexpr int kDigitsOfTyped = 6;
    constexpr double kFourDigits = 1e-3;
    if (std::abs(parseNumber(numberText(frequency_Hz, kDigitsOfTyped)).value_or(0.0) - frequency_Hz)
        <= kRoundingOfLimit * std::abs(frequency_Hz))
        return settingText(frequency_Hz, "Hz", kDigitsOfTyped);
    double nearest = kFourDigits * frequency_Hz;
    const auto [same, above] = std::equal_range(sorted.begin(), sorted.end(), frequency_Hz);
    if (same != sorted.begin())
        nearest = std::min(nearest, frequency_Hz - *(same - 1));
    if (above != sorted.end())
        nearest = std::min(nearest, *above - frequency_Hz);
    return nearest < kFourDigits * frequency_Hz ? roundedText(frequency_Hz, nearest, "Hz")
                                                : settingText(frequency_Hz, "Hz");
}

std::vector<Message> frequencyRow(const ResponseResult &response, const RowUncertainty &rows,
    const std::vector<double> &sorted, Index i)
{
    const std::string unit = response.unit == "1" ? "" : response.unit;
    const double magnitude = valueAt(response.magnitude, i);
    const double uMagnitude = valueAt(rows.u_magnitude, i);
    const double phase = kDegreesPerRadian * valueAt(response.phase_rad, i);
    const double uPhase = kDegreesPerRadian * valueAt(rows.u_phase_rad, i);
    const double f_Hz = response.frequency_Hz[i];
    const bool isModelled = !(f_Hz > (1.0 + kRoundingOfLimit) * response.modelLimit_Hz);
    const double k = printedCoverage(valueAt(rows.k_magnitude, i));
    const double kPhase = printedCoverage(valueAt(rows.k_phase, i));
    return {verbatim(frequencyText(sorted, f_Hz)), cell(magnitude, uMagnitude, unit, k),
        std::isfinite(magnitude) ? expandedCell(magnitude, uMagnitude, unit, k) : dash(),
        cell(phase, uPhase, "\xC2\xB0", kPhase),
        std::isfinite(phase) ? expandedCell(phase, uPhase, "\xC2\xB0", kPhase) : dash(),
        isModelled ? modelCell(valueAt(response.modelMagnitude, i),
            valueAt(rows.u_modelMagnitude, i), uMagnitude, unit)
                   : dash(),
        isModelled ? modelCell(kDegreesPerRadian * valueAt(response.modelPhase_rad, i),
            kDegreesPerRadian * valueAt(rows.u_modelPhase_rad, i), uPhase, "\xC2\xB0")
                   : dash()};
}

CertificateTable frequencyTable(const ResponseResult &response, const RowUncertainty &uncertainty,
    const std::vector<Index> &rows)
{
    CertificateTable table;
    table.id = "frequency-response";
    table.caption = response.unit == "1"
        ? Message{DYNCAL_TEXT("core",
                      "Normalised response over frequency: from the responses without a model, and from the model"),
            {}}
        : Message{
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
    for (const Index i : rows)
        table.rows.push_back(frequencyRow(response, uncertainty, sorted, i));
    return table;
}

void addNotes(const ResponseResult &response, std::size_t rows, CertificateSection &section)
{
    section.notes.push_back(
        {DYNCAL_TEXT("core",
             "The lower limit follows from the length of the window, the upper one from the noise and the sample rate. Frequencies are settings, without an uncertainty. The model's values have the digits of the wider of their uncertainty and the measured value's; they end at half the sample rate of the model. A dash means that the value, or its complete uncertainty, was not determined."),
            {}});
    if (response.isByTransducer)
        section.notes.push_back(
            {DYNCAL_TEXT("core",
                 "The values without a model are ratios of the item's record to that of the reference transducer, times its sensitivity; outside the frequencies of its calibration there are none. Where what sampling or the end of the records may change exceeds both the uncertainty of the noise and 2 % of the magnitude, none is stated."),
                {}});
    else
        section.notes.push_back(
            {DYNCAL_TEXT("core",
                 "The values without a model take nothing from it but the zero of time and, where there are any, the drift and what was taken out of the records. Where what sampling or the end of the records may change exceeds both the uncertainty of the noise and 2 % of the magnitude, none is stated; for the sampling it is assumed that above half the sample rate the response is nowhere stronger than just below."),
                {}});
    if (response.front.duration_s > 0.0 && !response.isByTransducer)
        section.notes.push_back(
            {DYNCAL_TEXT("core",
                 "The pressure rises over %1 at the sensor, standard uncertainty %2. The values without a model are divided by what an even rise takes off, and its uncertainty is part of theirs; the model is that behind it."),
                {numberWithUnit(response.front.duration_s, "s", 3),
                    numberWithUnit(response.front.u_s, "s", 2)}});
    if (const auto asked = static_cast<std::size_t>(response.frequency_Hz.size()); rows < asked)
        section.notes.push_back(
            {DYNCAL_TEXT("core",
                 "Of the %1 frequencies asked for, %2 lie outside these limits and have no line."),
                {std::to_string(asked), std::to_string(asked - rows)}});
    if (response.unit == "1")
        section.notes.push_back(
            {DYNCAL_TEXT(
                 "core", "The magnitude is relative to the level at the onset of the step."),
                {}});
}

} // namespace

CertificateSection frequencyResponseSection(const CalibrationResults &results, const Recipe &recipe)
{
    CertificateSection section;
    section.id = "frequency-response";
    section.title = {DYNCAL_TEXT("core", "Frequency response"), {}};
    if (calibrationKind(results, recipe) == CalibrationKind::FreeDecay) {
        section.paragraphs.push_back(
            {DYNCAL_TEXT("core",
                 "A free decay has no frequency response: what excited the item was not measured."),
                {}});
        return section;
    }
    if (!results.response || results.response->frequency_Hz.size() == 0) {
        section.paragraphs.push_back(
            {DYNCAL_TEXT("core", "The frequency response could not be determined."), {}});
        return section;
    }
    const ResponseResult &response = *results.response;
    section.fields = {{"f_low", {DYNCAL_TEXT("core", "Lower frequency limit"), {}},
                          setting(response.fLow_Hz, "Hz"), false},
        {"f_high", {DYNCAL_TEXT("core", "Upper frequency limit"), {}},
            setting(response.fHigh_Hz, "Hz"), false}};
    const std::vector<Index> rows = rowsInBand(response);
    if (!rows.empty())
        section.tables.push_back(frequencyTable(
            response, results.uncertainty ? results.uncertainty->rows : RowUncertainty(), rows));
    addNotes(response, rows.size(), section);
    if (const auto sentence = comparisonSentence(results))
        section.notes.push_back(*sentence);
    return section;
}

} // namespace dyncal
