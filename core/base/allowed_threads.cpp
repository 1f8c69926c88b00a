// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/allowed_threads.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace dyncal {
namespace {

std::atomic<bool> isOneThread = false;

} // namespace

unsigned allowedThreads()
{
    return isOneThread ? 1 : std::max(std::thread::hardware_concurrency(), 1U);
}

void useOneThread()
{
    isOneThread = true;
}

} // namespace dyncal
