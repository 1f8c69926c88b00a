// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/plain_rows_ahead.h"

#include "core/capture/formats/large_pages.h"

#include <algorithm>
#include <functional>
#include <new>
#include <system_error>
#include <utility>

namespace dyncal {
namespace {

constexpr std::size_t kMostThreads = 8; ///< memory is the bottleneck beyond
constexpr std::size_t kPartBytes = 1 << 20; ///< at least, as a thread takes some 0.1 ms to start

/// For all rows of `bytes`, if they are as long as those so far, of `done` bytes.
void makeRoom(PlainRows &rows, double done, double bytes)
{
    constexpr double kSpare = 1.02;
    const double expected = static_cast<double>(rows.rows()) * bytes / done;
    if (expected <= static_cast<double>(rows.columns.front().capacity()))
        return;
    for (std::vector<double> &column : rows.columns) {
        column.reserve(static_cast<std::size_t>(kSpare * expected));
        preferLargePages(column.data(), column.capacity() * sizeof(double));
    }
}

/// Rows of [begin, end) up to a line that is none, or until stopped.
template <typename Stopped>
PlainRows readRows(const PlainRowReader &reader, const TextSource &text, std::uint64_t begin,
    std::uint64_t end, std::size_t columns, const Stopped &stopped)
{
    PlainRows result{std::vector<std::vector<double>>(columns), begin};
    std::vector<double> row(columns);
    LineBlocks blocks(text, begin);
    for (std::string_view rest = blocks.next(end); !rest.empty();) {
        const char *const behind = reader.read(rest, row);
        if (behind == nullptr)
            break;
        for (std::size_t i = 0; i < columns; ++i)
            result.columns[i].push_back(row[i]);
        result.behind += static_cast<std::uint64_t>(behind - rest.data());
        rest.remove_prefix(static_cast<std::size_t>(behind - rest.data()));
        if (!rest.empty())
            continue;
        makeRoom(
            result, static_cast<double>(result.behind - begin), static_cast<double>(end - begin));
        rest = stopped() ? std::string_view() : blocks.next(end);
    }
    return result;
}

/// Where parts of about equal length begin, behind a line feed each, the first left out; and the
/// end of the text.
std::vector<std::uint64_t> boundaries(const TextSource &text, std::uint64_t begin)
{
    constexpr std::uint64_t kLongestLine = 1 << 16;
    const std::uint64_t threads
        = std::clamp<std::uint64_t>(std::thread::hardware_concurrency(), 1, kMostThreads);
    const std::uint64_t bytes = text.size() - begin;
    const std::uint64_t count = std::clamp<std::uint64_t>(bytes / kPartBytes, 1, threads);
    std::vector<std::uint64_t> places;
    std::vector<char> buffer;
    for (std::uint64_t k = 1; k < count; ++k) {
        const std::uint64_t at = begin + bytes / count * k;
        const auto piece = text.read(at, std::min(at + kLongestLine, text.size()), buffer);
        const std::size_t feed = piece ? piece->find('\n') : std::string_view::npos;
        if (feed != std::string_view::npos)
            places.push_back(at + feed + 1);
    }
    places.push_back(text.size());
    return places;
}

} // namespace

PlainRowsAhead::PlainRowsAhead(const PlainRowReader &reader, const TextSource &text,
    std::uint64_t begin, std::size_t columns, const std::stop_token &stop)
{
    const std::vector<std::uint64_t> places = boundaries(text, begin);
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
        if (places[k] < places[k + 1])
            m_parts.push_back({places[k], places[k + 1], {{}, places[k]}, {}});
    }
    const auto read = [&reader, &text, columns, stop](const std::stop_token &own, Part &part) {
        const auto stopped = [&] { return own.stop_requested() || stop.stop_requested(); };
        try {
            part.rows = readRows(reader, text, part.begin, part.end, columns, stopped);
        } catch (const std::bad_alloc &) {
            part.rows = {{}, part.begin}; // whoever reads on there will say so
        }
    };
    try {
        for (Part &part : m_parts)
            part.thread = std::jthread(read, std::ref(part));
    } catch (const std::system_error &) { // no more threads to be had: such parts hold no rows
    }
}

std::optional<std::uint64_t> PlainRowsAhead::nextBegin() const
{
    return m_next < m_parts.size() ? std::optional(m_parts[m_next].begin) : std::nullopt;
}

PlainRows PlainRowsAhead::take()
{
    Part &part = m_parts[m_next++];
    if (part.thread.joinable())
        part.thread.join();
    return std::move(part.rows);
}

void PlainRowsAhead::skip()
{
    m_parts[m_next].thread.request_stop();
    take();
}

} // namespace dyncal
