// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/curves/order_curves.h"

#include "core/realization/hankel/order_suggestion.h"
#include "core/signal/spectrum_analysis.h"
#include "ui/plot/curves/curve_building.h"
#include "ui/plot/values/axis_prefix.h"

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

/// The spectra with the same frequencies as the first one, including that one.
std::vector<const PowerSpectrum *> alikeSpectra(const SpectrumResult &spectrum)
{
    std::vector<const PowerSpectrum *> alike;
    for (const PowerSpectrum &other : spectrum.perShot) {
        const Eigen::VectorXd &first = spectrum.perShot.front().frequency_Hz;
        if (other.frequency_Hz.size() == first.size() && other.frequency_Hz == first)
            alike.push_back(&other);
    }
    return alike;
}

/// The mean spectrum over the frequencies of the poles, as the highest value in each of some
/// hundred bands: only its shape matters. It is drawn at every move of the order, so it takes one
/// logarithm per band, not per bin.
PlotCurve spectrumBehind(const SpectrumResult &spectrum, double from_Hz, double to_Hz)
{
    constexpr int kBands = 400;
    PlotCurve curve{Plots::tr("Spectrum"), CurveRole::Noise, CurveStyle::Line, {}, {}, true};
    curve.onSecondAxis = true;
    const std::vector<const PowerSpectrum *> alike = alikeSpectra(spectrum);
    if (alike.empty())
        return curve;
    const Eigen::VectorXd &f_Hz = alike.front()->frequency_Hz;
    const double *const end = f_Hz.data() + f_Hz.size();
    const double *bin = std::lower_bound(f_Hz.data(), end, from_Hz);
    for (int band = 0; band < kBands && bin != end; ++band) {
        const double end_Hz = from_Hz * std::pow(to_Hz / from_Hz, (band + 1.0) / kBands);
        double highest = 0.0;
        double at_Hz = 0.0;
        for (; bin != end && *bin <= end_Hz; ++bin) {
            double sum = 0.0;
            for (const PowerSpectrum *one : alike)
                sum += one->psd[bin - f_Hz.data()];
            if (sum > highest) {
                highest = sum;
                at_Hz = *bin;
            }
        }
        if (!(highest > 0.0))
            continue;
        curve.x.push_back(at_Hz);
        curve.y.push_back(10.0 * std::log10(highest / static_cast<double>(alike.size())));
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
    content.summary = Plots::tr(
        "Poles of orders 1 to %1: %2, of which stable: %3. f stable: the frequency was there at the order before; f, ζ stable: the damping ratio, too; new: neither; behind them the mean spectrum.")
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
    content.summary = Plots::tr(
        "FIT, error of each shot by the poles of the others, and information criterion (BIC) of every order; order %1 is chosen.")
                          .arg(order);
    return content;
}

} // namespace dyncal
