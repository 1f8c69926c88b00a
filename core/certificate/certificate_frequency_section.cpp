// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_frequency_section.h"

#include "core/base/constants.h"
#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "core/certificate/certificate_known_values.h"
#include "core/certificate/certificate_reference.h"
#include "core/certificate/certificate_words.h"
#include "core/pipeline/calibration_kind.h"
#include "core/uncertainty/capability.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dyncal {
namespace {

constexpr double kDegreesPerRadian = 57.295779513082320877;
constexpr double kRoundingOfLimit = 1e-9; ///< the last row lies on the limit

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
    if (response.atMarks)
        sorted.insert(sorted.end(), response.atMarks->frequency_Hz.begin(),
            response.atMarks->frequency_Hz.end());
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

/// A line of the table: a row of the response, or of that at the marked frequencies.
struct FrequencyLine
{
    const ResponseResult *response;
    const RowUncertainty *uncertainty;
    Index row;
    std::vector<RowMark> marks = {};

    double frequency_Hz() const { return response->frequency_Hz[row]; }
};

bool isAt(const FrequencyLine &line, double f_Hz)
{
    return std::abs(line.frequency_Hz() - f_Hz) <= kRoundingOfLimit * f_Hz;
}

/// A line of its own before the first above it; where its frequency was asked for, that line has
/// the mark.
void addMarked(const FrequencyLine &marked, std::vector<FrequencyLine> &lines)
{
    const double f_Hz = marked.frequency_Hz();
    const auto same
        = std::ranges::find_if(lines, [f_Hz](const auto &line) { return isAt(line, f_Hz); });
    if (same != lines.end()) {
        same->marks.push_back(marked.marks.front());
        return;
    }
    const auto above = std::ranges::find_if(
        lines, [f_Hz](const auto &line) { return line.frequency_Hz() > f_Hz; });
    lines.insert(above, marked);
}

/// The rows asked for in their order, and the marked ones between them.
std::vector<FrequencyLine> linesOf(const ResponseResult &response, const UncertaintyReport &report)
{
    std::vector<FrequencyLine> lines;
    for (const Index row : rowsInBand(response))
        lines.push_back({&response, &report.rows, row});
    if (const ResponseResult *marked = response.atMarks.get())
        for (Index i = 0; i < marked->frequency_Hz.size(); ++i)
            addMarked(
                {marked, &report.rowsAtMarks, i, {marked->marks[static_cast<std::size_t>(i)]}},
                lines);
    return lines;
}

/// The words of a mark, with a place for its frequency.
const char *markWords(RowMark mark)
{
    switch (mark) {
    case RowMark::LowEnd:
        return DYNCAL_TEXT("core", "lower limit %L1");
    case RowMark::Within5percent:
        return DYNCAL_TEXT("core", "edge 5 %: %L1");
    case RowMark::Within10percent:
        return DYNCAL_TEXT("core", "edge 10 %: %L1");
    case RowMark::Minus3dB:
        return DYNCAL_TEXT("core", "edge -3 dB: %L1");
    case RowMark::Resonance:
        return DYNCAL_TEXT("core", "resonance %L1");
    case RowMark::Known:
        return DYNCAL_TEXT("core", "compared at %L1");
    case RowMark::HighEnd:
        break;
    }
    return DYNCAL_TEXT("core", "upper limit %L1");
}

/// The name in the report of the result that a marked frequency is; null of the band's ends.
const char *reportedName(RowMark mark)
{
    switch (mark) {
    case RowMark::Within5percent:
        return "within_5_percent_hz";
    case RowMark::Within10percent:
        return "within_10_percent_hz";
    case RowMark::Minus3dB:
        return "minus_3_db_hz";
    case RowMark::Resonance:
        return "resonance_hz";
    case RowMark::LowEnd:
    case RowMark::HighEnd:
    case RowMark::Known:
        break;
    }
    return nullptr;
}

/// As the key results print it, where it is one of them.
std::string markedText(
    RowMark mark, const UncertaintyReport &report, const std::vector<double> &sorted, double f_Hz)
{
    const char *name = reportedName(mark);
    const ReportedValue *reported = name ? report.find(name) : nullptr;
    return reported && reported->u ? roundedText(f_Hz, *reported->expanded(), "Hz")
                                   : frequencyText(sorted, f_Hz);
}

Message frequencyCell(
    const FrequencyLine &line, const UncertaintyReport &report, const std::vector<double> &sorted)
{
    if (line.marks.empty())
        return inNumbers(frequencyText(sorted, line.frequency_Hz()));
    std::vector<Message> names;
    for (const RowMark mark : line.marks)
        names.push_back({markWords(mark), {markedText(mark, report, sorted, line.frequency_Hz())}});
    Message first = names.front();
    first.below.assign(names.begin() + 1, names.end());
    return first;
}

std::vector<Message> frequencyRow(const FrequencyLine &line, Message frequency)
{
    const ResponseResult &response = *line.response;
    const RowUncertainty &rows = *line.uncertainty;
    const Index i = line.row;
    const std::string unit = response.unit == "1" ? "" : response.unit;
    const double magnitude = valueAt(response.magnitude, i);
    const double uMagnitude = valueAt(rows.u_magnitude, i);
    const double least = magnitude * valueAt(rows.leastExpanded_relative, i);
    const double leastPhase = kDegreesPerRadian * valueAt(rows.leastExpandedPhase_rad, i);
    const double phase = kDegreesPerRadian * valueAt(response.phase_rad, i);
    const double uPhase = kDegreesPerRadian * valueAt(rows.u_phase_rad, i);
    const bool isModelled
        = !(line.frequency_Hz() > (1.0 + kRoundingOfLimit) * response.modelLimit_Hz);
    const double k = printedCoverage(valueAt(rows.k_magnitude, i));
    const double kPhase = printedCoverage(valueAt(rows.k_phase, i));
    const double uPrinted = printableU(uMagnitude, k, least);
    const double uPhasePrinted = printableU(uPhase, kPhase, leastPhase);
    return {std::move(frequency), cell(magnitude, uPrinted, unit, k),
        std::isfinite(magnitude) ? expandedCell(magnitude, uPrinted, unit, k) : dash(),
        cell(phase, uPhasePrinted, "\xC2\xB0", kPhase),
        std::isfinite(phase) ? expandedCell(phase, uPhasePrinted, "\xC2\xB0", kPhase) : dash(),
        isModelled ? modelCell(valueAt(response.modelMagnitude, i),
            valueAt(rows.u_modelMagnitude, i), uMagnitude, unit)
                   : dash(),
        isModelled ? modelCell(kDegreesPerRadian * valueAt(response.modelPhase_rad, i),
            kDegreesPerRadian * valueAt(rows.u_modelPhase_rad, i), uPhase, "\xC2\xB0")
                   : dash()};
}

std::vector<CertificateColumn> frequencyColumns()
{
    return {{{DYNCAL_TEXT("core", "Frequency"), {}}, true},
        {{DYNCAL_TEXT("core", "Magnitude"), {}}, true},
        {{DYNCAL_TEXT("core", "U (k = 2)"), {}}, true}, {{DYNCAL_TEXT("core", "Phase"), {}}, true},
        {{DYNCAL_TEXT("core", "U (k = 2)"), {}}, true},
        {{DYNCAL_TEXT("core", "Model, magnitude"), {}}, true},
        {{DYNCAL_TEXT("core", "Model, phase"), {}}, true}};
}

/// Values of other calibrations that are joined, each before the first line above it.
void addJoined(const UncertaintyReport &report, const std::vector<FrequencyLine> &lines,
    CertificateTable &table)
{
    std::size_t before = 0;
    for (JoinedLine &joined : joinedLines(report)) {
        const auto above = std::ranges::find_if(lines,
            [&](const FrequencyLine &line) { return line.frequency_Hz() > joined.frequency_Hz; });
        const auto place = static_cast<std::ptrdiff_t>(before++) + (above - lines.begin());
        table.rows.insert(table.rows.begin() + place,
            {std::move(joined.name), std::move(joined.magnitude), std::move(joined.expanded),
                dash(), dash(), dash(), dash()});
    }
}

/// A value outside the laboratory's scope is marked (CER-007).
Message markedCell(
    const FrequencyLine &line, Message frequency, const UncertaintySettings &settings)
{
    if (!isOutsideScope(settings.cmc, line.frequency_Hz())
        || !std::isfinite(valueAt(line.uncertainty->u_magnitude, line.row)))
        return frequency;
    return {"%M1 *", {}, {std::move(frequency)}};
}

void addNoteOfScope(
    const std::vector<FrequencyLine> &lines, const Recipe &recipe, CertificateSection &section)
{
    if (std::ranges::any_of(lines, [&](const FrequencyLine &line) {
            return *markedCell(line, {}, recipe.uncertainty).text != '\0';
        }))
        section.notes.push_back(
            {DYNCAL_TEXT("core",
                 "* outside the scope: the laboratory states no calibration and measurement capability (CMC) at this frequency."),
                {}});
}

CertificateTable frequencyTable(const ResponseResult &response, const UncertaintyReport &report,
    const Recipe &recipe, const std::vector<FrequencyLine> &lines)
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
    table.columns = frequencyColumns();
    const std::vector<double> sorted = sortedFrequencies(response);
    for (const FrequencyLine &line : lines)
        table.rows.push_back(frequencyRow(
            line, markedCell(line, frequencyCell(line, report, sorted), recipe.uncertainty)));
    addJoined(report, lines, table);
    return table;
}

