// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/curves/pressure_curves.h"

#include "ui/plot/curves/curve_building.h"
#include "ui/text/quantity_format.h"

namespace dyncal {

namespace {

/// An edge of the band, behind the pressure.
PlotCurve edgeOf(const ShotStyle &style, const QString &name, const CorrectedPressure &pressure,
    double sign, const std::vector<double> &time_s)
{
    const Eigen::VectorXd edge
        = pressure.pressure_Pa.array() + sign * pressure.k.array() * pressure.u_Pa.array();
    PlotCurve curve{
        name.arg(style.name), CurveRole::Noise, CurveStyle::Line, time_s, toVector(edge), true};
    curve.variant = style.variant;
    return curve;
}

ShotStyle styleOf(const ShotPressure &shot, const CaptureSet &captures)
{
    const auto at = static_cast<std::size_t>(shot.shot - 1);
    return shotStyle(
        shot.shot, at < captures.shots.size() ? captures.shots[at].level : ShotLevel::None);
}

} // namespace

PlotContent pressureCurves(const CorrectionOutcome &outcome, const CaptureSet &captures)
{
    PlotContent content;
    content.title = Plots::tr("Pressure behind the recording");
    content.xAxis = timeAxisMeaning();
    content.yAxis = {Plots::tr("Pressure"), QStringLiteral("Pa")};
    for (const ShotPressure &shot : outcome.shots) {
        const CorrectedPressure &pressure = shot.record.pressure;
        const ShotStyle style = styleOf(shot, captures);
        const std::vector<double> time_s
            = timeAxis(pressure.time_s, 1.0 / pressure.rate_Hz, pressure.pressure_Pa.size());
        content.curves.push_back(
            edgeOf(style, Plots::tr("%1, upper end of 95 %"), pressure, 1.0, time_s));
        content.curves.push_back(
            edgeOf(style, Plots::tr("%1, lower end of 95 %"), pressure, -1.0, time_s));
        content.curves.push_back(
            shotCurve(style, CurveStyle::Line, time_s, toVector(pressure.pressure_Pa)));
    }
    content.summary = Plots::tr("Pressure up to %1 with its band of 95 %; recordings: %2.")
                          .arg(shownQuantity(outcome.filter.lowPass.band_Hz, QStringLiteral("Hz")))
                          .arg(outcome.shots.size());
    return content;
}

Index pointsOf(const CorrectionOutcome &outcome)
{
    constexpr Index kCurvesOfAShot = 3;
    Index points = 0;
    for (const ShotPressure &shot : outcome.shots)
        points += kCurvesOfAShot * shot.record.pressure.pressure_Pa.size();
    return points;
}

} // namespace dyncal
