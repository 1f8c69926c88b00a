// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/order_words.h"

#include "core/base/number_text.h"

#include <cmath>

namespace dyncal {
namespace {

std::string percentText(double part, double whole)
{
    return numberText(100.0 * part / std::abs(whole), 2);
}

Message aboutSingularValues(const HankelDecomposition &decomposition, Index n)
{
    const Eigen::VectorXd &sigma = decomposition.singularValues;
    const Index above = (sigma.array() > decomposition.noiseFloor_p95).count();
    if (n >= sigma.size() || !(sigma[n] > 0.0)) {
        return {DYNCAL_TEXT("core", "Singular values above the noise floor: %1."),
            {std::to_string(above)}};
    }
    return {DYNCAL_TEXT("core",
                "Singular value %1 is %2 times the next; values above the noise floor: %3."),
        {std::to_string(n), numberText(sigma[n - 1] / sigma[n], 3), std::to_string(above)}};
}

Message aboutSpread(const OrderSpread &spread)
{
    return {DYNCAL_TEXT("core",
                "The pole at %1 is stable over the orders %2 to %3: its frequency varies by "
                "±%4 %, its damping ratio %5 by ±%6 %."),
        {numberWithUnit(spread.frequency_Hz, "Hz", 4), std::to_string(spread.fromOrder),
            std::to_string(spread.toOrder),
            percentText(spread.frequencySpread_Hz, spread.frequency_Hz),
            numberText(spread.dampingRatio, 3),
            percentText(spread.dampingSpread, spread.dampingRatio)}};
}

} // namespace

std::vector<Message> wordsFor(const ModelInput &, const HankelDecomposition &decomposition,
    const OrderSuggestion &suggestion, const OrderEvidence &evidence)
{
    std::vector<Message> words{suggestion.reason};
    words.push_back(aboutSingularValues(decomposition, suggestion.order));
    if (evidence.spread)
        words.push_back(aboutSpread(*evidence.spread));
    return words;
}

} // namespace dyncal
