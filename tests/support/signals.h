// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/capture/capture_set.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// Signals whose truth is known in closed form, for tests of the method.
namespace dyncal::testing {

/// Standard normal numbers that are the same with every standard library (std::normal_distribution
/// is not): Box-Muller on std::mt19937_64, whose sequence the standard fixes.
class Gaussian
{
public:
    explicit Gaussian(std::uint64_t seed)
        : m_bits(seed)
    {
    }

    double operator()()
    {
        const double radius = std::sqrt(-2.0 * std::log(uniform()));
        return radius * std::cos(2.0 * std::numbers::pi * uniform());
    }

    Eigen::VectorXd vector(Index size, double sd)
    {
        return Eigen::VectorXd::NullaryExpr(size, [&](Index) { return sd * (*this)(); });
    }

    double uniform() { return (static_cast<double>(m_bits() >> 11U) + 0.5) * 0x1p-53; } ///< (0, 1)

private:
    std::mt19937_64 m_bits;
};

/// A sensor of second order with unit gain, 0 < zeta < 1.
struct SecondOrder
{
    double f0_Hz = 0.0;
    double zeta = 0.0;

    double w0_rad_s() const { return 2.0 * std::numbers::pi * f0_Hz; }
    double ringing_Hz() const { return f0_Hz * std::sqrt(1.0 - zeta * zeta); }

    /// Response at `t_s` to a unit step at 0.
    double step(double t_s) const
    {
        if (t_s <= 0.0)
            return 0.0;
        const double root = std::sqrt(1.0 - zeta * zeta);
        const double angle = w0_rad_s() * root * t_s;
        return 1.0
            - std::exp(-zeta * w0_rad_s() * t_s)
            * (std::cos(angle) + zeta / root * std::sin(angle));
    }

    /// Response to an impulse at 0, scaled to a peak near 1: e^(-zeta w0 t) sin(wd t).
    double decay(double t_s) const
    {
        if (t_s <= 0.0)
            return 0.0;
        return std::exp(-zeta * w0_rad_s() * t_s)
            * std::sin(2.0 * std::numbers::pi * ringing_Hz() * t_s);
    }
};

/// A record of one shot: `arrival_s` of rest, then a sensor's response to a step.
struct StepRecord
{
    SecondOrder sensor{100e3, 0.05};
    double rate_Hz = 10e6;
    double duration_s = 4e-3;
    double arrival_s = 4e-4; ///< after the first sample
    double baseline = 0.0;
    double step = 1.0;
    double noiseSd = 0.0; ///< in the unit of `step`
    std::uint64_t seed = 1;

    Eigen::VectorXd values() const
    {
        Gaussian noise(seed);
        const auto size = static_cast<Index>(std::llround(duration_s * rate_Hz));
        return Eigen::VectorXd::NullaryExpr(size, [&](Index i) {
            const double t_s = static_cast<double>(i) / rate_Hz - arrival_s;
            return baseline + step * sensor.step(t_s) + noiseSd * noise();
        });
    }
};

/// Channel of doubles, unit V, scale 1.
inline Channel doubleChannel(const Eigen::VectorXd &values, double rate_Hz, double t0_s = 0.0)
{
    Channel channel;
    channel.name = "DUT";
    channel.role = ChannelRole::Dut;
    channel.samples = RawSamples(std::vector<double>(values.begin(), values.end()));
    channel.sampleRate_Hz = rate_Hz;
    channel.t0_s = t0_s;
    return channel;
}

/// Channel as a converter of `bits` over +-fullScale would record it, rails known.
inline Channel countsChannel(
    const Eigen::VectorXd &values, double rate_Hz, double fullScale, int bits, double t0_s = 0.0)
{
    const double top = std::ldexp(1.0, bits - 1) - 1.0;
    const double lsb = fullScale / (top + 1.0);
    std::vector<std::int16_t> counts;
    counts.reserve(static_cast<std::size_t>(values.size()));
    for (const double value : values)
        counts.push_back(
            static_cast<std::int16_t>(std::clamp(std::nearbyint(value / lsb), -top - 1.0, top)));
    Channel channel = doubleChannel({}, rate_Hz, t0_s);
    channel.samples = RawSamples(std::move(counts));
    channel.polynomial = {0.0, lsb};
    channel.adcMin = -top - 1.0;
    channel.adcMax = top;
    channel.adcBits = bits;
    return channel;
}

inline Shot shotOf(Channel channel, std::string label = "shot")
{
    Shot shot;
    shot.label = std::move(label);
    shot.channels.push_back(std::move(channel));
    return shot;
}

inline CaptureSet captureSetOf(const std::vector<Channel> &channels)
{
    CaptureSet set;
    for (const Channel &channel : channels)
        set.shots.push_back(shotOf(channel, "shot " + std::to_string(set.shots.size() + 1)));
    return set;
}

/// Whether a list of findings holds the id.
template <typename FindingList>
bool hasFinding(const FindingList &findings, const std::string &id)
{
    return std::any_of(
        findings.begin(), findings.end(), [&](const auto &finding) { return finding.id == id; });
}

} // namespace dyncal::testing
