// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/curves/model_curves.h"

#include "core/model_analysis/stated_characteristics.h"
#include "ui/plot/curves/curve_building.h"
#include "ui/plot/values/axis_prefix.h"
#include "ui/text/shown_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kClipShare = 0.5; ///< of the measured range, to either side

/// Limits a curve that diverges to values near the data.
void clipTo(const Eigen::VectorXd &measured, std::vector<double> &values)
{
    if (measured.size() == 0)
        return;
    const double low = measured.minCoeff();
    const double high = measured.maxCoeff();
    const double room = kClipShare * (high - low);
    for (double &value : values)
        value = std::isfinite(value) ? std::clamp(value, low - room, high + room) : kNone;
}

void addMeasuredSeries(
    PlotContent &content, const ModelInput &input, std::size_t position, const ShotStyle &style)
{
    const ModelSeries &series = input.series[position];
    content.curves.push_back(shotCurve(style, CurveStyle::Line,
        timeAxis(series.first_s, 1.0 / input.sampleRate_Hz, series.y.size()), toVector(series.y)));
}

void addModelSeries(PlotContent &content, const ModelInput &input, const SensorModel &model,
    std::size_t position, bool first)
{
    const ModelSeries &series = input.series[position];
    std::vector<double> simulated = toVector(model.series[position].simulated);
    if (model.diverges)
        clipTo(series.y, simulated);
    const auto count = static_cast<Index>(simulated.size());
    content.curves.push_back({Plots::tr("Model of order %1").arg(model.order), CurveRole::Model,
        CurveStyle::Line, timeAxis(series.first_s, 1.0 / input.sampleRate_Hz, count),
        std::move(simulated), first});
}

/// Time after which the slowest oscillating pole of the sensor has decayed to nothing visible.
std::optional<double> ringingTime_s(const SensorModel &model)
{
    constexpr double kDecays = 6.0;
    std::optional<double> longest;
    for (const Pole &pole : model.poles) {
        const double decay = -pole.s_rad_s.real();
        if (pole.poleClass == PoleClass::Sensor && pole.s_rad_s.imag() > 0.0 && decay > 0.0)
            longest = std::max(longest.value_or(0.0), kDecays / decay);
    }
    return longest;
}

struct PoleLook
{
    CurveRole role = CurveRole::Pole;
    QString name;
};

PoleLook lookOf(PoleClass poleClass)
{
    switch (poleClass) {
    case PoleClass::Sensor:
        return {CurveRole::Pole, Plots::tr("Poles of the sensor")};
    case PoleClass::Step:
        return {CurveRole::StepPole, Plots::tr("Pole of the step")};
    case PoleClass::Unstable:
        return {CurveRole::UnstablePole, Plots::tr("Unstable poles")};
    case PoleClass::Nyquist:
        return {CurveRole::ShotHigh, Plots::tr("Poles at the Nyquist frequency")};
    case PoleClass::Other:
        break;
    }
    return {CurveRole::ShotOther, Plots::tr("Other poles")};
}

void addResponseMarks(PlotContent &content, const ResponseResult &response)
{
    if (response.fLow_Hz > 0.0)
        content.marks.push_back({response.fLow_Hz, Plots::tr("lower limit"), CurveRole::Reference});
    if (response.fHigh_Hz > response.fLow_Hz)
        content.marks.push_back(
            {response.fHigh_Hz, Plots::tr("upper limit"), CurveRole::Reference});
}

/// Values with bars of +- 2u, where uncertainties are known. Never a band: between two frequencies
/// of the grid there may be a resonance.
void addMeasured(PlotContent &content, const Eigen::VectorXd &frequency_Hz,
    const Eigen::VectorXd &values, const Eigen::VectorXd &u, double scale)
{
    if (values.size() == 0 || values.size() != frequency_Hz.size())
        return;
    const std::vector<double> x = toVector(frequency_Hz);
    if (u.size() == values.size()) {
        PlotCurve bars{Plots::tr("± 2u"), CurveRole::Noise, CurveStyle::ErrorBars, {}, {}, true};
        for (Index i = 0; i < u.size(); ++i) {
            if (!std::isfinite(u[i]) || !(u[i] > 0.0))
                continue;
            bars.x.insert(bars.x.end(), 3, frequency_Hz[i]);
            bars.y.insert(bars.y.end(),
                {scale * (values[i] - 2.0 * u[i]), scale * (values[i] + 2.0 * u[i]), kNone});
        }
        if (!bars.x.empty())
            content.curves.push_back(std::move(bars));
    }
    content.curves.push_back({Plots::tr("Non-parametric"), CurveRole::Measured, CurveStyle::Dots, x,
        toVector(scale * values), true});
}

