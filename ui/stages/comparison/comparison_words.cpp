// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/comparison/comparison_words.h"

#include "ui/stages/comparison/known_words.h"
#include "ui/text/quantity_column.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

/// Gives the words below their translation context.
struct ComparisonWords
{
    Q_DECLARE_TR_FUNCTIONS(ComparisonWords)
};

const QString kNoNumber = QStringLiteral("–");
/// Of 20 rows that agree one is beyond its U by chance (k = 2); twice that is looked into.
constexpr double kShareByChance = 0.1;

QString plainUnit(const std::string &unit)
{
    return unit == "1" ? QString() : shownText(unit);
}

QString signedPercent(double relative)
{
    const QString number = shownNumber(100.0 * relative, 3) + QStringLiteral(" %");
    return relative > 0.0 ? QStringLiteral("+") + number : number;
}

QString numberText(double value)
{
    return std::isfinite(value) ? shownFigures(value, 2) : kNoNumber;
}

/// Frequencies at which the two differ by more than their U.
struct RowsBeyond
{
    qsizetype compared = 0;
    qsizetype beyond = 0;
    double lowest_Hz = kUnknown;
    double highest_Hz = kUnknown;

    bool isNotByChance() const
    {
        return static_cast<double>(beyond) > kShareByChance * static_cast<double>(compared);
    }
};

RowsBeyond rowsBeyond(const ComparisonResult &comparison)
{
    RowsBeyond found;
    for (const ComparedRow &row : comparedRows(comparison)) {
        found.compared += std::isfinite(row.e_n);
        if (!(std::abs(row.e_n) > 1.0))
            continue;
        if (found.beyond++ == 0)
            found.lowest_Hz = row.frequency_Hz;
        found.highest_Hz = row.frequency_Hz;
    }
    return found;
}

bool contradicts(const StepAgainstTransducer &found)
{
    return std::abs(found.meanE_n()) > 1.0;
}

QString rowsSentence(const RowsBeyond &rows)
{
    if (rows.beyond == 0)
        return ComparisonWords::tr("At none of %1 frequencies alone is Eₙ beyond ±1.")
            .arg(rows.compared);
    return ComparisonWords::tr("At %1 of %2 frequencies, between %3 and %4, Eₙ alone is beyond ±1.")
        .arg(QString::number(rows.beyond), QString::number(rows.compared),
            shownQuantity(rows.lowest_Hz, QStringLiteral("Hz"), 3),
            shownQuantity(rows.highest_Hz, QStringLiteral("Hz"), 3));
}

QString meanSentence(const StepAgainstTransducer &found)
{
    const QString words = contradicts(found)
        ? ComparisonWords::tr(
            "Step and reference transducer contradict each other: on the mean S(f) differs by %1, U of the difference %2 (k = 2), Eₙ = %3.")
        : ComparisonWords::tr(
            "Step and reference transducer agree: on the mean S(f) differs by %1, U of the difference %2 (k = 2), Eₙ = %3.");
    return words.arg(signedPercent(found.difference_relative),
        shownNumber(200.0 * found.u_relative, 2) + QStringLiteral(" %"),
        numberText(found.meanE_n()));
}

/// Whether anything else speaks against the step.
QString otherWaysSentence(const ConsistencyResult *checks)
{
    if (!checks)
        return {};
    const bool isContradicted = std::ranges::any_of(
        checks->checks, [](const WayComparison &check) { return !check.agrees(); });
    return isContradicted
        ? ComparisonWords::tr(
            "On the page Checks other ways contradict each other, too: begin there.")
        : ComparisonWords::tr(
            "On the page Checks nothing contradicts the step: begin with the transducer.");
}

QString adviceOnMean(const CalibrationResults &results)
{
    return ComparisonWords::tr(
        "Look at the reference transducer: number and date of its certificate, its unit, the gain of its chain, its mounting. A factor such as 1.5, 6.9 or 1000 is a gain or a unit. Then at the step: gas and humidity, T1, distances and delays of the arrival sensors (page Reference step). %1 Correct what is wrong; a caution that stays needs a reason before the certificate can be issued.")
        .arg(otherWaysSentence(results.checks.get()));
}

QString adviceOnRows()
{
    return ComparisonWords::tr(
        "The mean agrees, single frequencies do not: look there at the certificate's rows, at a resonance or the mounting of one of the two, at the delay between them, and at disturbances in either record. State S(f) only where both agree, or say why they differ.");
}

