// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Preloaded into the program as it is built: the system gives it no thread from the call on that
// the environment names (DYNCAL_THREADS, counted from 0), as where there is no room for the stack.

#include <atomic>
#include <cerrno>
#include <cstdlib>

#include <dlfcn.h>
#include <pthread.h>

extern "C" int pthread_create(
    pthread_t *thread, const pthread_attr_t *attributes, void *(*start)(void *), void *argument)
{
    static auto *const real
        = reinterpret_cast<decltype(&::pthread_create)>(::dlsym(RTLD_NEXT, "pthread_create"));
    static const char *const most = std::getenv("DYNCAL_THREADS");
    static std::atomic<long> calls = 0;
    const bool isRefused = most != nullptr && calls++ >= std::atol(most);
    return isRefused ? EAGAIN : real(thread, attributes, start, argument);
}
