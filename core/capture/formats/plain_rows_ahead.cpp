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

/// Rows from the beginning of `text` to its end, to a line that is none, or until stopped.
template <typename Stopped>
PlainRows readRows(const PlainRowReader &reader, std::string_view text, std::size_t columns,
    const Stopped &stopped)
{
    constexpr std::size_t kFirstRows = 1024;
    constexpr double kSpare = 1.02;
    constexpr std::size_t kRowsPerCheck = 1 << 14;
    PlainRows result{std::vector<std::vector<double>>(columns), text.data()};
    std::vector<double> row(columns);
    const char *const end = text.data() + text.size();
    for (std::size_t count = 0; count % kRowsPerCheck != 0 || !stopped(); ++count) {
        const std::string_view rest(result.behind, static_cast<std::size_t>(end - result.behind));
        const char *const behind = reader.read(rest, row);
        if (behind == nullptr)
            break;
        if (count == kFirstRows) {
            const double done = static_cast<double>(result.behind - text.data());
            const double all = kSpare * static_cast<double>(count * text.size()) / done;
            for (std::vector<double> &column : result.columns) {
                column.reserve(static_cast<std::size_t>(all));
                preferLargePages(column.data(), column.capacity() * sizeof(double));
            }
        }
        for (std::size_t i = 0; i < columns; ++i)
            result.columns[i].push_back(row[i]);
        result.behind = behind;
    }
    return result;
}

/// The text in about equal parts that begin behind a line feed, the first left out.
std::vector<std::string_view> laterParts(std::string_view text)
{
    const std::size_t threads
        = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, kMostThreads);
    const std::size_t count = std::clamp<std::size_t>(text.size() / kPartBytes, 1, threads);
    std::vector<std::string_view> parts;
    std::size_t begin = 0;
    for (std::size_t k = 1; k <= count; ++k) {
        const std::size_t feed = k < count ? text.find('\n', text.size() / count * k) : text.size();
        const std::size_t next = std::min(feed, text.size() - 1) + 1;
        if (k > 1 && next > begin)
            parts.push_back(text.substr(begin, next - begin));
        begin = next;
    }
    return parts;
}

} // namespace

PlainRowsAhead::PlainRowsAhead(const PlainRowReader &reader, std::string_view text,
    std::size_t columns, const std::stop_token &stop)
{
    for (const std::string_view part : laterParts(text))
        m_parts.push_back({part, {{}, part.data()}, {}});
    const auto read = [&reader, columns, stop](const std::stop_token &own, Part &part) {
        const auto stopped = [&] { return own.stop_requested() || stop.stop_requested(); };
        try {
            part.rows = readRows(reader, part.text, columns, stopped);
        } catch (const std::bad_alloc &) {
            part.rows = {{}, part.text.data()}; // whoever reads on there will say so
        }
    };
    try {
        for (Part &part : m_parts)
            part.thread = std::jthread(read, std::ref(part));
    } catch (const std::system_error &) { // no more threads to be had: such parts hold no rows
    }
}

const char *PlainRowsAhead::nextBegin() const
{
    return m_next < m_parts.size() ? m_parts[m_next].text.data() : nullptr;
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
