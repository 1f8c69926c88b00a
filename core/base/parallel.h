// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/allowed_threads.h"
#include "core/base/index.h"
#include "core/base/lanes.h"

#include <atomic>
#include <exception>
#include <system_error>
#include <thread>

namespace dyncal {

/// Calls f(0) .. f(parts - 1), each once, on one thread or on two. The caller cuts the work into
/// parts that do not depend on the number of threads, so neither does the result. Starting a thread
/// costs some 50 us: set `worthAThread` only for work of a millisecond or more. Where the system
/// gives no thread the caller's does it all. An exception of a part is thrown again here once all
/// have ended.
template <typename Function>
void forEachPart(Index parts, bool worthAThread, const Function &f)
{
    if (!worthAThread || parts < 2 || allowedThreads() < 2) {
        for (Index part = 0; part < parts; ++part)
            f(part);
        return;
    }
    std::atomic<Index> next = 0;
    std::exception_ptr problems[2];
    const auto work = [&](std::exception_ptr &problem) {
        try {
            for (Index part = next++; part < parts; part = next++)
                f(part);
        } catch (...) {
            problem = std::current_exception();
        }
    };
    {
        std::jthread second;
        try {
            second = std::jthread([&] {
                freeUpperLanes();
                work(problems[1]);
            });
        } catch (const std::system_error &) { // no memory or no number for one more
        }
        work(problems[0]);
    }
    for (const std::exception_ptr &problem : problems) {
        if (problem)
            std::rethrow_exception(problem);
    }
}

} // namespace dyncal
