// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/interrupt.h"

#include <csignal>
#include <thread>

#include <pthread.h>
#include <unistd.h>

namespace dyncal {
namespace {

/// Signals are waited for on a thread of their own: a handler may do next to nothing.
std::stop_source startWatching()
{
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    std::stop_source source;
    std::thread([source, signals]() mutable {
        int caught = 0;
        sigwait(&signals, &caught);
        source.request_stop();
        sigwait(&signals, &caught);
        ::_exit(128 + caught);
    }).detach();
    return source;
}

} // namespace

std::stop_token interruptToken()
{
    static const std::stop_source source = startWatching();
    return source.get_token();
}

} // namespace dyncal
