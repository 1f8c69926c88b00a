// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/aperiodic_start.h"

#include "core/realization/refinement/pole_refinement.h"
#include "core/realization/refinement/refinement_problem.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

using Complex = std::complex<double>;
using Poles = std::vector<Complex>;

constexpr double kCritical = 0.9; ///< damping ratio: from here on a pair may be two real poles
constexpr double kApart = 1.6; ///< |s| of two poles over the slower one, half a factor of 2.5

/// What the draft says of a response without ringing.
struct Aperiodic
{
    Poles unsettled;
    double slowest_rad_s = 0.0; ///< rate of the slowest settled pole
};

/// A pole of the sampled plane without a continuous partner, or next to it.
bool isAtNyquist(Complex s, double dt_s)
{
    return std::abs(s.imag()) * dt_s > 0.95 * std::numbers::pi;
}

/// Empty where the response rings or where no settled pole stands out.
std::optional<Aperiodic> aperiodicPart(const ModelInput &input, const ModelDraft &draft)
{
    const std::vector<bool> standsOut = standingOut(input, draft);
    const double dt_s = sampleInterval_s(input);
    const double length_s = static_cast<double>(input.samples) * dt_s;
    Aperiodic part{{}, HUGE_VAL};
    for (std::size_t i = 0; i < standsOut.size(); ++i) {
        const Complex s = draft.poles_rad_s[i];
        if (!standsOut[i] || isAtNyquist(s, dt_s))
            continue;
        if (s.imag() == 0.0 && isRelaxing(s.real() * length_s))
            part.unsettled.push_back(s);
        else if (s.imag() == 0.0)
            part.slowest_rad_s = std::min(part.slowest_rad_s, std::abs(s));
        else if (-s.real() > kCritical * std::abs(s))
            part.slowest_rad_s = std::min(part.slowest_rad_s, std::abs(s) / kApart);
        else
            return std::nullopt;
    }
    return std::isfinite(part.slowest_rad_s) ? std::optional(part) : std::nullopt;
}

/// Two settled poles, the slower one at the rate given: real and near, real and far apart, a pair.
std::vector<Poles> startsOfTwo(double slow_rad_s)
{
    constexpr double kFarApart = 8.0;
    const double ring = std::sqrt(1.0 - kCritical * kCritical);
    const Complex pair = kApart * slow_rad_s * Complex(-kCritical, ring);
    return {{-slow_rad_s, -kApart * kApart * slow_rad_s}, {-slow_rad_s, -kFarApart * slow_rad_s},
        {pair, std::conj(pair)}};
}

constexpr double kLeast = 0.3; ///< of the largest value, beside what does not ring
constexpr double kNoise = 6.0; ///< standard deviations

/// Whether a record swings about its end so often that what rings() looks for is sure: n real poles
/// and a constant cross a level n times at most.
bool swings(const RefinementRecord &record)
{
    constexpr int kCrossings = 8;
    const Eigen::VectorXd &y = record.y;
    const double end = y.tail(std::max<Index>(1, y.size() / 10)).mean();
    const double least = kLeast * y.cwiseAbs().maxCoeff() + kNoise / record.weight;
    int crossings = 0;
    double side = 0.0;
    for (Index k = 0; k < y.size() && crossings < kCrossings; ++k) {
        if (std::abs(y[k] - end) <= least || (y[k] - end) * side > 0.0)
            continue;
        crossings += side != 0.0 ? 1 : 0;
        side = y[k] - end;
    }
    return crossings == kCrossings;
}

/// Whether a record leaves so much beside one pole that it can only ring: two real poles, or a pair
/// damped as here, leave less than a fifth of it.
bool rings(const Refinement &onePole, const std::vector<RefinementRecord> &records)
{
    constexpr Index kLooks = 4000; ///< at a record, evenly spread
    for (std::size_t r = 0; r < records.size(); ++r) {
        const RefinementRecord &record = records[r];
        const Index stride = std::max<Index>(1, record.y.size() / kLooks);
        double largest = 0.0;
        double beside = 0.0;
        for (Index k = 0; k < record.y.size(); k += stride) {
            const double t_s = static_cast<double>(k) / record.rate_Hz;
            largest = std::max(largest, std::abs(record.y[k]));
            beside = std::max(beside, std::abs(record.y[k] - onePole.records[r].value(t_s)));
        }
        if (beside > kLeast * largest + kNoise / record.weight)
            return true;
    }
    return false;
}

double bicOf(const Refinement &fit, Index samples)
{
    const auto count = static_cast<double>(samples);
    const auto parameters = static_cast<double>(fit.covariance.rows());
    const double chiSquare = fit.residualToNoise * fit.residualToNoise;
    return count * std::log(chiSquare * (1.0 - parameters / count)) + parameters * std::log(count);
}

} // namespace

bool areWithin(const std::vector<RefinementRecord> &records, const Poles &poles)
{
    double rate_Hz = HUGE_VAL;
    for (const RefinementRecord &record : records)
        rate_Hz = std::min(rate_Hz, record.rate_Hz);
    return std::ranges::is_sorted(poles, {}, [](Complex s) { return std::abs(s); })
        && std::abs(poles.back()) < std::numbers::pi * rate_Hz;
}

std::optional<Refinement> refineAperiodic(const ModelInput &input, const ModelDraft &draft,
    const std::vector<RefinementRecord> &records, const JobControl &control)
{
    constexpr double kDescribes = 1.2; // residual over noise
    const auto part = isStepTreatment(input.treatment) && !isThesisMode(input)
        ? aperiodicPart(input, draft)
        : std::nullopt;
    if (!part || std::ranges::any_of(records, swings))
        return std::nullopt;
    Index samples = 0;
    for (const RefinementRecord &record : records)
        samples += record.y.size();
    const auto fitFrom = [&](Poles start) {
        start.insert(start.begin(), part->unsettled.begin(), part->unsettled.end());
        return refinePoles(records, start, true, control, RealPoles::Anywhere);
    };
    // One pole alone converges from afar, and lies near the slower of two.
    std::optional<Refinement> best = fitFrom({-part->slowest_rad_s});
    if (best && rings(*best, records)) // an order too low to show it; further starts are in vain
        return std::nullopt;
    const double slow_rad_s = best ? std::abs(best->poles_rad_s.back()) : part->slowest_rad_s;
    const auto isBetter = [&](const Refinement &fit) {
        return areWithin(records, fit.poles_rad_s)
            && (!best || bicOf(fit, samples) < bicOf(*best, samples));
    };
    for (const Poles &start : startsOfTwo(slow_rad_s))
        if (auto fit = fitFrom(start); fit && isBetter(*fit))
            best = std::move(fit);
    return best && best->residualToNoise < kDescribes && areWithin(records, best->poles_rad_s)
        ? std::move(best)
        : std::nullopt;
}

} // namespace dyncal
