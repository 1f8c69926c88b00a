// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/json_codec.h"

#include "core/base/calendar_date.h"
#include "core/base/number_text.h"
#include "core/project/nearest_word.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
constexpr std::size_t kLongestQuote = 48;

/// The value as a person would quote it from the file; long ones are cut.
std::string asFound(const Json &value)
{
    std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
    if (text.size() > kLongestQuote)
        text = text.substr(0, kLongestQuote) + "...";
    return text;
}

std::string keyName(const JsonAt &at)
{
    if (at.path.empty())
        return "(the whole)";
    return at.path.size() > 2 * kLongestQuote ? at.path.substr(0, 2 * kLongestQuote) + "..."
                                              : at.path;
}

/// "import.exclude[12].shot" -> "import.exclude[].shot"; free words in braces go too.
std::string withoutPlaces(const std::string &path)
{
    std::string plain;
    bool inPlace = false;
    for (const char c : path) {
        if (c == ']' || c == '}')
            inPlace = false;
        if (!inPlace)
            plain += c;
        if (c == '[' || c == '{')
            inPlace = true;
    }
    return plain;
}

std::string rangeWords(double least, double most, Bound bound)
{
    const bool open = bound == Bound::Exclusive;
    if (std::isinf(least) && std::isinf(most))
        return "a number";
    if (std::isinf(most))
        return std::string(open ? "a number above " : "a number of at least ") + numberText(least);
    return std::string("a number between ") + numberText(least) + " and " + numberText(most)
        + (open ? " (without these)" : "");
}

/// The value as a whole number, if it is one that a double holds exactly or an integer type does.
std::optional<Index> wholeValue(const Json &value)
{
    constexpr double kLargestExact = 9007199254740992.0; // 2^53
    if (value.is_number_unsigned()) {
        const auto v = value.get<std::uint64_t>();
        if (v > static_cast<std::uint64_t>(std::numeric_limits<Index>::max()))
            return std::nullopt;
        return static_cast<Index>(v);
    }
    if (value.is_number_integer())
        return value.get<Index>();
    if (!value.is_number_float())
        return std::nullopt;
    const double v = value.get<double>();
    if (v != std::floor(v) || std::abs(v) > kLargestExact)
        return std::nullopt;
    return static_cast<Index>(v);
}

Codec<std::string> textOfLength(std::size_t least, const char *needs)
{
    const auto read = [least, needs](const JsonAt &at) -> Result<std::string> {
        if (!at.value.is_string() || at.value.get_ref<const std::string &>().size() < least)
            return mismatch(at, needs);
        return at.value.get<std::string>();
    };
    return {needs, read, [](const std::string &value) { return Json(value); }};
}

} // namespace

tl::unexpected<Error> mismatch(const JsonAt &at, const std::string &needs)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core", "Recipe key %1 is %2; it needs %3."),
            {keyName(at), asFound(at.value), needs}});
}

tl::unexpected<Error> unknownKey(const JsonAt &at)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core", "Recipe key %1 is unknown; the nearest known key is %2."),
            {keyName(at), nearestKey(withoutPlaces(at.path), at.knownPaths)}});
}

JsonAt child(const JsonAt &object, const std::string &key)
{
    return {object.value.at(key), object.path.empty() ? key : object.path + "." + key,
        object.knownPaths};
}

JsonAt entry(const JsonAt &object, const std::string &key)
{
    return {object.value.at(key), object.path + "{" + key + "}", object.knownPaths};
}

Codec<double> number(double least, double most, Bound bound)
{
    const std::string needs = rangeWords(least, most, bound);
    const auto read = [=](const JsonAt &at) -> Result<double> {
        if (!at.value.is_number())
            return mismatch(at, needs);
        const double value = at.value.get<double>();
        const bool inside = bound == Bound::Exclusive ? value > least && value < most
                                                      : value >= least && value <= most;
        if (!std::isfinite(value) || !inside)
            return mismatch(at, needs);
        return value;
    };
    return {needs, read, [](const double &value) { return Json(value); }};
}

Codec<double> anyNumber()
{
    return number(-kUnlimited, kUnlimited);
}

Codec<double> positiveNumber()
{
    return number(0.0, kUnlimited, Bound::Exclusive);
}

Codec<double> nonNegativeNumber()
{
    return number(0.0, kUnlimited);
}

Codec<Index> whole(Index least, Index most)
{
    const std::string needs
        = "a whole number between " + std::to_string(least) + " and " + std::to_string(most);
    const auto read = [=](const JsonAt &at) -> Result<Index> {
        const std::optional<Index> value = wholeValue(at.value);
        if (!value || *value < least || *value > most)
            return mismatch(at, needs);
        return *value;
    };
    return {needs, read, [](const Index &value) { return Json(value); }};
}

Codec<bool> boolean()
{
    const auto read = [](const JsonAt &at) -> Result<bool> {
        if (!at.value.is_boolean())
            return mismatch(at, "true or false");
        return at.value.get<bool>();
    };
    return {"true or false", read, [](const bool &value) { return Json(value); }};
}

Codec<std::string> nonEmptyText()
{
    return textOfLength(1, "a text that is not empty");
}

Codec<std::string> anyText()
{
    return textOfLength(0, "a text");
}

Codec<std::string> oneOf(std::vector<std::string> words)
{
    std::string needs = words.size() > 1 ? "one of " : "";
    for (const std::string &word : words)
        needs += (&word == &words.front() ? "" : ", ")
            + (word.empty() ? "null" : asFound(Json(word)));
    const auto read = [words, needs](const JsonAt &at) -> Result<std::string> {
        const std::string word = at.value.is_string() ? at.value.get<std::string>() : "";
        const bool plain = at.value.is_string() || at.value.is_null();
        if (!plain || std::find(words.begin(), words.end(), word) == words.end())
            return mismatch(at, needs);
        return word;
    };
    const auto write
        = [](const std::string &value) { return value.empty() ? Json(nullptr) : Json(value); };
    return {needs, read, write};
}

Codec<Interval> interval()
{
    const char *needs = "a list of two numbers, the smaller first";
    const auto read = [needs](const JsonAt &at) -> Result<Interval> {
        if (!at.value.is_array() || at.value.size() != 2 || !at.value[0].is_number()
            || !at.value[1].is_number())
            return mismatch(at, needs);
        const Interval band{at.value[0].get<double>(), at.value[1].get<double>()};
        if (!(band.begin < band.end))
            return mismatch(at, needs);
        return band;
    };
    const auto write = [](const Interval &band) { return Json::array({band.begin, band.end}); };
    return {needs, read, write};
}

Codec<std::string> textOrNull()
{
    const Codec<std::optional<std::string>> plain = orNull(nonEmptyText());
    const auto read = [plain](const JsonAt &at) -> Result<std::string> {
        return plain.read(at).map(
            [](const std::optional<std::string> &text) { return text.value_or(""); });
    };
    return {plain.needs, read,
        [](const std::string &text) { return text.empty() ? Json(nullptr) : Json(text); }};
}

Codec<std::string> formedTextOrNull(std::string needs, bool (*hasForm)(std::string_view))
{
    const Codec<std::string> text = textOrNull();
    const auto read = [text, needs, hasForm](const JsonAt &at) -> Result<std::string> {
        const Result<std::string> found = text.read(at);
        if (!found || (!found->empty() && !hasForm(*found)))
            return mismatch(at, needs);
        return found;
    };
    return {std::move(needs), read, text.write};
}

Codec<std::string> dateOrNull()
{
    return formedTextOrNull("null or a date such as 2026-01-31", isCalendarDate);
}

} // namespace dyncal
