// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/time_words.h"

#include "core/base/ascii_text.h"

#include <algorithm>
#include <array>
#include <utility>

namespace dyncal {
namespace {

using UnitFactor = std::pair<std::string_view, double>;

constexpr auto kTimeUnits = std::to_array<UnitFactor>({{"s", 1.0}, {"sec", 1.0}, {"secs", 1.0},
    {"second", 1.0}, {"seconds", 1.0}, {"sek", 1.0}, {"sekunden", 1.0}, {"ms", 1e-3},
    {"msec", 1e-3}, {"millisecond", 1e-3}, {"milliseconds", 1e-3}, {"us", 1e-6}, {"usec", 1e-6},
    {"\u00B5s", 1e-6}, {"\u03BCs", 1e-6}, {"\u00B5sec", 1e-6}, {"microsecond", 1e-6},
    {"microseconds", 1e-6}, {"ns", 1e-9}, {"nsec", 1e-9}, {"nanosecond", 1e-9},
    {"nanoseconds", 1e-9}, {"ps", 1e-12}, {"psec", 1e-12}});

constexpr auto kRateUnits = std::to_array<UnitFactor>({{"hz", 1.0}, {"khz", 1e3}, {"mhz", 1e6},
    {"ghz", 1e9}, {"hertz", 1.0}, {"s/s", 1.0}, {"ks/s", 1e3}, {"ms/s", 1e6}, {"gs/s", 1e9},
    {"sa/s", 1.0}, {"ksa/s", 1e3}, {"msa/s", 1e6}, {"gsa/s", 1e9}, {"sps", 1.0}, {"ksps", 1e3},
    {"msps", 1e6}, {"gsps", 1e9}, {"1/s", 1.0}, {"samples/s", 1.0}});

constexpr auto kTimeNames = std::to_array<std::string_view>(
    {"time", "times", "t", "zeit", "tid", "temps", "tiempo", "tempo", "czas", "x_value", "x value",
        "timestamp", "elapsed time", "relative time", "rel. time", "zeitachse", "time axis"});

constexpr auto kFrequencyWords = std::to_array<std::string_view>(
    {"freq", "frek", "fr\u00E9q", "fr\u00E9c", "frec", "cz\u0119st"});

constexpr auto kRowNumberNames
    = std::to_array<std::string_view>({"index", "idx", "i", "k", "n", "#", "no", "no.", "nr", "nr.",
        "row", "point", "sample", "samples", "sample number", "sample no", "sequence", "counter"});

template <typename Table>
std::optional<double> factorOf(const Table &table, std::string_view unit)
{
    const std::string word = lowerCase(std::string(unit));
    for (const auto &[name, factor] : table) {
        if (name == word)
            return factor;
    }
    return std::nullopt;
}

} // namespace

std::optional<double> secondsPerUnit(std::string_view unit)
{
    return factorOf(kTimeUnits, unit);
}

std::optional<double> hertzPerUnit(std::string_view unit)
{
    return factorOf(kRateUnits, unit);
}

ColumnTitle withUnitSplit(ColumnTitle title)
{
    const std::size_t mark = title.name.find_last_of("_ ");
    if (!title.unit.empty() || mark == std::string::npos || mark == 0
        || !secondsPerUnit(std::string_view(title.name).substr(mark + 1)))
        return title;
    std::string_view name = trimmed(std::string_view(title.name).substr(0, mark));
    if (name.ends_with(" in"))
        name = trimmed(name.substr(0, name.size() - 3));
    return {std::string(name), title.name.substr(mark + 1)};
}

bool isTimeTitle(const ColumnTitle &title)
{
    const ColumnTitle split = withUnitSplit(title);
    const std::string name = lowerCase(split.name);
    if (name == "t" && !split.unit.empty() && !secondsPerUnit(split.unit))
        return false;
    return std::find(kTimeNames.begin(), kTimeNames.end(), name) != kTimeNames.end();
}

bool isFrequencyTitle(const ColumnTitle &title)
{
    const std::string name = lowerCase(title.name);
    const bool named = std::any_of(kFrequencyWords.begin(), kFrequencyWords.end(),
        [&](std::string_view word) { return name.starts_with(word); });
    return named || hertzPerUnit(title.unit) || lowerCase(title.unit) == "rad/s";
}

bool isNeutralTitle(const ColumnTitle &title)
{
    return title.name.empty() || lowerCase(title.name) == "x" || title.name.starts_with("column ");
}

bool isRowNumberTitle(const ColumnTitle &title)
{
    const auto isName = [](const std::string &text) {
        const std::string word = lowerCase(text);
        return std::find(kRowNumberNames.begin(), kRowNumberNames.end(), word)
            != kRowNumberNames.end();
    };
    return isName(title.name) || isName(title.unit);
}

} // namespace dyncal
