// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/order/order_words.h"

#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "core/realization/hankel/hankel_gap.h"
#include "core/realization/order/order_spread.h"
#include "core/realization/refinement/series_simulation.h"

#include <cmath>
#include <string_view>

namespace dyncal {
namespace {

constexpr double kEnough = 0.98; ///< of the attainable FIT
constexpr double kNoiseLimit_percent = 10.0; ///< a lower attainable FIT is meaningless
constexpr std::size_t kMostPoles = 3;

Message aboutSingularValues(const HankelDecomposition &decomposition, Index n)
{
    const Eigen::VectorXd &sigma = decomposition.singularValues;
    const std::string above
        = std::to_string((sigma.array() > decomposition.noiseFloor_p95).count());
    if (n >= sigma.size() || !(sigma[n] > 0.0))
        return {DYNCAL_TEXT("core", "Singular values above the noise floor: %1."), {above}};
    return {DYNCAL_TEXT("core",
                "Singular value %1 is %2 times the next one; above the noise floor lie %3."),
        {std::to_string(n), numberText(sigma[n - 1] / sigma[n], 3), above}};
}

Message aboutPair(const HankelDecomposition &decomposition, Index n)
{
    if (splitsPair(decomposition, n)) {
        return {DYNCAL_TEXT("core", "Order %1 splits an oscillating pair; order %2 keeps it."),
            {std::to_string(n), std::to_string(n + 1)}};
    }
    return {DYNCAL_TEXT("core", "Order %1 splits no oscillating pair."), {std::to_string(n)}};
}

/// "2.33000 MHz ± 0.00013 MHz".
std::string withSpread(double value, double spread, std::string_view unit)
{
    const RoundedValue rounded = roundedValue(value, spread, unit);
    const std::string tail = rounded.unit.empty() ? "" : " " + rounded.unit;
    return rounded.value + tail + (rounded.u.empty() ? "" : " \xC2\xB1 " + rounded.u + tail);
}

Message aboutPole(const OrderSpread &spread)
{
    return {
        DYNCAL_TEXT("core",
            "The pole at %1 with damping ratio %2 is stable from order %3 to %4; the ranges are those over these orders."),
        {withSpread(spread.frequency_Hz, spread.frequencySpread_Hz, "Hz"),
            withSpread(spread.dampingRatio, spread.dampingSpread, ""),
            std::to_string(spread.fromOrder), std::to_string(spread.toOrder)}};
}

/// Poles of the suggested order that stand out of the noise and that the next orders keep.
void addPoles(const OrderEvidence &evidence, Index n, std::vector<Message> &words)
{
    std::size_t said = 0;
    for (const OrderPole &pole : evidence.poles) {
        if (pole.order != n || !pole.standsOut || said >= kMostPoles)
            continue;
        const auto spread = spreadAround(evidence, n, pole.frequency_Hz);
        if (!spread || spread->toOrder == spread->fromOrder)
            continue;
        words.push_back(aboutPole(*spread));
        ++said;
    }
}

void addCrossShot(const OrderEvidence &evidence, Index n, std::vector<Message> &words)
{
    const Eigen::VectorXd &errors = evidence.crossShot_percent;
    if (n > errors.size() || !std::isfinite(errors[n - 1]))
        return;
    Index best = n;
    for (Index k = 1; k <= errors.size(); ++k) {
        if (errors[k - 1] < errors[best - 1])
            best = k;
    }
    const std::string here = numberText(errors[n - 1], 3);
    if (best == n) {
        words.push_back(
            {DYNCAL_TEXT("core",
                 "Poles of the other shots describe a shot best at order %1: they leave %2 % of it."),
                {std::to_string(n), here}});
        return;
    }
    words.push_back(
        {DYNCAL_TEXT("core",
             "Poles of the other shots leave %1 % of a shot at order %2; the least, %3 %, at order %4."),
            {here, std::to_string(n), numberText(errors[best - 1], 3), std::to_string(best)}});
}

void addSufficient(const OrderEvidence &evidence, std::vector<Message> &words)
{
    const double attainable = evidence.fitAttainable_percent;
    if (!(attainable > kNoiseLimit_percent))
        return;
    if (const auto order = lowestSufficientOrder(evidence)) {
        words.push_back(
            {DYNCAL_TEXT("core",
                 "Order %1 is the lowest whose FIT (%2 %) reaches 98 % of the attainable %3 % with neither an unstable nor a Nyquist pole."),
                {std::to_string(*order), fitPercentText(evidence.fit_percent[*order - 1]),
                    fitPercentText(attainable)}});
        return;
    }
    words.push_back(
        {DYNCAL_TEXT("core",
             "No order up to %1 reaches 98 % of the attainable FIT of %2 % with neither an unstable nor a Nyquist pole."),
            {std::to_string(evidence.fit_percent.size()), fitPercentText(attainable)}});
}

} // namespace

std::optional<Index> lowestSufficientOrder(const OrderEvidence &evidence)
{
    if (!(evidence.fitAttainable_percent > kNoiseLimit_percent))
        return std::nullopt;
    for (Index n = 1; n <= evidence.fit_percent.size(); ++n) {
        const auto at = static_cast<std::size_t>(n - 1);
        if (evidence.fit_percent[n - 1] >= kEnough * evidence.fitAttainable_percent
            && evidence.unstable[at] == 0 && evidence.nyquist[at] == 0)
            return n;
    }
    return std::nullopt;
}

std::vector<Message> wordsFor(const HankelDecomposition &decomposition,
    const OrderSuggestion &suggestion, const OrderEvidence &evidence)
{
    const Index n = suggestion.order;
    std::vector<Message> words{
        suggestion.reason, aboutSingularValues(decomposition, n), aboutPair(decomposition, n)};
    addPoles(evidence, n, words);
    addCrossShot(evidence, n, words);
    addSufficient(evidence, words);
    return words;
}

} // namespace dyncal
