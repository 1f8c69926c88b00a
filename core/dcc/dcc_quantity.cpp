// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_quantity.h"

#include "core/base/number_text.h"
#include "core/base/rounding.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dyncal {
namespace {

XmlElement quantityElement(const DccWords &words, const Message &name, const std::string &refType)
{
    XmlElement quantity = withRefType("dcc:quantity", refType);
    quantity.add(words.element("dcc:name", {name}));
    return quantity;
}

XmlElement expandedOf(const PrintedValue &printed, const std::string &factor)
{
    return {"si:measurementUncertaintyUnivariate", {}, {},
        {{"si:expandedMU", {}, {},
            {{"si:valueExpandedMU", {}, printed.expanded},
                {"si:coverageFactor", {},
                    dccFactor(printed.factor.empty() ? factor : printed.factor)},
                {"si:coverageProbability", {}, kDccProbability}}}}};
}

XmlElement expandedOf(const DccColumn &column)
{
    return {"si:measurementUncertaintyUnivariateXMLList", {}, {},
        {{"si:expandedMUXMLList", {}, {},
            {{"si:valueExpandedMUXMLList", {}, dccList(column.expanded)},
                {"si:coverageFactorXMLList", {}, dccList(column.factors, true)},
                {"si:coverageProbabilityXMLList", {}, kDccProbability}}}}};
}

XmlElement standardOf(const DccColumn &column)
{
    return {"si:measurementUncertaintyUnivariateXMLList", {}, {},
        {{"si:standardMUXMLList", {}, {},
            {{"si:valueStandardMUXMLList", {}, dccList(column.standard)}}}}};
}

XmlElement numbersOf(const DccWords &words, const DccColumn &column)
{
    XmlElement quantity = quantityElement(words, column.name, column.refType);
    if (*column.description.text != '\0')
        quantity.add(words.element("dcc:description", {column.description}));
    XmlElement &list = quantity.add({"si:realListXMLList"});
    list.add({"si:valueXMLList", {}, dccList(column.values)});
    list.add({"si:unitXMLList", {}, dccList(column.units, true)});
    if (!column.expanded.empty())
        list.add(expandedOf(column));
    else if (!column.standard.empty())
        list.add(standardOf(column));
    return quantity;
}

} // namespace

XmlElement withRefType(std::string name, const std::string &refType)
{
    XmlElement element{std::move(name)};
    if (!refType.empty())
        element.attributes.emplace_back("refType", refType);
    return element;
}

XmlElement dccResult(const DccWords &words, const Message &name, const std::string &refType)
{
    XmlElement result = withRefType("dcc:result", refType);
    result.add(words.element("dcc:name", {name}));
    return result;
}

XmlElement dccQuantity(const DccWords &words, const Message &name, const std::string &refType,
    const PrintedValue &printed, const std::string &factor)
{
    XmlElement quantity = quantityElement(words, name, refType);
    XmlElement &real = quantity.add({"si:real"});
    real.add({"si:value", {}, printed.value});
    real.add({"si:unit", {}, printed.unit});
    if (!printed.expanded.empty())
        real.add(expandedOf(printed, factor));
    return quantity;
}

XmlElement dccWordsQuantity(const DccWords &words, const Message &name, const std::string &refType,
    const std::vector<Message> &said)
{
    XmlElement quantity = quantityElement(words, name, refType);
    quantity.add(words.element("dcc:noQuantity", said));
    return quantity;
}

XmlElement dccQuantityOf(
    const DccWords &words, const Message &name, const std::string &refType, const Message &printed)
{
    if (const auto value = printedValue(printed))
        return dccQuantity(words, name, refType, *value);
    return dccWordsQuantity(words, name, refType, {printed});
}

void addDccColumn(const DccWords &words, const DccColumn &column, XmlElement &list)
{
    if (!column.values.empty())
        list.add(numbersOf(words, column));
    if (!column.words.empty())
        list.add(dccWordsQuantity(words, column.name,
            column.values.empty() ? column.refType : std::string(kDccRemarks), column.words));
}

std::string dccList(const std::vector<std::string> &texts, bool isOnce)
{
    if (isOnce && !texts.empty()
        && std::ranges::all_of(texts, [&](const auto &text) { return text == texts.front(); }))
        return texts.front();
    std::string list;
    for (const std::string &text : texts)
        list.append(list.empty() ? "" : " ").append(text);
    return list;
}

std::string dccFactor(const std::string &printed)
{
    constexpr double kPlainDigits = 1e4;
    const std::optional<double> k = parseNumber(printed);
    if (!k || !(*k >= 1.0) || !std::isfinite(*k))
        return kDccNone;
    return *k < kPlainDigits ? printed : fixedText(*k, 0);
}

std::string dccNumber(double value)
{
    return std::isfinite(value) ? exactNumber(value) : kDccNone;
}

} // namespace dyncal
