// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace dyncal {

/// The samples of one channel exactly as recorded: integer counts where the source has counts.
/// Immutable and shared, so copies of a shot cost nothing. Whole records are never converted to
/// double; only the part that an analysis asks for is (`physicalValues` in channel.h).
class RawSamples
{
public:
    using Counts = std::variant<std::vector<std::int16_t>, std::vector<std::int32_t>,
        std::vector<float>, std::vector<double>>;

    RawSamples();
    explicit RawSamples(Counts counts);

    Index size() const { return m_size; }
    bool isInteger() const { return m_counts->index() < 2; }

    /// Raw value (count, or value for floating point sources) of sample `i`, 0 <= i < size().
    double at(Index i) const;

    /// Bytes of the samples as stored in memory (little endian): what raw_sha256 is taken of.
    std::span<const std::byte> bytes() const;

    const Counts &counts() const { return *m_counts; }

private:
    std::shared_ptr<const Counts> m_counts;
    Index m_size = 0;
};

} // namespace dyncal
