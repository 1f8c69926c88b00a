// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/curves/component_curves.h"

#include "core/decomposition/component_result.h"
#include "core/decomposition/residual_analysis.h"
#include "ui/plot/curves/curve_building.h"
#include "ui/plot/values/axis_prefix.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

constexpr double kEnough_percent = 95.0;
constexpr double kShareOfLabel = 0.17; ///< of the width, right of the bars: "95 %" stands there
constexpr double kReachMargin = 1.15;
constexpr double kLeastShown_percent = 1e-9; ///< less is rounding

/// One curve per shot from the columns of `values` (samples x shots).
PlotContent columnsContent(const ComponentResult &components, const WindowResult &window,
    const Eigen::MatrixXd &values, const QString &title)
{
    PlotContent content;
    content.title = title;
    content.xAxis = timeAxisMeaning();
    content.yAxis = responseAxisMeaning(window);
    const auto shots = std::min(values.cols(), static_cast<Index>(components.shots.size()));
    for (Index i = 0; i < shots; ++i) {
        const ShotStyle style = shotStyle(components.shots[static_cast<std::size_t>(i)], window);
        content.curves.push_back(shotCurve(style, CurveStyle::Line,
            timeAxis(0.0, 1.0 / components.sampleRate_Hz, values.rows()), toVector(values.col(i))));
    }
    return content;
}

std::vector<double> lagAxis(Index count)
{
    return timeAxis(0.0, 1.0, count);
}

/// A mark per frequency, not per shot: shots mostly share their maxima.
void markOnce(PlotContent &content, double frequency_Hz)
{
    constexpr double kSame = 0.02; // relative; about the width of a label on a decade
    const bool known = std::any_of(
        content.marks.begin(), content.marks.end(), [frequency_Hz](const PlotMark &mark) {
            return std::abs(mark.x - frequency_Hz) < kSame * frequency_Hz;
        });
    if (!known)
        content.marks.push_back({frequency_Hz, valueWithUnit(frequency_Hz, QStringLiteral("Hz"), 3),
            CurveRole::Suggestion});
}

} // namespace

PlotContent explainedCurves(const ComponentResult &components)
{
    PlotContent content;
    content.title = Plots::tr("Explained by the first components");
    content.xAxis = {Plots::tr("Components"), QString(), false, true};
    content.yAxis = {Plots::tr("Explained, cumulative"), QStringLiteral("%")};
    content.yMin = 0.0;
    content.yMax = 105.0;
    content.levels.push_back({kEnough_percent, Plots::tr("95 %"), CurveRole::Reference});
    if (!components.principal) {
        content.summary = Plots::tr("One shot only: there are no components to compare.");
        return content;
    }
    const Eigen::VectorXd &percent = components.principal->explainedCumulative_percent;
    content.xMin = 0.4;
    const double lastEdge = static_cast<double>(percent.size()) + 0.3; // of the bars
    content.xMax = *content.xMin + (lastEdge - *content.xMin) / (1.0 - kShareOfLabel);
    content.curves.push_back({Plots::tr("Explained, cumulative"), CurveRole::Measured,
        CurveStyle::Bars, timeAxis(1.0, 1.0, percent.size()), toVector(percent), true});
    if (percent.size() > 0)
        content.summary = Plots::tr("The first component explains %1 %.")
                              .arg(valueWithUnit(percent[0], QString(), 5));
    return content;
}

PlotContent remainderCurves(const ComponentResult &components)
{
    PlotContent content;
    content.title = Plots::tr("Left by the first components");
    content.xAxis = {Plots::tr("Components"), QString(), false, true};
    content.yAxis = {Plots::tr("Not explained"), QStringLiteral("%"), true};
    if (!components.principal) {
        content.summary = Plots::tr("One shot only: there are no components to compare.");
        return content;
    }
    const Eigen::VectorXd &percent = components.principal->explainedCumulative_percent;
    PlotCurve left{Plots::tr("Not explained"), CurveRole::Measured, CurveStyle::Bars, {}, {}, true};
    double least = 100.0 - kEnough_percent;
    for (Index i = 0; i + 1 < percent.size(); ++i) {
        const double rest_percent = std::max(100.0 - percent[i], kLeastShown_percent);
        left.x.push_back(static_cast<double>(i + 1));
        left.y.push_back(rest_percent);
        least = std::min(least, rest_percent);
    }
    content.levels.push_back({100.0 - kEnough_percent, Plots::tr("5 %"), CurveRole::Reference});
    content.xMin = 0.4;
    content.xMax = std::max(1.6, static_cast<double>(percent.size()) - 0.4) + 0.2;
    content.yMin = 0.3 * least;
    content.yMax = 100.0;
    if (percent.size() > 1)
        content.summary = Plots::tr("The first component leaves %1 %.")
                              .arg(valueWithUnit(left.y.front(), QString(), 3));
    content.curves.push_back(std::move(left));
    return content;
}

