// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/hankel/order_suggestion.h"

#include "core/base/number_text.h"
#include "core/realization/exponentials/exponential_sum.h"
#include "core/realization/hankel/realized_poles.h"
#include "core/realization/input/shot_combination.h"
#include "core/realization/input/whitening.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dyncal {
namespace {

constexpr Index kHighestTried = 20;
constexpr double kRoundingFloor = 1e-11; ///< of the largest value: nothing below is information

/// The input of BIC, and whether it differs from the input of the given decomposition.
struct WhitenedInput
{
    ModelInput input;
    bool isOther = false;
    std::vector<double> floors = {}; ///< mean square per series below which nothing is information
};

/// Rounding errors that the noise does not randomise are not seen in the record before the start,
/// so their spectrum is unknown. The response is then used without whitening, and a residual counts
/// as at least noise and largest rounding error (three times the mean square of rounding).
std::optional<WhitenedInput> roundedInput(const ModelInput &input)
{
    if (std::none_of(input.series.begin(), input.series.end(), roundingCounts))
        return std::nullopt;
    WhitenedInput result{input};
    for (const ModelSeries &series : input.series)
        result.floors.push_back(
            series.noiseSd * series.noiseSd + 2.0 * series.roundingSd * series.roundingSd);
    return result;
}

WhitenedInput whitenedInput(const ModelInput &input)
{
    if (auto rounded = roundedInput(input))
        return std::move(*rounded);
    WhitenedInput result;
    result.input.treatment = input.treatment;
    result.input.sampleRate_Hz = input.sampleRate_Hz;
    if (auto combined = isThesisMode(input) ? std::nullopt : combineShots(input)) {
        result.input.series = {std::move(*combined)};
        result.isOther = true;
    } else {
        for (const ModelSeries &series : input.series) {
            result.input.series.emplace_back();
            result.input.series.back().y = series.y;
            result.input.series.back().noise = series.noise;
        }
    }
    std::vector<NoiseCovariance> noise;
    for (const ModelSeries &series : result.input.series)
        noise.push_back(noiseCovariance(series.noise, kLargestNoiseModel));
    const auto models = chooseAutoregressiveModels(noise, kLargestNoiseModel);
    for (std::size_t i = 0; i < models.size(); ++i) {
        ModelSeries &series = result.input.series[i];
        series.y = whitened(series.y, models[i].coefficients);
        series.noiseSd = std::sqrt(models[i].innovationVariance);
        series.noise.resize(0); // this decomposition needs no noise floor
    }
    result.floors.assign(models.size(), 0.0);
    result.input.samples = result.input.series.front().y.size();
    result.isOther = result.isOther || models.front().order() > 0;
    return result;
}

/// Coloured noise displaces the poles of weak modes, so they are realised again from the whitened
/// response. Thesis mode keeps the poles of the listing.
std::optional<HankelDecomposition> decomposeAnew(
    const WhitenedInput &whitened, const JobControl &control)
{
    if (!whitened.isOther || isThesisMode(whitened.input))
        return std::nullopt;
    RealizationSettings settings;
    settings.maxOrder = kHighestTried;
    auto hankel = decomposeHankel(whitened.input, settings, control);
    return hankel ? std::optional(std::move(*hankel)) : std::nullopt;
}

double bicOf(const WhitenedInput &whitened, const std::vector<std::complex<double>> &poles,
    bool withConstant)
{
    const std::vector<ModelSeries> &series = whitened.input.series;
    double bic = 0.0;
    double samples = 0.0;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const Eigen::VectorXd &y = series[i].y;
        const double n = static_cast<double>(y.size());
        const double floor = kRoundingFloor * y.cwiseAbs().maxCoeff();
        const double meanSquare
            = (y - fitAmplitudes(y, poles, withConstant).fitted).squaredNorm() / n;
        bic += n * std::log(std::max({meanSquare, floor * floor, whitened.floors[i]}));
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
        return {
            DYNCAL_TEXT("core",
                "Order %1 has the smallest BIC on the pre-whitened response: order %2 is %3 higher, order %4 is %5 higher."),
            {std::to_string(order), std::to_string(order - 1), above(order - 1),
                std::to_string(order + 1), above(order + 1)}};
    }
    return {DYNCAL_TEXT("core",
                "Order %1 has the smallest BIC on the pre-whitened response among orders 1 to %2."),
        {std::to_string(order), std::to_string(bic.size())}};
}

} // namespace

OrderSuggestion suggestOrder(
    const ModelInput &input, const HankelDecomposition &decomposition, const JobControl &control)
{
    const WhitenedInput whitened = whitenedInput(input);
    const std::optional<HankelDecomposition> anew = decomposeAnew(whitened, control);
    const HankelDecomposition &realized = anew ? *anew : decomposition;
    const Index highest
        = std::min({kHighestTried, largestOrder(realized), whitened.input.samples / 4});

    // In thesis mode the step is one of the poles; in impulse mode there is none.
    const bool withConstant = input.treatment == ResponseTreatment::StepDeflated
        || input.treatment == ResponseTreatment::Differenced;
    OrderSuggestion suggestion;
    suggestion.bic.setZero(std::max<Index>(highest, 1));
    for (Index n = 1; n <= suggestion.bic.size() && !control.stopRequested(); ++n)
        suggestion.bic[n - 1] = bicOf(whitened, realizedPoles(realized, n), withConstant);
    Index best = 0;
    suggestion.bic.minCoeff(&best);
    suggestion.order = best + 1;
    suggestion.reason = reasonFor(suggestion.bic, suggestion.order);
    return suggestion;
}

} // namespace dyncal
