// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/foreign_text.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace dyncal {

namespace {

constexpr char32_t kReplacement = 0xFFFD;
constexpr char32_t kZeroWidthNonJoiner = 0x200C;
constexpr char32_t kZeroWidthJoiner = 0x200D;
constexpr int kMostMarks = 8; ///< on one letter; real scripts have up to four

struct Range
{
    char32_t first, last;
};

template <std::size_t count>
bool isIn(const std::array<Range, count> &ranges, char32_t c)
{
    return std::ranges::any_of(ranges, [c](Range r) { return c >= r.first && c <= r.last; });
}

/// Controls, characters without width, those that change the direction of writing, letters that
/// look like blanks, characters for private use.
bool isUnseen(char32_t c)
{
    static constexpr std::array<Range, 20> kUnseen{{{0x00, 0x1F}, {0x7F, 0x9F}, {0xAD, 0xAD},
        {0x034F, 0x034F}, {0x061C, 0x061C}, {0x115F, 0x1160}, {0x17B4, 0x17B5}, {0x180E, 0x180E},
        {0x200B, 0x200F}, {0x2028, 0x202E}, {0x2060, 0x206F}, {0x3164, 0x3164}, {0xE000, 0xF8FF},
        {0xFDD0, 0xFDEF}, {0xFEFF, 0xFEFF}, {0xFFA0, 0xFFA0}, {0xFFF0, 0xFFFB}, {0x1BCA0, 0x1BCA3},
        {0x1D173, 0x1D17A}, {0xE0000, 0xE00FF}}};
    return isIn(kUnseen, c) || (c & 0xFFFE) == 0xFFFE || c >= 0xF0000;
}

bool isMark(char32_t c)
{
    static constexpr std::array<Range, 5> kMarks{
        {{0x0300, 0x036F}, {0x1AB0, 0x1AFF}, {0x1DC0, 0x1DFF}, {0x20D0, 0x20FF}, {0xFE20, 0xFE2F}}};
    return isIn(kMarks, c);
}

/// Joiners are legitimate between two characters of some scripts, and within emoji.
bool isJoined(char32_t before, char32_t c, char32_t after)
{
    constexpr char32_t kFirstJoining = 0x0600;
    return (c == kZeroWidthJoiner || c == kZeroWidthNonJoiner) && before >= kFirstJoining
        && after >= kFirstJoining && !isUnseen(before) && !isUnseen(after);
}

bool isFollowing(std::string_view bytes, std::size_t at)
{
    return at < bytes.size() && (static_cast<unsigned char>(bytes[at]) & 0xC0U) == 0x80;
}

/// The character at `at`, which moves past it. In what is no UTF-8 (an overlong form, a surrogate,
/// beyond Unicode, cut short) each byte that does not fit gives one replacement character.
char32_t next(std::string_view bytes, std::size_t &at)
{
    const auto first = static_cast<unsigned char>(bytes[at++]);
    if (first < 0x80)
        return first;
    const int following = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
    if (first < 0xC2 || first > 0xF4)
        return kReplacement;
    char32_t c = first & (0x3FU >> following);
    const std::size_t begin = at;
    for (int i = 0; i < following; ++i) {
        if (!isFollowing(bytes, at))
            return kReplacement;
        c = (c << 6U) | (static_cast<unsigned char>(bytes[at++]) & 0x3FU);
    }
    static constexpr std::array<char32_t, 4> kLeast{0, 0x80, 0x800, 0x10000};
    if (c >= kLeast[static_cast<std::size_t>(following)] && c <= 0x10FFFF
        && (c < 0xD800 || c > 0xDFFF))
        return c;
    at = begin;
    return kReplacement;
}

void append(std::string &text, char32_t c)
{
    const auto put = [&text](char32_t byte) { text += static_cast<char>(byte); };
    if (c < 0x80) {
        put(c);
    } else if (c < 0x800) {
        put(0xC0U | (c >> 6U));
        put(0x80U | (c & 0x3FU));
    } else if (c < 0x10000) {
        put(0xE0U | (c >> 12U));
        put(0x80U | ((c >> 6U) & 0x3FU));
        put(0x80U | (c & 0x3FU));
    } else {
        put(0xF0U | (c >> 18U));
        put(0x80U | ((c >> 12U) & 0x3FU));
        put(0x80U | ((c >> 6U) & 0x3FU));
        put(0x80U | (c & 0x3FU));
    }
}

std::string hex(char32_t c, int digits, const char *letters)
{
    std::string text;
    for (int digit = digits > 4 && c < 0x100000 ? 4 : digits - 1; digit >= 0; --digit)
        text += letters[(c >> (4U * static_cast<unsigned>(digit))) & 0xFU];
    return text;
}

/// How a character that cannot be shown is written.
std::string escaped(char32_t c)
{
    constexpr const char *kCapital = "0123456789ABCDEF";
    switch (c) {
    case '\n':
        return "\\n";
    case '\r':
        return "\\r";
    case '\t':
        return "\\t";
    default:
        break;
    }
    if (c < 0x80)
        return "\\x" + hex(c, 2, "0123456789abcdef");
    return "<U+" + hex(c, c > 0xFFFF ? 6 : 4, kCapital) + ">";
}

/// Walks over text and gives each character to `show` or `escape`.
template <typename Show, typename Escape>
void walk(std::string_view bytes, Show show, Escape escape)
{
    char32_t before = 0;
    int marks = 0;
    for (std::size_t at = 0; at < bytes.size();) {
        const char32_t c = next(bytes, at);
        std::size_t ahead = at;
        const char32_t after = at < bytes.size() ? next(bytes, ahead) : 0;
        marks = isMark(c) ? marks + 1 : 0;
        if ((isUnseen(c) && !isJoined(before, c, after)) || marks > kMostMarks)
            escape(c, after);
        else
            show(c);
        before = c;
    }
}

bool isPlainAscii(std::string_view text)
{
    return std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; });
}

