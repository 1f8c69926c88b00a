// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/shot_point.h"

#include "core/base/constants.h"
#include "core/model_analysis/step_transform.h"
#include "core/signal/step_readings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

constexpr Index kCuts = 12;
constexpr double kMarginOfEnd = 1.2; ///< over the largest change that a cut makes

void trimBefore(double span_s, RecordOfShot &shot)
{
    constexpr Index kFewestBefore = 64;
    constexpr double kShare = 1.0 / 16.0;
    const auto wanted = static_cast<Index>(kShare * span_s * shot.response->sampleRate_Hz);
    const Index before = std::min(shot.record.early, std::max(kFewestBefore, wanted));
    const Index kept = shot.record.values.size() - shot.record.early + before;
    shot.record.values = shot.record.values.tail(kept).eval();
    shot.record.early = before;
}

/// Behind the first of the samples used.
double onsetIn(const RecordOfShot &shot)
{
    return shot.onset_s + static_cast<double>(shot.record.early) / shot.response->sampleRate_Hz;
}

/// Middle of the rise, from the record alone; 0, the detected start, of a record without one.
double middleOfRise_s(const RecordOfShot &shot)
{
    const Eigen::VectorXd &y = shot.record.values;
    const Eigen::VectorXd relative = y / transformEnds(y, 0).back().level;
    const auto crossing = riseCrossing(relative, shot.record.early, y.size(), 0.5);
    const double early = static_cast<double>(shot.record.early);
    return (crossing.value_or(early) - early) / shot.response->sampleRate_Hz;
}

/// The noise of one shot as it acts on S at one frequency.
struct NoiseAt
{
    double rate_Hz = 0.0;
    double frequency_Hz = 0.0;
    NoiseDensity::Value density; ///< at the frequency
    double ofLevel = 0.0; ///< density that a mean of the record's last tenth has
    double slower = 0.0; ///< variance of what is slower: it moves the level against the baseline

    /// Of Re S and of Im S where the record ends at `end`, of `samples` samples of it.
    double variance(const TransformEnd &end, Index samples) const
    {
        return slower
            + stepTransformVariance(
                {samples, end.averaged, 0.0}, rate_Hz, density.variance, ofLevel, frequency_Hz);
    }
};

NoiseAt noiseAt(
    const NoiseDensity &noise, double rate_Hz, const TransformEnd &whole, double frequency_Hz)
{
    const double averaged = static_cast<double>(whole.averaged);
    NoiseAt at{rate_Hz, frequency_Hz, noise.at(frequency_Hz),
        noise.at(0.5 * rate_Hz / averaged).variance, 0.0};
    at.slower
        = std::max(0.0, noise.ofMean(whole.averaged, 2 * whole.samples) - at.ofLevel / averaged);
    return at;
}

} // namespace

void prepareShot(double span_s, RecordOfShot &shot)
{
    trimBefore(span_s, shot);
    shot.middle_s = middleOfRise_s(shot);
}

Eigen::Ref<const Eigen::VectorXd> samplesUsed(const RecordOfShot &shot, double length_s)
{
    constexpr double kRounding = 1e-6; // of a whole number of samples
    const double asked
        = std::max(2.0, std::ceil(length_s * shot.response->sampleRate_Hz - kRounding));
    const Index there = shot.record.values.size() - shot.record.early;
    const Index count = static_cast<Index>(std::min(asked, static_cast<double>(there)));
    return shot.record.values.head(shot.record.early + count);
}

ShotPoint shotPoint(
    const RecordOfShot &shot, const NoiseDensity &noise, double length_s, double frequency_Hz)
{
    const double rate_Hz = shot.response->sampleRate_Hz;
    const double scale2 = shot.scale * shot.scale;
    const auto y = samplesUsed(shot, length_s);
    const std::vector<TransformEnd> ends = transformEnds(y, kCuts);
    const TransformEnd &whole = ends.back();
    const NoiseAt at = noiseAt(noise, rate_Hz, whole, frequency_Hz);
    const auto transforms = stepTransforms(y, rate_Hz, ends, onsetIn(shot), frequency_Hz);
    const auto toS = [&](std::complex<double> transform) {
        return shot.scale * shot.record.ofStep(transform, frequency_Hz);
    };
    ShotPoint point{toS(transforms.back()),
        scale2 * (at.variance(whole, whole.samples) + noise.ofBaseline()), at.density.dof,
        Eigen::VectorXcd(kCuts), Eigen::VectorXd(kCuts), shot.u_onset_s,
        shot.onset_s - shot.middle_s};
    const std::complex<double> turn = std::polar(1.0, -std::arg(point.S));
    for (Index k = 0; k < kCuts; ++k) {
        const TransformEnd &end = ends[static_cast<std::size_t>(k)];
        point.changes[k] = (toS(transforms[static_cast<std::size_t>(k)]) - point.S) * turn;
        // Noise of the part cut off, and of the two levels.
        point.variancesOfChanges[k]
            = scale2 * (at.variance(end, whole.samples - end.samples) + at.variance(whole, 0));
    }
    return point;
}

/// |S| of a noisy S is too large by u^2/2|S|.
double meanMagnitude(const std::vector<ShotPoint> &shots)
{
    double sum = 0.0;
    for (const ShotPoint &shot : shots) {
        const double square = std::norm(shot.S) - shot.variance;
        sum += square < 0.0 ? 0.0 : std::sqrt(square); // a sample that is no number stays none
    }
    return sum / static_cast<double>(shots.size());
}

double meanPhase_rad(const std::vector<ShotPoint> &shots, double omega)
{
    const double n = static_cast<double>(shots.size());
    std::complex<double> together = 0.0;
    double offset_s = 0.0;
    for (const ShotPoint &shot : shots) {
        together += shot.S * std::polar(1.0, -omega * shot.onsetBehindRise_s);
        offset_s += shot.onsetBehindRise_s / n;
    }
    double sum = 0.0;
    for (const ShotPoint &shot : shots)
        sum += std::remainder(
            std::arg(shot.S) - omega * shot.onsetBehindRise_s - std::arg(together), kTwoPi);
    return std::remainder(std::arg(together) + sum / n + omega * offset_s, kTwoPi);
}

double boundOfEnd(const std::vector<ShotPoint> &shots)
{
    const double n = static_cast<double>(shots.size());
    Eigen::VectorXcd changes = Eigen::VectorXcd::Zero(kCuts);
    Eigen::VectorXd ofNoise = Eigen::VectorXd::Zero(kCuts);
    for (const ShotPoint &shot : shots) {
        changes += shot.changes / n;
        ofNoise += 2.0 * shot.variancesOfChanges / (n * n);
    }
    const double largest
        = (changes.array().abs2() - kSigmasOfNoise * kSigmasOfNoise * ofNoise.array()).maxCoeff();
    return kMarginOfEnd * std::sqrt(std::max(0.0, largest));
}

double dofOf(const std::vector<ShotPoint> &shots)
{
    double sum = 0.0, squares = 0.0;
    for (const ShotPoint &shot : shots) {
        sum += shot.variance;
        squares += shot.variance * shot.variance / shot.dof;
    }
    return squares > 0.0 ? sum * sum / squares : std::numeric_limits<double>::infinity();
}

} // namespace dyncal