PlotContent reconstructionCurves(const ComponentResult &components, const WindowResult &window)
{
    PlotContent content = columnsContent(components, window, components.reconstructions,
        Plots::tr("Reconstructed; components kept: %1").arg(components.kept));
    content.summary = content.title;
    return content;
}

PlotContent residualCurves(const ComponentResult &components, const WindowResult &window)
{
    const bool same = components.responses.rows() == components.reconstructions.rows()
        && components.responses.cols() == components.reconstructions.cols();
    PlotContent content = columnsContent(components, window,
        same ? Eigen::MatrixXd(components.responses - components.reconstructions)
             : Eigen::MatrixXd(),
        Plots::tr("Residuals"));
    content.yAxis.quantity = Plots::tr("Residual");
    content.summary = Plots::tr("What the components leave of each shot.");
    return content;
}

PlotContent autocovarianceCurves(
    const ComponentResult &components, const WindowResult &window, std::optional<Index> shot)
{
    PlotContent content;
    content.title = Plots::tr("Autocovariance; dotted: white noise");
    content.xAxis = {Plots::tr("Lag"), QString(), false, true};
    content.yAxis = {Plots::tr("Autocovariance, normalised"), QString()};
    double bound = 0.0;
    double reach = 0.0;
    for (std::size_t i = 0; i < components.residuals.size() && i < components.shots.size(); ++i) {
        if (shot && components.shots[i] != *shot)
            continue;
        const ResidualAnalysis &residual = components.residuals[i];
        const ShotStyle style = shotStyle(components.shots[i], window);
        content.curves.push_back(shotCurve(style, CurveStyle::Line,
            lagAxis(residual.autocovariance.size()), toVector(residual.autocovariance)));
        bound = std::max(bound, residual.confidenceBound);
        const Index lags = residual.autocovariance.size() - 1; // beside lag 0
        if (lags > 0)
            reach = std::max(reach, residual.autocovariance.tail(lags).cwiseAbs().maxCoeff());
        if (shot)
            content.title += QStringLiteral(", ") + style.name;
    }
    if (bound > 0.0) {
        content.levels.push_back({bound, QString(), CurveRole::Noise});
        content.levels.push_back({-bound, QString(), CurveRole::Noise});
    }
    // Lag 0 is always 1, and the band of white noise a hundredth of that: y shows the other lags.
    reach = std::max(reach, bound);
    if (std::isfinite(reach) && reach > 0.0) {
        content.yMin = -kReachMargin * reach;
        content.yMax = kReachMargin * reach;
    }
    content.summary = Plots::tr("Autocovariance of the residuals with the bounds of white noise.");
    return content;
}

PlotContent residualSpectrumCurves(const ComponentResult &components, const WindowResult &window)
{
    std::vector<ShotStyle> shots;
    std::vector<const PowerSpectrum *> spectra;
    for (std::size_t i = 0; i < components.residuals.size() && i < components.shots.size(); ++i) {
        shots.push_back(shotStyle(components.shots[i], window));
        spectra.push_back(&components.residuals[i].spectrum);
    }
    PlotContent content
        = spectraContent(Plots::tr("Power spectrum of the residuals"), window, shots, spectra);
    for (std::size_t i = 0; i < spectra.size(); ++i)
        if (const auto &peaks_Hz = components.residuals[i].peaks_Hz; !peaks_Hz.empty())
            markOnce(content, peaks_Hz.front());
    content.summary = Plots::tr(
        "Power spectra of the residuals; the strongest maximum of each shot is marked.");
    return content;
}

PlotContent averageCurves(const ComponentResult &components, const WindowResult &window)
{
    PlotContent content;
    content.title = Plots::tr("Average of the reconstructions");
    content.xAxis = timeAxisMeaning();
    content.yAxis = responseAxisMeaning(window);
    const ShotStyle style = shotStyle(0, ShotLevel::None);
    content.curves.push_back(shotCurve(style, CurveStyle::Line,
        timeAxis(0.0, 1.0 / components.sampleRate_Hz, components.average.size()),
        toVector(components.average)));
    content.summary = content.title;
    return content;
}

} // namespace dyncal
