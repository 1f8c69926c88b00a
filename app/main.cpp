// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/command_line.h"
#include "app/cli/console.h"
#include "app/cli/terminal_text.h"
#include "app/gui_main.h"

#include "core/base/content_hash.h"
#include "core/base/message.h"

#include <pthread.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {
namespace {

/// Raises a stack limit that is too small as far as the system allows, for all threads. False if
/// the stack stays too small.
bool allowStack()
{
    constexpr rlim_t kLeast = 2 << 20, kWanted = 8 << 20;
    rlimit stack{};
    if (::getrlimit(RLIMIT_STACK, &stack) != 0 || stack.rlim_cur >= kLeast)
        return true;
    if (stack.rlim_max < kLeast)
        return false;
    stack.rlim_cur = std::min(stack.rlim_max, kWanted);
    pthread_attr_t ofThreads;
    ::pthread_attr_init(&ofThreads);
    ::pthread_attr_setstacksize(&ofThreads, kWanted);
    const bool isAllowed
        = ::setrlimit(RLIMIT_STACK, &stack) == 0 && ::pthread_setattr_default_np(&ofThreads) == 0;
    ::pthread_attr_destroy(&ofThreads);
    return isAllowed;
}

/// A umask that takes away the user's own rights would leave files that the program itself cannot
/// open again.
void keepOwnRights()
{
    ::umask(::umask(S_IRWXG | S_IRWXO) & (S_IRWXG | S_IRWXO));
}

/// The stack grows when it is used, and the program crashes if no memory is left for that; so it
/// grows now to what the program needs.
[[gnu::noinline]] void growStack()
{
    constexpr std::size_t kBytes = 1 << 20, kPage = 4096;
    [[maybe_unused]] volatile char stack[kBytes];
    for (std::size_t i = 0; i < kBytes; i += kPage)
        stack[i] = 0;
}

/// Every recording stays open while it is worked on (docs/adr/0014), and desktops allow 1024 open
/// files unless a program asks for more.
void allowManyFiles()
{
    rlimit files{};
    if (::getrlimit(RLIMIT_NOFILE, &files) != 0)
        return;
    files.rlim_cur = files.rlim_max;
    ::setrlimit(RLIMIT_NOFILE, &files);
}

/// OpenSSL sets itself up when it is first used; if memory runs out during this, it crashes later.
/// False: memory ran out.
bool setUpHashing()
{
    try {
        return !sha256Hex(std::string_view()).empty();
    } catch (const std::bad_alloc &) {
        return false;
    }
}

/// A word that is no file is most likely a misspelt subcommand.
int refuseMissing(const std::string &word)
{
    if (word.empty())
        return report({ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core", "An empty name was given where a file is needed; name a file."),
                {}},
            {}, 0});
    const std::string verb = similarVerb(word);
    if (!verb.empty())
        return report({ErrorKind::Usage,
            {DYNCAL_TEXT(
                 "core", "%1 is neither a subcommand nor a file; the nearest subcommand is %2."),
                {word, verb}},
            {}, 0});
    return report({ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core", "The file %1 does not exist."), {word}}, {}, 0});
}

int openWorkbench(int argc, char **argv)
{
    const std::vector<std::string> files(argv + 1, argv + argc);
    for (const std::string &file : files) {
        std::error_code ignored;
        if (!std::filesystem::exists(file, ignored))
            return refuseMissing(file);
    }
    if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY")
        && !std::getenv("QT_QPA_PLATFORM"))
        return report({ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The workbench needs a display and there is none; the subcommands work without, see dyncal --help."),
                {}},
            {}, 0});
    return runGui(argc, argv, files);
}

/// Writing to a closed pipe, or to a file that may not grow, is to be an error that is reported; by
/// default it would kill the program. And how a helper process ended is known only if SIGCHLD is
/// not ignored, as it may be by the program that started this one.
void takeSignals()
{
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGCHLD, SIG_DFL);
}

} // namespace
} // namespace dyncal

int main(int argc, char **argv)
{
    if (!dyncal::allowStack()) {
        std::cerr << "The stack may not grow to the 2 MiB that are needed; raise its limit (ulimit "
                     "-s).\n";
        return 5;
    }
    dyncal::growStack();
    dyncal::keepOwnRights();
    if (!dyncal::setUpHashing()) {
        std::cerr << "There is not enough memory to start; raise the memory limit.\n";
        return 5;
    }
    dyncal::allowManyFiles();
    dyncal::takeSignals();
    const bool isCommandLine = dyncal::isCommandLine(argc, argv);
    const auto isStopped = isCommandLine ? &dyncal::isStopRequested : nullptr;
    const dyncal::TerminalText answers(std::cout, isStopped);
    const dyncal::TerminalText complaints(std::cerr, isStopped);
    if (argc >= 3 && argc <= 5 && std::string_view(argv[1]) == "--screenshot-tour")
        return dyncal::runGui(argc, argv, {});
    return isCommandLine ? dyncal::runCommandLine(argc, argv) : dyncal::openWorkbench(argc, argv);
}
