// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/order_curves.h"

#include "ui/plot/axis_prefix.h"
#include "ui/plot/curve_building.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

constexpr double kLowestFit_percent = 0.0; ///< below, an order says nothing but "bad"
/// Above 100 %: the attainable FIT and the chosen order are written there.
constexpr double kRoomForLabels_percent = 135.0;

struct StabilityLook
{
    PoleStability stability;
    CurveRole role;
    QString name;
};

std::vector<StabilityLook> stabilityLooks()
{
    return {{PoleStability::New, CurveRole::NewPole, Plots::tr("New")},
        {PoleStability::Frequency, CurveRole::HalfStablePole, Plots::tr("f stable")},
        {PoleStability::FrequencyAndDamping, CurveRole::StablePole, Plots::tr("f, ζ stable")},
        {PoleStability::Unstable, CurveRole::UnstablePole, Plots::tr("Unstable")}};
}

/// Mean of the shots' spectra at the first one's frequencies; where they differ in their
/// frequencies, the first one alone.
PowerSpectrum meanSpectrum(const SpectrumResult &spectrum)
{
    if (spectrum.perShot.empty())
        return {};
    PowerSpectrum mean = spectrum.perShot.front();
    double count = 1.0;
    for (std::size_t i = 1; i < spectrum.perShot.size(); ++i) {
        const PowerSpectrum &other = spectrum.perShot[i];
        if (other.frequency_Hz.size() != mean.frequency_Hz.size()
            || other.frequency_Hz != mean.frequency_Hz)
            continue;
        mean.psd += other.psd;
        count += 1.0;
    }
    mean.psd /= count;
    return mean;
}

/// The highest value of each of some hundred bands over the frequencies of the poles: the shape is
/// all that is asked for.
PlotCurve spectrumBehind(const SpectrumResult &spectrum, double from_Hz, double to_Hz)
{
    constexpr Index kBands = 400;
    const PowerSpectrum mean = meanSpectrum(spectrum);
    PlotCurve curve{Plots::tr("Spectrum"), CurveRole::Noise, CurveStyle::Line, {}, {}, true};
    curve.onSecondAxis = true;
    const double perBand = std::log(to_Hz / from_Hz) / static_cast<double>(kBands);
    Index last = -1;
    for (Index i = 0; i < mean.frequency_Hz.size(); ++i) {
        const double f_Hz = mean.frequency_Hz[i];
        if (!(f_Hz >= from_Hz && f_Hz <= to_Hz) || !(mean.psd[i] > 0.0))
            continue;
        const double level_dB = 10.0 * std::log10(mean.psd[i]);
        const auto band = static_cast<Index>(std::log(f_Hz / from_Hz) / perBand);
        if (band > last) {
            curve.x.push_back(f_Hz);
            curve.y.push_back(level_dB);
        } else if (level_dB > curve.y.back()) {
            curve.x.back() = f_Hz;
            curve.y.back() = level_dB;
        }
        last = band;
    }
    return curve;
}

void markOrder(PlotContent &content, Index order)
{
    if (order > 0)
        content.marks.push_back(
            {static_cast<double>(order), Plots::tr("order %1").arg(order), CurveRole::Model});
}

PlotCurve overOrder(const QString &name, CurveRole role, const Eigen::VectorXd &values)
{
    return {name, role, CurveStyle::LineAndDots, timeAxis(1.0, 1.0, values.size()),
        toVector(values), true};
}

} // namespace

PlotContent stabilisationCurves(
    const OrderEvidence &evidence, const SpectrumResult &spectrum, Index order)
{
    PlotContent content;
    content.title = Plots::tr("Stabilisation: poles of all orders");
    content.xAxis = frequencyAxisMeaning();
    content.yAxis = {Plots::tr("Order"), QString(), false, true};
    if (evidence.poles.empty()) {
        content.summary = Plots::tr("No order has an oscillating pole.");
        return content;
    }
    const auto [lowest, highest]
        = std::ranges::minmax(evidence.poles, {}, &OrderPole::frequency_Hz);
    content.xMin = 0.7 * lowest.frequency_Hz;
    content.xMax = 1.4 * highest.frequency_Hz;
    content.yAxis2 = PlotAxis{Plots::tr("Spectrum"), QStringLiteral("dB")};
    content.curves.push_back(spectrumBehind(spectrum, *content.xMin, *content.xMax));
    int stable = 0;
    for (const StabilityLook &look : stabilityLooks()) {
        PlotCurve curve{look.name, look.role, CurveStyle::Markers, {}, {}, true};
        for (const OrderPole &pole : evidence.poles) {
            if (pole.stability != look.stability)
                continue;
            curve.x.push_back(pole.frequency_Hz);
            curve.y.push_back(static_cast<double>(pole.order));
        }
        if (look.stability == PoleStability::FrequencyAndDamping)
            stable = static_cast<int>(curve.x.size());
        if (!curve.x.empty())
            content.curves.push_back(std::move(curve));
    }
    content.yMin = 0.0;
    content.yMax = 1.05 * static_cast<double>(evidence.poles.back().order) + 1.0;
    if (order > 0)
        content.levels.push_back(
            {static_cast<double>(order), Plots::tr("order %1").arg(order), CurveRole::Model});
    content.summary = Plots::tr("Poles of orders 1 to %1: %2, of which stable: %3. f stable: "
                                "the frequency was there at the order before; f, ζ stable: the "
                                "damping ratio, too; new: neither; behind them the mean spectrum.")
                          .arg(evidence.poles.back().order)
                          .arg(evidence.poles.size())
                          .arg(stable);
    return content;
}

PlotContent evidenceCurves(const OrderEvidence *evidence, const OrderSuggestion &suggestion,
    double attainable_percent, Index order)
{
    PlotContent content;
    content.title = Plots::tr("FIT and criteria over the order");
    content.xAxis = {Plots::tr("Order"), QString(), false, true};
    content.yAxis = {Plots::tr("FIT"), QStringLiteral("%")};
    if (suggestion.bic.size() > 0) {
        content.yAxis2 = PlotAxis{Plots::tr("BIC"), QString()};
        PlotCurve bic = overOrder(Plots::tr("BIC"), CurveRole::Noise, suggestion.bic);
        bic.onSecondAxis = true;
        content.curves.push_back(std::move(bic));
    }
    if (evidence) {
        content.curves.push_back(
            overOrder(Plots::tr("FIT"), CurveRole::Measured, evidence->fit_percent));
        if (evidence->crossShot_percent.size() > 0)
            content.curves.push_back(overOrder(
                Plots::tr("Left-out error"), CurveRole::Error, evidence->crossShot_percent));
        content.yMin = kLowestFit_percent;
        content.yMax = kRoomForLabels_percent;
    }
    if (std::isfinite(attainable_percent))
        content.levels.push_back({attainable_percent,
            Plots::tr("attainable %1 %").arg(valueWithUnit(attainable_percent, QString(), 3)),
            CurveRole::Reference});
    markOrder(content, order);
    content.summary
        = Plots::tr("FIT, error of each shot by the poles of the others, and information "
                    "criterion (BIC) of every order; order %1 is chosen.")
              .arg(order);
    return content;
}

} // namespace dyncal
