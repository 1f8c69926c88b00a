// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/template_logo.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace dyncal {
namespace {

constexpr std::size_t kMostPixels = 4000; ///< along one side

tl::unexpected<Error> notDrawn(const std::string &name, const char *sentence)
{
    return fail(ErrorKind::Usage, {sentence, {name, std::to_string(kMostPixels)}});
}

/// Big-endian, as PNG has it.
std::size_t wholeAt(std::string_view bytes, std::size_t at)
{
    std::size_t value = 0;
    for (std::size_t i = at; i < at + 4; ++i)
        value = 256 * value + static_cast<unsigned char>(bytes[i]);
    return value;
}

/// Signature, length and kind of the first chunk, width and height (PNG, ISO/IEC 15948, 5.2, 11.2).
bool isSmallPng(std::string_view bytes)
{
    constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR", 16);
    constexpr std::size_t kHead = 24;
    if (bytes.size() < kHead || !bytes.starts_with(kSignature))
        return false;
    const std::size_t width = wholeAt(bytes, 16);
    const std::size_t height = wholeAt(bytes, 20);
    return std::min(width, height) >= 1 && std::max(width, height) <= kMostPixels;
}

std::string inLowerCase(std::string_view text)
{
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(),
        [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    return lower;
}

/// What would have other files read, or hides what is drawn.
bool standsByItself(std::string_view svg)
{
    constexpr std::array<std::string_view, 7> kForeign{
        "href", "<!entity", "<!doctype", "<script", "<style", "<?xml-stylesheet", "@import"};
    const std::string text = inLowerCase(svg);
    if (text.find("<svg") == text.npos || text.find('\0') != text.npos)
        return false;
    for (std::size_t at = text.find("url("); at != text.npos; at = text.find("url(", at + 1))
        if (!std::string_view(text).substr(at).starts_with("url(#"))
            return false;
    return std::ranges::none_of(
        kForeign, [&](std::string_view word) { return text.find(word) != text.npos; });
}

} // namespace

Result<void> checkLogo(const std::string &name, const std::string &bytes)
{
    if (name.ends_with(".png") && !isSmallPng(bytes))
        return notDrawn(name,
            DYNCAL_TEXT("core",
                "The logo %1 is no PNG image of at most %2 x %2 pixels; make it smaller, or use an SVG."));
    if (name.ends_with(".svg") && !standsByItself(bytes))
        return notDrawn(name,
            DYNCAL_TEXT("core",
                "The logo %1 is no SVG drawing that stands by itself; it must hold no links (href), document type, entities, scripts or style sheets: save it as a plain SVG."));
    return {};
}

} // namespace dyncal
