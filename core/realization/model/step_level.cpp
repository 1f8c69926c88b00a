// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/step_level.h"

#include "core/realization/model/onset_level.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dyncal {
namespace {

constexpr double kSlower = 0.1; ///< of the sensor's slowest rate, at most
constexpr double kMostOfLevel = 1.1; ///< a part of the step itself has no more than its level
constexpr double kSignificant = 3.0; ///< times its u
constexpr double kMayGrow = 3.0; ///< u: a drift within the window, which no rate describes

using Poles = std::vector<std::size_t>;

/// Of one series: the level, then for each slow part what it changes over the model input, then
/// what its slope at the onset exceeds that of a part of the step by, |h s| - 1.1 L |s|; with the
/// variance of each. A drift that is nearly a ramp has no well-known size h, but a well-known
/// change and slope. What grows is no part of a sensor: a negative number stands for it.
struct Level
{
    OnsetLevel onset;
    Eigen::VectorXd values;
    Eigen::VectorXd variances;
};

std::vector<bool> flagsOf(const Poles &slow, std::size_t count)
{
    std::vector<bool> flags(count, false);
    for (const std::size_t i : slow)
        flags[i] = true;
    return flags;
}

struct Question
{
    std::vector<bool> isSlow; ///< of the poles of the draft
    double onset_s = 0.0;
    double end_s = 0.0; ///< of the model input, from the onset on
};

/// `sum` has its time 0 at the onset.
Level answer(const ExponentialSum &sum, const Question &asked)
{
    Level level{onsetLevel(sum, asked.isSlow), {}, {}};
    const Index parts = static_cast<Index>(level.onset.slow.size());
    level.values.resize(1 + 2 * parts);
    level.values[0] = level.onset.value;
    Index at = 0;
    for (Index i = 0; i < sum.poles_rad_s.size(); ++i) {
        if (!asked.isSlow[static_cast<std::size_t>(i)])
            continue;
        const double size = level.onset.slow[static_cast<std::size_t>(at)];
        const double rate = sum.poles_rad_s[i].real();
        level.values[1 + at] = size * std::expm1(rate * asked.end_s);
        const double slope = std::abs(size * rate);
        level.values[1 + parts + at]
            = rate < 0.0 ? slope + kMostOfLevel * std::abs(level.onset.value) * rate : -slope;
        ++at;
    }
    return level;
}

/// By central differences over a tenth of the u of each parameter of the fit.
Level withVariances(
    const Refinement &refinement, Index record, const SeriesFit &fit, const Question &asked)
{
    Level level = answer({fit.plateauGain, fit.recorded.poles_rad_s, fit.amplitudes}, asked);
    const Eigen::MatrixXd covariance = recordCovariance(refinement, record);
    Eigen::MatrixXd gradient = Eigen::MatrixXd::Zero(covariance.rows(), level.values.size());
    for (Index i = 0; i < covariance.rows(); ++i) {
        const double step = 0.1 * std::sqrt(std::max(0.0, covariance(i, i)));
        if (!(step > 0.0))
            continue;
        const auto moved = [&](double delta) {
            ExponentialSum sum = perturbed(refinement, record, i, delta);
            sum.amplitudes.array() *= (sum.poles_rad_s.array() * asked.onset_s).exp();
            return answer(sum, asked).values;
        };
        gradient.row(i) = (moved(step) - moved(-step)).transpose() / (2.0 * step);
    }
    level.variances = (gradient.transpose() * covariance * gradient).diagonal().cwiseMax(0.0);
    return level;
}

/// Real poles that stand out and decay, or grow by no more than their rate is uncertain; slowest
/// first.
Poles candidates(const ModelDraft &draft, const std::vector<bool> &standsOut)
{
    Poles found;
    for (std::size_t i = 0; i < draft.poles_rad_s.size(); ++i) {
        const auto at = static_cast<Index>(i);
        const double u = std::sqrt(std::max(0.0, draft.refinement->covariance(at, at)));
        const std::complex<double> s = draft.poles_rad_s[i];
        if (s.imag() == 0.0 && standsOut[i] && s.real() <= kMayGrow * u)
            found.push_back(i);
    }
    std::ranges::sort(found, {}, [&](std::size_t i) { return std::abs(draft.poles_rad_s[i]); });
    return found;
}

/// How fast the slowest of the other poles that stand out is; empty if there is none.
std::optional<double> restRate_rad_s(
    const ModelDraft &draft, const std::vector<bool> &standsOut, const std::vector<bool> &isSlow)
{
    std::optional<double> slowest;
    for (std::size_t i = 0; i < draft.poles_rad_s.size(); ++i)
        if (standsOut[i] && !isSlow[i])
            slowest = std::min(slowest.value_or(HUGE_VAL), std::abs(draft.poles_rad_s[i]));
    return slowest;
}

/// Whether every slow part changes the response beyond its uncertainty.
bool isSeen(const std::vector<Level> &levels, Index part)
{
    double weights = 0.0;
    double sum = 0.0;
    for (const Level &level : levels) {
        if (!(level.variances[1 + part] > 0.0))
            return false;
        weights += 1.0 / level.variances[1 + part];
        sum += level.values[1 + part] / level.variances[1 + part];
    }
    return std::abs(sum) > kSignificant * std::sqrt(weights);
}

/// Whether the rest alone may complete the step. The series share the rate, so their errors are
/// nearly the same and are not averaged.
bool mayBelongToTheStep(const std::vector<Level> &levels, Index part, Index parts)
{
    double excess = 0.0;
    double u = 0.0;
    for (const Level &level : levels) {
        if (level.onset.value == 0.0)
            return false;
        excess += level.values[1 + parts + part];
        u += std::sqrt(level.variances[1 + parts + part]);
    }
    return excess <= kSignificant * u;
}

/// Whether it most likely does, by the values alone: that the data do not exclude it is no reason
/// for a doubt about a pole as fast as the sensor's others.
bool likelyBelongsToTheStep(const std::vector<Level> &levels)
{
    const auto parts = static_cast<Index>(levels.front().onset.slow.size());
    Eigen::VectorXd excess = Eigen::VectorXd::Zero(parts);
    for (const Level &level : levels)
        excess += level.values.tail(parts);
    return excess.maxCoeff() <= 0.0;
}

bool completesTheStep(const std::vector<Level> &levels)
{
    const auto parts = static_cast<Index>(levels.front().onset.slow.size());
    for (Index part = 0; part < parts; ++part)
        if (!isSeen(levels, part) || !mayBelongToTheStep(levels, part, parts))
            return false;
    return true;
}

std::vector<Level> levelsWith(const ModelInput &input, const ModelDraft &draft,
    const SensorModel &model, const std::vector<bool> &isSlow)
{
    const double end_s = input.offset_s + static_cast<double>(input.samples) / input.sampleRate_Hz;
    std::vector<Level> levels;
    for (std::size_t r = 0; r < model.series.size(); ++r) {
        const SeriesFit &fit = model.series[r];
        levels.push_back(withVariances(*draft.refinement, static_cast<Index>(r), fit,
            {isSlow, fit.onset_s, end_s - fit.onset_s}));
    }
    return levels;
}

/// Sum of some of the values over the level, mean of the series.
double meanShare(const std::vector<Level> &levels, Index first, Index count)
{
    double sum = 0.0;
    for (const Level &level : levels)
        sum += level.values.segment(first, count).sum() / level.onset.value;
    return sum / static_cast<double>(levels.size());
}

void take(const ModelInput &input, const Poles &slow, const std::vector<Level> &levels,
    SensorModel &model)
{
    for (const std::size_t i : slow) {
        model.slowPoles.push_back(static_cast<Index>(i));
        model.poles[i].poleClass = PoleClass::Other;
        model.poles[i].flags.push_back(kDriftFlag);
    }
    model.drift = meanShare(levels, 1, static_cast<Index>(slow.size()));
    for (std::size_t r = 0; r < levels.size(); ++r) {
        SeriesFit &fit = model.series[r];
        fit.stepLevel = levels[r].onset.value;
        fit.u_stepLevel = std::hypot(std::sqrt(levels[r].variances[0]), input.series[r].u_baseline);
        fit.sensorStep = levels[r].onset.sensor;
    }
}

} // namespace

