// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/capture/import_settings.h"

#include <cstdint>
#include <string>

namespace dyncal {

/// What would take too much memory; the comments say which name the sentence needs.
enum class Expanding {
    Channel, ///< its name
    ChannelsUpTo, ///< name of the last
    Columns, ///< their number
    RowsUpTo, ///< number of the line; counts blank lines and empty cells
    SegmentsUpTo, ///< number of the last
    Pieces, ///< number of stretches in which samples lie in the file
    Objects, ///< number of those whose names and attributes were read
};

/// Memory that the contents of one file may take: 64 MiB and import.max_expansion times its size. A
/// reader asks before it allocates what a file only claims to hold, be it compressed, repeated or
/// left blank; helper processes get their limits from it (docs/adr/0019).
class ExpansionBudget
{
public:
    explicit ExpansionBudget(std::uint64_t fileBytes, double factor = kUsualExpansion);

    std::uint64_t allowed() const { return m_allowed; }
    std::uint64_t taken() const { return m_taken; }

    /// Whether so much may still be allocated; if so, it is counted.
    bool take(std::uint64_t bytes);
    /// For memory that was taken and is free again.
    void giveBack(std::uint64_t bytes);

    /// Error for the file `path`, of which `what` would need so many bytes (CAP-018).
    tl::unexpected<Error> exceededBy(const std::string &path, Expanding what,
        const std::string &name, std::uint64_t bytes) const;

private:
    std::uint64_t m_allowed;
    std::uint64_t m_taken = 0;
};

/// Memory of a channel besides its samples: names, unit, scale.
inline constexpr std::uint64_t kBytesOfChannel = 1024;

/// The sentence alone, for callers without a budget.
Message expansionSentence(const std::string &path, Expanding what, const std::string &name,
    std::uint64_t bytes, std::uint64_t allowed);

} // namespace dyncal