double differenceOf(const ComparedRow &row)
{
    const double step = row.byStep.value, transducer = row.byTransducer.value;
    return 2.0 * (step - transducer) / (step + transducer);
}

Estimate withExpanded(const ReportedValue &stated)
{
    return {stated.value, stated.expanded().value_or(kUnknown)};
}

std::vector<ShownResult> columnOf(
    const std::vector<ComparedRow> &rows, ReportedValue ComparedRow::*one, const QString &unit)
{
    std::vector<Estimate> values;
    values.reserve(rows.size());
    for (const ComparedRow &row : rows)
        values.push_back(withExpanded(row.*one));
    return shownColumn(values, unit);
}

QStringList meanRow(const StepAgainstTransducer &found)
{
    return {ComparisonWords::tr("mean"), kNoNumber, kNoNumber, kNoNumber, kNoNumber,
        signedPercent(found.difference_relative), numberText(found.meanE_n())};
}

QStringList comparisonHeaders()
{
    return {ComparisonWords::tr("Frequency"), ComparisonWords::tr("Against the\ntransducer"),
        ComparisonWords::tr("U"), ComparisonWords::tr("Against\nthe step"),
        ComparisonWords::tr("U"), ComparisonWords::tr("Difference"), ComparisonWords::tr("Eₙ")};
}

} // namespace

QString sourceSentence(const CertifiedReference &source, const std::string &unit)
{
    const ReferencePoint lowest = source.sensitivity.lowest();
    const QString from = source.certificate.empty()
        ? ComparisonWords::tr("Table")
        : ComparisonWords::tr("Certificate %1").arg(shownText(source.certificate));
    return ComparisonWords::tr("%1, from %2 to %3; at %2: %4 (k = 1).")
        .arg(from, shownQuantity(source.sensitivity.lowest_Hz(), QStringLiteral("Hz"), 3),
            shownQuantity(source.sensitivity.highest_Hz(), QStringLiteral("Hz"), 3),
            shownWithU(lowest.magnitude, lowest.u_magnitude, plainUnit(unit)));
}

QString comparisonVerdict(const CalibrationResults &results)
{
    const ComparisonResult *comparison = results.comparison.get();
    if (!comparison)
        return {};
    const auto &report = results.uncertainty;
    if (!comparison->byTransducer && report && !report->known.empty())
        return knownVerdict(report->known);
    if (!comparison->byTransducer)
        return ComparisonWords::tr(
            "Nothing is compared. Where a transducer of known sensitivity was recorded beside the sensor, say what it is, then switch the comparison on. Where another certificate states this sensor's sensitivity, type its value.");
    if (!comparison->againstStep)
        return ComparisonWords::tr(
            "S(f) against the reference transducer stands alone: the pressure step, or one of the two, has no complete uncertainty to compare by.");
    return meanSentence(*comparison->againstStep) + QLatin1Char(' ')
        + rowsSentence(rowsBeyond(*comparison));
}

QString comparisonAdvice(const CalibrationResults &results)
{
    const ComparisonResult *comparison = results.comparison.get();
    if (!comparison || !comparison->againstStep)
        return {};
    if (contradicts(*comparison->againstStep))
        return adviceOnMean(results);
    return rowsBeyond(*comparison).isNotByChance() ? adviceOnRows() : QString();
}

ShownTable comparisonTable(const ComparisonResult *comparison)
{
    ShownTable table{comparisonHeaders(), {}};
    if (!comparison || !comparison->byTransducer)
        return table;
    const std::vector<ComparedRow> rows = comparedRows(*comparison);
    const QString unit = plainUnit(comparison->byTransducer->response.unit);
    const auto transducer = columnOf(rows, &ComparedRow::byTransducer, unit);
    const auto step = columnOf(rows, &ComparedRow::byStep, unit);
    if (comparison->againstStep)
        table.rows.push_back(meanRow(*comparison->againstStep));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double difference = differenceOf(rows[i]);
        table.rows.push_back({shownQuantity(rows[i].frequency_Hz, QStringLiteral("Hz"), 4),
            transducer[i].value, transducer[i].u, step[i].value, step[i].u,
            std::isfinite(difference) ? signedPercent(difference) : kNoNumber,
            numberText(rows[i].e_n)});
    }
    return table;
}

} // namespace dyncal
