// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/shock/shock_settings.h"

#include <cstddef>

namespace dyncal {

/// Whether the settings can be used with a capture of `shots` shots: the place of the DUT is one
/// of two, what is typed per shot has a value for each of them, a typed step is a number other
/// than 0, and the sensors lie before the end wall. Else: Usage, with the key.
Result<void> checkShockSettings(const ShockSettings &settings, std::size_t shots);

} // namespace dyncal
