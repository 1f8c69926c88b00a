// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/number_text.h"
#include "core/realization/exponential_sum.h"
#include "core/realization/hankel_decomposition.h"
#include "core/realization/realized_poles.h"
#include "core/realization/whitening.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr Index kHighestTried = 20;
constexpr Index kNoiseModelOrder = 4; ///< docs/method/order.md
constexpr double kRoundingFloor = 1e-11; ///< of the largest value: nothing below is information

/// Response of one series made ready for BIC: whitened, with the variance left to its noise.
std::vector<Eigen::VectorXd> whitenedSeries(const ModelInput &input)
{
    std::vector<Eigen::VectorXd> list;
    for (const ModelSeries &series : input.series)
        list.push_back(whitened(series.y, autoregressiveModel(series.noise, kNoiseModelOrder)));
    return list;
}

double bicOf(const std::vector<Eigen::VectorXd> &series,
    const std::vector<std::complex<double>> &poles, bool withConstant)
{
    double bic = 0.0;
    double samples = 0.0;
    for (const Eigen::VectorXd &y : series) {
        const double n = static_cast<double>(y.size());
        const double floor = kRoundingFloor * y.cwiseAbs().maxCoeff();
        const double meanSquare
            = (y - fitAmplitudes(y, poles, withConstant).fitted).squaredNorm() / n;
        bic += n * std::log(std::max(meanSquare, floor * floor));
        samples += n;
    }
    const double perSeries = static_cast<double>(poles.size()) + (withConstant ? 1.0 : 0.0);
    const double parameters
        = static_cast<double>(poles.size()) + perSeries * static_cast<double>(series.size());
    return bic + parameters * std::log(samples);
}

Message reasonFor(const Eigen::VectorXd &bic, Index order)
{
    const auto above
        = [&](Index n) { return numberText(std::round(bic[n - 1] - bic[order - 1]), 6); };
    if (order > 1 && order < bic.size()) {
        return {DYNCAL_TEXT("core",
                    "Order %1 has the smallest BIC on the pre-whitened response: order %2 is %3 "
                    "higher, order %4 is %5 higher."),
            {std::to_string(order), std::to_string(order - 1), above(order - 1),
                std::to_string(order + 1), above(order + 1)}};
    }
    return {DYNCAL_TEXT("core",
                "Order %1 has the smallest BIC on the pre-whitened response among orders 1 to %2."),
        {std::to_string(order), std::to_string(bic.size())}};
}

} // namespace

OrderSuggestion suggestOrder(const ModelInput &input, const HankelDecomposition &decomposition)
{
    const std::vector<Eigen::VectorXd> series = whitenedSeries(input);
    Index shortest = series.front().size();
    for (const Eigen::VectorXd &y : series)
        shortest = std::min(shortest, y.size());
    const Index highest = std::min({kHighestTried, largestOrder(decomposition), shortest / 4});

    // In thesis mode the step is one of the poles; in impulse mode there is none.
    const bool withConstant = input.treatment == ResponseTreatment::StepDeflated
        || input.treatment == ResponseTreatment::Differenced;
    OrderSuggestion suggestion;
    suggestion.bic.resize(std::max<Index>(highest, 1));
    for (Index n = 1; n <= suggestion.bic.size(); ++n)
        suggestion.bic[n - 1] = bicOf(series, realizedPoles(decomposition, n), withConstant);
    Index best = 0;
    suggestion.bic.minCoeff(&best);
    suggestion.order = best + 1;
    suggestion.reason = reasonFor(suggestion.bic, suggestion.order);
    return suggestion;
}

} // namespace dyncal
