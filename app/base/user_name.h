// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>

namespace dyncal {

/// The name of the account that runs the program, for the audit trail where no other is given; its
/// number where it has no name. It never gets into files that are handed out.
std::string userName();

} // namespace dyncal
