// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/tube_resonances.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

constexpr int kLengthwise = 3;

void addLengthwise(std::vector<TubeResonance> &list, ResonanceKind kind, double fundamental_Hz)
{
    for (int order = 1; order <= kLengthwise; ++order)
        list.push_back({kind, order, 0, 0, order * fundamental_Hz, kind != ResonanceKind::Body});
}

/// Travel time of sound through the whole tube when the plateau ends: region 5 between wall and
/// stopped contact surface, then driver gas of region 3 (the reflected head has crossed the driver
/// by then).
double mixedTravel_s(const ShockStates &states, const GasState &expanded, double drivenLength_m,
    double driverLength_m)
{
    const double arrival_s = drivenLength_m / states.velocity_m_s;
    const double meeting_s = (drivenLength_m - states.shocked.velocity_m_s * arrival_s)
        / (states.reflectedVelocity_m_s + states.shocked.velocity_m_s);
    const double region5_m = states.reflectedVelocity_m_s * meeting_s;
    return region5_m / states.reflected.soundSpeed_m_s
        + (drivenLength_m + driverLength_m - region5_m) / expanded.soundSpeed_m_s;
}

} // namespace

const char *resonanceKindName(ResonanceKind kind)
{
    switch (kind) {
    case ResonanceKind::Body:
        return "tube-body";
    case ResonanceKind::Cavity:
        return "cavity";
    case ResonanceKind::CavityShocked:
        return "cavity-shocked";
    case ResonanceKind::CavityMixed:
        return "cavity-mixed";
    case ResonanceKind::Transverse:
        return "transverse";
    }
    return "";
}

std::string TubeResonance::label() const
{
    const std::string name = resonanceKindName(kind);
    if (kind == ResonanceKind::Transverse)
        return name + " (" + std::to_string(m) + "," + std::to_string(n) + ")";
    return name + " " + std::to_string(order);
}

const std::vector<BesselZero> &transverseZeros()
{
    // Abramowitz and Stegun, table 9.5; checked in the tests against the function itself.
    static const std::vector<BesselZero> zeros{{1, 0, 1.841183781340659}, {2, 0, 3.054236928227140},
        {0, 1, 3.831705970207512}, {3, 0, 4.201188941210528}, {4, 0, 5.317553126083994},
        {1, 1, 5.331442773525033}, {5, 0, 6.415616375700240}, {2, 1, 6.706133194158459},
        {0, 2, 7.015586669815619}, {6, 0, 7.501266144684147}, {3, 1, 8.015236598375951},
        {1, 2, 8.536316366346286}};
    return zeros;
}

std::vector<TubeResonance> tubeResonances(const ShockStates &states,
    const std::optional<GasState> &driver, const Gas &driverGas, const TubeDimensions &d)
{
    std::vector<TubeResonance> list;
    const double a5_m_s = states.reflected.soundSpeed_m_s;
    if (d.wholeLength_m) {
        addLengthwise(list, ResonanceKind::Body, d.wallSoundSpeed_m_s / (2.0 * *d.wholeLength_m));
        addLengthwise(
            list, ResonanceKind::Cavity, states.driven.soundSpeed_m_s / (2.0 * *d.wholeLength_m));
        for (std::size_t i = list.size() - kLengthwise; i < list.size(); ++i)
            list[i].followsGas = false; // a1 is the same in every shot
    }
    if (d.drivenLength_m)
        addLengthwise(list, ResonanceKind::CavityShocked, a5_m_s / (2.0 * *d.drivenLength_m));
    if (driver && d.drivenLength_m && d.driverLength_m
        && driver->pressure_Pa > states.shocked.pressure_Pa) {
        const GasState expanded
            = expandedDriver(states, driverGas, driver->pressure_Pa, driver->temperature_K);
        addLengthwise(list, ResonanceKind::CavityMixed,
            0.5 / mixedTravel_s(states, expanded, *d.drivenLength_m, *d.driverLength_m));
    }
    if (d.innerDiameter_m) {
        for (const BesselZero &zero : transverseZeros())
            list.push_back({ResonanceKind::Transverse, 0, zero.m, zero.n,
                zero.zero * a5_m_s / (std::numbers::pi * *d.innerDiameter_m), true});
    }
    std::stable_sort(list.begin(), list.end(), [](const TubeResonance &a, const TubeResonance &b) {
        return a.frequency_Hz < b.frequency_Hz;
    });
    return list;
}

std::optional<SoundSpeedTest> testSoundSpeed(const std::vector<PeakOfShot> &peaks)
{
    double weights = 0.0, meanX = 0.0, meanY = 0.0;
    for (const PeakOfShot &p : peaks) {
        const double w = std::pow(p.frequency_Hz / p.u_frequency_Hz, 2);
        if (!(w > 0.0 && std::isfinite(w) && p.soundSpeed_m_s > 0.0))
            return std::nullopt;
        weights += w;
        meanX += w * std::log(p.soundSpeed_m_s);
        meanY += w * std::log(p.frequency_Hz);
    }
    if (peaks.size() < 2)
        return std::nullopt;
    meanX /= weights;
    meanY /= weights;
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (const PeakOfShot &p : peaks) {
        const double w = std::pow(p.frequency_Hz / p.u_frequency_Hz, 2);
        const double x = std::log(p.soundSpeed_m_s) - meanX, y = std::log(p.frequency_Hz) - meanY;
        xx += w * x * x;
        xy += w * x * y;
        yy += w * y * y;
    }
    if (!(xx > 1e-12 * weights)) // sound speeds equal to one part in a million
        return std::nullopt;
    SoundSpeedTest test;
    test.slope = xy / xx;
    const double dof = static_cast<double>(peaks.size()) - 2.0;
    const double scatter = dof > 0.0 ? std::max((yy - xy * xy / xx) / dof, 1.0) : 1.0;
    test.u_slope = std::sqrt(scatter / xx);
    const auto agrees
        = [&](double value) { return std::abs(test.slope - value) <= 2.0 * test.u_slope; };
    test.followsGas = agrees(1.0) && !agrees(0.0);
    test.excludesGas = agrees(0.0) && !agrees(1.0);
    return test;
}

double sideWallLimit_Hz(double diameter_m, double velocity_m_s)
{
    constexpr double kHalfPower = 1.616339948310703; ///< x with 2 J1(x)/x = 1/sqrt(2)
    return kHalfPower / std::numbers::pi * velocity_m_s / diameter_m;
}

} // namespace dyncal
