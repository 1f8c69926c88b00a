// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/recheck/recheck_outcome.h"

#include <string>
#include <vector>

namespace dyncal {

/// The answer for people: what differs beyond U as a table, worst first, and of every folder what
/// it was made by, which methods changed, and which findings. Unreadable folders are told on
/// stderr.
std::string recheckText(const std::vector<RecheckAnswer> &answers);

} // namespace dyncal
