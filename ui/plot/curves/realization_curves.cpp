// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/curves/realization_curves.h"

#include "core/realization/hankel/order_suggestion.h"
#include "ui/plot/curves/curve_building.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

/// |<u, ones>| / sqrt(r) from which a vector counts as constant.
constexpr double kConstantEnough = 0.9;
constexpr double kFirstValuesShown = 40.5;
constexpr Index kSamplesShown = 150;

void addSuggestion(PlotContent &content, const OrderSuggestion &suggestion)
{
    if (suggestion.order > 0)
        content.marks.push_back({static_cast<double>(suggestion.order),
            Plots::tr("Suggested: %1").arg(suggestion.order), CurveRole::Suggestion});
}

} // namespace

PlotContent modelInputCurves(const ModelInput &input, const WindowResult &window)
{
    PlotContent content;
    content.title = Plots::tr("Model input");
    content.xAxis = timeAxisMeaning();
    content.yAxis = responseAxisMeaning(window);
    bool named = false;
    for (const ModelSeries &series : input.series) {
        if (series.fullRate.size() == 0 || !(series.fullRate_Hz > 0.0))
            continue;
        content.curves.push_back({Plots::tr("Full rate"), CurveRole::Noise, CurveStyle::Line,
            timeAxis(0.0, 1.0 / series.fullRate_Hz, series.fullRate.size()),
            toVector(series.fullRate), !named});
        named = true;
    }
    for (const ModelSeries &series : input.series) {
        const ShotStyle style = shotStyle(series.shot, window);
        content.curves.push_back(shotCurve(style, CurveStyle::Markers,
            timeAxis(series.first_s, 1.0 / input.sampleRate_Hz, series.y.size()),
            toVector(series.y)));
    }
    // The first view must show single samples; zooming out shows the rest.
    if (input.samples > kSamplesShown && input.sampleRate_Hz > 0.0)
        content.xMax = input.offset_s + static_cast<double>(kSamplesShown) / input.sampleRate_Hz;
    content.summary = Plots::tr("Model input; samples in each series: %1.").arg(input.samples);
    return content;
}

std::optional<Index> stepValue(
    const HankelDecomposition &decomposition, ResponseTreatment treatment)
{
    const Eigen::MatrixXd &left = decomposition.leftVectors;
    if (treatment != ResponseTreatment::StepAsImpulse || left.size() == 0)
        return std::nullopt;
    const Eigen::VectorXd likeness
        = left.colwise().sum().cwiseAbs().transpose() / std::sqrt(static_cast<double>(left.rows()));
    Index best = 0;
    if (likeness.maxCoeff(&best) < kConstantEnough)
        return std::nullopt;
    return best;
}

PlotContent singularValueCurves(const HankelDecomposition &decomposition,
    const OrderSuggestion &suggestion, ResponseTreatment treatment)
{
    PlotContent content;
    content.title = Plots::tr("Singular values");
    content.xAxis = {Plots::tr("Order"), QString(), false, true};
    content.yAxis = {Plots::tr("Singular value"), QString(), true};
    const Eigen::VectorXd &values = decomposition.singularValues;
    PlotCurve sensor{
        Plots::tr("Singular values"), CurveRole::Measured, CurveStyle::Markers, {}, {}, true};
    PlotCurve step{
        Plots::tr("Belongs to the step"), CurveRole::StepPole, CurveStyle::Markers, {}, {}, true};
    const std::optional<Index> ofStep = stepValue(decomposition, treatment);
    for (Index i = 0; i < values.size(); ++i) {
        PlotCurve &curve = ofStep && *ofStep == i ? step : sensor;
        curve.x.push_back(static_cast<double>(i + 1));
        curve.y.push_back(values[i]);
    }
    content.curves.push_back(std::move(sensor));
    if (ofStep)
        content.curves.push_back(std::move(step));
    content.xMin = 0.5;
    if (static_cast<double>(values.size()) > kFirstValuesShown)
        content.xMax = kFirstValuesShown;
    if (decomposition.noiseFloor_p95 > 0.0)
        content.levels.push_back({decomposition.noiseFloor_p95, Plots::tr("Noise: median to 95 %"),
            CurveRole::Noise,
            decomposition.noiseFloor_median > 0.0 ? std::optional(decomposition.noiseFloor_median)
                                                  : std::nullopt});
    addSuggestion(content, suggestion);
    content.summary = Plots::tr("Singular values: %1; suggested order: %2.")
                          .arg(values.size())
                          .arg(suggestion.order);
    return content;
}

PlotContent bicCurves(const OrderSuggestion &suggestion)
{
    PlotContent content;
    content.title = Plots::tr("Bayesian information criterion");
    content.xAxis = {Plots::tr("Order"), QString(), false, true};
    content.yAxis = {Plots::tr("BIC"), QString()};
    if (suggestion.bic.size() > 0)
        content.curves.push_back({Plots::tr("BIC"), CurveRole::Measured, CurveStyle::LineAndDots,
            timeAxis(1.0, 1.0, suggestion.bic.size()), toVector(suggestion.bic), true});
    addSuggestion(content, suggestion);
    content.summary = suggestion.bic.size() > 0
        ? Plots::tr("BIC of orders 1 to %1; the smallest is best.").arg(suggestion.bic.size())
        : Plots::tr("The BIC could not be formed for these data.");
    return content;
}

} // namespace dyncal
