// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_monte_carlo.h"

#include "core/base/rounding.h"
#include "core/certificate/certificate_words.h"
#include "core/monte_carlo/chain_monte_carlo.h"

#include <algorithm>
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

/// What the trials say of a result.
struct DrawnInterval
{
    double low = kUnknown;
    double high = kUnknown;
};

/// Where it reaches beyond value -+ U, by more than JCGM 101 (8.2) allows; what lies within is
/// stated safely, if wider than it need be.
std::optional<DrawnInterval> intervalOf(
    const ResultQuantity &of, const DrawnQuantity &drawn, const GumValidation &gum)
{
    const double reach = printedCoverage(of.k) * of.u + gum.tolerance;
    if (of.leastExpanded > printedCoverage(of.k) * of.u) // nothing narrower than the CMC is stated
        return std::nullopt;
    const bool isBeyond = drawn.low < of.value - reach || drawn.high > of.value + reach;
    return !gum.validated && isBeyond ? std::optional(DrawnInterval{drawn.low, drawn.high})
                                      : std::nullopt;
}

std::optional<DrawnInterval> atResonance(
    const CalibrationResults &results, const ChainMonteCarlo &drawn, const ResultQuantity &of)
{
    const ResponseResult *marked = results.response ? results.response->atMarks.get() : nullptr;
    if (!marked)
        return std::nullopt;
    const auto mark = std::ranges::find(marked->marks, RowMark::Resonance);
    const auto row = static_cast<std::size_t>(mark - marked->marks.begin());
    if (mark == marked->marks.end() || row >= drawn.rowsAtMarks.size()
        || !drawn.rowsAtMarks[row].withMagnitude)
        return std::nullopt;
    const DrawnRow &found = drawn.rowsAtMarks[row];
    return intervalOf(of, found.magnitude, found.gumMagnitude);
}

std::optional<DrawnInterval> otherInterval(
    const CalibrationResults &results, const ChainMonteCarlo &drawn, const ResultQuantity &of)
{
    if (of.of == "magnitude_at_resonance")
        return atResonance(results, drawn, of);
    const DrawnValue *value = drawn.find(of.drawnAs.empty() ? of.of : of.drawnAs);
    return value ? intervalOf(of, value->drawn, value->gum) : std::nullopt;
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
    constexpr Index kFewest = 10'000; // for the ends of 95 % (JCGM 101, 7.2.2)
    const auto &drawn = results.chainMonteCarlo;
    if (!drawn || drawn->trials < kFewest)
        return std::nullopt;
    CertificateTable table;
    table.id = "monte-carlo";
    table.caption = {
        DYNCAL_TEXT("core",
            "Results whose interval of %1 % by Monte Carlo reaches beyond the one that U gives; it is the one to use"),
        {settingText(100.0 * drawn->coverage, "")}};
    table.columns = {{{DYNCAL_TEXT("core", "Quantity"), {}}, false},
        {{DYNCAL_TEXT("core", "Lower end"), {}}, true},
        {{DYNCAL_TEXT("core", "Upper end"), {}}, true}};
    for (const ResultQuantity &quantity : quantities) {
        const auto interval = otherInterval(results, *drawn, quantity);
        if (!interval || !quantity.isResult())
            continue;
        // A digit more than U has, or its ends could read as those of value -+ U.
        const double digits = 0.05 * (interval->high - interval->low);
        table.rows.push_back(
            {quantity.label, inNumbers(roundedText(interval->low, digits, quantity.unit)),
                inNumbers(roundedText(interval->high, digits, quantity.unit))});
    }
    return table.rows.empty() ? std::nullopt : std::optional(std::move(table));
}

} // namespace dyncal
