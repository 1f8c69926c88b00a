// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_budget.h"

#include "core/base/number_text.h"
#include "core/certificate/certificate_words.h"
#include "core/uncertainty/quantity_words.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dyncal {
namespace {

constexpr double kLeastShare_percent = 0.1;

/// A source, or all the small ones.
struct Part
{
    std::string quantity;
    double square = 0.0; ///< of its contribution
    double share_percent = 0.0;

    void add(const Part &other)
    {
        square += other.square;
        share_percent += other.share_percent;
    }
};

std::vector<Part> partsBySource(const ReportedValue &reported)
{
    std::vector<Part> parts;
    for (const UncertaintyLine &line : reported.lines) {
        auto found = std::ranges::find(parts, line.quantity, &Part::quantity);
        if (found == parts.end())
            found = parts.insert(parts.end(), {line.quantity});
        found->add({{}, line.contribution * line.contribution, reported.sharePercent(line)});
    }
    std::ranges::stable_sort(parts, std::greater(), &Part::share_percent);
    return parts;
}

std::vector<Message> rowOf(const Message &label, const Part &part, double value)
{
    const double percent = 100.0 * std::sqrt(part.square) / std::abs(value);
    return {label, inNumbers(numberText(percent, 2) + " %"),
        inNumbers(numberText(part.share_percent, 2) + " %")};
}

} // namespace

std::optional<CertificateTable> budgetTable(const ReportedValue &sensitivity)
{
    if (!sensitivity.u || !(std::abs(sensitivity.value) > 0.0))
        return std::nullopt;
    CertificateTable table;
    table.id = "budget";
    table.caption = {DYNCAL_TEXT("core", "What the uncertainty of the sensitivity is made of"), {}};
    table.columns = {{{DYNCAL_TEXT("core", "Source"), {}}, false},
        {{DYNCAL_TEXT("core", "Contribution (k = 1)"), {}}, true},
        {{DYNCAL_TEXT("core", "Share of the variance"), {}}, true}};
    Part others;
    for (const Part &part : partsBySource(sensitivity)) {
        if (std::abs(part.share_percent) < kLeastShare_percent)
            others.add(part);
        else
            table.rows.push_back(rowOf(sourceWords(part.quantity), part, sensitivity.value));
    }
    if (others.square > 0.0)
        table.rows.push_back(
            rowOf({DYNCAL_TEXT("core", "all others together"), {}}, others, sensitivity.value));
    return table;
}

} // namespace dyncal
