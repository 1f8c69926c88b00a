// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_monte_carlo.h"

#include "core/monte_carlo/chain_monte_carlo.h"

#include <string>

namespace dyncal {
namespace {

Message sentenceOf(const ChainMonteCarlo &drawn)
{
    const ValidatedCount count = drawn.count();
    std::vector<std::string> numbers{std::to_string(drawn.trials), std::to_string(count.validated),
        std::to_string(count.compared), std::to_string(drawn.refits.refits)};
    if (!drawn.refits.agrees())
        return {DYNCAL_TEXT("core", "%1 trials: %2 of %3 values and rows"), std::move(numbers)};
    return {
        DYNCAL_TEXT("core",
            "%1 trials: %2 of %3 values and rows; the draws of the model agree with %4 full refits"),
        std::move(numbers)};
}

} // namespace

std::optional<CertificateField> monteCarloField(const CalibrationResults &results)
{
    const auto &drawn = results.chainMonteCarlo;
    if (!drawn || drawn->trials == 0)
        return std::nullopt;
    return CertificateField{"monte_carlo",
        {DYNCAL_TEXT("core", "GUM validated by Monte Carlo (JCGM 101)"), {}}, sentenceOf(*drawn),
        false};
}

} // namespace dyncal
