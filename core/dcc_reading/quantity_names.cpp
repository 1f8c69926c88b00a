// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc_reading/quantity_names.h"

#include "core/base/ascii_text.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

using Words = std::vector<std::string>;

bool isOfWord(char c)
{
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x80 || (byte >= '0' && byte <= '9') || (byte >= 'a' && byte <= 'z');
}

Words wordsOf(std::string_view text)
{
    Words words;
    bool isInside = false;
    for (const char c : text) {
        if (isOfWord(c) && !isInside)
            words.emplace_back();
        isInside = isOfWord(c);
        if (isInside)
            words.back() += c;
    }
    return words;
}

template <std::size_t N>
bool isAnyOf(std::string_view word, const std::array<std::string_view, N> &all)
{
    return std::ranges::find(all, word) != all.end();
}

template <std::size_t N>
bool hasAnyOf(std::string_view word, const std::array<std::string_view, N> &parts)
{
    return std::ranges::any_of(
        parts, [&](std::string_view part) { return word.find(part) != word.npos; });
}

/// What follows them does not say what it is.
constexpr std::array<std::string_view, 20> kBeyond{"with", "mit", "med", "incl", "including",
    "inkl", "inklusive", "einschl", "at", "bei", "vid", "and", "und", "och", "for", "without",
    "ohne", "utan", "f\xC3\xBCr", "f\xC3\xB6r"};
/// What follows them says whose it is.
constexpr std::array<std::string_view, 7> kWhose{"of", "der", "des", "von", "vom", "av", "hos"};

template <std::size_t N>
void endBefore(Words &words, const std::array<std::string_view, N> &ends)
{
    const auto end
        = std::ranges::find_if(words, [&](const std::string &word) { return isAnyOf(word, ends); });
    words.erase(end, words.end());
}

/// The parts between commas and brackets, in lower case, each up to what only belongs to it.
std::vector<Words> partsOf(const std::string &name)
{
    constexpr std::string_view kMarks = "()[]{},;:/";
    const std::string text = lowerCase(name);
    std::vector<Words> parts;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find_first_of(kMarks, at), text.size());
        parts.push_back(wordsOf(std::string_view(text).substr(at, end - at)));
        endBefore(parts.back(), kBeyond);
        at = end + 1;
    }
    return parts;
}

// Parts of words, without the capital umlaut that a word may begin with: lowerCase() leaves it.
constexpr std::array<std::string_view, 48> kAbout{"uncertain", "unsicherheit", "kerhet",
    "deviation", "abweichung", "avvikelse", "error", "fehler", "m\xC3\xA4tfel", "change", "nderung",
    "ndring", "drift", "limit", "grenz", "gr\xC3\xA4ns", "transvers", "quer", "tv\xC3\xA4r",
    "coefficient", "koeffizient", "koefficient", "toleran", "correction", "korrekt", "hysteres",
    "linearit", "linj\xC3\xA4r", "repeatab", "wiederhol", "repeterbar", "reproduc", "reproduz",
    "stability", "stabilit", "difference", "skillnad", "residu", "streu", "scatter", "spread",
    "sollwert", "b\xC3\xB6rv\xC3\xA4rde", "coverage", "noise", "rausch", "brus", "threshold"};
constexpr std::array<std::string_view, 7> kNominal{"nominal", "nominell", "nenn", "referenzwert",
    "bezugswert", "referensv\xC3\xA4rde", "m\xC3\xA4rkv\xC3\xA4rde"};
constexpr std::array<std::string_view, 6> kBand{
    "bandwidth", "bandbreit", "bandbredd", "resolution", "aufl\xC3\xB6sung", "uppl\xC3\xB6sning"};
/// Whole words that a name begins with.
constexpr std::array<std::string_view, 8> kSymbols{
    "u", "uc", "u95", "mu", "unc", "dev", "cross", "fel"};
constexpr std::array<std::string_view, 4> kOthers{"value", "standard", "transducer", "sensor"};

