// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/stuck_values.h"

#include "core/base/distributions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

constexpr double kChance = 1e-6; ///< of a false alarm in a record
constexpr double kArithmetic = 1e-9; ///< of the range: rounding of computed values, no noise
constexpr double kFewestRuns = 8.0; ///< needed to estimate how long runs get
constexpr Index kFewestSamples = 48; ///< needed to estimate the noise
constexpr Index kLongestLag = 64; ///< samples after which noise counts as independent
constexpr double kSureBend = 4.0; ///< codes: a rounded second difference this large was
constexpr double kLeastBend = 2.0; ///< at least this many codes before rounding

/// Calls `visit(begin, count)` for every run of equal values.
template <typename Visit>
void forEachEqualRun(const Eigen::Ref<const Eigen::VectorXd> &values, const Visit &visit)
{
    for (Index begin = 0; begin < values.size();) {
        Index end = begin + 1;
        while (end < values.size() && values[end] == values[begin])
            ++end;
        visit(begin, end - begin);
        begin = end;
    }
}

/// The smallest step from one sample to the next; 0 if there is none.
double codeOf(const Eigen::Ref<const Eigen::VectorXd> &values, double least)
{
    double code = std::numeric_limits<double>::infinity();
    for (Index i = 1; i < values.size(); ++i) {
        const double step = std::abs(values[i] - values[i - 1]);
        code = step > least ? std::min(code, step) : code;
    }
    return std::isfinite(code) ? code : 0.0;
}

/// Probability per sample that noise leaves a code when the level lies in the middle of it, from
/// second differences over `lag` samples, which slow movement does not affect. 0 = not known.
double leavingRate(const Eigen::Ref<const Eigen::VectorXd> &quiet, double code, Index lag)
{
    const Index count = quiet.size() - 2 * lag;
    Index large = 0;
    for (Index i = 0; i < count; ++i) {
        const double bend = quiet[i] - 2.0 * quiet[i + lag] + quiet[i + 2 * lag];
        large += std::abs(bend) >= (kSureBend - 0.5) * code ? 1 : 0;
    }
    if (large == 0)
        return 0.0;
    const double share = static_cast<double>(large) / static_cast<double>(count);
    const double deviations = normalQuantile(1.0 - 0.5 * std::min(share, 0.99));
    const double noise_codes = kLeastBend / (std::sqrt(6.0) * deviations);
    const double stays = std::erf(0.5 / (std::sqrt(2.0) * noise_codes));
    return -std::log(stays) / static_cast<double>(lag);
}

} // namespace

std::optional<double> longestExplainedRun(
    const Eigen::Ref<const Eigen::VectorXd> &quiet, Index size)
{
    if (quiet.size() < kFewestSamples)
        return std::nullopt;
    Index longest = 0;
    double runs = 0.0;
    forEachEqualRun(quiet, [&](Index, Index count) {
        longest = std::max(longest, count);
        runs += 1.0;
    });
    const double code = codeOf(quiet, kArithmetic * quiet.cwiseAbs().maxCoeff());
    if (runs < kFewestRuns || !(code > 0.0))
        return std::nullopt;
    double rate = 0.0;
    for (Index lag = 1; lag <= kLongestLag && 4 * lag < quiet.size(); lag *= 2)
        rate = std::max(rate, leavingRate(quiet, code, lag));
    if (!(rate > 0.0))
        return std::nullopt;
    const double tries = std::log(static_cast<double>(size) / kChance);
    const double ofRuns = tries * static_cast<double>(longest) / std::log(runs);
    return std::max(ofRuns, tries / rate);
}

std::optional<StuckValues> stuckValues(
    const Eigen::Ref<const Eigen::VectorXd> &values, const Eigen::Ref<const Eigen::VectorXd> &quiet)
{
    if (values.size() == 0)
        return std::nullopt;
    const double range = values.maxCoeff() - values.minCoeff();
    const double noise = quiet.size() > 0 ? quiet.maxCoeff() - quiet.minCoeff() : 0.0;
    const std::optional<double> explained = longestExplainedRun(quiet, values.size());
    if (!explained || !(noise > kArithmetic * range))
        return std::nullopt;
    StuckValues stuck;
    forEachEqualRun(values, [&](Index begin, Index count) {
        if (static_cast<double>(count) > *explained && count > stuck.longest)
            stuck = {begin, count, 0};
    });
    if (stuck.longest == 0)
        return std::nullopt;
    forEachEqualRun(values, [&](Index begin, Index count) {
        if (static_cast<double>(count) > *explained && values[begin] == values[stuck.begin])
            stuck.total += count;
    });
    return stuck;
}

} // namespace dyncal
