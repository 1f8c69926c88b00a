// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc_reading/dcc_contents.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// What a quantity must be to be the frequencies, magnitudes or phases of a list.
struct QuantityRole
{
    std::function<bool(const DSiUnit &unit)> isInUnit;
    std::vector<std::string_view> marks; ///< refTypes, the strongest first
    bool isAxis = false; ///< frequencies or angles
    bool mayBeComplex = false; ///< real ones go before complex ones
    bool (*isAbout)(const std::string &name, const std::vector<std::string> &refTypes)
        = nullptr; ///< what is about it and not it: isAboutAValue(), isAboutAFrequency()
};

/// The quantities of a list for a role.
struct MeantQuantity
{
    const StatedQuantity *meant = nullptr; ///< null: none, or it is not clear which
    std::vector<const StatedQuantity *> inUnit = {}; ///< those that could be it
    std::vector<const StatedQuantity *> about = {}; ///< those in its unit that are about it
    /// Those that are not understood and may be it: then no neighbour is taken for it.
    std::vector<const UnreadQuantity *> unread = {};
};

/// The only one with the strongest mark; else the only one that could be it; else the only one of
/// them that states an uncertainty. One that is not understood counts as one with its marks, and
/// where its unit is that of the role or unknown it could be it, unless it is about it, is marked
/// for another role (vib_..., dyncal_..., basic_tableIndex...), is of the surroundings, or its
/// unknown unit names what the role does not have (UnreadQuantity::isNoAxis).
MeantQuantity meantQuantity(const StatedTable &table, const QuantityRole &role);

/// Whether it may be it: as above.
bool mayBe(const UnreadQuantity &unread, const QuantityRole &role);

} // namespace dyncal
