// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <csignal>
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

/// The signal by which a program asks its child processes to stop.
inline constexpr int kStopChild = SIGUSR1;

/// To be called in a forked child process of a program that has called interruptToken(): from now
/// on kStopChild asks for the stop, and the signals that the terminal or a cluster sends to all
/// processes at once are left to the parent, which decides what they mean. A second kStopChild ends
/// the process at once.
void takeStopsFromParent();

} // namespace dyncal
