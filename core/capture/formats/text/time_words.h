// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dyncal {

/// Name and unit of a column as far as the header says.
struct ColumnTitle
{
    std::string name;
    std::string unit;
};

// The words for time and frequency in texts from instruments and spreadsheets.

/// 1e-3 for "ms" or "Milliseconds"; empty if the word is no unit of time.
std::optional<double> secondsPerUnit(std::string_view unit);

/// 1e6 for "MHz" or "MS/s"; empty if the word is no unit of frequency or sample rate.
std::optional<double> hertzPerUnit(std::string_view unit);

/// The same title with a unit that was part of the name: "time_ms", "t in ms", "Zeit ms".
ColumnTitle withUnitSplit(ColumnTitle title);

/// Whether the title of a column says that it holds times. "t" with another unit than one of time
/// is a temperature.
bool isTimeTitle(const ColumnTitle &title);

/// Whether the title of a column says that it holds frequencies.
bool isFrequencyTitle(const ColumnTitle &title);

/// Whether the title says nothing of the column's quantity: there is none, or it is "X".
bool isNeutralTitle(const ColumnTitle &title);

/// Whether the title says that the column numbers the rows: "index", "sample", or Rigol's "X" in
/// "Sequence".
bool isRowNumberTitle(const ColumnTitle &title);

} // namespace dyncal
