// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/channel_units.h"

#include <array>

namespace dyncal {
namespace {

struct KnownUnit
{
    const char *name;
    const char *si;
    double factor;
};

constexpr std::array<KnownUnit, 17> kUnits{{{"Pa", "Pa", 1.0}, {"kPa", "Pa", 1e3},
    {"MPa", "Pa", 1e6}, {"hPa", "Pa", 100.0}, {"mbar", "Pa", 100.0}, {"bar", "Pa", 1e5},
    {"psi", "Pa", 6894.757}, {"V", "V", 1.0}, {"mV", "V", 1e-3}, {"uV", "V", 1e-6},
    {"\u00b5V", "V", 1e-6}, {"\u03bcV", "V", 1e-6}, {"kV", "V", 1e3}, {"Volt", "V", 1.0},
    {"Volts", "V", 1.0}, {"volt", "V", 1.0}, {"volts", "V", 1.0}}};

} // namespace

std::optional<SiUnit> siUnitOf(std::string_view unit)
{
    for (const KnownUnit &known : kUnits) {
        if (unit == known.name)
            return SiUnit{known.si, known.factor};
    }
    return std::nullopt;
}

std::optional<std::string> unitInName(std::string_view name)
{
    const std::size_t mark = name.find_last_of("_ ");
    if (mark == std::string_view::npos || mark == 0)
        return std::nullopt;
    const std::string_view word = name.substr(mark + 1);
    const bool isNumeral = word == "V" && name[mark] == ' ';
    return siUnitOf(word) && !isNumeral ? std::optional(std::string(word)) : std::nullopt;
}

} // namespace dyncal
