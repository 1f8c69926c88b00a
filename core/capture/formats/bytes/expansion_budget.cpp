// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/bytes/expansion_budget.h"

#include "core/base/number_text.h"

#include <algorithm>

namespace dyncal {
namespace {

constexpr std::uint64_t kAlways = std::uint64_t(64) << 20;
constexpr double kMostExpanded = 0x1p62; ///< sums of two stay in range

std::uint64_t allowedFor(std::uint64_t fileBytes, double factor)
{
    const double grown = factor * static_cast<double>(fileBytes);
    return kAlways + static_cast<std::uint64_t>(std::clamp(grown, 0.0, kMostExpanded));
}

/// "141.3 MiB".
std::string mebibytesText(std::uint64_t bytes)
{
    constexpr double kMebibyte = 1 << 20;
    constexpr double kGibibyte = 1 << 30;
    const auto value = static_cast<double>(bytes);
    return value < kGibibyte ? numberText(value / kMebibyte, 4) + " MiB"
                             : numberText(value / kGibibyte, 4) + " GiB";
}

const char *textOf(Expanding what)
{
    switch (what) {
    case Expanding::ChannelsUpTo:
        return DYNCAL_TEXT("core",
            "%1: the channels up to %2 would take %3 of memory, more than the %4 that a file of this size may; if you trust the file, raise import.max_expansion in the recipe.");
    case Expanding::Columns:
        return DYNCAL_TEXT("core",
            "%1: its %2 columns would take %3 of memory, more than the %4 that a file of this size may; if you trust the file, raise import.max_expansion in the recipe.");
    case Expanding::RowsUpTo:
        return DYNCAL_TEXT("core",
            "%1: the rows up to line %2, with the blank lines and empty cells between, would take %3 of memory, more than the %4 that a file of this size may; if you trust the file, raise import.max_expansion in the recipe.");
    case Expanding::SegmentsUpTo:
        return DYNCAL_TEXT("core",
            "%1: the segments up to number %2 would take %3 of memory, more than the %4 that a file of this size may; if you trust the file, raise import.max_expansion in the recipe.");
    case Expanding::Pieces:
        return DYNCAL_TEXT("core",
            "%1: the places of its samples, which lie in %2 pieces, would take %3 of memory, more than the %4 that a file of this size may; if you trust the file, raise import.max_expansion in the recipe.");
    case Expanding::Objects:
        return DYNCAL_TEXT("core",
            "%1: names and attributes of the first %2 objects in it would take %3 of memory, more than the %4 that a file of this size may; if you trust the file, raise import.max_expansion in the recipe.");
    case Expanding::Channel:
        break;
    }
    return DYNCAL_TEXT("core",
        "%1: channel %2 would take %3 of memory, more than the %4 that a file of this size may; if you trust the file, raise import.max_expansion in the recipe.");
}

} // namespace

ExpansionBudget::ExpansionBudget(std::uint64_t fileBytes, double factor)
    : m_allowed(allowedFor(fileBytes, factor))
{
}

bool ExpansionBudget::take(std::uint64_t bytes)
{
    if (bytes > m_allowed - m_taken)
        return false;
    m_taken += bytes;
    return true;
}

void ExpansionBudget::giveBack(std::uint64_t bytes)
{
    m_taken -= std::min(bytes, m_taken);
}

tl::unexpected<Error> ExpansionBudget::exceededBy(
    const std::string &path, Expanding what, const std::string &name, std::uint64_t bytes) const
{
    return fail(ErrorKind::FileUnreadable, expansionSentence(path, what, name, bytes, m_allowed),
        "CAP-018");
}

Message expansionSentence(const std::string &path, Expanding what, const std::string &name,
    std::uint64_t bytes, std::uint64_t allowed)
{
    return {textOf(what), {path, name, mebibytesText(bytes), mebibytesText(allowed)}};
}

} // namespace dyncal
