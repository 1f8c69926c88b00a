// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc_reading/dcc_quantities.h"

#include "core/dcc_reading/d_si_numbers.h"
#include "core/dcc_reading/dcc_words_read.h"

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

Result<StatedQuantity> quantityOf(const ParsedElement &element, const ParsedElement &values)
{
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

/// The quantity goes to the others, or the reason to the reasons.
void read(const ParsedElement &element, std::vector<StatedQuantity> &quantities,
    std::vector<Message> &reasons)
{
    const ParsedElement *values = valuesIn(element);
    if (!values)
        return;
    Result<StatedQuantity> quantity = quantityOf(element, *values);
    if (!quantity)
        return reasons.push_back(std::move(quantity.error().message));
    const ParsedElement *relative = element.child("relativeUncertainty");
    if (relative && quantity->stated.values.u.empty())
        reasons.push_back(unknownFactor(*relative));
    quantities.push_back(std::move(*quantity));
}

void readList(const ParsedElement &list, const std::string &nameOfResult, DccContents &contents)
{
    const std::string own = wordsOfText(list.child("name"));
    StatedTable table{list.attribute("id"), own.empty() ? nameOfResult : own,
        wordsOfAttribute(list, "refType"), list.line};
    for (const ParsedElement *quantity : list.all("quantity"))
        read(*quantity, table.columns, table.notUnderstood);
    const std::string name = table.name;
    contents.tables.push_back(std::move(table));
    for (const ParsedElement *inner : list.all("list")) // no deeper than kDeepestXml
        readList(*inner, name, contents);
}

} // namespace

void readResult(const ParsedElement &result, DccContents &contents)
{
    const ParsedElement *data = result.child("data");
    if (!data)
        return;
    const std::string name = wordsOfText(result.child("name"));
    for (const ParsedElement &child : data->children) {
        if (child.name == "list")
            readList(child, name, contents);
        else if (child.name == "quantity")
            read(child, contents.single, contents.notUnderstood);
    }
}

} // namespace dyncal