void describeStepLevel(const ModelInput &input, const ModelDraft &draft,
    const std::vector<bool> &standsOut, SensorModel &model)
{
    if (!isStepTreatment(input.treatment) || isThesisMode(input) || !draft.refinement
        || !draft.refinement->withConstant)
        return;
    const Poles real = candidates(draft, standsOut);
    for (std::size_t count = real.size(); count > 0; --count) {
        const Poles slow(real.begin(), real.begin() + static_cast<std::ptrdiff_t>(count));
        const std::vector<bool> isSlow = flagsOf(slow, draft.poles_rad_s.size());
        const auto rest_rad_s = restRate_rad_s(draft, standsOut, isSlow);
        const double fastest = std::abs(draft.poles_rad_s[slow.back()]);
        if (!rest_rad_s || fastest > *rest_rad_s)
            continue;
        const std::vector<Level> levels = levelsWith(input, draft, model, isSlow);
        if (!completesTheStep(levels))
            continue;
        if (fastest <= kSlower * *rest_rad_s) {
            take(input, slow, levels, model);
            return;
        }
        if (!likelyBelongsToTheStep(levels))
            continue;
        model.doubtfulPole = static_cast<Index>(slow.back());
        double share = 0.0;
        for (std::size_t r = 0; r < levels.size(); ++r)
            share += levels[r].onset.value / model.series[r].plateauGain - 1.0;
        model.doubtfulShare = share / static_cast<double>(levels.size());
    }
}

} // namespace dyncal
