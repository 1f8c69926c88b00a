// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/band_edges.h"

#include "core/base/constants.h"
#include "core/model_analysis/bisection.h"
#include "core/model_analysis/model_response.h"
#include "core/model_analysis/normalised_step.h"
#include "core/model_analysis/unwrapped_phase.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace dyncal {
namespace {

/// Even ones on a logarithmic scale and the resonances between them, in rising order; each computed
/// when it is asked for.
class FrequencyGrid
{
public:
    explicit FrequencyGrid(const SensorModel &model)
    {
        constexpr int kPerDecade = 400;
        const Eigen::ArrayXd rates = normalisedStep(model).poles_rad_s.cwiseAbs();
        m_from_Hz = 1e-3 * rates.minCoeff() / kTwoPi;
        m_to_Hz = 20.0 * rates.maxCoeff() / kTwoPi;
        m_steps = static_cast<Index>(std::ceil(std::log10(m_to_Hz / m_from_Hz) * kPerDecade));
        m_resonant_Hz = resonantFrequencies_Hz(model, m_from_Hz, m_to_Hz);
        for (const double f_Hz : m_resonant_Hz)
            m_resonantAt.push_back(evenUpTo(f_Hz) + static_cast<Index>(m_resonantAt.size()));
    }

    Index size() const { return m_steps + 1 + static_cast<Index>(m_resonant_Hz.size()); }

    /// i-th of them, i from 0 and below size().
    double at_Hz(Index i) const
    {
        const auto next = std::ranges::upper_bound(m_resonantAt, i);
        const auto passed = static_cast<std::size_t>(next - m_resonantAt.begin());
        if (passed > 0 && m_resonantAt[passed - 1] == i)
            return m_resonant_Hz[passed - 1];
        return even_Hz(i - static_cast<Index>(passed));
    }

private:
    double even_Hz(Index i) const
    {
        return m_from_Hz
            * std::pow(m_to_Hz / m_from_Hz, static_cast<double>(i) / static_cast<double>(m_steps));
    }

    /// How many of the even ones are not above `f_Hz`, which lies between first and last.
    Index evenUpTo(double f_Hz) const
    {
        const double share = std::log(f_Hz / m_from_Hz) / std::log(m_to_Hz / m_from_Hz);
        auto count = static_cast<Index>(share * static_cast<double>(m_steps));
        while (count > 0 && even_Hz(count - 1) > f_Hz)
            --count;
        while (count <= m_steps && even_Hz(count) <= f_Hz)
            ++count;
        return count;
    }

    double m_from_Hz = 0.0;
    double m_to_Hz = 0.0;
    Index m_steps = 0;
    std::vector<double> m_resonant_Hz;
    std::vector<Index> m_resonantAt; ///< places of these among all
};

/// |S(f)/S(0)| of a model.
class RelativeMagnitude
{
public:
    RelativeMagnitude(const SensorModel &model, ResponseTreatment treatment)
        : m_model(model)
        , m_treatment(treatment)
        , m_own(normalisedStep(model))
    {
    }

    double at(double frequency_Hz) const
    {
        if (m_model.slowPoles.empty())
            return std::abs(
                modelResponse(m_model, m_treatment, frequency_Hz) / m_model.plateauGain);
        const std::complex<double> jw(0.0, kTwoPi * frequency_Hz);
        return std::abs(
            1.0 + (m_own.amplitudes.array() * jw / (jw - m_own.poles_rad_s.array())).sum());
    }

    /// Bound of its change between two frequencies, rounding included: of S(f)/S(0) = 1 + sum of
    /// a jw/(jw - s) the derivative by jw is the sum of -a s/(jw - s)^2.
    double largestChange(double from_Hz, double to_Hz) const
    {
        constexpr double kRounding = 1e-12;
        double slope = 0.0;
        double size = 1.0;
        for (Index i = 0; i < m_own.amplitudes.size(); ++i) {
            const std::complex<double> s = m_own.poles_rad_s[i];
            const double past
                = std::max({0.0, kTwoPi * from_Hz - s.imag(), s.imag() - kTwoPi * to_Hz});
            slope += std::abs(m_own.amplitudes[i]) * std::abs(s)
                / (s.real() * s.real() + past * past);
            size += std::abs(m_own.amplitudes[i]);
        }
        return slope * kTwoPi * (to_Hz - from_Hz) + kRounding * size;
    }

private:
    const SensorModel &m_model;
    ResponseTreatment m_treatment;
    ExponentialSum m_own;
};

/// How far outside of a band a relative magnitude is: 0 at its edge, negative inside, and it
/// changes no faster than the magnitude.
using Outside = double (*)(double ratio);

/// Number of points from i on, at least the i-th itself, that are inside because the i-th is, by
/// `margin`.
Index pointsInside(
    const RelativeMagnitude &ratio, const FrequencyGrid &grid, Index i, double margin)
{
    constexpr double kShare = 0.999;
    Index count = 1;
    while (i + 2 * count <= grid.size()
        && ratio.largestChange(grid.at_Hz(i), grid.at_Hz(i + 2 * count - 1)) < kShare * margin)
        count *= 2;
    return count;
}

std::optional<double> firstExit_Hz(
    const RelativeMagnitude &ratio, const FrequencyGrid &grid, Outside outside)
{
    for (Index i = 1; i < grid.size();) {
        const double now = outside(ratio.at(grid.at_Hz(i)));
        if (now > 0.0)
            return bisect([&](double f_Hz) { return outside(ratio.at(f_Hz)); }, grid.at_Hz(i - 1),
                grid.at_Hz(i));
        i += pointsInside(ratio, grid, i, -now);
    }
    return std::nullopt;
}

} // namespace

void describeBands(
    const SensorModel &model, ResponseTreatment treatment, StepCharacteristics &result)
{
    const RelativeMagnitude ratio(model, treatment);
    const FrequencyGrid grid(model);
    const auto exit_Hz = [&](Outside outside) { return firstExit_Hz(ratio, grid, outside); };
    result.within5percent_Hz = exit_Hz([](double r) { return std::abs(r - 1.0) - 0.05; });
    result.within10percent_Hz = exit_Hz([](double r) { return std::abs(r - 1.0) - 0.10; });
    result.minus3dB_Hz = exit_Hz([](double r) { return std::numbers::sqrt2 / 2.0 - r; });
}

} // namespace dyncal
