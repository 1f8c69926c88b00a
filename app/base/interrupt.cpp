// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/interrupt.h"

#include <csignal>
#include <thread>
#include <utility>

#include <pthread.h>
#include <unistd.h>

namespace dyncal {
namespace {

std::stop_source startWatching()
{
    std::stop_source source;
    onEndRequest([source](int) mutable { source.request_stop(); });
    return source;
}

} // namespace

/// Signals are waited for on a thread of their own: a handler may do next to nothing.
void onEndRequest(std::function<void(int)> end)
{
    sigset_t signals;
    sigemptyset(&signals);
    for (const int number : {SIGINT, SIGTERM, SIGHUP})
        sigaddset(&signals, number);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    std::thread([end = std::move(end), signals] {
        int caught = 0;
        sigwait(&signals, &caught);
        end(caught);
        sigwait(&signals, &caught);
        ::_exit(128 + caught);
    }).detach();
}

std::stop_token interruptToken()
{
    static const std::stop_source source = startWatching();
    return source.get_token();
}

} // namespace dyncal
