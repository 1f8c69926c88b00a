// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace dyncal {

/// Upper regularised incomplete gamma function Q(a, x) = Gamma(a, x)/Gamma(a), a > 0, x >= 0:
/// series for x < a + 1, else Lentz's continued fraction (Abramowitz and Stegun 6.5.29, 6.5.31).
/// 1e-13 relative. Pure, unlike functions that use std::lgamma with its global sign.
double upperGammaRatio(double a, double x);

/// Probability that a chi-square variable with `degrees` > 0 degrees of freedom exceeds x >= 0.
double chiSquareSurvival(double x, double degrees);

/// z with P(Z <= z) = p for standard normal Z, 0 < p < 1 (algorithm AS 241, PPND16, relative
/// accuracy about 1e-15), with the portable logarithm: the same bits on every machine.
double normalQuantile(double probability);

/// Probability that Student's t with `dof` > 0 degrees of freedom (any real number, infinity = the
/// normal distribution) exceeds t. 1e-12 relative.
double studentSurvival(double t, double dof);

/// t with P(T <= t) = p, 0 < p < 1, to 1e-12 relative; NaN unless dof > 0.
double studentQuantile(double probability, double dof);

} // namespace dyncal
