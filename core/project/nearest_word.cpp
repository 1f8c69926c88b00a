// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/nearest_word.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace dyncal {
namespace {

/// Longer words are cut, so that a hostile file cannot cause long comparisons.
constexpr std::size_t kLongestWord = 64;
/// Greatest extra distance of a key in another section.
constexpr Index kOtherSection = 3;

struct SplitKey
{
    std::string_view section;
    std::string_view name;
};

SplitKey split(std::string_view key)
{
    const std::size_t dot = key.rfind('.');
    if (dot == std::string_view::npos)
        return {{}, key};
    return {key.substr(0, dot), key.substr(dot + 1)};
}

Index keyDistance(std::string_view a, std::string_view b)
{
    const SplitKey left = split(a);
    const SplitKey right = split(b);
    return editDistance(left.name, right.name)
        + std::min(kOtherSection, editDistance(left.section, right.section));
}

} // namespace

Index editDistance(std::string_view a, std::string_view b)
{
    a = a.substr(0, kLongestWord);
    b = b.substr(0, kLongestWord);
    std::vector<Index> row(b.size() + 1);
    std::iota(row.begin(), row.end(), Index(0));
    for (std::size_t i = 0; i < a.size(); ++i) {
        Index diagonal = row[0];
        row[0] = static_cast<Index>(i) + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const Index replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

std::string nearestKey(std::string_view unknown, const std::vector<std::string> &known)
{
    std::string nearest;
    Index smallest = std::numeric_limits<Index>::max();
    for (const std::string &key : known) {
        const Index distance = keyDistance(unknown, key);
        if (distance < smallest) {
            smallest = distance;
            nearest = key;
        }
    }
    return nearest;
}

} // namespace dyncal
