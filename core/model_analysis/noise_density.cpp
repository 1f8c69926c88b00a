// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/noise_density.h"

#include "core/base/constants.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace dyncal {
namespace {

constexpr Index kFactor = 8;
constexpr Index kFewest = 100; ///< values of which a density is still made
constexpr double kHighestOfRate = 0.1; ///< means of samples follow the noise up to there
constexpr double kSigmasApart = 2.5; ///< by which a slower layer must differ to be believed

Eigen::VectorXd meansOf(const Eigen::VectorXd &values)
{
    const Index count = values.size() / kFactor;
    return values.head(count * kFactor).reshaped(kFactor, count).colwise().mean();
}

} // namespace

NoiseDensity::NoiseDensity(const WindowedResponse &response)
    : m_rate_Hz(response.sampleRate_Hz)
{
    Eigen::VectorXd values = response.noise;
    Layer layer{m_rate_Hz, 1.0, values.size(), {}};
    double recorded = 0.0;
    while (layer.count >= (m_layers.empty() ? 2 : kFewest)) {
        const NoiseCovariance covariance = noiseCovariance(values, kLargestNoiseModelOrder);
        if (m_layers.empty())
            recorded = covariance.values[0];
        layer.model = chooseAutoregressiveModels({covariance}, kLargestNoiseModelOrder).front();
        m_layers.push_back(layer);
        values = meansOf(values);
        layer.rate_Hz /= static_cast<double>(kFactor);
        layer.samples *= static_cast<double>(kFactor);
        layer.count = values.size();
    }
    const double noiseSd = response.noiseSd / std::abs(response.valueScale);
    m_white = std::max(0.0, noiseSd * noiseSd - recorded);
    if (!m_layers.empty())
        m_ofBaseline = ofMean(response.noise.size(), response.noise.size())
            + response.roundingSd * response.roundingSd;
}

double NoiseDensity::densityOf(const Layer &layer, double frequency_Hz)
{
    const double x = kTwoPi * frequency_Hz / layer.rate_Hz;
    std::complex<double> filter = 1.0;
    for (Index i = 0; i < layer.model.order(); ++i)
        filter += layer.model.coefficients[i] * std::polar(1.0, -x * static_cast<double>(i + 1));
    return layer.samples * layer.model.innovationVariance / std::norm(filter);
}

NoiseDensity::Value NoiseDensity::at(double frequency_Hz) const
{
    if (m_layers.empty())
        return {m_white, std::numeric_limits<double>::infinity()};
    Value found{densityOf(m_layers.front(), frequency_Hz), m_layers.front().dof()};
    for (const Layer &slower : m_layers) {
        if (frequency_Hz > kHighestOfRate * slower.rate_Hz)
            break;
        const double density = densityOf(slower, frequency_Hz);
        const double scatter = std::sqrt(2.0 / found.dof + 2.0 / slower.dof());
        if (std::abs(std::log(density / found.variance)) > kSigmasApart * scatter)
            found = {density, slower.dof()};
    }
    found.variance += m_white;
    return found;
}

double NoiseDensity::ofMean(Index samples, Index apart) const
{
    if (samples == 0)
        return 0.0;
    constexpr double kStep = 2.0;
    const double perHz = 2.0 / m_rate_Hz;
    const double lowest_Hz = 0.5 * m_rate_Hz / static_cast<double>(std::max(samples, apart));
    double upper_Hz = 0.5 * m_rate_Hz / static_cast<double>(samples);
    double sum = 0.0;
    for (; upper_Hz > lowest_Hz; upper_Hz /= kStep) {
        const double lower_Hz = std::max(lowest_Hz, upper_Hz / kStep);
        sum += at(std::sqrt(lower_Hz * upper_Hz)).variance * (upper_Hz - lower_Hz) * perHz;
    }
    return sum + at(lowest_Hz).variance * lowest_Hz * perHz;
}

} // namespace dyncal
