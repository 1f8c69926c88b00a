// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/coverage_study.h"

#include "core/base/constants.h"
#include "core/base/parallel.h"
#include "core/selftest/virtual_calibration.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kStatedCoverage = 0.95;
constexpr double kRisk = 1e-3;
constexpr double kSigmasOfRisk = 3.2905; ///< two-sided, of the normal distribution

struct StudiedQuantity
{
    VirtualQuantity quantity;
    Message inside;
    Message size;
};

std::vector<StudiedQuantity> studiedQuantities()
{
    using enum VirtualQuantity;
    return {{Sensitivity, {DYNCAL_TEXT("core", "sensitivities within U"), {}},
                {DYNCAL_TEXT("core", "errors of the sensitivity over u, rms"), {}}},
        {Frequency, {DYNCAL_TEXT("core", "natural frequencies within U"), {}},
            {DYNCAL_TEXT("core", "errors of the natural frequency over u, rms"), {}}},
        {Damping, {DYNCAL_TEXT("core", "damping ratios within U"), {}},
            {DYNCAL_TEXT("core", "errors of the damping ratio over u, rms"), {}}},
        {Magnitude, {DYNCAL_TEXT("core", "magnitudes at 20 kHz within U"), {}},
            {DYNCAL_TEXT("core", "errors of the magnitude over u, rms"), {}}}};
}

SelfCheck insideCheck(const StudiedQuantity &studied, const std::vector<VirtualErrors> &runs)
{
    const auto q = static_cast<std::size_t>(studied.quantity);
    const auto count = static_cast<double>(runs.size());
    SelfCheck check{kCoverageStep, studied.inside,
        {DYNCAL_TEXT("core", "binomial bound at 0.1 % for a coverage of 95 %"), {}},
        kStatedCoverage * count, 0.0, 0.0, kUnknown};
    check.tolerance = check.expected
        - static_cast<double>(fewestInside(std::ssize(runs), kStatedCoverage, kRisk));
    for (const VirtualErrors &errors : runs)
        check.found += errors[q].isInside ? 1.0 : 0.0;
    return check;
}

/// Of the root mean square of `count` errors over their u.
double sizeTolerance(double count)
{
    return kSigmasOfRisk / std::sqrt(2.0 * count);
}

/// Root mean square: 1 where u says what it should, with the scatter 1/sqrt(2 n).
SelfCheck sizeCheck(const StudiedQuantity &studied, const std::vector<VirtualErrors> &runs)
{
    const auto q = static_cast<std::size_t>(studied.quantity);
    const auto count = static_cast<double>(runs.size());
    double sum = 0.0;
    for (const VirtualErrors &errors : runs)
        sum += errors[q].overU * errors[q].overU;
    return {kCoverageStep, studied.size,
        {DYNCAL_TEXT("core", "1 where u is right; bounds of so many draws at 0.1 %"), {}}, 1.0,
        std::sqrt(sum / count), sizeTolerance(count), kUnknown};
}

/// Two at a time, so that progress and stop keep to one thread.
std::vector<VirtualErrors> calibrations(Index count, const JobControl &control)
{
    std::vector<VirtualErrors> runs(static_cast<std::size_t>(count));
    for (Index first = 0; first < count && !control.stopRequested(); first += 2) {
        const Index together = std::min<Index>(2, count - first);
        forEachPart(together, true, [&](Index part) {
            runs[static_cast<std::size_t>(first + part)]
                = virtualCalibration(first + part + 1, control.stop);
        });
        control.report(static_cast<double>(first + together) / static_cast<double>(count));
    }
    return runs;
}

} // namespace

Index fewestInside(Index count, double coverage, double risk)
{
    const auto n = static_cast<double>(count);
    double term = std::pow(1.0 - coverage, n); // of none inside
    double below = 0.0;
    for (Index k = 0; k < count; ++k) {
        below += term;
        if (below > risk)
            return k;
        const auto now = static_cast<double>(k);
        term *= (n - now) / (now + 1.0) * coverage / (1.0 - coverage);
    }
    return count;
}

Index leastCalibrations()
{
    Index count = 1;
    while (fewestInside(count, kStatedCoverage, kRisk) == 0
        || sizeTolerance(static_cast<double>(count)) >= 1.0)
        ++count;
    return count;
}

std::vector<SelfCheck> coverageStudy(Index count, const JobControl &control)
{
    const std::vector<VirtualErrors> runs = calibrations(count, control);
    std::vector<SelfCheck> checks;
    if (control.stopRequested())
        return checks;
    for (const StudiedQuantity &studied : studiedQuantities()) {
        checks.push_back(insideCheck(studied, runs));
        checks.push_back(sizeCheck(studied, runs));
    }
    return checks;
}

} // namespace dyncal
