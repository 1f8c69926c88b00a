// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/response_findings.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

/// Compares the two independent answers and reports where they differ beyond their uncertainty.
void compareAnswers(ResponseResult &result)
{
    constexpr double kCoverage = 4.0;
    constexpr double kModelShare = 0.02; // allowed error of the model itself
    for (Index k = 0; k < result.magnitude.size(); ++k) {
        const double difference = std::abs(result.magnitude[k] - result.modelMagnitude[k]);
        const double limit = kCoverage * result.u_noiseMagnitude[k] + result.boundEnd[k]
            + result.boundAlias[k] + kModelShare * result.modelMagnitude[k];
        if (difference > limit) {
            result.findings.push_back({.id = "RSP-001",
                .severity = Severity::Caution,
                .message
                = {DYNCAL_TEXT("core",
                       "At %1 the response taken from the data directly differs by %2 % from the model, more than noise allows: the model misses something there."),
                    {numberWithUnit(result.frequency_Hz[k], "Hz", 3),
                        numberText(100.0 * difference / result.modelMagnitude[k], 2)}},
                .value = difference,
                .limit = limit});
            return;
        }
    }
}

/// Says once for each of the two bounds at which frequencies nothing is stated.
void reportWithheld(
    WithheldReason reason, const char *id, const char *words, ResponseResult &result)
{
    Index count = 0;
    double lowest_Hz = std::numeric_limits<double>::infinity();
    double highest_Hz = 0.0;
    for (std::size_t k = 0; k < result.withheld.size(); ++k) {
        if (result.withheld[k] != reason)
            continue;
        const double f_Hz = result.frequency_Hz[static_cast<Index>(k)];
        lowest_Hz = std::min(lowest_Hz, f_Hz);
        highest_Hz = std::max(highest_Hz, f_Hz);
        ++count;
    }
    if (count == 0)
        return;
    result.findings.push_back({.id = id,
        .severity = Severity::Info,
        .message = {words,
            {std::to_string(count), std::to_string(result.withheld.size()),
                numberWithUnit(lowest_Hz, "Hz", 3), numberWithUnit(highest_Hz, "Hz", 3)}},
        .value = static_cast<double>(count)});
}

void reportAllWithheld(ResponseResult &result)
{
    reportWithheld(WithheldReason::End, "RSP-003",
        DYNCAL_TEXT("core",
            "The response taken from the data is withheld at %1 of %2 frequencies, from %3 to %4: what the end of the record cuts off may change it there by more than its noise and 2 %. Use a longer window, or only what the model says there."),
        result);
    reportWithheld(WithheldReason::Alias, "RSP-004",
        DYNCAL_TEXT("core",
            "The response taken from the data is withheld at %1 of %2 frequencies, from %3 to %4: the sampling may change it there by more than its noise and 2 %. Record at a higher rate, or use only what the model says there."),
        result);
    reportWithheld(WithheldReason::NotCalibrated, "RSP-005",
        DYNCAL_TEXT("core",
            "The response taken from the data is withheld at %1 of %2 frequencies, from %3 to %4: the reference transducer was not calibrated there, and nothing is extrapolated."),
        result);
    reportWithheld(WithheldReason::ChainUnknown, "RSP-005",
        DYNCAL_TEXT("core",
            "The response taken from the data is withheld at %1 of %2 frequencies, from %3 to %4: the response of the chain (chain.source) is not stated there, and nothing is extrapolated."),
        result);
}

} // namespace

void judgeRows(ResponseResult &result)
{
    reportAllWithheld(result);
    compareAnswers(result);
}

void reportBelowBand(ResponseResult &result)
{
    if (result.frequency_Hz.size() == 0)
        return;
    const double lowest_Hz = result.frequency_Hz.minCoeff();
    if (lowest_Hz >= result.fLow_Hz * (1.0 - 1e-9))
        return;
    result.findings.push_back({.id = "WIN-005",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "The shortest window, %1, resolves steps of %2, but the response is asked for from %3: below %2 it is not measured. Lengthen the window or take these frequencies out of response.frequencies_hz."),
            {numberWithUnit(1.0 / result.fLow_Hz, "s", 4), numberWithUnit(result.fLow_Hz, "Hz", 4),
                numberWithUnit(lowest_Hz, "Hz", 4)}},
        .value = lowest_Hz,
        .limit = result.fLow_Hz});
}

} // namespace dyncal
