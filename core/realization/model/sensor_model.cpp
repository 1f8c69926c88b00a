// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/sensor_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace dyncal {
namespace {

/// Amplitude of a pole that at least half of the shots have, in units of each shot's plateau if it
/// has one: the median, for an even number the smaller middle value.
double commonAmplitude(
    const std::vector<Pole> &poles, const std::vector<SeriesFit> &series, std::size_t pole)
{
    std::vector<double> amplitudes;
    for (const SeriesFit &fit : series) {
        if (static_cast<Index>(pole) >= fit.amplitudes.size())
            return poles[pole].amplitude;
        const double unit = fit.level() != 0.0 ? std::abs(fit.level()) : 1.0;
        amplitudes.push_back(std::abs(fit.amplitudes[static_cast<Index>(pole)]) / unit);
    }
    if (amplitudes.empty())
        return poles[pole].amplitude;
    const auto middle = amplitudes.begin() + (std::ssize(amplitudes) - 1) / 2;
    std::ranges::nth_element(amplitudes, middle);
    return *middle;
}

} // namespace

const char *poleClassName(PoleClass poleClass)
{
    switch (poleClass) {
    case PoleClass::Sensor:
        return "sensor";
    case PoleClass::Step:
        return "step";
    case PoleClass::Nyquist:
        return "nyquist";
    case PoleClass::Unstable:
        return "unstable";
    case PoleClass::Other:
        break;
    }
    return "other";
}

const Pole *mainPole(const std::vector<Pole> &poles, const std::vector<SeriesFit> &series)
{
    const Pole *main = nullptr;
    double most = 0.0;
    for (std::size_t i = 0; i < poles.size(); ++i) {
        const Pole &pole = poles[i];
        if (pole.poleClass != PoleClass::Sensor || pole.s_rad_s.imag() <= 0.0)
            continue;
        const double amplitude = commonAmplitude(poles, series, i);
        const double energy = amplitude * amplitude / std::abs(pole.s_rad_s.real());
        if (!main || energy > most) {
            main = &pole;
            most = energy;
        }
    }
    return main;
}

bool isPlateauKnown(const SensorModel &model)
{
    constexpr double kMost = 0.05;
    if (model.slowPoles.empty())
        return true;
    double u = 0.0; // the series share the rate, and with it their errors
    for (const SeriesFit &fit : model.series)
        u += fit.u_plateauGain / static_cast<double>(model.series.size());
    return u <= kMost * std::abs(model.plateauGain);
}

Index countBeyondMap(const SensorModel &model)
{
    const auto isBeyond = [](std::complex<double> z) { return !(std::abs(z) <= kFarthestInMap); };
    return std::ranges::count_if(model.poles, isBeyond, &Pole::z)
        + std::ranges::count_if(model.zeros, isBeyond);
}

} // namespace dyncal
