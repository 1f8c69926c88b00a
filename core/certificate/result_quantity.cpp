// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/result_quantity.h"

#include "core/base/rounding.h"
#include "core/certificate/certificate_words.h"

#include <utility>

namespace dyncal {
namespace {

RoundedValue roundedOf(const ResultQuantity &quantity)
{
    const double expanded = statedFactor(quantity.k) * quantity.u;
    return roundedValue(
        quantity.value, neverBelow(expanded, quantity.leastExpanded), quantity.unit);
}

std::vector<Message> rowOfResult(const ResultQuantity &quantity)
{
    const RoundedValue rounded = roundedOf(quantity);
    const std::string tail = rounded.unit.empty() ? "" : " " + rounded.unit;
    return {quantity.label, inNumbers(rounded.value + tail), inNumbers(rounded.u + tail),
        inNumbers(printedFactor(quantity.k))};
}

CertificateTable tableOfResults()
{
    CertificateTable table;
    table.id = "key-results";
    table.columns = {{{DYNCAL_TEXT("core", "Quantity"), {}}, false},
        {{DYNCAL_TEXT("core", "Value"), {}}, true}, {{DYNCAL_TEXT("core", "U"), {}}, true},
        {{DYNCAL_TEXT("core", "k"), {}}, true}};
    return table;
}

CertificateTable tableOfOthers()
{
    CertificateTable table;
    table.id = "not-reported";
    table.caption = {
        DYNCAL_TEXT("core",
            "Not among the results, because no value with a complete uncertainty is known of them"),
        {}};
    table.columns = {{{DYNCAL_TEXT("core", "Quantity"), {}}, false},
        {{DYNCAL_TEXT("core", "What is known"), {}}, false}};
    return table;
}

} // namespace

bool ResultQuantity::isResult() const
{
    return !roundedOf(*this).u.empty();
}

Message whyNoResult(const ReportedValue *reported)
{
    if (!reported || *reported->missing.text == '\0')
        return {DYNCAL_TEXT("core", "no complete uncertainty"), {}};
    return {DYNCAL_TEXT("core", "no complete uncertainty:"), {}, {reported->missing}};
}

void addQuantityTables(const std::vector<ResultQuantity> &quantities, CertificateSection &section)
{
    CertificateTable results = tableOfResults();
    CertificateTable others = tableOfOthers();
    for (const ResultQuantity &quantity : quantities) {
        if (quantity.isResult())
            results.rows.push_back(rowOfResult(quantity));
        else
            others.rows.push_back({quantity.label, quantity.otherwise});
    }
    for (CertificateTable *table : {&results, &others})
        if (!table->rows.empty())
            section.tables.push_back(std::move(*table));
}

} // namespace dyncal
