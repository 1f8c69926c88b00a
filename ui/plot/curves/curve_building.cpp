// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/curves/curve_building.h"

#include "ui/text/shown_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace dyncal {

namespace {

QString levelText(ShotLevel level)
{
    switch (level) {
    case ShotLevel::Low:
        return Plots::tr("low");
    case ShotLevel::Medium:
        return Plots::tr("medium");
    case ShotLevel::High:
        return Plots::tr("high");
    case ShotLevel::None:
        break;
    }
    return {};
}

CurveRole roleOf(Index shot, ShotLevel level)
{
    if (level == ShotLevel::Low || (level == ShotLevel::None && shot == 1))
        return CurveRole::ShotLow;
    if (level == ShotLevel::Medium || (level == ShotLevel::None && shot == 2))
        return CurveRole::ShotMedium;
    if (level == ShotLevel::High || (level == ShotLevel::None && shot == 3))
        return CurveRole::ShotHigh;
    return CurveRole::ShotOther;
}

/// The number that a shot of the role has in a set of three.
Index usualNumber(CurveRole role)
{
    switch (role) {
    case CurveRole::ShotLow:
        return 1;
    case CurveRole::ShotMedium:
        return 2;
    case CurveRole::ShotHigh:
        return 3;
    default:
        return 4; // the first without a place of its own
    }
}

} // namespace

PlotCurve shotCurve(
    const ShotStyle &shot, CurveStyle style, std::vector<double> x, std::vector<double> y)
{
    PlotCurve curve{shot.name, shot.role, style, std::move(x), std::move(y), true};
    curve.variant = shot.variant;
    return curve;
}

ShotStyle shotStyle(Index shot, ShotLevel level)
{
    if (shot <= 0)
        return {Plots::tr("Average"), CurveRole::Mean};
    QString name = Plots::tr("Shot %1").arg(shot);
    if (level != ShotLevel::None)
        name += QStringLiteral(" (%1)").arg(levelText(level));
    const CurveRole role = roleOf(shot, level);
    return {name, role, shot == usualNumber(role) ? 0 : static_cast<int>(shot)};
}

ShotStyle shotStyle(Index shot, const WindowResult &window)
{
    const auto response = std::find_if(window.responses.begin(), window.responses.end(),
        [shot](const WindowedResponse &candidate) { return candidate.shot == shot; });
    return shotStyle(shot, response == window.responses.end() ? ShotLevel::None : response->level);
}

std::vector<double> toVector(const Eigen::Ref<const Eigen::VectorXd> &values)
{
    return {values.data(), values.data() + values.size()};
}

std::vector<double> timeAxis(double first, double step, Index count)
{
    std::vector<double> times(static_cast<std::size_t>(std::max<Index>(0, count)));
    for (std::size_t i = 0; i < times.size(); ++i)
        times[i] = first + step * static_cast<double>(i);
    return times;
}

std::vector<double> decibels(const Eigen::VectorXd &power)
{
    std::vector<double> values(static_cast<std::size_t>(power.size()));
    for (Index i = 0; i < power.size(); ++i)
        values[static_cast<std::size_t>(i)] = power[i] > 0.0
            ? 10.0 * std::log10(power[i])
            : std::numeric_limits<double>::quiet_NaN();
    return values;
}

namespace {

/// The highest value of each of `bands` log-spaced bands, at its own frequency: a point picked on
/// the curve is one of the spectrum.
PowerSpectrum highestPerBand(const PowerSpectrum &spectrum, Index bands)
{
    const Eigen::VectorXd &f_Hz = spectrum.frequency_Hz;
    const auto from = std::find_if(f_Hz.begin(), f_Hz.end(), [](double f) { return f > 0.0; });
    const double ratio = std::log(f_Hz[f_Hz.size() - 1] / *from) / static_cast<double>(bands);
    std::vector<Index> highest;
    Index lastBand = -1;
    for (Index i = from - f_Hz.begin(); i < f_Hz.size(); ++i) {
        const auto band = static_cast<Index>(std::log(f_Hz[i] / *from) / ratio);
        if (band > lastBand)
            highest.push_back(i);
        else if (!(spectrum.psd[highest.back()] >= spectrum.psd[i])) // a NaN is replaced
            highest.back() = i;
        lastBand = band;
    }
    return {f_Hz(highest), spectrum.psd(highest)};
}

/// Lowest decibel value of the first view: deep nulls of a periodogram would squeeze the rest.
std::optional<double> lowestShown_dB(const std::vector<PlotCurve> &curves)
{
    constexpr double kHiddenShare = 0.02;
    constexpr double kRoom_dB = 6.0;
    std::vector<double> values;
    for (const PlotCurve &curve : curves)
        std::copy_if(curve.y.begin(), curve.y.end(), std::back_inserter(values),
            [](double value) { return std::isfinite(value); });
    if (values.empty())
        return std::nullopt;
    const auto place
        = values.begin() + static_cast<Index>(kHiddenShare * static_cast<double>(values.size()));
    std::nth_element(values.begin(), place, values.end());
    return *place - kRoom_dB;
}

} // namespace

