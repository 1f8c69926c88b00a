// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/onset_level.h"

#include "core/base/index.h"

#include <cmath>
#include <complex>

namespace dyncal {
namespace {

using Complex = std::complex<double>;

/// h_0 + sum h_i s / (s - s_i), over L: what stands before the sensor, at s.
Complex before(
    const OnsetLevel &level, double constant, const std::vector<Complex> &slow, Complex s)
{
    Complex sum = constant;
    for (std::size_t i = 0; i < slow.size(); ++i)
        sum += level.slow[i] * s / (s - slow[i]);
    return sum / level.value;
}

/// g(s) of the sensor's part.
double gain(const ExponentialSum &sensor, double s)
{
    Complex sum = 1.0;
    for (Index k = 0; k < sensor.poles_rad_s.size(); ++k)
        sum += sensor.amplitudes[k] * s / (s - sensor.poles_rad_s[k]);
    return sum.real();
}

} // namespace

OnsetLevel onsetLevel(const ExponentialSum &sum, const std::vector<bool> &isSlow)
{
    // The slow part hardly changes the sensor's amplitudes, so this converges by a factor of at
    // least ten in each round.
    constexpr int kRounds = 20;
    std::vector<Complex> slow;
    std::vector<double> slowAmplitudes;
    std::vector<Index> own;
    for (Index i = 0; i < sum.poles_rad_s.size(); ++i) {
        if (isSlow[static_cast<std::size_t>(i)]) {
            slow.push_back(sum.poles_rad_s[i]);
            slowAmplitudes.push_back(sum.amplitudes[i].real());
        } else {
            own.push_back(i);
        }
    }
    OnsetLevel level{sum.constant, slowAmplitudes, {}};
    level.sensor = {1.0, sum.poles_rad_s(own), sum.amplitudes(own)};
    for (const double amplitude : slowAmplitudes)
        level.value += amplitude;
    const Eigen::VectorXcd amplitudes = level.sensor.amplitudes;
    for (int round = 0; round < kRounds && level.value != 0.0; ++round) {
        for (Index k = 0; k < amplitudes.size(); ++k)
            level.sensor.amplitudes[k] = amplitudes[k]
                / (level.value * before(level, sum.constant, slow, level.sensor.poles_rad_s[k]));
        double value = sum.constant;
        for (std::size_t i = 0; i < slow.size(); ++i) {
            level.slow[i] = slowAmplitudes[i] / gain(level.sensor, slow[i].real());
            value += level.slow[i];
        }
        if (slow.empty() || value == level.value || !std::isfinite(value))
            break;
        level.value = value;
    }
    if (!std::isfinite(level.value))
        level.value = 0.0;
    return level;
}

} // namespace dyncal