/// Position in `text` (valid UTF-8) after its first `count` characters.
std::size_t placeOf(std::string_view text, std::size_t count)
{
    std::size_t at = 0;
    for (; at < text.size() && count > 0; --count) {
        ++at;
        while (isFollowing(text, at))
            ++at;
    }
    return at;
}

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// Whether a text that begins with a sign is a number, perhaps with a unit or an uncertainty after
/// a blank: "-1.5e-3", "-2,33 MHz", "-1.2 ×10^-7 1/Pa". A dash alone is no formula either.
bool isNumberWithUnit(std::string_view text)
{
    std::size_t at = 1;
    while (at < text.size() && (isDigit(text[at]) || text[at] == '.' || text[at] == ','))
        ++at;
    if (at == 1)
        return text == "-" || text == "+";
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        ++at;
        if (at < text.size() && (text[at] == '+' || text[at] == '-'))
            ++at;
        if (at == text.size() || !isDigit(text[at]))
            return false;
        while (at < text.size() && isDigit(text[at]))
            ++at;
    }
    if (at < text.size() && text[at] != ' ')
        return false;
    for (; at < text.size(); ++at) {
        const char c = text[at];
        const bool isWord = isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')
            || static_cast<unsigned char>(c) >= 0x80 || c == ' ' || c == '.' || c == ',' || c == '%'
            || c == '/' || c == '^' || (c == '-' && text[at - 1] == '^');
        if (!isWord)
            return false;
    }
    return true;
}

/// Whether spreadsheets would begin to compute at the start of `text`.
bool beginsFormula(std::string_view text)
{
    static constexpr std::array<std::string_view, 4> kWide{
        "\xEF\xBC\x9D", "\xEF\xBC\x8B", "\xEF\xBC\x8D", "\xEF\xBC\xA0"}; // = + - @ of East Asia
    if (text.empty())
        return false;
    if (text[0] == '+' || text[0] == '-')
        return !isNumberWithUnit(text);
    return text[0] == '=' || text[0] == '@'
        || std::ranges::any_of(kWide, [text](auto wide) { return text.starts_with(wide); });
}

} // namespace

std::string presentable(std::string_view bytes, LineBreaks breaks)
{
    if (isPlainAscii(bytes))
        return std::string(bytes);
    std::string text;
    text.reserve(bytes.size() + 16);
    walk(
        bytes, [&text](char32_t c) { append(text, c); },
        [&](char32_t c, char32_t after) {
            const bool kept = breaks == LineBreaks::Keep;
            if (kept && (c == '\n' || c == '\t'))
                append(text, c);
            else if (!kept || c != '\r' || after != '\n')
                text += escaped(c);
        });
    return text;
}

std::string presentableInBrief(std::string_view bytes, std::size_t most)
{
    // A shown character takes at most four bytes of the input.
    constexpr std::size_t kBytesOfCharacter = 4;
    const std::size_t enough = kBytesOfCharacter * most + kBytesOfCharacter;
    std::string text = bytes.size() > 2 * enough
        ? presentable(bytes.substr(0, enough)) + presentable(bytes.substr(bytes.size() - enough))
        : presentable(bytes);
    if (text.size() <= most)
        return text;
    const auto count = static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
    if (count <= most)
        return text;
    const std::size_t tail = most / 3;
    const std::size_t head = most - tail - 1;
    return text.substr(0, placeOf(text, head)) + "\xE2\x80\xA6"
        + text.substr(placeOf(text, count - tail));
}

std::string spreadsheetText(std::string_view bytes)
{
    const std::string text = presentable(bytes);
    std::string cell;
    bool atStart = true;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (atStart && beginsFormula(std::string_view(text).substr(at)))
            cell.insert(at == text.find_first_not_of(' ') ? 0 : cell.size(), 1, '\'');
        const char c = text[at];
        // Where the comma is the decimal mark, cells are separated by another mark, even inside
        // quotes.
        atStart = c == ';' || c == ',' || c == '"' || (c == ' ' && atStart);
        cell += c;
    }
    return cell;
}

std::string pastedCell(std::string_view bytes)
{
    const std::string cell = spreadsheetText(bytes);
    if (!cell.starts_with('"'))
        return cell;
    std::string quoted(1, '"');
    for (const char c : cell)
        quoted.append(c == '"' ? 2 : 1, c);
    return quoted + '"';
}

std::string presentableJson(std::string_view json)
{
    std::string text;
    text.reserve(json.size());
    const auto unit = [&text](char32_t u) { text += "\\u" + hex(u, 4, "0123456789abcdef"); };
    walk(
        json, [&text](char32_t c) { append(text, c); },
        [&](char32_t c, char32_t) {
            if (c < 0x20 || isMark(c)) { // JSON has line breaks outside its texts
                append(text, c);
            } else if (c > 0xFFFF) {
                unit(0xD800 + ((c - 0x10000) >> 10U));
                unit(0xDC00 + ((c - 0x10000) & 0x3FFU));
            } else {
                unit(c);
            }
        });
    return text;
}

} // namespace dyncal
