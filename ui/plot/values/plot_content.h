// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "ui/plot/values/axis_prefix.h"

#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace dyncal {

class CurveSamples;

/// What a curve stands for; the theme gives it colour, dash and marker (never colour alone).
enum class CurveRole {
    ShotLow,
    ShotMedium,
    ShotHigh, ///< also used for the 1st, 2nd, 3rd shot without level
    ShotOther, ///< further shots, told apart by PlotCurve::variant
    Mean,
    Measured,
    Model,
    Error,
    Noise, ///< bands and floors of noise
    Reference, ///< limits, tolerance lines
    Pole,
    Zero,
    StepPole,
    UnstablePole, ///< markers of the pole-zero map
    Suggestion,
    Candidate1,
    Candidate2,
    Candidate3,
    Candidate4, ///< models of other orders laid over that of the chosen one
    StablePole,
    HalfStablePole,
    NewPole, ///< markers of the stabilisation strip, beside UnstablePole
};

/// ErrorBars: lines between pairs of points, each pair parted from the next by a NaN.
enum class CurveStyle { Line, Steps, Dots, LineAndDots, Markers, Stems, Bars, ErrorBars };

/// One curve as values: what is drawn, exported as CSV and printed is the same data.
struct PlotCurve
{
    QString name; ///< legend text
    CurveRole role = CurveRole::Measured;
    CurveStyle style = CurveStyle::Line;
    std::vector<double> x;
    std::vector<double> y;
    bool inLegend = true;
    /// A long record behind the curve; x and y then hold only its extremes over the whole length.
    /// Views are drawn from the record, down to single samples.
    std::shared_ptr<const CurveSamples> record = {};
    bool onSecondAxis = false; ///< against PlotContent::yAxis2, behind what is the plot's own
    int variant = 0; ///< tells curves of one role apart (PlotTheme::style)
};

/// An axis: quantity and SI unit; the plot chooses the prefix ("Time / µs") by the range shown.
struct PlotAxis
{
    QString quantity; ///< "Time"
    QString unit; ///< "s", "Hz", "V", "" or "dB"
    bool logarithmic = false;
    bool integers = false; ///< tick labels are whole numbers (orders, lags)
};

/// That of title and ticks of an axis that shows this range.
inline AxisPrefix prefixOf(const PlotAxis &axis, double lower, double upper)
{
    return axis.logarithmic ? decadePrefix(lower, upper, axis.unit)
                            : axisPrefix(lower, upper, axis.unit);
}

/// A labelled vertical tick, e.g. a resonance found; `label` is drawn beside it.
struct PlotMark
{
    double x = 0.0;
    QString label;
    CurveRole role = CurveRole::Reference;

    bool operator==(const PlotMark &) const = default;
};

/// A horizontal line, e.g. a confidence bound; with `from` the end of a band that begins there.
struct PlotLevel
{
    double y = 0.0;
    QString label;
    CurveRole role = CurveRole::Reference;
    std::optional<double> from = {};

    bool operator==(const PlotLevel &) const = default;
};

/// Everything that one plot shows. Built by the pure functions in ui/plot/curves from results.
struct PlotContent
{
    QString title;
    PlotAxis xAxis;
    PlotAxis yAxis;
    /// At the right; always fitted to its curves. Cursors, hints and picks use yAxis only.
    std::optional<PlotAxis> yAxis2 = {};
    std::vector<PlotCurve> curves;
    std::vector<PlotMark> marks;
    std::vector<PlotLevel> levels;
    bool equalAspect = false; ///< pole-zero map
    bool unitCircle = false;
    /// Sample rate of a z plane: lines of one damping ratio and of one frequency are drawn in it.
    std::optional<double> dampingGridRate_Hz = {};
    std::optional<double> xMin, xMax, yMin, yMax; ///< first view; else fitted to the data
    /// More is to come: the next content is fitted too, unless the operator moved the view.
    bool growing = false;
    QString summary; ///< one sentence for screen readers and as tooltip of the plot
};

} // namespace dyncal
