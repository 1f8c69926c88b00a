// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"

#include <string>
#include <string_view>

namespace dyncal {

/// What sentences and certificate call a reported value: "Damping ratio" for "damping_ratio"; its
/// name where it has no words.
Message valueWords(std::string_view of);

/// What they call a quantity of the budget: "initial pressure" for "p1_pa", with its place
/// for "distance_m[Side 1]"; its name where it has no words.
Message sourceWords(const std::string &quantity);

} // namespace dyncal
