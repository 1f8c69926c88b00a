// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_known_values.h"

#include "core/base/number_text.h"
#include "core/certificate/certificate_words.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

Message frequencyOf(const KnownSensitivity &stated)
{
    return stated.frequency_Hz > 0.0 ? setting(stated.frequency_Hz, "Hz")
                                     : Message{DYNCAL_TEXT("core", "static"), {}};
}

Message nameOfCalibration(const KnownSensitivity &stated)
{
    if (stated.certificate.empty())
        return verbatim(stated.label);
    return {DYNCAL_TEXT("core", "%V1, certificate %V2"), {stated.label, stated.certificate}};
}

double printedU(const ReportedValue &value)
{
    return printableU(value.u.value_or(kUnknown), printedCoverage(value.k), value.leastExpanded);
}

Message magnitudeCell(const ReportedValue &value)
{
    return std::isfinite(value.value)
        ? valueCell(value.value, printedU(value), value.unit, printedCoverage(value.k))
        : dash();
}

Message uCell(const ReportedValue &value)
{
    return std::isfinite(value.value)
        ? expandedCell(value.value, printedU(value), value.unit, printedCoverage(value.k))
        : dash();
}

Message withU(const ReportedValue &value)
{
    return std::isfinite(value.value)
        ? printedWithUncertainty(value.value, printedU(value), value.unit, printedCoverage(value.k))
        : dash();
}

Message verdictOf(const KnownValue &known)
{
    if (!known.isCompared())
        return {DYNCAL_TEXT("core", "not compared"), {}};
    return known.isJoined() ? Message{DYNCAL_TEXT("core", "agrees, joined"), {}}
                            : Message{DYNCAL_TEXT("core", "differs, not joined"), {}};
}

} // namespace

CertificateTable knownValuesTable(const UncertaintyReport &report)
{
    CertificateTable table;
    table.id = "known-values";
    table.caption = {
        DYNCAL_TEXT("core", "Values of other calibrations of the item, beside those of this one"),
        {}};
    table.columns = {{{DYNCAL_TEXT("core", "Calibration"), {}}},
        {{DYNCAL_TEXT("core", "Frequency"), {}}, true},
        {{DYNCAL_TEXT("core", "Its value"), {}}, true},
        {{DYNCAL_TEXT("core", "This calibration"), {}}, true},
        {{DYNCAL_TEXT("core", "En"), {}}, true}, {{DYNCAL_TEXT("core", "Verdict"), {}}}};
    for (const KnownValue &known : report.known)
        table.rows.push_back({nameOfCalibration(known.stated), frequencyOf(known.stated),
            withU(known.other), withU(known.here),
            known.isCompared() ? inNumbers(numberText(known.e_n, 2)) : dash(), verdictOf(known)});
    return table;
}

std::vector<JoinedLine> joinedLines(const UncertaintyReport &report)
{
    std::vector<JoinedLine> lines;
    for (const KnownValue &known : report.known) {
        if (!known.isJoined())
            continue;
        const KnownSensitivity &stated = known.stated;
        Message name = stated.frequency_Hz > 0.0
            ? Message{DYNCAL_TEXT("core", "%1: %V2"), {english(frequencyOf(stated)), stated.label}}
            : Message{DYNCAL_TEXT("core", "static: %V1"), {stated.label}};
        lines.push_back(
            {stated.frequency_Hz, std::move(name), magnitudeCell(known.other), uCell(known.other)});
    }
    std::ranges::stable_sort(lines, {}, &JoinedLine::frequency_Hz);
    return lines;
}

} // namespace dyncal
