// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The whole way of a file: the helper process with the library, then one of the three readers that
// share it, chosen by the last byte (which the format does not look at). A file of its own and not
// one in memory only: libhdf5 resolves the path, and /proc/self/fd/N resolves to nothing.
//
// A helper may die, of whatever the library or a sanitizer finds there; it is counted, but no crash
// of ours. All else is.

#include "core/capture/formats/foreign/foreign_hdf5.h"
#include "core/capture/formats/foreign/mat73.h"
#include "core/capture/formats/hdf5/hdf5_capture_reader.h"
#include "tests/fuzz/fuzz_reader.h"
#include "tests/support/scratch_folder.h"

#include <pthread.h>
#include <sanitizer/common_interface_defs.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>

namespace {

constexpr suseconds_t kHelperTime_us = 100'000; ///< honest ones take a thirtieth of it

/// In a helper a sanitizer must not report to the fuzzer, which would write a crash of ours down.
/// One that hangs is ended before its 2 s are over, or nearly all of the time would go to hangs;
/// for us it died all the same.
void prepareHelper()
{
    __sanitizer_set_death_callback([] { ::_exit(1); });
    ::signal(SIGVTALRM, SIG_DFL);
    const itimerval timer{{0, 0}, {0, kHelperTime_us}};
    ::setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

/// What became of the inputs; printed when the fuzzer ends.
struct Tally
{
    Tally() { pthread_atfork(nullptr, nullptr, &prepareHelper); }
    Tally(const Tally &) = delete;
    Tally &operator=(const Tally &) = delete;
    ~Tally()
    {
        std::fprintf(stderr, "read %ld, refused %ld, helper died %ld\n", read, refused, died);
    }

    void add(const dyncal::Result<dyncal::CaptureSet> &set)
    {
        constexpr std::string_view kDied = "the HDF5 library fails on it";
        const bool dead
            = !set && dyncal::english(set.error().message).find(kDied) != std::string::npos;
        ++(set ? read : dead ? died : refused);
    }

    long read = 0;
    long refused = 0;
    long died = 0;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const dyncal::testing::ScratchFolder folder;
    static Tally tally;
    constexpr std::array<dyncal::fuzz::Reader, 3> kReaders{
        &dyncal::readHdf5Capture, &dyncal::readForeignHdf5, &dyncal::readMat73};
    const std::size_t choice = size > 0 ? data[size - 1] : 0;
    const std::string path = folder.write("x.h5", data, size);
    const auto set = kReaders[choice % kReaders.size()](path, {}, {});
    tally.add(set);
    dyncal::fuzz::requireSound(set);
    return 0;
}
