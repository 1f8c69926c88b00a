// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc_reading/d_si_numbers.h"

#include "core/base/constants.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

/// The D-SI's word where there is no value.
constexpr std::string_view kNoValue = "NaN";

tl::unexpected<Error> noNumber(const ParsedElement &element, std::string_view word)
{
    if (word.find(',') != word.npos)
        return notUnderstood(element,
            DYNCAL_TEXT("core",
                "Line %1, %2: '%3' has a comma; numbers of a certificate have a point as decimal mark, and which is meant is not guessed."),
            {std::string(word)});
    return notUnderstood(element,
        DYNCAL_TEXT("core", "Line %1, %2: '%3' is no finite number, and one is needed."),
        {std::string(word)});
}

tl::unexpected<Error> holdsElement(const ParsedElement &element)
{
    return notUnderstood(element,
        DYNCAL_TEXT("core",
            "Line %1, %2: the element %3 stands among its text, so what belongs together in it is not known; text alone is needed."),
        {element.children.front().name});
}

tl::unexpected<Error> otherCount(const ParsedElement &element, std::size_t found, std::size_t count)
{
    return notUnderstood(element,
        DYNCAL_TEXT("core",
            "Line %1, %2: it has %3 entries for %4 values; one for all or one for each is needed."),
        {std::to_string(found), std::to_string(count)});
}

tl::unexpected<Error> unknownUnit(const ParsedElement &element, std::string_view word)
{
    return notUnderstood(element,
        DYNCAL_TEXT("core",
            "Line %1, %2: '%3' is no unit that is known here; a unit of the D-SI, such as \\volt\\pascal\\tothe{-1}, is needed."),
        {std::string(word)});
}

tl::unexpected<Error> mixedUnits(
    const ParsedElement &element, std::string_view first, std::string_view other)
{
    return notUnderstood(element,
        DYNCAL_TEXT("core",
            "Line %1, %2: the units '%3' and '%4' stand in one list; values of one unit are needed."),
        {std::string(first), std::string(other)});
}

} // namespace

tl::unexpected<Error> notUnderstood(
    const ParsedElement &element, const char *text, std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), {std::to_string(element.line), element.name});
    return fail(ErrorKind::Usage, {text, std::move(arguments)});
}

Result<const ParsedElement *> neededChild(const ParsedElement &element, std::string_view name)
{
    const std::vector<const ParsedElement *> found = element.all(name);
    if (found.size() == 1)
        return found.front();
    if (found.size() > 1)
        return notUnderstood(element,
            DYNCAL_TEXT(
                "core", "Line %1, %2: it has the element %3 more than once; one is needed."),
            {std::string(name)});
    return notUnderstood(element,
        DYNCAL_TEXT("core", "Line %1, %2: it lacks the element %3, without which it says nothing."),
        {std::string(name)});
}

Result<std::vector<double>> numbersIn(const ParsedElement &element)
{
    if (!element.children.empty())
        return holdsElement(element);
    const bool isList = element.name.ends_with("XMLList");
    std::vector<double> numbers;
    for (const std::string &word : wordsIn(element.text)) {
        const bool isNone = isList && word == kNoValue;
        const std::optional<double> number = isNone ? std::optional(kUnknown) : parseNumber(word);
        if (!number || (!isNone && !std::isfinite(*number)))
            return noNumber(element, word);
        numbers.push_back(*number);
    }
    if (numbers.empty())
        return noNumber(element, "");
    return numbers;
}

Result<std::vector<double>> numbersIn(const ParsedElement &element, std::size_t count)
{
    Result<std::vector<double>> numbers = numbersIn(element);
    if (!numbers || numbers->size() == count)
        return numbers;
    if (numbers->size() != 1)
        return otherCount(element, numbers->size(), count);
    return std::vector<double>(count, numbers->front());
}

Result<std::vector<double>> numbersOfChild(
    const ParsedElement &element, std::string_view name, std::size_t count)
{
    return neededChild(element, name).and_then([count](const ParsedElement *child) {
        return numbersIn(*child, count);
    });
}

Result<ListedUnit> unitIn(const ParsedElement &element, std::size_t count)
{
    if (!element.children.empty())
        return holdsElement(element);
    const std::vector<std::string> words = wordsIn(element.text);
    if (words.size() != 1 && words.size() != count)
        return otherCount(element, words.size(), count);
    ListedUnit listed;
    for (const std::string &word : words) {
        const std::optional<DSiUnit> unit = parseDSiUnit(word);
        if (!unit)
            return unknownUnit(element, word);
        if (listed.factors.empty())
            listed.unit.powers = unit->powers;
        if (unit->powers != listed.unit.powers)
            return mixedUnits(element, words.front(), word);
        listed.factors.push_back(unit->factor);
    }
    listed.factors.resize(count, listed.factors.back());
    return listed;
}

} // namespace dyncal
