// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/plain_rows_ahead.h"

#include "core/base/allowed_threads.h"
#include "core/capture/formats/text/text_source.h"

#include <algorithm>
#include <new>
#include <system_error>

namespace dyncal {
namespace {

constexpr std::uint64_t kMostThreads = 8; ///< with more the owner's joining is the limit
constexpr std::uint64_t kThreadBytes = 1 << 20; ///< at least, as one takes some 0.1 ms to start
constexpr std::uint64_t kPartBytes = 1 << 18; ///< text and rows stay in a core's own cache
constexpr std::size_t kPartsPerThread = 2; ///< one being read and one waiting for the owner

/// Number of threads that pay off, with the owner's.
std::uint64_t threadsFor(std::uint64_t bytes)
{
    const std::uint64_t cores = std::min<std::uint64_t>(allowedThreads(), kMostThreads);
    return std::clamp<std::uint64_t>(bytes / kThreadBytes, 1, cores);
}

} // namespace

std::size_t PlainRows::read(const PlainRowReader &reader, std::string_view text)
{
    const std::size_t most = text.size() / (2 * m_columns) + 1; // a cell takes two bytes
    m_rows = 0;
    if (most > m_capacity) {
        m_capacity = 0;
        m_values = std::make_unique_for_overwrite<double[]>(most * m_columns);
        m_capacity = most;
    }
    const std::size_t before = text.size();
    m_rows = reader.readRows(text, m_columns, m_values.get(), m_capacity);
    return before - text.size();
}

PlainRowsAhead::PlainRowsAhead(
    const PlainRowReader &reader, const TextSource &text, std::uint64_t begin, std::size_t columns)
    : m_reader(reader)
    , m_text(text)
    , m_begunText(begin)
{
    const std::uint64_t bytes = text.size() - begin;
    const std::uint64_t threads = threadsFor(bytes);
    if (bytes > 0)
        m_nextBegin = begin;
    m_buffers.resize(threads, std::vector<char>(text.inMemory() ? 0 : std::min(bytes, kPartBytes)));
    for (std::size_t k = 0; k < kPartsPerThread * threads; ++k)
        m_parts.push_back({0, 0, 0, false, PlainRows(columns)});
    try {
        for (std::size_t k = 1; k < threads; ++k)
            m_threads.emplace_back(
                [this, k](const std::stop_token &stop) { readAhead(stop, m_buffers[k]); });
    } catch (const std::system_error &) { // no more threads to be had
    }
}

PlainRowsAhead::Taken PlainRowsAhead::take()
{
    std::unique_lock lock(m_mutex);
    m_free = m_taken;
    m_changed.notify_all();
    while (m_begun == m_taken || !part(m_taken).done) {
        if (mayBegin())
            readOne(lock, m_buffers.front());
        else
            m_changed.wait(lock);
    }
    const Part &taken = part(m_taken++);
    const bool last = taken.end == taken.begin || taken.end == m_text.size();
    m_nextBegin = last ? std::nullopt : std::optional(taken.end);
    return {taken.rows, taken.behind};
}

/// Whether there is a part left, and room for it.
bool PlainRowsAhead::mayBegin() const
{
    return m_begunText < m_text.size() && m_begun < m_free + m_parts.size();
}

/// Begins the next part and reads it, without the lock.
void PlainRowsAhead::readOne(std::unique_lock<std::mutex> &lock, std::vector<char> &buffer)
{
    Part &mine = part(m_begun++);
    mine.begin = m_begunText;
    mine.end = endOfPart(mine.begin, buffer);
    mine.done = false;
    m_begunText = mine.end == mine.begin ? m_text.size() : mine.end;
    lock.unlock();
    fill(mine, buffer);
    lock.lock();
    mine.done = true;
    m_changed.notify_all();
}

/// The place after the last line feed within the size of a part; `begin` where no line feed is
/// found near the end, or the text cannot be read.
std::uint64_t PlainRowsAhead::endOfPart(std::uint64_t begin, std::vector<char> &buffer) const
{
    const std::uint64_t end = std::min(begin + kPartBytes, m_text.size());
    if (end == m_text.size())
        return end;
    for (const std::uint64_t lookedAt : {kPartBytes / 64, kPartBytes / 4}) {
        const auto piece = m_text.read(end - lookedAt, end, buffer);
        const std::size_t feed = piece ? piece->rfind('\n') : std::string_view::npos;
        if (feed != std::string_view::npos)
            return end - lookedAt + feed + 1;
    }
    return begin;
}

void PlainRowsAhead::fill(Part &part, std::vector<char> &buffer) const
{
    part.behind = part.begin;
    const auto text = m_text.read(part.begin, part.end, buffer);
    try {
        part.behind += part.rows.read(m_reader, text.value_or(std::string_view()));
    } catch (const std::bad_alloc &) { // the owner reads on here and reports it
    }
}

void PlainRowsAhead::readAhead(const std::stop_token &stop, std::vector<char> &buffer)
{
    std::unique_lock lock(m_mutex);
    while (m_changed.wait(lock, stop, [this] { return mayBegin(); }) && !stop.stop_requested())
        readOne(lock, buffer);
}

} // namespace dyncal
