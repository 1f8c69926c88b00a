// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <stop_token>

namespace dyncal {

/// From the first call on, Ctrl-C and SIGTERM ask running work to stop through this token, so that
/// no half-written file is left; a second one ends the program at once. Call it before any thread
/// is started.
std::stop_token interruptToken();

} // namespace dyncal
