// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_monte_carlo.h"

#include "core/base/rounding.h"
#include "core/certificate/certificate_words.h"
#include "core/monte_carlo/chain_monte_carlo.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dyncal {
namespace {

Message sentenceOf(const ChainMonteCarlo &drawn)
{
    const ValidatedCount count = drawn.count();
    std::vector<std::string> numbers{std::to_string(drawn.trials), std::to_string(count.validated),
        std::to_string(count.compared), std::to_string(drawn.refits.refits)};
    if (!drawn.refits.agrees())
        return {DYNCAL_TEXT("core", "%1 trials: both agree for %2 of %3 values and rows"),
            std::move(numbers)};
    return {
        DYNCAL_TEXT("core",
            "%1 trials: both agree for %2 of %3 values and rows; the draws of the model agree with %4 full refits"),
        std::move(numbers)};
}

/// What the trials say of a result; an interval that does not exist is NaN.
struct DrawnInterval
{
    double low = kUnknown;
    double high = kUnknown;
};

std::optional<DrawnInterval> intervalOf(const DrawnQuantity &drawn, const GumValidation &gum)
{
    if (gum.validated || !std::isfinite(drawn.low) || !std::isfinite(drawn.high))
        return std::nullopt;
    return DrawnInterval{drawn.low, drawn.high};
}

std::optional<DrawnInterval> atResonance(
    const CalibrationResults &results, const ChainMonteCarlo &drawn)
{
    const ResponseResult *marked = results.response ? results.response->atMarks.get() : nullptr;
    if (!marked)
        return std::nullopt;
    const auto mark = std::ranges::find(marked->marks, RowMark::Resonance);
    const auto row = static_cast<std::size_t>(mark - marked->marks.begin());
    if (mark == marked->marks.end() || row >= drawn.rowsAtMarks.size()
        || !drawn.rowsAtMarks[row].withMagnitude)
        return std::nullopt;
    return intervalOf(drawn.rowsAtMarks[row].magnitude, drawn.rowsAtMarks[row].gumMagnitude);
}

/// Where it is not the one that U gives.
std::optional<DrawnInterval> otherInterval(
    const CalibrationResults &results, const ChainMonteCarlo &drawn, const ResultQuantity &of)
{
    if (of.of == "magnitude_at_resonance")
        return atResonance(results, drawn);
    const DrawnValue *value = drawn.find(of.drawnAs.empty() ? of.of : of.drawnAs);
    return value ? intervalOf(value->drawn, value->gum) : std::nullopt;
}

} // namespace

std::optional<CertificateField> monteCarloField(const CalibrationResults &results)
{
    const auto &drawn = results.chainMonteCarlo;
    if (!drawn || drawn->trials == 0)
        return std::nullopt;
    return CertificateField{"monte_carlo",
        {DYNCAL_TEXT("core", "Comparison of GUM and Monte Carlo (JCGM 101)"), {}},
        sentenceOf(*drawn), false};
}

std::optional<CertificateTable> monteCarloTable(
    const CalibrationResults &results, const std::vector<ResultQuantity> &quantities)
{
    const auto &drawn = results.chainMonteCarlo;
    if (!drawn || drawn->trials == 0)
        return std::nullopt;
    CertificateTable table;
    table.id = "monte-carlo";
    table.caption = {
        DYNCAL_TEXT("core",
            "Results whose interval of %1 % by Monte Carlo is not the one that U gives; it is the one to use"),
        {settingText(100.0 * drawn->coverage, "")}};
    table.columns = {{{DYNCAL_TEXT("core", "Quantity"), {}}, false},
        {{DYNCAL_TEXT("core", "Lower end"), {}}, true},
        {{DYNCAL_TEXT("core", "Upper end"), {}}, true}};
    for (const ResultQuantity &quantity : quantities) {
        const auto interval = otherInterval(results, *drawn, quantity);
        if (!interval || !quantity.isResult())
            continue;
        const double half = 0.5 * (interval->high - interval->low);
        table.rows.push_back(
            {quantity.label, inNumbers(roundedText(interval->low, half, quantity.unit)),
                inNumbers(roundedText(interval->high, half, quantity.unit))});
    }
    return table.rows.empty() ? std::nullopt : std::optional(std::move(table));
}

} // namespace dyncal
