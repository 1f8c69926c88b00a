// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"

#include <string>

namespace dyncal {

/// A step of the method in words, "expected shock" of "expected_shock"; a key that is not known
/// keeps itself.
Message stepWords(const std::string &step);

} // namespace dyncal
