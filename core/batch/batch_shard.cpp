// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/batch_shard.h"

#include <charconv>
#include <optional>
#include <string_view>

namespace dyncal {
namespace {

constexpr std::size_t kMostShards = 1'000'000;

std::optional<std::size_t> wholeNumber(std::string_view text)
{
    std::size_t value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool isWhole = problem == std::errc() && end == text.data() + text.size();
    return isWhole && value >= 1 && value <= kMostShards ? std::optional(value) : std::nullopt;
}

} // namespace

Result<BatchShard> parseShard(const std::string &text)
{
    if (text.empty())
        return BatchShard{};
    const std::string_view whole = text;
    const std::size_t slash = std::min(whole.find('/'), whole.size());
    const auto number = wholeNumber(whole.substr(0, slash));
    const auto count = wholeNumber(whole.substr(std::min(slash + 1, whole.size())));
    if (number && count && *number <= *count)
        return BatchShard{*number, *count};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "--shard is \"%1\"; it needs K/N, whole numbers with K from 1 to N and N at most 1000000, for example 3/7."),
            {text}});
}

} // namespace dyncal