/// "Reference value" and such; "reference sensitivity" is that at the reference frequency.
bool isOfReference(const Words &words)
{
    for (std::size_t i = 0; i + 1 < words.size(); ++i)
        if (words[i] == "reference" && isAnyOf(words[i + 1], kOthers))
            return true;
    return false;
}

template <std::size_t N>
bool hasWordWith(const std::vector<Words> &parts, const std::array<std::string_view, N> &stems)
{
    return std::ranges::any_of(parts, [&](const Words &words) {
        return std::ranges::any_of(
            words, [&](const std::string &word) { return hasAnyOf(word, stems); });
    });
}

/// Errors and such, of values and of frequencies.
bool isAbout(const std::vector<Words> &parts)
{
    const Words &first = parts.front();
    return hasWordWith(parts, kAbout) || (!first.empty() && isAnyOf(first.front(), kSymbols));
}

constexpr std::array<std::string_view, 12> kTypesAbout{"error", "limit", "deviation", "uncertainty",
    "tolerance", "correction", "drift", "hysteresis", "transverse", "coverage", "linearity",
    "repeatability"};
constexpr std::array<std::string_view, 4> kTypesNominal{
    "nominal", "referencevalue", "referencestandard", "referencetransducer"};

template <std::size_t N>
bool hasTypeWith(
    const std::vector<std::string> &refTypes, const std::array<std::string_view, N> &parts)
{
    return std::ranges::any_of(
        refTypes, [&](const std::string &type) { return hasAnyOf(lowerCase(type), parts); });
}

bool hasTypeOf(const std::vector<std::string> &refTypes, std::string_view begin)
{
    return std::ranges::any_of(
        refTypes, [&](const std::string &type) { return type.starts_with(begin); });
}

} // namespace

bool isAboutAValue(const std::string &name, const std::vector<std::string> &refTypes)
{
    if (hasTypeOf(refTypes, "dyncal_"))
        return false;
    if (hasTypeWith(refTypes, kTypesAbout) || hasTypeWith(refTypes, kTypesNominal))
        return true;
    if (hasTypeOf(refTypes, "vib_"))
        return false;
    const std::vector<Words> parts = partsOf(name);
    return isAbout(parts) || hasWordWith(parts, kNominal)
        || std::ranges::any_of(parts, isOfReference);
}

bool isAboutAFrequency(const std::string &name, const std::vector<std::string> &refTypes)
{
    if (hasTypeOf(refTypes, "dyncal_"))
        return false;
    if (hasTypeWith(refTypes, kTypesAbout))
        return true;
    if (hasTypeOf(refTypes, "vib_") || hasTypeOf(refTypes, "basic_tableIndex0"))
        return false;
    const std::vector<Words> parts = partsOf(name);
    return isAbout(parts) || hasWordWith(parts, kBand);
}

bool isCalled(const std::string &name, const std::vector<std::string_view> &words)
{
    constexpr std::size_t kLongestSymbol = 3; // "natural frequency f0"
    const std::vector<Words> parts = partsOf(name);
    if (isAbout(parts) || hasWordWith(parts, kNominal))
        return false;
    Words head = parts.front();
    endBefore(head, kWhose);
    while (head.size() > 1 && head.back().size() <= kLongestSymbol)
        head.pop_back();
    std::string text;
    for (const std::string &word : head)
        text += (text.empty() ? "" : " ") + word;
    return std::ranges::any_of(words, [&](std::string_view word) {
        const std::size_t at = text.rfind(word);
        return at != text.npos && text.find(' ', at + word.size()) == text.npos;
    });
}

bool isOfSurroundings(const std::string &name, const std::vector<std::string> &refTypes)
{
    constexpr std::array<std::string_view, 4> kParts{"temperatur", "humidity", "feucht", "fukt"};
    return hasAnyOf(lowerCase(name), kParts) || hasTypeWith(refTypes, kParts);
}

} // namespace dyncal
