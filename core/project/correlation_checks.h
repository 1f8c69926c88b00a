// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/result.h"
#include "core/shock/uncertainty_settings.h"

namespace dyncal {

/// Whether uncertainty.correlations are possible: each pair once, and together a matrix that errors
/// can have (no negative eigenvalue). `velocities`: how many are typed, one for each shot; their
/// errors are independent, so what one of them goes along with, the others can share less of.
/// Fails (Usage). One that the budget has no use for is SHK-013.
Result<void> checkCorrelations(const UncertaintySettings &settings, Index velocities = 1);

} // namespace dyncal
