// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/signal/power_spectrum.h"
#include "core/signal/response_window.h"
#include "ui/plot/values/plot_content.h"

#include <QCoreApplication>

#include <Eigen/Core>

namespace dyncal {

/// Translation context of every text in a plot.
struct Plots
{
    Q_DECLARE_TR_FUNCTIONS(Plots)
};

/// How the curves of one shot are named and drawn on every plot.
struct ShotStyle
{
    QString name; ///< "Shot 2 (medium)"
    CurveRole role = CurveRole::ShotOther;
    int variant = 0;
};

/// A curve of a shot. Shots that follow each other always look different.
PlotCurve shotCurve(
    const ShotStyle &shot, CurveStyle style, std::vector<double> x, std::vector<double> y);

/// By level where there is one, else by number: 1st, 2nd, 3rd, others. The shots that a level has
/// besides the one that belongs at its place (low, medium, high) differ by dash and marker.
ShotStyle shotStyle(Index shot, ShotLevel level);

/// Style of a shot by its number, with its level from `window`; number 0 is the average of the
/// shots.
ShotStyle shotStyle(Index shot, const WindowResult &window);

std::vector<double> toVector(const Eigen::Ref<const Eigen::VectorXd> &values);

/// first, first + step, ...: `count` values.
std::vector<double> timeAxis(double first, double step, Index count);

/// A value with its U at a place of the axis; U NaN: not known.
struct BarPoint
{
    double x = 0.0;
    double y = 0.0;
    double U = 0.0;
};
using BarPoints = std::vector<BarPoint>;

/// Bars of ± U, not a band: between two points there may be a resonance.
PlotCurve barsOf(const QString &name, CurveRole role, const BarPoints &points);

/// Markers of the values with bars of ± U beneath, as two curves; nothing where there are none.
void addWithBars(
    const QString &name, CurveRole role, const BarPoints &points, PlotContent &content);

/// 10 log10; NaN (a gap) where there is no power.
std::vector<double> decibels(const Eigen::VectorXd &power);

/// The power spectra of shots in decibels. Periodograms of many points would hide each other, so
/// each shot is drawn as its highest value per narrow band, over all its values in grey.
std::vector<PlotCurve> spectraOfShots(
    const std::vector<ShotStyle> &shots, const std::vector<const PowerSpectrum *> &spectra);

/// A plot of power spectral densities of responses: axes, the shots' curves, and where y begins.
PlotContent spectraContent(const QString &title, const WindowResult &window,
    const std::vector<ShotStyle> &shots, const std::vector<const PowerSpectrum *> &spectra);

PlotAxis timeAxisMeaning(); ///< "Time" in s
PlotAxis frequencyAxisMeaning(); ///< "Frequency" in Hz, logarithmic
/// What the values of windowed responses are: remapped (no unit) or in the channel's unit.
PlotAxis responseAxisMeaning(const WindowResult &window);

} // namespace dyncal
