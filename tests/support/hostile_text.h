// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/foreign_text.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal::test {

/// What somebody may have written into any text of any file. `file` is one that must not be opened.
inline std::vector<std::string> hostileTexts(const std::string &file = "/tmp/dyncal-not-there")
{
    using namespace std::string_literals;
    std::string storm = "Z";
    for (int i = 0; i < 60; ++i)
        storm += "\u0301\u0316";
    return {"<img src=\"file://" + file + "\">", "<img src=" + file + ">",
        "<a href=\"file://" + file + "\">open</a>", "<b>bold</b><br><h1>big</h1>",
        "<script>alert(1)</script>", "<style>*{color:red}</style>x", "&lt;b&gt; &amp; &#65; &nbsp;",
        "<table><tr><td background='" + file + "'>x</td></tr></table>",
        "<!DOCTYPE x [<!ENTITY e SYSTEM \"file://" + file + "\">]><x>&e;</x>", "]]><svg onload=x>",
        "-->\"><text>injected</text>", "&File && &Edit", "%1 %2 %n %L1 %%", "%s%n%x%p %08x",
        "\x1b]0;title\x07", "\x1b[2J\x1b[31mred",
        "\xc2\x9b"
        "2J\xc2\x9d"
        "0;t\xc2\x9c",
        "\x9b"
        "31m",
        "line\r\nDone.", "\nCAP-001 (block): false", "a\0b"s, "\x08\x08\x7f erased",
        "\u202egpj.exe\u202c", "\u2066left\u2069\u200f\u061c", "\xff\xfe\x80 no UTF-8",
        "\xc0\xaf\xe0\x80\xaf", "\xed\xa0\x80\xed\xb0\x80", "\xf4\x90\x80\x80 \xe2\x82",
        "=cmd|' /C calc'!A0", "+1+1", "-2+3", "@SUM(1+1)*cmd|' /C calc'!A0",
        "\t=HYPERLINK(\"http://x\")", "\"=1+1\",\"x", std::string(20000, 'W'), storm,
        "two\u2028lines\u2029here\u0085", "nan", "-inf", "../../../etc/passwd",
        "\", \"x\": {\"y\": [", "back\\slash\\\"quote'`$(id)`", "zero\u200bwidth\ufeff\u00ad\u2060",
        "\U000e0001\U000e0041 \ue000", "; rm -rf / #", "[*][*]", "\ufdfd\u3164\uffa0 wide"};
}

/// Whether this is valid UTF-8 without characters that act or hide; with LineBreaks::Keep it may
/// have line breaks.
inline bool isFitToShow(std::string_view text, LineBreaks breaks = LineBreaks::Escape)
{
    static constexpr std::array<std::string_view, 14> kNever{"\u202e", "\u202c", "\u2066", "\u2069",
        "\u200f", "\u061c", "\u2028", "\u2029", "\u200b", "\ufeff", "\u2060", "\u00ad",
        "\U000e0041", "\u0085"};
    const bool acts = std::ranges::any_of(text, [breaks](char c) {
        const bool isBreak = c == '\n' && breaks == LineBreaks::Keep;
        return (static_cast<unsigned char>(c) < 0x20 && !isBreak) || c == '\x7f';
    });
    if (acts || std::ranges::any_of(kNever, [text](auto c) { return text.find(c) != text.npos; }))
        return false;
    std::size_t following = 0;
    unsigned char before = 0;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (following > 0) {
            const bool control = before == 0xC2 && byte < 0xA0;
            const bool surrogate = before == 0xED && byte > 0x9F;
            const bool overlong
                = (before == 0xE0 && byte < 0xA0) || (before == 0xF0 && byte < 0x90);
            if ((byte & 0xC0U) != 0x80 || control || surrogate || overlong)
                return false;
            --following;
        } else if (byte >= 0x80) {
            if (byte < 0xC2 || byte > 0xF4)
                return false;
            following = byte >= 0xF0 ? 3 : byte >= 0xE0 ? 2 : 1;
        }
        before = byte;
    }
    return following == 0;
}

} // namespace dyncal::test
