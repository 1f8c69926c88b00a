// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/file_samples.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace dyncal {

/// Expands a zlib stream that lies in a file, as far as the caller asks and into the caller's
/// memory only.
class ZlibStream
{
public:
    /// The stream is the bytes [offset, offset + bytes) of the file, which must hold them.
    ZlibStream(std::shared_ptr<const SampleFile> file, std::uint64_t offset, std::uint64_t bytes);
    ~ZlibStream();
    ZlibStream(const ZlibStream &) = delete;
    ZlibStream &operator=(const ZlibStream &) = delete;

    /// Fills `target` as far as the stream goes; returns the number of bytes.
    std::size_t read(std::span<std::byte> target);

    /// Whether nothing was wrong so far.
    bool ok() const { return m_ok; }
    /// Whether the stream came to its end and its checksum was right.
    bool ended() const { return m_ended; }

private:
    struct State;
    bool refill();

    std::shared_ptr<const SampleFile> m_file;
    std::uint64_t m_next;
    std::uint64_t m_left;
    std::unique_ptr<State> m_state;
    bool m_ok = true;
    bool m_ended = false;
};

} // namespace dyncal
