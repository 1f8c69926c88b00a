// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_list_rules.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace dyncal {
namespace {

constexpr std::size_t kMostShown = 60;

std::string shown(const std::string &text)
{
    if (text.size() <= kMostShown)
        return text;
    std::size_t end = kMostShown; // not inside a character of UTF-8
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
        --end;
    return text.substr(0, end) + "...";
}

/// An element whose text is a list; others of such a name only hold lists.
bool isListOfTexts(const DccNode &node)
{
    return node.name().ends_with("XMLList") && node.children().empty();
}

bool isSingleSpaced(const std::string &text)
{
    return !text.empty() && text.front() != ' ' && text.back() != ' '
        && text.find("  ") == text.npos && text.find_first_of("\t\r\n") == text.npos;
}

/// All lists inside a list of numbers, those of its uncertainties too.
void collect(const DccNode &node, std::vector<DccNode> &lists)
{
    for (const DccNode &child : node.children()) {
        if (isListOfTexts(child))
            lists.push_back(child);
        else
            collect(child, lists);
    }
}

/// How many values it has; empty: it is no list of values.
std::optional<std::size_t> countOf(const DccNode &list)
{
    for (const DccNode &child : list.children())
        for (const char *name : {"valueXMLList", "valueRealXMLList", "valueMagnitudeXMLList"})
            if (child.name() == name)
                return wordsIn(child.text()).size();
    return std::nullopt;
}

/// One for each value; others may be one for all.
bool isOfEachValue(const std::string &name)
{
    constexpr std::string_view kValues[] = {"valueXMLList", "valueRealXMLList", "valueImagXMLList",
        "valueMagnitudeXMLList", "valuePhaseXMLList"};
    return std::ranges::find(kValues, name) != std::end(kValues);
}

void checkList(const DccNode &list, std::vector<DccFinding> &findings)
{
    const auto count = countOf(list);
    if (!count)
        return;
    std::vector<DccNode> parts;
    collect(list, parts);
    for (const DccNode &part : parts) {
        const std::size_t size = wordsIn(part.text()).size();
        const bool isOne
            = size == 1 && !(isOfEachValue(part.name()) && part.parentName() == list.name());
        if (size != *count && !isOne)
            findings.push_back({"length", part.path(), std::to_string(size),
                {DYNCAL_TEXT(
                     "core", "A list has one text for each of the %1 values, or one for all."),
                    {std::to_string(*count)}}});
    }
}

/// Quantities of one dcc:list are columns of one table.
void checkColumns(const DccNode &table, std::vector<DccFinding> &findings)
{
    std::optional<std::size_t> rows;
    for (const DccNode &quantity : table.children())
        for (const DccNode &list : quantity.children()) {
            const auto count = countOf(list);
            if (!count || *count == 1)
                continue;
            if (rows && *rows != *count)
                findings.push_back({"length", quantity.path(), std::to_string(*count),
                    {DYNCAL_TEXT("core",
                         "The quantities of a list have one number of values; the first has %1."),
                        {std::to_string(*rows)}}});
            rows = rows.value_or(*count);
        }
}

/// "-1", "0.5"
bool isExponent(std::string_view text)
{
    constexpr std::string_view kDigits = "0123456789";
    text.remove_prefix(text.starts_with('-') ? 1 : 0);
    const std::size_t end = std::min(text.find_first_not_of(kDigits), text.size());
    if (end == 0 || end == text.size())
        return end > 0;
    const std::string_view behind = text.substr(end + 1);
    return text[end] == '.' && !behind.empty() && behind.find_first_not_of(kDigits) == behind.npos;
}

/// Takes "\pascal" or "\tothe{-1}" from the front; false where there is none.
bool takePart(std::string_view &text)
{
    if (!text.starts_with('\\'))
        return false;
    const std::size_t end = std::min(
        text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ", 1),
        text.size());
    if (end == 1)
        return false;
    text.remove_prefix(end);
    if (!text.starts_with('{'))
        return true;
    const std::size_t close = text.find('}');
    if (close == text.npos || !isExponent(text.substr(1, close - 1)))
        return false;
    text.remove_prefix(close + 1);
    return true;
}

/// "\volt\mega\pascal\tothe{-1}"
bool isUnit(std::string_view text)
{
    if (text.empty())
        return false;
    while (!text.empty())
        if (!takePart(text))
            return false;
    return true;
}

} // namespace

void checkLists(const DccTree &tree, std::vector<DccFinding> &findings)
{
    for (const DccNode &node : tree.all())
        if (isListOfTexts(node) && !isSingleSpaced(node.text()))
            findings.push_back({"list", node.path(), shown(node.text()),
                {DYNCAL_TEXT(
                     "core", "A list has single blanks between its texts, and none at its ends."),
                    {}}});
}

void checkLengths(const DccTree &tree, std::vector<DccFinding> &findings)
{
    for (const char *name : {"realListXMLList", "complexListXMLList"})
        for (const DccNode &list : tree.all(name))
            checkList(list, findings);
    for (const DccNode &table : tree.all("list"))
        checkColumns(table, findings);
}

void checkUnits(const DccTree &tree, std::vector<DccFinding> &findings)
{
    const auto check = [&](const DccNode &node, const std::vector<std::string> &units) {
        for (const std::string &unit : units)
            if (!isUnit(unit)) {
                findings.push_back({"unit", node.path(), shown(unit),
                    {DYNCAL_TEXT("core",
                         "A unit is written as the D-SI does, without blanks, like \\volt\\pascal\\tothe{-1}."),
                        {}}});
                return;
            }
    };
    for (const char *name : {"unitXMLList", "unitPhaseXMLList"})
        for (const DccNode &node : tree.all(name))
            check(node, wordsIn(node.text()));
    for (const char *name : {"unit", "unitPhase"})
        for (const DccNode &node : tree.all(name))
            check(node, {node.text()});
}

} // namespace dyncal
