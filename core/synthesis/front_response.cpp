// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/front_response.h"

#include "core/base/constants.h"
#include "core/base/index.h"
#include "core/base/portable_math.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace dyncal {
namespace {

constexpr int kLeastNodes = 40;
constexpr int kMostNodes = 2000;

std::complex<double> complexExp(std::complex<double> z)
{
    const double magnitude = portableExp(z.real());
    const SineCosine angle = portableSineCosine(z.imag());
    return {magnitude * angle.cosine, magnitude * angle.sine};
}

/// (e^z - 1)/z, 1 at 0; by its series where the difference would lose digits.
std::complex<double> meanExponential(std::complex<double> z)
{
    constexpr double kNear = 0.5;
    constexpr int kTerms = 16;
    if (std::norm(z) >= kNear * kNear)
        return (complexExp(z) - 1.0) / z;
    std::complex<double> sum(1.0, 0.0);
    for (int n = kTerms; n >= 1; --n)
        sum = 1.0 + sum * z / static_cast<double>(n + 1);
    return sum;
}

/// Angle from 0 to pi/4 whose sine is given, by Newton's method.
double angleOfSine(double sine)
{
    constexpr int kSteps = 6;
    double angle = sine;
    for (int i = 0; i < kSteps; ++i) {
        const SineCosine at = portableSineCosine(angle);
        angle += (sine - at.sine) / at.cosine;
    }
    return angle;
}

/// theta with cos(theta) = 1 - 2 share: how far a front is when that share of its time is over.
double sweptAngle(double share)
{
    if (share <= 0.5)
        return 2.0 * angleOfSine(std::sqrt(share));
    return std::numbers::pi - 2.0 * angleOfSine(std::sqrt(1.0 - share));
}

} // namespace

double tiltDuration_s(double angle_deg, double diameter_m, double velocity_m_s)
{
    return diameter_m * portableSineCosine(angle_deg * kTwoPi / 360.0).sine / velocity_m_s;
}

FrontResponse::FrontResponse(StepResponse response, const std::optional<Front> &front)
    : m_response(std::move(response))
    , m_front(front)
    , m_settled(m_response)
{
    if (!front)
        return;
    if (front->kind == Front::Kind::Tilt) {
        // As many as it takes to follow the fastest exponential over half the front.
        const double turns = m_response.fastestPole_rad_s() * front->duration_s;
        m_nodes = gaussLegendre(
            std::min(kMostNodes, kLeastNodes + static_cast<int>(std::min(turns, 1e6))));
    }
    m_settled = weightedAfter(front->duration_s);
}

/// Nodes and weights by Newton's method on the Legendre polynomial.
std::vector<FrontResponse::Node> FrontResponse::gaussLegendre(int count)
{
    constexpr int kSteps = 8;
    std::vector<Node> nodes;
    for (int i = 1; i <= count; ++i) {
        double x = portableSineCosine(std::numbers::pi * (i - 0.25) / (count + 0.5)).cosine;
        double slope = 1.0;
        for (int step = 0; step < kSteps; ++step) {
            double value = 1.0;
            double before = 0.0;
            for (int n = 1; n <= count; ++n)
                before
                    = std::exchange(value, ((2.0 * n - 1.0) * x * value - (n - 1.0) * before) / n);
            slope = count * (x * value - before) / (x * x - 1.0);
            x -= value / slope;
        }
        nodes.push_back({x, 2.0 / ((1.0 - x * x) * slope * slope)});
    }
    return nodes;
}

/// Integral over the time v that has come so far of e^(s (elapsed - v)) / duration.
std::complex<double> FrontResponse::rampWeight(
    std::complex<double> pole_per_s, double elapsed_s) const
{
    return elapsed_s / m_front->duration_s * meanExponential(pole_per_s * elapsed_s);
}

/// The same with the growth of a tilt: (2/pi) sin^2(theta) dtheta, v = duration sin^2(theta/2).
std::complex<double> FrontResponse::tiltWeight(
    std::complex<double> pole_per_s, double elapsed_s) const
{
    const double swept = sweptAngle(std::min(elapsed_s / m_front->duration_s, 1.0));
    std::complex<double> sum(0.0, 0.0);
    for (const Node &node : m_nodes) {
        const SineCosine half = portableSineCosine(0.25 * swept * (1.0 + node.position));
        const double sine = 2.0 * half.sine * half.cosine;
        const double come_s = m_front->duration_s * half.sine * half.sine;
        sum += node.weight * sine * sine * complexExp(pole_per_s * (elapsed_s - come_s));
    }
    return std::numbers::inv_pi * swept * sum;
}

/// Its value at 0 is that of the convolution when `elapsed_s` of the front have come.
StepResponse FrontResponse::weightedAfter(double elapsed_s) const
{
    return m_response.weighted([&](std::complex<double> pole_per_s) {
        return m_front->kind == Front::Kind::Ramp ? rampWeight(pole_per_s, elapsed_s)
                                                  : tiltWeight(pole_per_s, elapsed_s);
    });
}

double FrontResponse::at(double time_s) const
{
    if (time_s >= half_s())
        return m_settled.at(time_s - half_s());
    return time_s <= -half_s() ? 0.0 : weightedAfter(time_s + half_s()).at(0.0);
}

void FrontResponse::addTo(
    std::span<double> values, double firstTime_s, double sampleRate_Hz, double scale) const
{
    m_settled.addTo(values, firstTime_s - half_s(), sampleRate_Hz, scale);
    if (!m_front)
        return;
    // The samples of the front itself, up to the one at which the settled part began.
    const double count = static_cast<double>(values.size());
    const auto begin = [&](double time_s) {
        return static_cast<std::size_t>(std::clamp(std::ceil(-(time_s)*sampleRate_Hz), 0.0, count));
    };
    const double start_s = firstTime_s + half_s();
    for (std::size_t i = begin(start_s); i < begin(firstTime_s - half_s()); ++i) {
        const double elapsed_s = start_s + static_cast<double>(i) / sampleRate_Hz;
        values[i] += scale * weightedAfter(std::clamp(elapsed_s, 0.0, m_front->duration_s)).at(0.0);
    }
}

} // namespace dyncal