/// What the plots leave out without a model; empty where nothing.
QString withheldWords(const ResponseResult &response)
{
    const auto isWithheld = [](WithheldReason reason) { return reason != WithheldReason::None; };
    const auto count = std::ranges::count_if(response.withheld, isWithheld);
    if (count == 0)
        return {};
    return QStringLiteral(" ")
        + Plots::tr("Non-parametric values withheld: %1 of %2; results and findings say why.")
              .arg(count)
              .arg(response.withheld.size());
}

/// Value of the model's step response at t >= 0.
double stepResponse(const SensorModel &model, const std::vector<std::complex<double>> &rates,
    ResponseTreatment treatment, double t_s)
{
    std::complex<double> sum = isStepTreatment(treatment) ? model.plateauGain : 0.0;
    for (std::size_t i = 0; i < rates.size(); ++i) {
        const std::complex<double> amplitude = model.amplitudes[static_cast<Index>(i)];
        const std::complex<double> grown = std::exp(rates[i] * t_s);
        sum += isStepTreatment(treatment) ? amplitude * grown
                                          : amplitude * (grown - 1.0) / rates[i];
    }
    return sum.real();
}

/// Words alone: the value stands with its U among the key results.
void addOvershoot(const ResponseResult &response, double settled, PlotContent &content)
{
    const auto overshoot_percent = statedCharacteristics(response).overshoot_percent.value;
    if (!overshoot_percent)
        return;
    content.levels.push_back({settled, Plots::tr("final value"), CurveRole::Reference});
    content.levels.push_back({settled * (1.0 + 0.01 * *overshoot_percent),
        Plots::tr("final value + overshoot"), CurveRole::Reference});
}

} // namespace

PlotContent simulationCurves(const ModelInput &input, const SensorModel &model,
    const WindowResult &window, std::optional<std::size_t> series)
{
    PlotContent content;
    content.title = model.diverges
        ? Plots::tr("Data and model of order %1: diverges").arg(model.order)
        : Plots::tr("Data and model of order %1").arg(model.order);
    content.xAxis = timeAxisMeaning();
    content.yAxis = responseAxisMeaning(window);
    const std::size_t count = std::min(input.series.size(), model.series.size());
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < count; ++i)
        if (!series || *series == i)
            shown.push_back(i);
    for (const std::size_t i : shown)
        addMeasuredSeries(content, input, i, shotStyle(input.series[i].shot, window));
    for (const std::size_t i : shown)
        addModelSeries(content, input, model, i, i == shown.front());
    const double length_s = static_cast<double>(input.samples) / input.sampleRate_Hz;
    if (const auto ringing_s = ringingTime_s(model); ringing_s && *ringing_s < length_s)
        content.xMax = input.offset_s + *ringing_s;
    content.summary = Plots::tr("Data and model of order %1; the fit is %2 %.")
                          .arg(model.order)
                          .arg(valueWithUnit(model.fit_percent, QString(), 4));
    return content;
}

PlotContent errorCurves(const ModelInput &input, const SensorModel &model,
    const WindowResult &window, std::optional<std::size_t> series)
{
    PlotContent content;
    content.title = Plots::tr("Data minus model");
    content.xAxis = timeAxisMeaning();
    content.yAxis = {Plots::tr("Error"), responseAxisMeaning(window).unit};
    const std::size_t count = std::min(input.series.size(), model.series.size());
    for (std::size_t i = 0; i < count; ++i) {
        if (series && *series != i)
            continue;
        const ShotStyle style = shotStyle(input.series[i].shot, window);
        std::vector<double> error = toVector(model.series[i].error);
        if (model.diverges)
            clipTo(input.series[i].y, error);
        content.curves.push_back(shotCurve(style, CurveStyle::Line,
            timeAxis(
                input.series[i].first_s, 1.0 / input.sampleRate_Hz, model.series[i].error.size()),
            std::move(error)));
    }
    content.summary = content.title;
    return content;
}

PlotContent poleZeroCurves(const SensorModel &model)
{
    PlotContent content;
    content.title = Plots::tr("Poles and zeros, order %1").arg(model.order);
    content.xAxis = {Plots::tr("Real part"), QString()};
    content.yAxis = {Plots::tr("Imaginary part"), QString()};
    content.equalAspect = true;
    content.unitCircle = true;
    if (model.stateSpace.sampleInterval_s > 0.0)
        content.dampingGridRate_Hz = 1.0 / model.stateSpace.sampleInterval_s;
    double reach = 1.0;
    const auto add = [&](PlotCurve &curve, std::complex<double> z) {
        curve.x.push_back(z.real());
        curve.y.push_back(z.imag());
        if (std::abs(z) <= kFarthestInMap)
            reach = std::max({reach, std::abs(z.real()), std::abs(z.imag())});
    };
    for (const PoleClass poleClass : {PoleClass::Sensor, PoleClass::Step, PoleClass::Nyquist,
             PoleClass::Unstable, PoleClass::Other}) {
        const PoleLook look = lookOf(poleClass);
        PlotCurve curve{look.name, look.role, CurveStyle::Markers, {}, {}, true};
        for (const Pole &pole : model.poles)
            if (pole.poleClass == poleClass)
                add(curve, pole.z);
        if (!curve.x.empty())
            content.curves.push_back(std::move(curve));
    }
    PlotCurve zeros{Plots::tr("Zeros"), CurveRole::Zero, CurveStyle::Markers, {}, {}, true};
    for (const std::complex<double> &zero : model.zeros)
        add(zeros, zero);
    if (!zeros.x.empty())
        content.curves.push_back(std::move(zeros));
    content.xMin = content.yMin = -1.1 * reach;
    content.xMax = content.yMax = 1.1 * reach;
    content.summary
        = Plots::tr("poles: %1, zeros: %2").arg(model.poles.size()).arg(model.zeros.size());
    if (const Index beyond = countBeyondMap(model); beyond > 0)
        content.summary
            += QStringLiteral("; ") + Plots::tr("further out than shown: %1").arg(beyond);
    return content;
}

