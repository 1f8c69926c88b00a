// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc_reading/meant_quantity.h"

#include "core/dcc_reading/quantity_names.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

template <typename Quantity>
std::vector<const Quantity *> markedOf(
    const std::vector<const Quantity *> &all, std::string_view mark)
{
    std::vector<const Quantity *> marked;
    std::ranges::copy_if(all, std::back_inserter(marked),
        [&](const Quantity *one) { return one->hasRefType(mark); });
    return marked;
}

/// Without complex ones where there are real ones, or where no complex ones are asked for.
void preferReal(std::vector<const StatedQuantity *> &all, bool mayBeComplex)
{
    const auto isComplex = [](const StatedQuantity *one) { return one->isComplex(); };
    if (!mayBeComplex || !std::ranges::all_of(all, isComplex))
        std::erase_if(all, isComplex);
}

const StatedQuantity *onlyUncertain(const std::vector<const StatedQuantity *> &all)
{
    const StatedQuantity *found = nullptr;
    for (const StatedQuantity *one : all) {
        if (one->stated.values.u.empty())
            continue;
        if (found)
            return nullptr;
        found = one;
    }
    return found;
}

const StatedQuantity *chosen(const MeantQuantity &among, const QuantityRole &role)
{
    for (const std::string_view mark : role.marks) {
        const auto marked = markedOf(among.inUnit, mark);
        if (!markedOf(among.unread, mark).empty())
            return nullptr;
        if (marked.size() == 1)
            return marked.front();
    }
    if (!among.unread.empty())
        return nullptr;
    return among.inUnit.size() == 1 ? among.inUnit.front() : onlyUncertain(among.inUnit);
}

bool isOfAnotherRole(const UnreadQuantity &unread, const QuantityRole &role)
{
    constexpr std::array<std::string_view, 3> kRoles{"vib_", "dyncal_", "basic_tableIndex"};
    const auto isOfRole = [&](const std::string &type) {
        return std::ranges::any_of(
            kRoles, [&](std::string_view begin) { return type.starts_with(begin); });
    };
    const auto isMark = [&](const std::string &type) {
        return std::ranges::find(role.marks, type) != role.marks.end();
    };
    return std::ranges::any_of(unread.refTypes, isOfRole)
        && std::ranges::none_of(unread.refTypes, isMark);
}

} // namespace

bool mayBe(const UnreadQuantity &unread, const QuantityRole &role)
{
    if (role.isAbout(unread.name, unread.refTypes) || isOfAnotherRole(unread, role))
        return false;
    if (unread.unit)
        return role.isInUnit(*unread.unit);
    return !(role.isAxis && unread.isNoAxis) && !isOfSurroundings(unread.name, unread.refTypes);
}

MeantQuantity meantQuantity(const StatedTable &table, const QuantityRole &role)
{
    MeantQuantity among;
    for (const StatedQuantity &one : table.columns)
        if (role.isInUnit(one.stated.values.unit))
            (role.isAbout(one.name, one.refTypes) ? among.about : among.inUnit).push_back(&one);
    preferReal(among.inUnit, role.mayBeComplex);
    for (const UnreadQuantity &one : table.unread)
        if (mayBe(one, role))
            among.unread.push_back(&one);
    among.meant = chosen(among, role);
    return among;
}

} // namespace dyncal
