// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <stop_token>

namespace dyncal {

/// How a rehearsal in a process of its own ended.
enum class GuardedOutcome {
    Finished, ///< it came back; do it here
    Died, ///< crashed, ran out of memory or took too long
    Stopped, ///< stop was requested
    NotStarted, ///< the system gave us no process
};

struct GuardedLimits
{
    std::uint64_t memoryBytes; ///< beyond what this process uses already
    std::chrono::seconds time;
};

/// Runs `work` in a forked copy of this process under limits and throws its results away: what
/// crashes a library there does not crash us. `work` may use only what is safe after fork in a
/// threaded program: memory, files, and libraries whose locks no other thread holds now.
GuardedOutcome rehearse(
    const std::function<void()> &work, const GuardedLimits &limits, const std::stop_token &stop);

} // namespace dyncal
