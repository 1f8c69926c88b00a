// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc_reading/dcc_quantities.h"

#include "core/dcc_reading/d_si_numbers.h"
#include "core/dcc_reading/dcc_words_read.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

/// What holds the values; null where there are words only.
const ParsedElement *valuesIn(const ParsedElement &quantity)
{
    const ParsedElement *words = nullptr;
    for (const ParsedElement &child : quantity.children) {
        if (isDSiElement(child) || child.name == "list")
            return &child;
        if (child.name == "noQuantity" || child.name == "charsXMLList")
            words = &child;
    }
    return words ? nullptr : &quantity;
}

/// readXml() of readDcc() names it so.
bool isForeign(const ParsedElement &element)
{
    return element.name.starts_with('{');
}

/// The first at any depth below; null where there is none.
const ParsedElement *foreignIn(const ParsedElement &element)
{
    for (const ParsedElement &child : element.children) { // no deeper than kDeepestXml
        if (isForeign(child))
            return &child;
        if (const ParsedElement *found = foreignIn(child))
            return found;
    }
    return nullptr;
}

tl::unexpected<Error> foreign(const ParsedElement &element)
{
    return notUnderstood(element,
        DYNCAL_TEXT("core",
            "Line %1, %2: the element is of another namespace than those of a certificate (https://ptb.de/dcc, https://ptb.de/si), so what it says is not known here."));
}

Result<StatedQuantity> quantityOf(const ParsedElement &element, const ParsedElement &values)
{
    if (const ParsedElement *found = foreignIn(values))
        return foreign(*found);
    Result<DSiQuantity> stated = readDSiQuantity(values);
    if (!stated)
        return tl::unexpected<Error>(stated.error());
    return StatedQuantity{element.attribute("id"), wordsOfText(element.child("name")),
        wordsOfAttribute(element, "refType"), element.line, std::move(*stated)};
}

/// The schema does not say whether it is a standard or an expanded one, nor with which k.
Message unknownFactor(const ParsedElement &relative)
{
    return notUnderstood(relative,
        DYNCAL_TEXT("core",
            "Line %1, %2: a relative uncertainty has no coverage factor, so it is not taken; the values beside it are read without uncertainty."))
        .value()
        .message;
}

/// Of the values themselves, not of their uncertainties.
void findUnits(const ParsedElement &values, std::vector<std::string> &units)
{
    for (const ParsedElement &child : values.children) {
        if (child.name == "unit" || child.name == "unitXMLList" || child.name == "listUnit")
            for (std::string &word : wordsIn(child.text))
                units.push_back(std::move(word));
        else if (isDSiElement(child))
            findUnits(child, units);
    }
}

/// The one that all of them are; degrees Celsius are known to be none of those asked for.
std::optional<DSiUnit> commonUnit(const std::vector<std::string> &units)
{
    std::optional<DSiUnit> common;
    for (const std::string &word : units) {
        const bool isCelsius = word.find("\\degreecelsius") != word.npos;
        const std::optional<DSiUnit> unit
            = isCelsius ? std::optional(DSiUnit{1.0, {{"degreecelsius", 1}}}) : parseDSiUnit(word);
        if (!unit || (common && common->powers != unit->powers))
            return std::nullopt;
        common = DSiUnit{1.0, unit->powers};
    }
    return common;
}

bool isNoAxis(const std::string &unit)
{
    constexpr std::array kWords{"volt", "ampere", "coulomb", "watt", "pascal", "bar", "newton",
        "metre", "gram", "kelvin", "bel", "neper"}; // with their prefixes
    return std::ranges::any_of(
        kWords, [&](const char *word) { return unit.find(word) != std::string::npos; });
}

UnreadQuantity unreadOf(const ParsedElement &element, const ParsedElement &values)
{
    std::vector<std::string> units;
    findUnits(values, units);
    return {wordsOfText(element.child("name")), wordsOfAttribute(element, "refType"), element.line,
        commonUnit(units), std::ranges::any_of(units, isNoAxis)};
}

/// The quantity goes to the others, or the reason to the reasons.
template <typename Where>
void read(const ParsedElement &element, std::vector<StatedQuantity> &quantities, Where &where)
{
    std::vector<Message> &reasons = where.notUnderstood;
    const ParsedElement *values = valuesIn(element);
    if (!values)
        return;
    Result<StatedQuantity> quantity = quantityOf(element, *values);
    if (!quantity) {
        where.unread.push_back(unreadOf(element, *values));
        return reasons.push_back(std::move(quantity.error().message));
    }
    const ParsedElement *relative = element.child("relativeUncertainty");
    if (relative && quantity->stated.values.u.empty())
        reasons.push_back(unknownFactor(*relative));
    quantities.push_back(std::move(*quantity));
}

std::vector<std::string> entriesOf(const ParsedElement &words)
{
    std::vector<std::string> entries;
    for (const ParsedElement *content : words.all("content"))
        if (const std::string language = content->attribute("lang");
            language.empty() || language == "en")
            entries.push_back(content->trimmedText());
    return entries;
}

/// What a list has from the result or the list that it stands in, where it says nothing itself.
struct Surrounding
{
    std::string name;
    std::vector<std::string> refTypes;
};

void readList(const ParsedElement &list, const Surrounding &around, DccContents &contents)
{
    StatedTable table{list.attribute("id"), wordsOfText(list.child("name")),
        wordsOfAttribute(list, "refType"), list.line};
    if (table.name.empty())
        table.name = around.name;
    if (table.refTypes.empty())
        table.refTypes = around.refTypes;
    for (const ParsedElement &child : list.children)
        if (isForeign(child)) {
            table.notUnderstood.push_back(foreign(child).value().message);
            table.unread.push_back({"", {}, child.line});
        }
    for (const ParsedElement *quantity : list.all("quantity")) {
        read(*quantity, table.columns, table);
        if (const ParsedElement *words = quantity->child("noQuantity"))
            table.words.push_back({wordsOfAttribute(*quantity, "refType"), entriesOf(*words)});
    }
    const Surrounding inside{table.name, table.refTypes};
    contents.tables.push_back(std::move(table));
    for (const ParsedElement *inner : list.all("list")) // no deeper than kDeepestXml
        readList(*inner, inside, contents);
}

} // namespace

void readResult(const ParsedElement &result, DccContents &contents)
{
    const ParsedElement *data = result.child("data");
    if (!data)
        return;
    const Surrounding around{
        wordsOfText(result.child("name")), wordsOfAttribute(result, "refType")};
    for (const ParsedElement &child : data->children) {
        if (child.name == "list")
            readList(child, around, contents);
        else if (child.name == "quantity")
            read(child, contents.single, contents);
        else if (isForeign(child))
            contents.notUnderstood.push_back(foreign(child).value().message);
    }
}

} // namespace dyncal
