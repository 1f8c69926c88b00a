// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/columns_text.h"

#include <algorithm>

namespace dyncal {
namespace {

/// How many characters of UTF-8.
std::size_t widthOf(const std::string &text)
{
    return static_cast<std::size_t>(std::ranges::count_if(
        text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

} // namespace

std::string filledTo(std::size_t width, const std::string &text)
{
    const std::size_t own = widthOf(text);
    return own < width ? text + std::string(width - own, ' ') : text;
}

std::string columnsText(const std::vector<std::vector<std::string>> &rows)
{
    std::vector<std::size_t> widths;
    for (const auto &row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], widthOf(row[i]));
    }
    std::string text;
    for (const auto &row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i)
            text += i + 1 < row.size() ? filledTo(widths[i] + 2, row[i]) : row[i] + '\n';
    }
    return text;
}

} // namespace dyncal