void addNoteOfMarks(const ResponseResult &response, CertificateSection &section)
{
    if (response.atMarks)
        section.notes.push_back(
            {DYNCAL_TEXT("core",
                 "Beside the frequencies asked for, the table always has the limits of the band and, where they are known and lie between these, the model's band edges and resonance. What stands in these lines was computed at exactly these frequencies, as in all others."),
                {}});
}

void addKnown(const UncertaintyReport &report, CertificateSection &section)
{
    if (report.known.empty())
        return;
    section.tables.push_back(knownValuesTable(report));
    section.notes.push_back(
        {DYNCAL_TEXT("core",
             "A value of another calibration stands in the table of this one, under its name, only where both agree within their expanded uncertainties (absolute En at most 1); below the band it is compared with the sensitivity at the onset of the step. It is no result of this calibration; the line \"compared at\" of its frequency is."),
            {}});
}

Message endWords(BandEnd end)
{
    switch (end) {
    case BandEnd::Window:
        return {DYNCAL_TEXT("core", "one over the length of the shortest window"), {}};
    case BandEnd::Noise:
        return {DYNCAL_TEXT("core", "where the noise begins to exceed 10 % of the magnitude"), {}};
    case BandEnd::Rate:
        return {DYNCAL_TEXT("core", "0.4 of the lowest sample rate"), {}};
    case BandEnd::ModelRate:
        return {DYNCAL_TEXT("core", "half the sample rate of the model"), {}};
    case BandEnd::Reference:
        return {DYNCAL_TEXT("core", "where the calibration of the reference transducer ends"), {}};
    case BandEnd::Chain:
        break;
    }
    return {DYNCAL_TEXT("core", "where the stated response of amplifier and converter ends"), {}};
}

