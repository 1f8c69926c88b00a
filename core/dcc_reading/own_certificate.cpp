// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc_reading/own_certificate.h"

#include <algorithm>

namespace dyncal {
namespace {

template <typename Named>
bool has(const Named &one, std::string_view refType)
{
    return std::ranges::find(one.refTypes, refType) != one.refTypes.end();
}

std::vector<const StatedTable *> tablesWith(const DccContents &contents, const char *refType)
{
    std::vector<const StatedTable *> tables;
    for (const StatedTable &table : contents.tables)
        if (has(table, refType))
            tables.push_back(&table);
    return tables;
}

/// The only one with this refType; null where there is none, or several.
template <typename Named>
const Named *onlyWith(const std::vector<Named> &all, std::string_view refType)
{
    const Named *found = nullptr;
    for (const Named &one : all) {
        if (has(one, refType) && found)
            return nullptr;
        found = has(one, refType) ? &one : found;
    }
    return found;
}

bool isSha256(const std::string &text)
{
    constexpr std::size_t kDigits = 64;
    return text.size() == kDigits
        && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

} // namespace

bool isOwnCertificate(const DccContents &contents)
{
    const auto isOwnType = [](const std::string &type) { return type.starts_with("dyncal_"); };
    const auto hasOwn
        = [&](const auto &one) { return std::ranges::any_of(one.refTypes, isOwnType); };
    return std::ranges::any_of(contents.tables, hasOwn)
        || std::ranges::any_of(contents.single, hasOwn);
}

const StatedQuantity *ownValue(const DccContents &contents, const char *refType)
{
    const StatedQuantity *found = nullptr;
    for (const StatedQuantity &one : contents.single) {
        const bool isMeant = one.refTypes.size() == 1 && one.refTypes.front() == refType
            && !one.isComplex() && one.stated.values.values.size() == 1;
        if (isMeant && found)
            return nullptr;
        found = isMeant ? &one : found;
    }
    return found;
}

std::vector<const StatedTable *> ownResponses(const DccContents &contents)
{
    const auto exact = tablesWith(contents, "dyncal_complexResponse");
    return exact.empty() ? tablesWith(contents, "dyncal_frequencyResponse") : exact;
}

std::vector<std::string> ownRecordings(const DccContents &contents)
{
    const StatedTable *table = onlyWith(contents.tables, "dyncal_recordings");
    const StatedWords *hashes = table ? onlyWith(table->words, "dyncal_sha256") : nullptr;
    if (!hashes || !std::ranges::all_of(hashes->entries, isSha256))
        return {};
    std::vector<std::string> sorted = hashes->entries;
    std::ranges::sort(sorted);
    return sorted;
}

} // namespace dyncal
