// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How fast a TDMS file is opened and all its samples are copied; tests/bench/run_tdms runs it
// beside its peer.
//   bench_tdms --make FILE SAMPLES SEGMENTS    writes 3 channels of int16 noise
//   bench_tdms FILE                            prints two times in ms to read it all: into fresh
//                                              memory, and into the same again

#include "core/capture/formats/tdms/tdms.h"
#include "tests/support/tdms_writer.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace dyncal;

using Buffer = std::unique_ptr<std::int16_t[]>;

constexpr int kChannels = 3;

std::string segmentOf(Index rows, std::uint64_t &noise)
{
    testing::TdmsSegment segment;
    std::string data;
    for (int c = 0; c < kChannels; ++c) {
        segment.channel<std::int16_t>(
            "/'shot'/'c" + std::to_string(c) + "'", static_cast<std::uint64_t>(rows));
        for (Index i = 0; i < rows; ++i) {
            noise = noise * 6364136223846793005U + 1442695040888963407U;
            data += static_cast<char>(noise >> 56U);
            data += static_cast<char>(noise >> 62U);
        }
    }
    segment.data().raw(data);
    return segment.bytes();
}

int make(const std::string &path, Index samples, Index segments)
{
    std::ofstream file(path, std::ios::binary);
    std::uint64_t noise = 1;
    for (Index i = 0; i < segments; ++i)
        file << segmentOf(samples / segments, noise);
    return file.good() ? 0 : 1;
}

/// Opens the file and copies every sample into buffers of its own.
bool readAll(const std::string &path, std::vector<Buffer> &targets)
{
    const Result<CaptureSet> set = readTdms(path, {}, {});
    if (!set || set->shots.front().channels.size() != targets.size())
        return false;
    for (std::size_t c = 0; c < targets.size(); ++c) {
        const RawSamples &samples = set->shots.front().channels[c].samples;
        if (targets[c] == nullptr)
            targets[c] = std::make_unique_for_overwrite<std::int16_t[]>(
                static_cast<std::size_t>(samples.size()));
        const bool done = samples.visitBlocks(0, samples.size(), [&](auto block, Index first) {
            std::copy(block.begin(), block.end(), targets[c].get() + first);
        });
        if (!done)
            return false;
    }
    return true;
}

int read(const std::string &path)
{
    std::vector<Buffer> targets(kChannels);
    for (int pass = 0; pass < 2; ++pass) {
        const auto start = std::chrono::steady_clock::now();
        if (!readAll(path, targets))
            return 1;
        const std::chrono::duration<double, std::milli> time
            = std::chrono::steady_clock::now() - start;
        std::cout << time.count() << '\n';
    }
    return 0;
}

} // namespace

int main(int argc, char **argv)
{
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    if (arguments.size() == 4 && arguments[0] == "--make")
        return make(arguments[1], std::stoll(arguments[2]), std::stoll(arguments[3]));
    return arguments.size() == 1 ? read(arguments[0]) : 1;
}
