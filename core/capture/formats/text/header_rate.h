// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/text/text_dialect.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// A sample rate that the lines before the data state, as rate or as interval.
struct HeaderRate
{
    double rate_Hz = 0.0;
    bool unitStated = false; ///< else Hz or s were assumed
    Index line = 0; ///< from 1
    std::string text; ///< "Sample rate: 10 MHz" as in the file, for messages
};

/// All statements like "Sample rate: 10 MHz", "Sampling interval [us],0.01", "fs = 50000" or a cell
/// "Increment" with a number below it, in order. Without a unit a statement counts only if it gives
/// at least kCredibleRate_Hz. "50,000 Hz" above decimal points counts for nothing, nor "50.000"
/// above decimal commas: it may be 50 kHz as well as 50 Hz.
std::vector<HeaderRate> headerRates(const TextDialect &dialect);

/// Least rate that is accepted from a number without unit.
constexpr double kCredibleRate_Hz = 100.0;

} // namespace dyncal
