// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/correction/known_response.h"
#include "core/signal/fft.h"

#include <cmath>
#include <complex>
#include <numbers>

/// Responses and recordings of known truth for the tests of the correction.
namespace dyncal::testing {

/// S0 w0^2/(w0^2 + 2 zeta w0 jw - w^2)
struct TrueSensor
{
    double f0_Hz = 300e3;
    double zeta = 0.05;
    double S0 = 2e-9;

    std::complex<double> at(double frequency_Hz) const
    {
        const double x = frequency_Hz / f0_Hz;
        return S0 / std::complex<double>(1.0 - x * x, 2.0 * zeta * x);
    }

    std::complex<double> pole_rad_s() const
    {
        return 2.0 * std::numbers::pi * f0_Hz
            * std::complex<double>(-zeta, std::sqrt(1.0 - zeta * zeta));
    }

    /// Its step response 1 + sum c_i e^(s_i t) is 0 at 0 with slope 0: c_1 = s_2/(s_1 - s_2).
    PoleShape shape() const
    {
        PoleShape shape;
        const std::complex<double> s = pole_rad_s();
        const std::complex<double> other = std::conj(s);
        shape.s_rad_s = Eigen::Vector2cd(s, other);
        shape.c = Eigen::Vector2cd(other / (s - other), s / (other - s));
        return shape;
    }

    Eigen::VectorXcd at(const Eigen::VectorXd &frequency_Hz) const
    {
        Eigen::VectorXcd values(frequency_Hz.size());
        for (Index i = 0; i < values.size(); ++i)
            values[i] = at(frequency_Hz[i]);
        return values;
    }

    /// The level and thirds of an octave from 1 kHz to 316 kHz, without errors.
    KnownResponse known() const
    {
        KnownResponse response;
        response.knot_Hz = Eigen::VectorXd::Zero(27);
        for (Index k = 1; k < 27; ++k)
            response.knot_Hz[k] = std::pow(10.0, 3.0 + 0.1 * static_cast<double>(k - 1));
        response.atKnots = at(response.knot_Hz);
        response.shape = shape();
        response.u_alone = Eigen::VectorXd::Zero(27);
        response.validTo_Hz = 1e6;
        response.unit = "V/Pa";
        return response;
    }

    /// What it makes of a pressure that has gone at both ends of the record.
    Eigen::VectorXd recordOf(const Eigen::VectorXd &pressure_Pa, double rate_Hz) const
    {
        const RealFft fft(pressure_Pa.size());
        const Eigen::VectorXd frequency_Hz
            = Eigen::VectorXd::LinSpaced(pressure_Pa.size() / 2 + 1, 0.0, 0.5 * rate_Hz);
        return fft.inverse(fft.forward(pressure_Pa).cwiseProduct(at(frequency_Hz)));
    }
};

/// exp(-(t - t0)^2/2 w^2) cos 2 pi f (t - t0), t = n/rate.
inline Eigen::VectorXd burst(
    Index count, double rate_Hz, double t0_s, double width_s, double frequency_Hz)
{
    Eigen::VectorXd values(count);
    for (Index n = 0; n < count; ++n) {
        const double t = static_cast<double>(n) / rate_Hz - t0_s;
        values[n] = std::exp(-0.5 * t * t / (width_s * width_s))
            * std::cos(2.0 * std::numbers::pi * frequency_Hz * t);
    }
    return values;
}

} // namespace dyncal::testing
