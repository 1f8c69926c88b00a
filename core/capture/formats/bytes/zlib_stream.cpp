// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/bytes/zlib_stream.h"

#include <zlib.h>

#include <algorithm>
#include <array>

namespace dyncal {

struct ZlibStream::State
{
    z_stream stream{};
    std::array<std::byte, 1 << 16> input{};
};

ZlibStream::ZlibStream(
    std::shared_ptr<const SampleFile> file, std::uint64_t offset, std::uint64_t bytes)
    : m_file(std::move(file))
    , m_next(offset)
    , m_left(bytes)
    , m_state(std::make_unique<State>())
{
    m_ok = inflateInit(&m_state->stream) == Z_OK;
}

ZlibStream::~ZlibStream()
{
    inflateEnd(&m_state->stream);
}

bool ZlibStream::refill()
{
    const auto piece
        = static_cast<std::size_t>(std::min<std::uint64_t>(m_left, m_state->input.size()));
    if (piece == 0 || !m_file->read(m_next, piece, m_state->input.data()))
        return false;
    m_state->stream.next_in = reinterpret_cast<Bytef *>(m_state->input.data());
    m_state->stream.avail_in = static_cast<uInt>(piece);
    m_next += piece;
    m_left -= piece;
    return true;
}

std::size_t ZlibStream::read(std::span<std::byte> target)
{
    constexpr std::size_t kPiece = 1 << 20; // zlib counts in 32 bits
    std::size_t done = 0;
    while (m_ok && !m_ended && done < target.size()) {
        if (m_state->stream.avail_in == 0 && !refill()) {
            m_ok = false; // the stream is cut
            break;
        }
        const std::size_t room = std::min(kPiece, target.size() - done);
        m_state->stream.next_out = reinterpret_cast<Bytef *>(target.data() + done);
        m_state->stream.avail_out = static_cast<uInt>(room);
        const int result = inflate(&m_state->stream, Z_NO_FLUSH);
        done += room - m_state->stream.avail_out;
        m_ended = result == Z_STREAM_END;
        m_ok = m_ended || result == Z_OK || result == Z_BUF_ERROR;
    }
    return done;
}

} // namespace dyncal
