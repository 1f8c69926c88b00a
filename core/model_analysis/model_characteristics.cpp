// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/model_characteristics.h"

#include "core/base/constants.h"
#include "core/model_analysis/bisection.h"
#include "core/model_analysis/model_response.h"
#include "core/model_analysis/step_scan.h"
#include "core/model_analysis/unwrapped_phase.h"
#include "core/realization/exponentials/exponential_sum.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace dyncal {
namespace {

bool hasStepResponse(const SensorModel &model, ResponseTreatment treatment)
{
    if (!isStepTreatment(treatment) || model.diverges || model.level() == 0.0)
        return false;
    const Eigen::VectorXcd poles = normalisedStep(model).poles_rad_s;
    return poles.size() > 0 && (poles.array().real() < 0.0).all();
}

/// 400 points per decade from 1e-3 of the slowest to 20 times the fastest pole, and further ones at
/// every resonance, which may be narrower than their spacing; in rising order, as far as asked for.
class FrequencyGrid
{
public:
    explicit FrequencyGrid(const SensorModel &model)
    {
        constexpr int kPerDecade = 400;
        const Eigen::ArrayXd rates = normalisedStep(model).poles_rad_s.cwiseAbs();
        m_from_Hz = 1e-3 * rates.minCoeff() / kTwoPi;
        m_to_Hz = 20.0 * rates.maxCoeff() / kTwoPi;
        m_steps = static_cast<int>(std::ceil(std::log10(m_to_Hz / m_from_Hz) * kPerDecade));
        m_resonant_Hz = resonantFrequencies_Hz(model, m_from_Hz, m_to_Hz);
        std::ranges::sort(m_resonant_Hz);
    }

    std::size_t size() const
    {
        return static_cast<std::size_t>(m_steps) + 1 + m_resonant_Hz.size();
    }

    /// i-th of them, i below size().
    double at_Hz(std::size_t i)
    {
        while (m_grid_Hz.size() <= i)
            m_grid_Hz.push_back(next_Hz());
        return m_grid_Hz[i];
    }

private:
    double next_Hz()
    {
        const bool isDone = m_even > m_steps;
        const double even_Hz = isDone
            ? 0.0
            : m_from_Hz * std::pow(m_to_Hz / m_from_Hz, static_cast<double>(m_even) / m_steps);
        if (m_taken < m_resonant_Hz.size() && (isDone || m_resonant_Hz[m_taken] < even_Hz))
            return m_resonant_Hz[m_taken++];
        ++m_even;
        return even_Hz;
    }

    double m_from_Hz = 0.0;
    double m_to_Hz = 0.0;
    int m_steps = 0;
    int m_even = 0;
    std::size_t m_taken = 0;
    std::vector<double> m_resonant_Hz;
    std::vector<double> m_grid_Hz;
};

void describeBands(
    const SensorModel &model, ResponseTreatment treatment, StepCharacteristics &result)
{
    const ExponentialSum own = model.sensorStep;
    const auto ratioAt = [&](double frequency_Hz) {
        if (model.slowPoles.empty())
            return std::abs(modelResponse(model, treatment, frequency_Hz) / model.plateauGain);
        const std::complex<double> jw(0.0, kTwoPi * frequency_Hz);
        return std::abs(1.0 + (own.amplitudes.array() * jw / (jw - own.poles_rad_s.array())).sum());
    };
    FrequencyGrid grid(model);
    std::vector<double> ratios; // as far as one of the edges asked for them
    const auto ratioOf = [&](std::size_t i) {
        while (ratios.size() <= i)
            ratios.push_back(ratioAt(grid.at_Hz(ratios.size())));
        return ratios[i];
    };
    /// Lowest frequency at which `leaves` of the relative magnitude turns positive.
    const auto firstExit
        = [&](const std::function<double(double)> &leaves) -> std::optional<double> {
        for (std::size_t i = 1; i < grid.size(); ++i) {
            if (leaves(ratioOf(i)) > 0.0)
                return bisect([&](double f_Hz) { return leaves(ratioAt(f_Hz)); }, grid.at_Hz(i - 1),
                    grid.at_Hz(i));
        }
        return std::nullopt;
    };
    result.within5percent_Hz = firstExit([](double ratio) { return std::abs(ratio - 1.0) - 0.05; });
    result.within10percent_Hz
        = firstExit([](double ratio) { return std::abs(ratio - 1.0) - 0.10; });
    result.minus3dB_Hz = firstExit([](double ratio) { return std::numbers::sqrt2 / 2.0 - ratio; });
}

} // namespace

ExponentialSum normalisedStep(const SensorModel &model)
{
    if (!model.slowPoles.empty())
        return model.sensorStep;
    ExponentialSum sum{1.0, Eigen::VectorXcd(model.amplitudes.size()), model.amplitudes};
    for (Index i = 0; i < sum.poles_rad_s.size(); ++i)
        sum.poles_rad_s[i] = model.poles[static_cast<std::size_t>(i)].s_rad_s;
    sum.amplitudes /= model.plateauGain;
    return sum;
}

StepCharacteristics stepCharacteristics(const SensorModel &model, ResponseTreatment treatment)
{
    if (!hasStepResponse(model, treatment))
        return {};
    StepCharacteristics result = describedStep(normalisedStep(model), kSettledRange);
    describeBands(model, treatment, result);
    return result;
}

std::optional<double> settlingTime_s(
    const SensorModel &model, ResponseTreatment treatment, double settled)
{
    if (!hasStepResponse(model, treatment))
        return std::nullopt;
    return describedStep(normalisedStep(model), settled).settlingTime_s;
}

} // namespace dyncal
