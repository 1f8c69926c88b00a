// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/table_band.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace dyncal {
namespace {

std::string hertz(double frequency_Hz)
{
    return numberWithUnit(frequency_Hz, "Hz", 4);
}

const char *keyOf(BandEnd why)
{
    return why == BandEnd::Chain ? "chain.source" : "comparison.source";
}

void reportApart(const ReferenceSensitivity &table, BandEnd why, ResponseResult &result)
{
    result.findings.push_back({.id = "RSP-007",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "The file of %1 states a response from %2 to %3, the records have one from %4 to %5: nothing in common, so no S(f) can be stated. Give a file that covers the band."),
            {keyOf(why), hertz(table.lowest_Hz()), hertz(table.highest_Hz()), hertz(result.fLow_Hz),
                hertz(result.fHigh_Hz)}}});
}

void reportGap(const ReferenceSensitivity &table, BandEnd why, ResponseResult &result)
{
    constexpr double kWidest = 10.0 * (1.0 + 1e-9);
    const auto gap = table.widestGap(result.fLow_Hz, result.fHigh_Hz);
    if (!gap || gap->to_Hz <= kWidest * gap->from_Hz)
        return;
    result.findings.push_back({.id = "RSP-006",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "The file of %1 has no row between %2 and %3: the response rests on a straight line there, and what that misses is in no uncertainty. Have the rows between calibrated, or give the reason why there is nothing between them."),
            {keyOf(why), hertz(gap->from_Hz), hertz(gap->to_Hz)}},
        .value = gap->to_Hz / gap->from_Hz,
        .limit = kWidest});
}

/// By how much a chain leaves 1 from its lowest row to `to_Hz`, and where; of the table's own
/// range.
struct Departure
{
    double frequency_Hz = 0.0;
    double share = 0.0;
};

Departure largestDeparture(const ReferenceSensitivity &chain, double to_Hz)
{
    constexpr double kStep = 1.0471285480508996; // 50 a decade
    Departure largest;
    for (double f_Hz = std::min(to_Hz, chain.highest_Hz()); f_Hz >= chain.lowest_Hz();
         f_Hz /= kStep) {
        const auto row = chain.at(f_Hz);
        if (row && std::abs(row->magnitude - 1.0) > std::abs(largest.share))
            largest = {f_Hz, row->magnitude - 1.0};
    }
    return largest;
}

void reportUnlikely(const ReferenceSensitivity &table, BandEnd why, ResponseResult &result)
{
    constexpr double kLeastOfBand = 0.1, kWellWithin = 0.5, kMostOfFlat = 0.15;
    const auto flat_Hz = result.characteristics.within10percent_Hz;
    if (!flat_Hz)
        return;
    const auto report = [&](const char *text, std::vector<std::string> arguments) {
        result.findings.push_back({.id = "RSP-008",
            .severity = Severity::Caution,
            .message = {text, std::move(arguments)},
            .causes = {FindingCause::Typed}});
    };
    if (table.highest_Hz() < kLeastOfBand * *flat_Hz)
        return report(
            DYNCAL_TEXT("core",
                "The file of %1 ends at %2, and the sensor is flat up to %3: less than a tenth of that is stated. Check that its frequencies are in Hz, or give a file that covers the band."),
            {keyOf(why), hertz(table.highest_Hz()), hertz(*flat_Hz)});
    const Departure found
        = why == BandEnd::Chain ? largestDeparture(table, kWellWithin * *flat_Hz) : Departure();
    if (std::abs(found.share) > kMostOfFlat)
        report(
            DYNCAL_TEXT("core",
                "The file of %1 states a chain that is off by %2 % at %3, where the records show chain and sensor together within 10 % of flat (up to %4): S(f) would be off by what the file says. Check that its frequencies are in Hz and its magnitudes those of this chain."),
            {keyOf(why), numberText(100.0 * found.share, 3), hertz(found.frequency_Hz),
                hertz(*flat_Hz)});
}

} // namespace

void endByTable(const ReferenceSensitivity &table, BandEnd why, ResponseResult &result)
{
    if (table.lowest_Hz() > result.fHigh_Hz || table.highest_Hz() < result.fLow_Hz) {
        reportApart(table, why, result);
    } else {
        reportGap(table, why, result);
        reportUnlikely(table, why, result);
    }
    if (table.lowest_Hz() > result.fLow_Hz) {
        result.fLow_Hz = table.lowest_Hz();
        result.lowEnd = why;
    }
    if (table.highest_Hz() < result.fHigh_Hz) {
        result.fHigh_Hz = table.highest_Hz();
        result.highEnd = why;
    }
}

} // namespace dyncal
