// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/capture/formats/text/plain_row.h"
#include "core/capture/formats/text/text_source.h"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <string_view>
#include <thread>
#include <vector>

namespace dyncal {

/// Consecutive lines that are plain rows, as columns.
class PlainRows
{
public:
    explicit PlainRows(std::size_t columns)
        : m_columns(columns)
    {
    }

    Index rows() const { return static_cast<Index>(m_rows); }
    std::size_t columns() const { return m_columns; }
    std::span<const double> column(std::size_t i) const
    {
        return {m_values.get() + i * m_capacity, m_rows};
    }

    /// Replaces the rows by those of the text, up to a line that is no plain row; returns their
    /// bytes.
    std::size_t read(const PlainRowReader &reader, std::string_view text);

private:
    std::size_t m_columns;
    std::size_t m_rows = 0;
    std::size_t m_capacity = 0;
    std::unique_ptr<double[]> m_values; ///< not touched beyond the rows there are
};

/// Reads a table in parts of some 256 KiB, on its owner's thread and on further threads that run a
/// few parts ahead. A part ends early at the first line that is no plain row; the owner reads on
/// from there. A part depends only on the text after a line end, so the number of threads changes
/// no result.
class PlainRowsAhead
{
public:
    /// Reads the text from `begin` on, the beginning of a line; text and reader must outlive this
    /// object. Only the owner reads if the text is short or the machine has one core.
    PlainRowsAhead(const PlainRowReader &reader, const TextSource &text, std::uint64_t begin,
        std::size_t columns);
    PlainRowsAhead(const PlainRowsAhead &) = delete;
    PlainRowsAhead &operator=(const PlainRowsAhead &) = delete;
    ~PlainRowsAhead() = default; ///< stops and waits

    /// Where the next part begins. Empty after the last one: at the end of the text, or before it
    /// where lines are too long for parts or the text cannot be read.
    std::optional<std::uint64_t> nextBegin() const { return m_nextBegin; }

    struct Taken
    {
        const PlainRows &rows; ///< until the next part is taken
        std::uint64_t behind; ///< where in the text the next line begins
    };

    /// Reads the next part, or waits for it. Parts are taken in order; each once.
    Taken take();

    /// Forgets the next part, as its first line does not follow plain rows.
    void skip() { take(); }

private:
    struct Part
    {
        std::uint64_t begin = 0;
        std::uint64_t end = 0;
        std::uint64_t behind = 0; ///< its rows
        bool done = false;
        PlainRows rows;
    };

    Part &part(std::size_t number) { return m_parts[number % m_parts.size()]; }
    bool mayBegin() const;
    void readOne(std::unique_lock<std::mutex> &lock, std::vector<char> &buffer);
    std::uint64_t endOfPart(std::uint64_t begin, std::vector<char> &buffer) const;
    void fill(Part &part, std::vector<char> &buffer) const;
    void readAhead(const std::stop_token &stop, std::vector<char> &buffer);

    const PlainRowReader &m_reader;
    const TextSource &m_text;
    std::optional<std::uint64_t> m_nextBegin;
    std::vector<std::vector<char>> m_buffers; ///< one per thread, the owner's first

    std::mutex m_mutex; ///< for all below except the rows of parts, which have one user each
    std::condition_variable_any m_changed;
    std::vector<Part> m_parts; ///< a ring
    std::uint64_t m_begunText; ///< end of the text of the parts begun
    std::size_t m_begun = 0; ///< number of parts that somebody reads or has read
    std::size_t m_taken = 0;
    std::size_t m_free = 0; ///< parts that the owner no longer needs
    std::vector<std::jthread> m_threads; ///< last, as they use all the rest
};

} // namespace dyncal
