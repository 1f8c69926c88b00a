// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/noise_density.h"

#include "core/base/constants.h"
#include "core/signal/fft.h"
#include "core/signal/power_spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace dyncal {
namespace {

/// Values of noise that are looked at: of longer records the last ones, or means of several.
constexpr Index kLongestNoise = 65536;
constexpr Index kFewestOfOctaves = 256;
constexpr Index kFirstBin = 2; ///< the trend that was taken off took the first with it
constexpr double kTopOfOctaves = 0.2; ///< above, the autoregressive model resolves all
constexpr double kSigmasApart = 2.0; ///< by which the octaves must differ to be believed
constexpr double kOctavesBeside = 1.75; ///< octaves to either side that make one value

/// Of a mean of neighbouring bins behind a Hann window, whose powers are correlated by 4/9 and
/// 1/36.
double dofOfBins(Index bins)
{
    const double n = static_cast<double>(bins);
    return 2.0 * n / (1.0 + 0.94 * (1.0 - 1.0 / n));
}

/// Means of so many samples each, as many as an FFT takes fast.
Eigen::VectorXd lastMeansOf(const Eigen::VectorXd &noise, Index samples)
{
    Index count = noise.size() / samples;
    while (count > 1 && fastFftLength(count) != count)
        --count;
    return noise.tail(count * samples).reshaped(samples, count).colwise().mean();
}

} // namespace

NoiseDensity::NoiseDensity(const WindowedResponse &response)
    : m_rate_Hz(response.sampleRate_Hz)
    , m_count(response.noise.size())
{
    const double noiseSd = response.noiseSd / std::abs(response.valueScale);
    m_white = noiseSd * noiseSd;
    if (m_count < 2)
        return;
    const NoiseCovariance covariance = noiseCovariance(
        response.noise.tail(std::min(kLongestNoise, m_count)), kLargestNoiseModelOrder);
    m_model = chooseAutoregressiveModels({covariance}, kLargestNoiseModelOrder).front();
    m_white = std::max(0.0, m_white - covariance.values[0]);
    findOctaves(response.noise);
    m_ofBaseline = response.baselineVarianceFactor * ofMean(m_count, m_count)
        + response.roundingSd * response.roundingSd;
}

void NoiseDensity::findOctaves(const Eigen::VectorXd &noise)
{
    if (noise.size() < kFewestOfOctaves)
        return;
    const Index samples = (noise.size() + kLongestNoise - 1) / kLongestNoise;
    const double rate_Hz = m_rate_Hz / static_cast<double>(samples);
    SpectrumSettings settings;
    settings.taper = Taper::Hann;
    const auto spectrum = computePowerSpectrum(lastMeansOf(noise, samples), rate_Hz, settings);
    if (!spectrum)
        return; // a sample that is no number
    const Eigen::VectorXd power = 0.5 * m_rate_Hz * spectrum->psd; // 1 for white noise of 1
    const double bin_Hz = spectrum->frequency_Hz[1];
    for (Index k = kFirstBin; 2.0 * static_cast<double>(k) * bin_Hz < kTopOfOctaves * rate_Hz;
         k *= 2) {
        const double mean = power.segment(k, k).mean();
        if (!(mean > 0.0))
            return;
        const double dof = dofOfBins(k);
        // The mean of the logarithm of a chi-square variable over its dof is about -1/dof.
        const double centre_Hz = bin_Hz * (1.5 * static_cast<double>(k) - 0.5);
        const double logDensity = std::log(mean) + 1.0 / dof;
        m_octaves.push_back(
            {centre_Hz, logDensity, dof, logDensity - std::log(modelAt(centre_Hz))});
    }
}

double NoiseDensity::modelAt(double frequency_Hz) const
{
    const double x = kTwoPi * frequency_Hz / m_rate_Hz;
    std::complex<double> filter = 1.0;
    for (Index i = 0; i < m_model.order(); ++i)
        filter += m_model.coefficients[i] * std::polar(1.0, -x * static_cast<double>(i + 1));
    return m_model.innovationVariance / std::norm(filter);
}

/// A line through the logarithms of the octaves about the frequency.
NoiseDensity::Value NoiseDensity::octavesAt(double frequency_Hz) const
{
    const double low_Hz = std::max(frequency_Hz, m_octaves.front().centre_Hz);
    double w = 0.0, wx = 0.0, wxx = 0.0, wy = 0.0, wxy = 0.0;
    const auto forNear = [&](const auto &use) {
        for (const Octave &octave : m_octaves) {
            const double x = std::log2(octave.centre_Hz / low_Hz);
            if (std::abs(x) < kOctavesBeside)
                use(octave, x, octave.dof * (1.0 - std::abs(x) / kOctavesBeside));
        }
    };
    forNear([&](const Octave &octave, double x, double weight) {
        w += weight;
        wx += weight * x;
        wxx += weight * x * x;
        wy += weight * octave.logDensity;
        wxy += weight * x * octave.logDensity;
    });
    const double spread = w * wxx - wx * wx;
    if (!(spread > 0.0))
        return {std::exp(wy / w), w};
    const double at0 = (wxx * wy - wx * wxy) / spread;
    const double slope = (w * wxy - wx * wy) / spread;
    double variance = 0.0;
    forNear([&](const Octave &octave, double x, double weight) {
        const double share = weight * (wxx - wx * x) / spread;
        variance += share * share * 2.0 / octave.dof;
    });
    const double beyond = std::min(0.0, std::log2(frequency_Hz / low_Hz));
    return {std::exp(at0 + slope * std::max(beyond, -1.0)), 2.0 / variance};
}

/// Whether the octaves about the frequency differ from the model: chi-square of their logarithms.
bool NoiseDensity::differsFromModel(double frequency_Hz) const
{
    double chiSquare = 0.0, octaves = 0.0;
    for (const Octave &octave : m_octaves) {
        const double x = std::log2(octave.centre_Hz / frequency_Hz);
        if (x > kOctavesBeside || (x < -kOctavesBeside && &octave != &m_octaves.front()))
            continue;
        chiSquare += 0.5 * octave.dof * octave.aboveModel * octave.aboveModel;
        octaves += 1.0;
    }
    return chiSquare > octaves + kSigmasApart * std::sqrt(2.0 * octaves);
}

NoiseDensity::Value NoiseDensity::at(double frequency_Hz) const
{
    if (m_count < 2)
        return {m_white, std::numeric_limits<double>::infinity()};
    Value found{modelAt(frequency_Hz),
        static_cast<double>(std::min(kLongestNoise, m_count))
            / static_cast<double>(m_model.order() + 1)};
    if (!m_octaves.empty() && frequency_Hz < m_octaves.back().centre_Hz
        && differsFromModel(frequency_Hz))
        found = octavesAt(frequency_Hz);
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