void addNotes(const ResponseResult &response, std::size_t rows, CertificateSection &section)
{
    section.notes.push_back(
        {DYNCAL_TEXT("core", "The lower limit of the band is %M1, the upper limit %M2."), {},
            {endWords(response.lowEnd), endWords(response.highEnd)}});
    section.notes.push_back(
        {DYNCAL_TEXT("core",
             "Frequencies are settings, without an uncertainty. The model's values have the digits of the wider of their uncertainty and the measured value's; they end at half the sample rate of the model. A dash means that the value, or its complete uncertainty, was not determined."),
            {}});
    if (response.isByTransducer) {
        section.notes.push_back(
            {DYNCAL_TEXT("core",
                 "The values without a model are ratios of the item's record to that of the reference transducer, times its sensitivity; outside the frequencies of its calibration there are none. Where what sampling or the end of the records may change exceeds both the uncertainty of the noise and 2 % of the magnitude, none is stated."),
                {}});
        section.notes.push_back(
            {DYNCAL_TEXT("core",
                 "The phase without a model counts from the pressure at the reference transducer, that of the model from the item's own onset: the two may differ in proportion to the frequency."),
                {}});
    } else {
        section.notes.push_back(
            {DYNCAL_TEXT("core",
                 "The values without a model take nothing from it but the zero of time and, where there are any, the drift and what was taken out of the records. Where what sampling or the end of the records may change exceeds both the uncertainty of the noise and 2 % of the magnitude, none is stated; for the sampling it is assumed that above half the sample rate the response is nowhere stronger than just below."),
                {}});
    }
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
    if (!results.response
        || (results.response->frequency_Hz.size() == 0 && !results.response->atMarks)) {
        section.paragraphs.push_back(
            {DYNCAL_TEXT("core", "The frequency response could not be determined."), {}});
        return section;
    }
    const ResponseResult &response = *results.response;
    section.fields = {{"f_low", {DYNCAL_TEXT("core", "Lower frequency limit"), {}},
                          setting(response.fLow_Hz, "Hz"), false},
        {"f_high", {DYNCAL_TEXT("core", "Upper frequency limit"), {}},
            setting(response.fHigh_Hz, "Hz"), false}};
    const UncertaintyReport none;
    const UncertaintyReport &report = results.uncertainty ? *results.uncertainty : none;
    const std::vector<FrequencyLine> lines = linesOf(response, report);
    if (!lines.empty())
        section.tables.push_back(frequencyTable(response, report, recipe, lines));
    addNoteOfScope(lines, recipe, section);
    addKnown(report, section);
    addNoteOfMarks(response, section);
    addNotes(response, rowsInBand(response).size(), section);
    if (const auto sentence = comparisonSentence(results))
        section.notes.push_back(*sentence);
    return section;
}

} // namespace dyncal
