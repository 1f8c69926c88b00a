// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/interrupt.h"

#include <system_error>
#include <thread>
#include <utility>

#include <pthread.h>
#include <unistd.h>

namespace dyncal {
namespace {

/// The signals that end the program, without those ignored at its start: nohup asks for that, and a
/// shell does for background jobs.
sigset_t endSignals()
{
    sigset_t signals;
    sigemptyset(&signals);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction now
        {
        };
        sigaction(number, nullptr, &now);
        if (now.sa_handler != SIG_IGN)
            sigaddset(&signals, number);
    }
    return signals;
}

/// Signals are waited for on a thread of their own: a handler may do next to nothing.
void watchFor(const sigset_t &signals, std::function<void(int)> end)
{
    if (sigisemptyset(&signals) != 0)
        return;
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    try {
        std::thread([end = std::move(end), signals] {
            int caught = 0;
            sigwait(&signals, &caught);
            end(caught);
            sigwait(&signals, &caught);
            ::_exit(128 + caught);
        }).detach();
    } catch (const std::system_error &) { // then the first signal ends the program
        pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    }
}

std::stop_source startWatching()
{
    std::stop_source source;
    onEndRequest([source](int) mutable { source.request_stop(); });
    return source;
}

const std::stop_source &interruptSource()
{
    static const std::stop_source source = startWatching();
    return source;
}

} // namespace

void onEndRequest(std::function<void(int)> end)
{
    watchFor(endSignals(), std::move(end));
}

std::stop_token interruptToken()
{
    return interruptSource().get_token();
}

void takeStopsFromParent()
{
    for (const int number : {SIGINT, SIGTERM, SIGHUP})
        std::signal(number, SIG_IGN);
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, kStopChild);
    watchFor(signals, [source = interruptSource()](int) mutable { source.request_stop(); });
}

} // namespace dyncal
