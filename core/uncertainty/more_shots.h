// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/uncertainty/reported_value.h"

#include <vector>

namespace dyncal {

/// The value as `shots` shots would give it, from the lines that `made` shots gave: what each shot
/// makes anew goes with 1 / sqrt(n) and its degrees of freedom with n, a scatter's degrees of
/// freedom grow by one with each shot, and what they share stays. Without u where a scatter would
/// have no degree of freedom left.
ReportedValue withShots(ReportedValue reported, Index made, Index shots);

/// What no number of shots goes below: the shared lines alone.
ReportedValue withEndlessShots(ReportedValue reported);

/// withShots() of 1, 2, ... `most`; nothing without a u.
std::vector<ReportedValue> forShots(const ReportedValue &reported, Index made, Index most = 20);

} // namespace dyncal
