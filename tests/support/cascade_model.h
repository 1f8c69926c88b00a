// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/model/sensor_model.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

namespace dyncal::testing {

/// Model of prod_i (-s_i)/(s - s_i) with distinct poles: amplitudes of its step response by the
/// residues of G(s)/s. Pairs stand together, the upper half first.
inline SensorModel modelOfPoles(const std::vector<std::complex<double>> &poles_rad_s)
{
    SensorModel model;
    model.plateauGain = 1.0;
    model.order = static_cast<Index>(poles_rad_s.size());
    model.amplitudes.resize(model.order);
    for (Index i = 0; i < model.order; ++i) {
        const std::complex<double> s = poles_rad_s[static_cast<std::size_t>(i)];
        std::complex<double> c = -1.0;
        for (const std::complex<double> &other : poles_rad_s) {
            if (other != s)
                c *= -other / (s - other);
        }
        model.amplitudes[i] = c;
        Pole pole;
        pole.s_rad_s = s;
        pole.poleClass = PoleClass::Sensor;
        pole.frequency_Hz = std::abs(s) / (2.0 * std::numbers::pi);
        pole.dampingRatio = -s.real() / std::abs(s);
        model.poles.push_back(pole);
    }
    return model;
}

/// The same for second-order sensors in series: f0 in Hz and zeta of each.
inline SensorModel cascadeModel(const std::vector<std::pair<double, double>> &modes)
{
    std::vector<std::complex<double>> poles_rad_s;
    for (const auto &[f0_Hz, zeta] : modes) {
        const double w0 = 2.0 * std::numbers::pi * f0_Hz;
        poles_rad_s.push_back(w0 * std::complex<double>(-zeta, std::sqrt(1.0 - zeta * zeta)));
        poles_rad_s.push_back(std::conj(poles_rad_s.back()));
    }
    return modelOfPoles(poles_rad_s);
}

} // namespace dyncal::testing
