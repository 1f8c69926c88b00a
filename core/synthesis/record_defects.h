// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"

namespace dyncal {

/// Volts as floating point numbers, three of them invalid from `time_s` on (on the stated axis).
void spoilWithInvalidSamples(Channel &channel, double time_s);

/// Values in psi under the unit "bar", as when somebody typed the wrong unit.
void mislabelAsBar(Channel &channel, double sensitivity_V_Pa);

/// Exchanges the roles of the DUT and the driven-side channel.
void swapRoles(Shot &shot);

/// The same counts with values `factor` times as large.
void misstateScale(Channel &channel, double factor);

} // namespace dyncal
