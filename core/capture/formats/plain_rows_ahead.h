// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/capture/formats/plain_row.h"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string_view>
#include <thread>
#include <vector>

namespace dyncal {

/// Lines of a table one behind the other, each of them a plain row.
struct PlainRows
{
    std::vector<std::vector<double>> columns; ///< equally long
    const char *behind = nullptr; ///< the last of these lines

    Index rows() const { return columns.empty() ? 0 : std::ssize(columns.front()); }
};

/// Reads the later parts of a table on threads of their own, while its owner reads the first. A
/// part ends early at the first line that is no plain row. As it depends on nothing but the text
/// behind a line end, whoever reads on there gets the same as without it: the number of threads
/// changes no result.
class PlainRowsAhead
{
public:
    /// `text` begins with a line and outlives this object. There are no parts if it is short or the
    /// machine has one core. A part that was stopped by `stop` has ended early, too.
    PlainRowsAhead(const PlainRowReader &reader, std::string_view text, std::size_t columns,
        const std::stop_token &stop);
    PlainRowsAhead(const PlainRowsAhead &) = delete;
    PlainRowsAhead &operator=(const PlainRowsAhead &) = delete;
    ~PlainRowsAhead() = default; ///< stops and waits

    /// Where the next part begins; null if there is none.
    const char *nextBegin() const;

    /// Waits for the next part. Parts are taken in order; each once.
    PlainRows take();

    /// Forgets the next part, as its first line does not follow plain rows.
    void skip();

private:
    struct Part
    {
        std::string_view text;
        PlainRows rows;
        std::jthread thread;
    };

    std::vector<Part> m_parts;
    std::size_t m_next = 0;
};

} // namespace dyncal
