// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/table_band.h"

#include "core/base/number_text.h"

#include <string>

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

} // namespace

void endByTable(const ReferenceSensitivity &table, BandEnd why, ResponseResult &result)
{
    if (table.lowest_Hz() > result.fHigh_Hz || table.highest_Hz() < result.fLow_Hz)
        reportApart(table, why, result);
    else
        reportGap(table, why, result);
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
