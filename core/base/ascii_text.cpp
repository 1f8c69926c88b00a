// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/ascii_text.h"

#include <algorithm>

namespace dyncal {
namespace {

constexpr std::string_view kBlanks = " \t";

} // namespace

std::string lowerCase(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
        [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && kBlanks.find(text.front()) != std::string_view::npos)
        text.remove_prefix(1);
    while (!text.empty() && kBlanks.find(text.back()) != std::string_view::npos)
        text.remove_suffix(1);
    return text;
}

std::string commaList(const std::vector<std::string> &texts, std::size_t most)
{
    std::string list;
    for (std::size_t i = 0; i < std::min(texts.size(), most); ++i)
        list += (i > 0 ? ", " : "") + texts[i];
    return texts.size() > most ? list + ", ..." : list;
}

} // namespace dyncal
