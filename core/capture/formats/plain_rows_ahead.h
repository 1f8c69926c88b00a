// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/capture/formats/plain_row.h"
#include "core/capture/formats/text_source.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

namespace dyncal {

/// Lines of a table one behind the other, each of them a plain row.
struct PlainRows
{
    std::vector<std::vector<double>> columns; ///< equally long
    std::uint64_t behind = 0; ///< where in the text the next line begins

    Index rows() const { return columns.empty() ? 0 : std::ssize(columns.front()); }
};

/// Reads the later parts of a table on threads of their own, while its owner reads the first. A
/// part ends early at the first line that is no plain row. As it depends on nothing but the text
/// behind a line end, whoever reads on there gets the same as without it: the number of threads
/// changes no result.
class PlainRowsAhead
{
public:
    /// Of the text from `begin` on, which is the beginning of a line; text and reader outlive this
    /// object. There are no parts if it is short or the machine has one core. A part that was
    /// stopped by `stop` has ended early, too.
    PlainRowsAhead(const PlainRowReader &reader, const TextSource &text, std::uint64_t begin,
        std::size_t columns, const std::stop_token &stop);
    PlainRowsAhead(const PlainRowsAhead &) = delete;
    PlainRowsAhead &operator=(const PlainRowsAhead &) = delete;
    ~PlainRowsAhead() = default; ///< stops and waits

    /// Where the next part begins, if there is one.
    std::optional<std::uint64_t> nextBegin() const;

    /// Waits for the next part. Parts are taken in order; each once.
    PlainRows take();

    /// Forgets the next part, as its first line does not follow plain rows.
    void skip();

private:
    struct Part
    {
        std::uint64_t begin = 0;
        std::uint64_t end = 0;
        PlainRows rows;
        std::jthread thread;
    };

    std::vector<Part> m_parts;
    std::size_t m_next = 0;
};

} // namespace dyncal
