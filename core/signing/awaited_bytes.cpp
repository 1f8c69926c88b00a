// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/awaited_bytes.h"

#include <array>
#include <cerrno>

#include <poll.h>
#include <unistd.h>

namespace dyncal {
namespace {

constexpr std::chrono::milliseconds kGlance(100); ///< between looks at the clock and the stop
constexpr std::size_t kBlock = 4096;

} // namespace

AnswerClock::AnswerClock(const AnswerLimits &limits, std::stop_token stop)
    : m_end(std::chrono::steady_clock::now() + limits.time)
    , m_stop(std::move(stop))
{
}

Awaited AnswerClock::standing() const
{
    if (m_stop.stop_requested())
        return Awaited::Stopped;
    return std::chrono::steady_clock::now() < m_end ? Awaited::Whole : Awaited::TooLate;
}

Awaited AnswerClock::ready(int descriptor, short events) const
{
    for (Awaited now = standing();; now = standing()) {
        if (now != Awaited::Whole)
            return now;
        pollfd wanted{descriptor, events, 0};
        const int got = ::poll(&wanted, 1, static_cast<int>(kGlance.count()));
        if (got > 0)
            return Awaited::Whole;
        if (got < 0 && errno != EINTR)
            return Awaited::Broken;
    }
}

Awaited readToEnd(
    int descriptor, const AnswerLimits &limits, const AnswerClock &clock, std::string &bytes)
{
    std::array<char, kBlock> block{};
    for (;;) {
        if (const Awaited now = clock.ready(descriptor, POLLIN); now != Awaited::Whole)
            return now;
        const ssize_t got = ::read(descriptor, block.data(), block.size());
        if (got == 0)
            return Awaited::Whole;
        if (got < 0 && errno != EINTR && errno != EAGAIN)
            return Awaited::Broken;
        bytes.append(block.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
        if (bytes.size() > limits.bytes)
            return Awaited::TooMuch;
    }
}

} // namespace dyncal
