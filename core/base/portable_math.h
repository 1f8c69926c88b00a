// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace dyncal {

/// exp, log, sin and cos made of + - * / and bit operations only. Those of the C library depend on
/// the processor and may differ in the last bit; simulated counts must not. Errors: at most 2 units
/// in the last place (sine and cosine: 2^-52 absolute) within the stated domains.

/// Any x; 0 below -708, infinity above 709.
double portableExp(double x);

/// Natural logarithm of a normal number x > 0.
double portableLog(double x);

struct SineCosine
{
    double sine = 0.0;
    double cosine = 1.0;
};

/// |x| <= 1e6 rad.
SineCosine portableSineCosine(double x);

} // namespace dyncal
