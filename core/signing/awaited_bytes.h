// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <chrono>
#include <cstddef>
#include <stop_token>
#include <string>

namespace dyncal {

/// How long another program or machine is waited for, and how much is taken from it.
struct AnswerLimits
{
    std::chrono::milliseconds time = std::chrono::seconds(60); ///< for all of it
    std::size_t bytes = std::size_t{64} * 1024;
};

enum class Awaited { Whole, TooMuch, TooLate, Broken, Stopped };

/// The moments of one answer: by when it must be there.
class AnswerClock
{
public:
    explicit AnswerClock(const AnswerLimits &limits, std::stop_token stop);

    /// Waits until the descriptor can be read (POLLIN) or written (POLLOUT): Whole then.
    Awaited ready(int descriptor, short events) const;

    /// Whole while there is time and nobody asked to stop.
    Awaited standing() const;

private:
    std::chrono::steady_clock::time_point m_end;
    std::stop_token m_stop;
};

/// Reads to the end, into `bytes`: what came so far also where it is not Whole.
Awaited readToEnd(
    int descriptor, const AnswerLimits &limits, const AnswerClock &clock, std::string &bytes);

} // namespace dyncal