std::vector<PlotCurve> spectraOfShots(
    const std::vector<ShotStyle> &shots, const std::vector<const PowerSpectrum *> &spectra)
{
    constexpr Index kBands = 1000; // about one a pixel
    std::vector<PlotCurve> all;
    std::vector<PlotCurve> shapes;
    for (std::size_t i = 0; i < shots.size() && i < spectra.size(); ++i) {
        const bool many = spectra[i]->frequency_Hz.size() > 4 * kBands;
        const PowerSpectrum shape = many ? highestPerBand(*spectra[i], kBands) : *spectra[i];
        shapes.push_back(shotCurve(
            shots[i], CurveStyle::Line, toVector(shape.frequency_Hz), decibels(shape.psd)));
        if (many)
            all.push_back({Plots::tr("All values"), CurveRole::Noise, CurveStyle::Line,
                toVector(spectra[i]->frequency_Hz), decibels(spectra[i]->psd), all.empty()});
    }
    all.insert(
        all.end(), std::make_move_iterator(shapes.begin()), std::make_move_iterator(shapes.end()));
    return all;
}

PlotContent spectraContent(const QString &title, const WindowResult &window,
    const std::vector<ShotStyle> &shots, const std::vector<const PowerSpectrum *> &spectra)
{
    PlotContent content;
    content.title = title;
    content.xAxis = frequencyAxisMeaning();
    const QString unit = responseAxisMeaning(window).unit;
    content.yAxis = {Plots::tr("Power spectral density"),
        unit.isEmpty() ? QStringLiteral("dB re 1/Hz")
                       : QStringLiteral("dB re ") + unit + QStringLiteral("²/Hz")};
    content.curves = spectraOfShots(shots, spectra);
    content.yMin = lowestShown_dB(content.curves);
    return content;
}

PlotCurve barsOf(const QString &name, CurveRole role, const BarPoints &points)
{
    PlotCurve bars{name, role, CurveStyle::ErrorBars, {}, {}, true};
    for (const BarPoint &point : points) {
        bars.x.insert(bars.x.end(), 3, point.x);
        bars.y.insert(bars.y.end(), {point.y - point.U, point.y + point.U, std::nan("")});
    }
    return bars;
}

void addWithBars(const QString &name, CurveRole role, const BarPoints &points, PlotContent &content)
{
    if (points.empty())
        return;
    PlotCurve dots{name, role, CurveStyle::Markers, {}, {}, true};
    for (const BarPoint &point : points) {
        dots.x.push_back(point.x);
        dots.y.push_back(point.y);
    }
    content.curves.push_back(barsOf(Plots::tr("%1, ± U").arg(name), role, points));
    content.curves.push_back(std::move(dots));
}

PlotAxis timeAxisMeaning()
{
    return {Plots::tr("Time"), QStringLiteral("s")};
}

PlotAxis frequencyAxisMeaning()
{
    return {Plots::tr("Frequency"), QStringLiteral("Hz"), true};
}

PlotAxis responseAxisMeaning(const WindowResult &window)
{
    const bool remapped = std::any_of(window.responses.begin(), window.responses.end(),
        [](const WindowedResponse &response) { return response.valueScale != 1.0; });
    if (remapped)
        return {Plots::tr("Response, remapped"), QString()};
    QStringList units;
    for (const WindowedResponse &response : window.responses)
        units << shownText(response.unit);
    units.removeDuplicates();
    if (units.size() > 1) // one axis cannot have the prefix of several units
        return {Plots::tr("Response in %1").arg(units.join(QStringLiteral(", "))), QString()};
    return {Plots::tr("Response"), units.value(0)};
}

} // namespace dyncal
