// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>

namespace dyncal {

/// The SHA-256 that a capture states of all that it says (docs/method/captures.md); empty if it
/// states none, as those of older versions and other programs: nothing protects their texts.
std::string statedContentHashOf(const std::string &path);

} // namespace dyncal
