// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <functional>
#include <stop_token>

namespace dyncal {

/// Calls `end` (on a thread of its own) with the number of the first INT, TERM or HUP that arrives;
/// a second one ends the program at once. A signal that was ignored at the start stays ignored.
/// Call it once, before any thread is started.
void onEndRequest(std::function<void(int)> end);

/// From the first call on, Ctrl-C, SIGTERM and SIGHUP ask running work to stop through this token,
/// so that no half-written file is left. Call it before any thread is started, as onEndRequest().
std::stop_token interruptToken();

} // namespace dyncal