PlotContent bodeMagnitudeCurves(const ResponseResult &response)
{
    PlotContent content;
    content.title = Plots::tr("Frequency response, magnitude");
    content.xAxis = frequencyAxisMeaning();
    const QString unit = shownText(response.unit);
    content.yAxis = {Plots::tr("Magnitude"), unit == QLatin1String("1") ? QString() : unit, true};
    content.curves.push_back({Plots::tr("Model"), CurveRole::Model, CurveStyle::Line,
        toVector(response.modelCurve.frequency_Hz), toVector(response.modelCurve.magnitude), true});
    addMeasured(content, response.frequency_Hz, response.magnitude, response.u_magnitude, 1.0);
    addResponseMarks(content, response);
    content.summary = Plots::tr("Magnitude of the frequency response; usable from %1 to %2.")
                          .arg(valueWithUnit(response.fLow_Hz, QStringLiteral("Hz"), 3),
                              valueWithUnit(response.fHigh_Hz, QStringLiteral("Hz"), 3))
        + withheldWords(response);
    return content;
}

PlotContent bodePhaseCurves(const ResponseResult &response)
{
    const double toDegrees = 180.0 / M_PI;
    PlotContent content;
    content.title = Plots::tr("Frequency response, phase");
    content.xAxis = frequencyAxisMeaning();
    content.yAxis = {Plots::tr("Phase"), QStringLiteral("°")};
    content.curves.push_back(
        {response.isByTransducer ? Plots::tr("Model, from its own onset") : Plots::tr("Model"),
            CurveRole::Model, CurveStyle::Line, toVector(response.modelCurve.frequency_Hz),
            toVector(toDegrees * response.modelCurve.phase_rad), true});
    addMeasured(
        content, response.frequency_Hz, response.phase_rad, response.u_phase_rad, toDegrees);
    addResponseMarks(content, response);
    content.summary = Plots::tr("Phase of the frequency response, output over input, lag negative.")
        + withheldWords(response);
    return content;
}

PlotContent stepCurves(
    const SensorModel &model, ResponseTreatment treatment, const ResponseResult *response)
{
    constexpr Index kPoints = 3000;
    constexpr double kSettled = 6.0; ///< e-foldings of the slowest pole
    constexpr double kLongSettled = 40.0; ///< to rounding
    PlotContent content;
    content.title = Plots::tr("Step response of the model");
    content.xAxis = timeAxisMeaning();
    content.yAxis = {Plots::tr("Response"), QString()};
    content.summary = content.title;
    std::vector<std::complex<double>> rates;
    double slowest = 0.0;
    for (const Pole &pole : model.poles) {
        if (pole.poleClass == PoleClass::Step)
            continue;
        rates.push_back(pole.s_rad_s);
        const double decay = std::abs(pole.s_rad_s.real());
        if (decay > 0.0)
            slowest = slowest > 0.0 ? std::min(slowest, decay) : decay;
    }
    if (static_cast<Index>(rates.size()) != model.amplitudes.size() || !(slowest > 0.0))
        return content;
    if (model.diverges)
        content.title = Plots::tr("Step response of the model: diverges");
    const double step = kSettled / slowest / static_cast<double>(kPoints - 1);
    PlotCurve curve{Plots::tr("Model of order %1").arg(model.order), CurveRole::Model,
        CurveStyle::Line, timeAxis(0.0, step, kPoints), {}, true};
    for (const double t_s : curve.x)
        curve.y.push_back(stepResponse(model, rates, treatment, t_s));
    if (model.diverges)
        clipTo(Eigen::Vector2d(0.0, 2.0 * model.plateauGain), curve.y);
    content.curves.push_back(std::move(curve));
    if (response && model.slowPoles.empty()) // a drift is no part of what overshoots
        addOvershoot(
            *response, stepResponse(model, rates, treatment, kLongSettled / slowest), content);
    return content;
}

} // namespace dyncal
