// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <string_view>

namespace dyncal {

/// How work in a process of its own ended.
enum class GuardedOutcome {
    Finished, ///< it returned; all it wrote was received
    Died, ///< crashed, ran out of memory or time, or `receive` refused
    Killed, ///< somebody else ended it, as the system does when memory runs out
    Stopped, ///< stop was requested
    NotStarted, ///< the system could not start a process
};

struct GuardedLimits
{
    std::uint64_t memoryBytes; ///< beyond what this process uses already
    std::chrono::milliseconds time; ///< of the processor, from one piece of output to the next
};

/// Where guarded work puts what it finds out.
class GuardedOutput
{
public:
    GuardedOutput(int descriptor, std::chrono::milliseconds time);

    /// Blocks while the receiver is busy; ends the process if the receiver is gone.
    void write(std::span<const std::byte> bytes);
    void write(std::string_view text) { write(std::as_bytes(std::span(text))); }

private:
    void restartClock() const;

    int m_descriptor;
    std::chrono::milliseconds m_time;
};

/// Runs `work` in a forked copy of this process under limits: if a library crashes there, or takes
/// all memory, this process goes on. All that comes back is what it writes, handed to `receive` in
/// pieces of any size; if `receive` returns false, the work is ended. What was received may be used
/// only after Finished. `work` may use only what is safe after fork in a threaded program: memory,
/// files it only reads, and libraries whose locks no other thread holds now.
GuardedOutcome runGuarded(const std::function<void(GuardedOutput &)> &work,
    const std::function<bool(std::span<const std::byte>)> &receive, const GuardedLimits &limits,
    const std::stop_token &stop);

} // namespace dyncal
