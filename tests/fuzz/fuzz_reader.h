// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/capture/import_settings.h"
#include "tests/support/memory_file.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

/// A fuzz target of one reader is: its header, this header, and DYNCAL_FUZZ_READER(&readIt).
namespace dyncal::fuzz {

/// Promises that every reader keeps, whatever the bytes are.
inline void require(bool promise)
{
    if (!promise)
        std::abort();
}

/// Reads samples at both ends of the record, which is what a broken header puts out of bounds.
inline void touch(const Channel &channel)
{
    constexpr Index kEnd = 4096;
    const Index size = channel.samples.size();
    require(size >= 0 && !channel.polynomial.empty());
    double sum = 0.0;
    const auto visit = [&](auto block, Index) {
        for (const auto value : block)
            sum += static_cast<double>(value);
    };
    const Index part = size < kEnd ? size : kEnd;
    require(channel.samples.visitBlocks(0, part, visit));
    require(channel.samples.visitBlocks(size - part, size, visit));
    volatile double keep = sum; // so that the reading is not left out
    static_cast<void>(keep);
}

using Reader = Result<CaptureSet> (*)(
    const std::string &path, const ImportSettings &settings, const JobControl &control);

/// What a reader makes of a file: a refusal in words, or shots whose samples can be read.
inline void requireSound(const Result<CaptureSet> &set)
{
    if (!set) {
        require(
            set.error().kind == ErrorKind::FileUnreadable && !english(set.error().message).empty());
        return;
    }
    require(!set->shots.empty());
    for (const Shot &shot : set->shots) {
        for (const Channel &channel : shot.channels)
            touch(channel);
    }
}

inline int readBytes(Reader reader, const std::uint8_t *data, std::size_t size)
{
    const testing::MemoryFile file(data, size);
    requireSound(reader(file.path(), {}, {}));
    return 0;
}

} // namespace dyncal::fuzz

#define DYNCAL_FUZZ_READER(reader)                                                                 \
    extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)              \
    {                                                                                              \
        return dyncal::fuzz::readBytes(reader, data, size);                                        \
    }
