// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/capture/raw_samples.h"

#include <bit>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// A recording opened for reading samples from it later. It remembers size and time of change; if
/// they differ later, nothing more is read. It is read with pread, never mapped, because a mapped
/// file that somebody shortens kills the process.
class SampleFile
{
public:
    /// Fails (CAP-018) if it cannot be opened or is no regular file.
    static Result<std::shared_ptr<const SampleFile>> open(const std::string &path);

    /// Shows whether a file was written to. A copy that keeps times restores the time of the
    /// samples (mtime), never that of the entry (ctime).
    struct State
    {
        std::uint64_t size;
        std::int64_t samplesChanged_ns;
        std::int64_t entryChanged_ns;

        bool operator==(const State &) const = default;
    };

    SampleFile(const SampleFile &) = delete;
    SampleFile &operator=(const SampleFile &) = delete;
    ~SampleFile();

    std::uint64_t size() const { return m_state.size; }

    /// False if the file changed since it was opened, or is too short.
    bool read(std::uint64_t offset, std::size_t bytes, std::byte *target) const;
    bool unchanged() const;

private:
    SampleFile(int descriptor, const State &state);

    int m_descriptor;
    State m_state;
};

/// A stretch of a record that lies in one piece of the file.
struct SampleExtent
{
    std::uint64_t offset = 0; ///< of the first sample, bytes from the start of the file
    Index count = 0;
};

/// Where in a file the samples of one channel lie, and how.
struct SampleLayout
{
    SampleType type = SampleType::Int16;
    std::endian byteOrder = std::endian::little;
    Index stride = 0; ///< bytes from one sample to the next; 0 = close together
    std::vector<SampleExtent> extents; ///< in the order of the record
};

/// The samples that `layout` describes, read from the file on demand; nothing is allocated here.
/// Empty if an extent does not lie wholly within the file (whatever a damaged header claims) or the
/// stride is smaller than a sample.
std::optional<RawSamples> samplesInFile(
    std::shared_ptr<const SampleFile> file, SampleLayout layout);

} // namespace dyncal
