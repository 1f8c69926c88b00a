// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <optional>
#include <span>

namespace dyncal {

/// The first numbers of a column that describe the rest, as PTB's digitizers write them: number of
/// samples, interval in s, and perhaps trigger index and the trigger's place within its sample.
struct CountedHeader
{
    Index lines = 0; ///< 2 to 4
    Index declared = 0; ///< samples
    double interval_s = 0.0;
    bool complete = false; ///< there are as many samples as declared
};

/// Recognised by its count, which must be the number of rows after it; four suitable numbers with
/// another count are an incomplete file. For columns without title only.
std::optional<CountedHeader> countedHeader(std::span<const double> column);

} // namespace dyncal
