// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/known_values.h"

#include "core/base/number_text.h"
#include "core/capture/sensor_card.h"
#include "core/model_analysis/model_response.h"
#include "core/model_analysis/response_rows.h"

#include <cmath>
#include <limits>

namespace dyncal {
namespace {

constexpr int kDigitsOfKnown = 4;

/// The value as a card would state it, so that units are understood alike.
std::optional<CardSensitivity> perPascal(const KnownSensitivity &stated)
{
    constexpr int kAllDigits = 17;
    return sensitivityOfCard({{"sensitivity", numberText(stated.magnitude, kAllDigits)},
        {"sensitivity_unit", stated.unit}});
}

ReportedValue otherValue(const KnownSensitivity &stated)
{
    ReportedValue other{"known", kUnknown, stated.unit};
    const std::optional<CardSensitivity> card = perPascal(stated);
    if (!card)
        return other;
    other.value = card->value;
    other.unit = card->unit;
    const double u = stated.u * card->value / stated.magnitude;
    other.lines = {
        directLine("certificate", u, stated.dof.value_or(std::numeric_limits<double>::infinity()))};
    combineLines(other);
    return other;
}

/// What the model's gain at a frequency is of that at the onset's level; a drift that is not the
/// sensor's is taken out, one of its chain kept, as in S(f).
double riseTo(double frequency_Hz, const ResponseResult &response, const FittedModel &fitted)
{
    const SensorModel &model = fitted.model;
    if (!(frequency_Hz > 0.0) || model.level() == 0.0)
        return 1.0;
    std::complex<double> gain
        = modelResponse(model, fitted.treatment, frequency_Hz) / model.level();
    if (!response.drift.shots.empty())
        gain *= response.drift.keptAt(frequency_Hz) / modelledDrift(model, frequency_Hz);
    return std::abs(gain);
}

/// What heat takes off is not the sensor's; an AC coupling has no static value.
bool mayBeAcCoupled(const DriftResult &drift)
{
    return drift.kind == DriftKind::AcCoupling || drift.kind == DriftKind::Undetermined;
}

ReportedValue belowBand(const KnownSensitivity &stated, const ResponseResult &response,
    const ReportedValue &sensitivity, const FittedModel &fitted)
{
    const double rise = riseTo(stated.frequency_Hz, response, fitted);
    ReportedValue here = sensitivity;
    here.value = std::abs(rise * sensitivity.value);
    here.lines = scaled(std::move(here.lines), rise);
    here.leastExpanded *= rise;
    combineLines(here);
    return here;
}

/// Why nothing here can be compared with the value; empty where it can.
Message whyNot(const KnownSensitivity &stated, const ReportedValue &other,
    const ResponseResult &response, const UncertaintyReport &report)
{
    if (response.unit == "1" || !report.sensitivity)
        return {DYNCAL_TEXT("core", "S(f) is not stated per pressure"), {}};
    if (other.unit != response.unit)
        return {DYNCAL_TEXT("core", "its unit %1 is none of %2, in which S(f) is"),
            {stated.unit, response.unit}};
    if (!(other.expanded().value_or(kUnknown) < other.value))
        return {DYNCAL_TEXT("core", "its expanded uncertainty is not below its value"), {}};
    if (stated.frequency_Hz < response.fLow_Hz && mayBeAcCoupled(response.drift))
        return {
            DYNCAL_TEXT("core",
                "the response drifts as behind an AC coupling, so below the band it is not known"),
            {}};
    if (stated.frequency_Hz > response.fHigh_Hz)
        return {DYNCAL_TEXT("core", "%1 is above the band, which ends at %2"),
            {numberWithUnit(stated.frequency_Hz, "Hz", kDigitsOfKnown),
                numberWithUnit(response.fHigh_Hz, "Hz", kDigitsOfKnown)}};
    if (!report.sensitivity->u || !report.rows.isComplete())
        return {DYNCAL_TEXT("core", "the sensitivity has no complete uncertainty"), {}};
    return {};
}

void compareRow(KnownValue &known, const ResponseResult &marked, const RowUncertainty &rows)
{
    const std::optional<Index> row = measuredRowAt(marked, known.stated.frequency_Hz);
    if (row)
        known.here = magnitudeOfRow(marked, rows, *row);
    if (known.here.u)
        known.against = KnownAgainst::Row;
    else
        known.missing = {DYNCAL_TEXT("core", "S(f) is withheld at %1"),
            {numberWithUnit(known.stated.frequency_Hz, "Hz", kDigitsOfKnown)}};
}

KnownValue comparedOne(const KnownSensitivity &stated, const ResponseResult &response,
    const UncertaintyReport &report, const FittedModel &fitted)
{
    KnownValue known{stated, otherValue(stated), {"magnitude", kUnknown, response.unit}};
    known.missing = whyNot(stated, known.other, response, report);
    if (*known.missing.text != '\0')
        return known;
    if (stated.frequency_Hz < response.fLow_Hz) {
        known.here = belowBand(stated, response, *report.sensitivity, fitted);
        known.against = KnownAgainst::Sensitivity;
    } else if (response.atMarks) {
        compareRow(known, *response.atMarks, report.rowsAtMarks);
    }
    if (known.isCompared())
        known.e_n = (known.here.value - known.other.value)
            / std::hypot(*known.here.expanded(), *known.other.expanded());
    return known;
}

Message nameOf(const KnownSensitivity &stated)
{
    return stated.frequency_Hz > 0.0 ? Message{DYNCAL_TEXT("core", "%1 at %2"),
               {stated.label, numberWithUnit(stated.frequency_Hz, "Hz", kDigitsOfKnown)}}
                                     : Message{"%1", {stated.label}};
}

Finding differs(const KnownValue &known)
{
    constexpr double kPercent = 100.0;
    const std::string &unit = known.other.unit;
    return {.id = "UNC-004",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "%M1 states %1, this calibration %2: they differ by %3 %, En = %4, more than both expanded uncertainties, and are not joined to one curve. Check unit, range, gas and mounting of either; the one that is wrong is not known."),
            {numberWithUnit(known.other.value, unit, kDigitsOfKnown),
                numberWithUnit(known.here.value, unit, kDigitsOfKnown),
                numberText(kPercent * known.difference_relative(), 2), numberText(known.e_n, 2)},
            {nameOf(known.stated)}},
        .value = known.e_n,
        .limit = 1.0};
}

Finding notCompared(const KnownValue &known)
{
    return {.id = "UNC-005",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "%M1 of response.known cannot be compared with this calibration: %M2. Correct it, or leave it out."),
            {}, {nameOf(known.stated), known.missing}}};
}

} // namespace

std::vector<KnownValue> compareKnown(const std::vector<KnownSensitivity> &known,
    const ResponseResult &response, const UncertaintyReport &report, const FittedModel &fitted)
{
    std::vector<KnownValue> compared;
    compared.reserve(known.size());
    for (const KnownSensitivity &stated : known)
        compared.push_back(comparedOne(stated, response, report, fitted));
    return compared;
}

Findings judgeKnown(const std::vector<KnownValue> &known)
{
    Findings findings;
    for (const KnownValue &one : known) {
        if (!one.isCompared())
            findings.push_back(notCompared(one));
        else if (!one.isJoined())
            findings.push_back(differs(one));
    }
    return findings;
}

} // namespace dyncal
