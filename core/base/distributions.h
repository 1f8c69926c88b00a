// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace dyncal {

/// Outside their domains, and for what is not a number, all give NaN: never a probability.

/// Upper regularised incomplete gamma function Q(a, x) = Gamma(a, x)/Gamma(a), a > 0, x >= 0:
/// series for x < a + 1, else Lentz's continued fraction (Abramowitz and Stegun 6.5.29, 6.5.31).
/// 1e-12 relative for Q above 1e-100 and a up to 1e6; 1 where x < 0. Pure, unlike functions that
/// use std::lgamma with its global sign.
double upperGammaRatio(double a, double x);

/// Probability that a chi-square variable with `degrees` > 0 degrees of freedom exceeds x >= 0.
double chiSquareSurvival(double x, double degrees);

/// z with P(Z <= z) = p for standard normal Z, 0 < p < 1 (algorithm AS 241, PPND16, relative
/// accuracy about 1e-15), with the portable logarithm: the same bits on every machine. Infinite at
/// 0 and 1.
double normalQuantile(double probability);

/// Probability that Student's t with `dof` > 0 degrees of freedom (any real number, infinity = the
/// normal distribution) exceeds t. 1e-12 relative up to 1e4 degrees, then dof * 1e-16; beyond 1e8
/// the normal distribution serves.
double studentSurvival(double t, double dof);

/// t with P(T <= t) = p, 0 < p < 1, as exact as studentSurvival(); NaN unless dof > 0.
double studentQuantile(double probability, double dof);

} // namespace dyncal
