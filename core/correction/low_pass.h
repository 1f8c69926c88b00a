// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <complex>

namespace dyncal {

enum class LowPassKind {
    Gaussian, ///< 1 to a part in 10^4 up to the band's end, no phase
    TwoPole, ///< two equal real poles, -3 dB at the band's end, its delay at 0 Hz taken off
};

const char *lowPassName(LowPassKind kind); ///< "gaussian", "two-pole"

/// What a correction leaves of the pressure: its content up to band_Hz, nothing beyond edge_Hz.
struct LowPass
{
    LowPassKind kind = LowPassKind::Gaussian;
    double band_Hz = 0.0;
    double edge_Hz = 0.0; ///< above band_Hz; of no meaning for TwoPole

    /// L(f), f >= 0. Gaussian: erfc(z (f - m)/w)/2 with m half way between band and edge, w the
    /// half of their distance, and z such that L is 1 - 1e-4 at the band's end and 1e-4 at the
    /// edge. TwoPole: e^(2j x)/(1 + jx)^2, x = f/(1.555 band_Hz) (V. Wilkens, M. Weber, tutorial on
    /// the deconvolution of hydrophone signals).
    std::complex<double> at(double frequency_Hz) const;
};

} // namespace dyncal
