// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/flat_top.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace dyncal {
namespace {

constexpr Index kNoiseSpan = 4096; ///< samples at the start; give the noise
constexpr Index kLeastSpan = 64;
constexpr Index kLongRun = 16;
constexpr double kJumpShare = 0.01; ///< of the range
constexpr double kJumpSigmas = 6.0;
constexpr double kJumpCodes = 2.0;
constexpr double kResolved = 3.0; ///< codes of noise
constexpr double kNormal = 1.4826; ///< standard deviation over median of a normal distribution

/// Noise and smallest step of the values, from the quiet beginning of a record.
FlatTopScale scaleOf(const RawSamples &samples, const RecordSurvey &survey)
{
    FlatTopScale scale;
    scale.range = survey.highest - survey.lowest;
    scale.codeSize = samples.isInteger() ? 1.0 : 0.0;
    const Index span = std::min(kNoiseSpan, samples.size() / 8);
    if (span < kLeastSpan)
        return scale;
    std::vector<double> steps;
    std::vector<double> bends; // second differences, which contain no slow movement
    double before = samples.at(0);
    double last = samples.at(1);
    samples.visitBlocks(2, span, [&](auto values, Index) {
        for (const auto raw : values) {
            const auto value = static_cast<double>(raw);
            if (const double bend = std::abs(value - 2.0 * last + before); std::isfinite(bend)) {
                bends.push_back(bend);
                steps.push_back(std::abs(value - last));
            }
            before = std::exchange(last, value);
        }
    });
    if (steps.empty())
        return scale;
    std::sort(steps.begin(), steps.end());
    std::sort(bends.begin(), bends.end());
    scale.noiseSd = kNormal * bends[bends.size() / 2] / std::sqrt(6.0);
    if (const auto moved = std::upper_bound(steps.begin(), steps.end(), 0.0);
        !samples.isInteger() && moved != steps.end())
        scale.codeSize = *moved;
    return scale;
}

} // namespace

bool isCutOff(const std::function<double(Index)> &valueAt, Index size, const EqualRun &run,
    const FlatTopScale &scale)
{
    const double level = valueAt(run.begin);
    const double leastJump = std::max(
        {kJumpShare * scale.range, kJumpSigmas * scale.noiseSd, kJumpCodes * scale.codeSize});
    const auto exists = [&](Index i) { return i >= 0 && i < size; };
    const auto jumps = [&](Index beside) {
        return exists(beside) && std::abs(valueAt(beside) - level) > leastJump;
    };
    /// `step` leads away from the run.
    const auto moves = [&](Index beside, Index step) {
        return exists(beside + step) && valueAt(beside + step) != valueAt(beside);
    };
    const Index before = run.begin - 1;
    const Index after = run.begin + run.count;
    const bool neverRepeats = scale.noiseSd > kResolved * scale.codeSize;
    if (neverRepeats)
        return true;
    const bool isNoisy = scale.noiseSd > 0.5 * scale.codeSize;
    if (isNoisy)
        return jumps(before) || jumps(after) || run.count >= kLongRun;
    return jumps(before) && jumps(after) && moves(before, -1) && moves(after, 1);
}

bool isCutOff(const RawSamples &samples, const RecordSurvey &survey, const EqualRun &run)
{
    return isCutOff(
        [&](Index i) { return samples.at(i); }, samples.size(), run, scaleOf(samples, survey));
}

} // namespace dyncal
