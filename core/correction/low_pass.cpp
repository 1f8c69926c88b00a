// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/low_pass.h"

#include <cmath>

namespace dyncal {
namespace {

constexpr double kErfcOf2e4 = 2.629741776210274; ///< erfc of this is 2e-4
constexpr double kCornerOfTwoPoles = 1.555; ///< -3 dB of two equal poles is at 1/1.555 of each

} // namespace

const char *lowPassName(LowPassKind kind)
{
    return kind == LowPassKind::Gaussian ? "gaussian" : "two-pole";
}

std::complex<double> LowPass::at(double frequency_Hz) const
{
    if (kind == LowPassKind::TwoPole) {
        const double x = frequency_Hz / (kCornerOfTwoPoles * band_Hz);
        const std::complex<double> pole(1.0, x);
        return std::polar(1.0, 2.0 * x) / (pole * pole);
    }
    const double middle_Hz = 0.5 * (band_Hz + edge_Hz);
    const double half_Hz = 0.5 * (edge_Hz - band_Hz);
    return 0.5 * std::erfc(kErfcOf2e4 * (frequency_Hz - middle_Hz) / half_Hz);
}

} // namespace dyncal
