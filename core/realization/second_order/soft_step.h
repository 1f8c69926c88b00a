// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace dyncal {

/// Response of w0^2/(s^2 + 2 zeta w0 s + w0^2) to a pressure that rises evenly from 0 to 1 over
/// `duration_s`, `t_s` from the middle of the rise on: the mean of its step response (thesis eqs
/// 3.11-3.17) over the rise, by the response's closed integral. During the rise too. Any zeta > 0;
/// duration 0 is a sharp step.
double softStep(double omega_rad_s, double zeta, double duration_s, double t_s);

} // namespace dyncal
