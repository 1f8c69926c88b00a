// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/file_samples.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dyncal {

/// Samples of one channel in one segment, or in several of the same shape: `chunks` pieces of
/// `perChunk` samples each, every piece `chunkStride` bytes after the one before.
struct TdmsRun
{
    std::uint64_t offset = 0; ///< of the first sample, bytes from the start of the file
    Index perChunk = 0;
    Index chunks = 1;
    std::uint64_t chunkStride = 0; ///< bytes; no meaning with one chunk
    Index stride = 0; ///< bytes from one sample to the next within a chunk
    bool bigEndian = false;

    Index size() const { return perChunk * chunks; }
};

/// Where all samples of a channel lie, in order. Runs that continue the one before are merged, so
/// that a log of a million equal segments is one run.
class TdmsRuns
{
public:
    /// Leaves empty runs out.
    void append(TdmsRun run);

    Index size() const { return m_size; }
    const std::vector<TdmsRun> &runs() const { return m_runs; }

    /// Copies samples [begin, begin + count), which must exist, of 1, 2, 4 or 8 bytes each, in the
    /// byte order of this machine. False if the file cannot be read or has changed.
    bool read(const SampleFile &file, Index sampleBytes, Index begin, Index count,
        std::byte *target) const;

private:
    bool mergeIntoLast(const TdmsRun &run);

    std::vector<TdmsRun> m_runs;
    std::vector<Index> m_begins; ///< first sample of each run
    Index m_size = 0;
};

} // namespace dyncal
