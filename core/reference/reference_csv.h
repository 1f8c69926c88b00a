// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/reference/reference_sensitivity.h"

#include <string_view>

namespace dyncal {

/// Table of a reference transducer: a line of names, frequency_hz,magnitude,u_magnitude and, both
/// or neither, phase_rad,u_phase_rad, then perhaps dof, in any order; then numbers with "." as
/// decimal mark, u at k = 1, as many in each line as there are names, each name once. Lines that
/// begin with "#" and empty ones are left out; an empty cell of dof is infinite. Fails (Usage) with
/// line, column and what was found.
Result<ReferenceSensitivity> readReferenceCsv(std::string_view text);

} // namespace dyncal
