// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/sensor_response.h"
#include "core/realization/exponential_sum.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace dyncal {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

Index sensorPoles(const SensorModel &model)
{
    return model.amplitudes.size();
}

std::complex<double> rate(const SensorModel &model, Index i)
{
    return model.poles[static_cast<std::size_t>(i)].s_rad_s;
}

/// y(t)/c0 of the model's step response, t from the onset.
double normalisedStep(const SensorModel &model, double t_s)
{
    std::complex<double> y = model.plateauGain;
    for (Index i = 0; i < sensorPoles(model); ++i)
        y += model.amplitudes[i] * std::exp(rate(model, i) * t_s);
    return y.real() / model.plateauGain;
}

/// The same as a sum of exponentials.
ExponentialSum normalisedSum(const SensorModel &model)
{
    ExponentialSum sum{1.0, Eigen::VectorXcd(sensorPoles(model)), model.amplitudes};
    for (Index i = 0; i < sensorPoles(model); ++i)
        sum.rates_rad_s[i] = rate(model, i);
    sum.amplitudes /= model.plateauGain;
    return sum;
}

bool hasStepResponse(const SensorModel &model, ResponseTreatment treatment)
{
    return isStepTreatment(treatment) && !model.diverges && model.plateauGain != 0.0
        && sensorPoles(model) > 0
        && std::all_of(model.poles.begin(), model.poles.begin() + sensorPoles(model),
            [](const Pole &pole) { return pole.s_rad_s.real() < 0.0; });
}

/// Root of a sign change of `f` between a and b, by bisection to full precision.
double bisect(const std::function<double(double)> &f, double a, double b)
{
    const bool negative = f(a) < 0.0;
    for (int i = 0; i < 100 && a != b; ++i) {
        const double middle = 0.5 * (a + b);
        if (middle == a || middle == b)
            break;
        ((f(middle) < 0.0) == negative ? a : b) = middle;
    }
    return 0.5 * (a + b);
}

struct TimeGrid
{
    double step_s = 0.0;
    Index count = 0;
};

/// Forty points per radian of the fastest part, until e^-8 of the slowest is left.
TimeGrid timeGrid(const SensorModel &model)
{
    constexpr double kMostPoints = 4e5;
    double fastest = 0.0;
    double slowest = std::abs(rate(model, 0).real());
    for (Index i = 0; i < sensorPoles(model); ++i) {
        fastest = std::max(fastest, std::abs(rate(model, i)));
        slowest = std::min(slowest, std::abs(rate(model, i).real()));
    }
    const double end_s = 8.0 / slowest;
    const double count = std::min(kMostPoints, std::ceil(end_s * fastest * 40.0));
    return {end_s / count, static_cast<Index>(count)};
}

void describeStep(const SensorModel &model, StepCharacteristics &result)
{
    constexpr double kSettled = 0.05;
    const TimeGrid grid = timeGrid(model);
    const auto y = [&](double t) { return normalisedStep(model, t); };
    std::optional<double> t10;
    std::optional<double> t90;
    double top = -1e300;
    double topTime_s = 0.0;
    double previous = y(0.0);
    const ExponentialSampler sampler(normalisedSum(model), grid.step_s);
    Eigen::VectorXd values;
    for (Index k = 1; k <= grid.count; ++k) {
        const double t = static_cast<double>(k) * grid.step_s;
        const double before = t - grid.step_s;
        if (k == 1 || k % ExponentialSampler::kBlock == 0)
            values = sampler.block(k / ExponentialSampler::kBlock);
        const double now = values[k % ExponentialSampler::kBlock];
        if (!t10 && now >= 0.1)
            t10 = bisect([&](double x) { return y(x) - 0.1; }, before, t);
        if (!t90 && now >= 0.9)
            t90 = bisect([&](double x) { return y(x) - 0.9; }, before, t);
        if (now > top) {
            top = now;
            topTime_s = t;
        }
        if ((std::abs(previous - 1.0) > kSettled) != (std::abs(now - 1.0) > kSettled)) {
            const double level = std::abs(previous - 1.0) > kSettled ? previous : now;
            const double bound = level > 1.0 ? 1.0 + kSettled : 1.0 - kSettled;
            result.settlingTime_s = bisect([&](double x) { return y(x) - bound; }, before, t);
        }
        previous = now;
    }
    if (t10 && t90)
        result.riseTime_s = *t90 - *t10;
    // Parabola through the highest grid point and its neighbours.
    const double left = y(topTime_s - grid.step_s);
    const double right = y(topTime_s + grid.step_s);
    const double curvature = left - 2.0 * top + right;
    if (curvature < 0.0)
        top -= (right - left) * (right - left) / (8.0 * curvature);
    result.overshoot_percent = std::max(0.0, 100.0 * (top - 1.0));
}

/// Lowest frequency at which `leaves` of the relative magnitude turns from negative to positive.
std::optional<double> firstExit(const SensorModel &model, ResponseTreatment treatment,
    double from_Hz, double to_Hz, const std::function<double(double)> &leaves)
{
    constexpr int kPerDecade = 400;
    const auto f = [&](double frequency_Hz) {
        return leaves(std::abs(modelResponse(model, treatment, frequency_Hz) / model.plateauGain));
    };
    const int steps = static_cast<int>(std::ceil(std::log10(to_Hz / from_Hz) * kPerDecade));
    const double ratio = std::pow(to_Hz / from_Hz, 1.0 / steps);
    double previous = from_Hz;
    for (int i = 0; i < steps; ++i) {
        const double next = previous * ratio;
        if (f(next) > 0.0)
            return bisect(f, previous, next);
        previous = next;
    }
    return std::nullopt;
}

void describeBands(
    const SensorModel &model, ResponseTreatment treatment, StepCharacteristics &result)
{
    double slowest = std::abs(rate(model, 0));
    double fastest = slowest;
    for (Index i = 0; i < sensorPoles(model); ++i) {
        slowest = std::min(slowest, std::abs(rate(model, i)));
        fastest = std::max(fastest, std::abs(rate(model, i)));
    }
    const double from_Hz = 1e-3 * slowest / kTwoPi;
    const double to_Hz = 20.0 * fastest / kTwoPi;
    const auto outside = [](double limit) {
        return [limit](double ratio) { return std::abs(ratio - 1.0) - limit; };
    };
    result.within5percent_Hz = firstExit(model, treatment, from_Hz, to_Hz, outside(0.05));
    result.within10percent_Hz = firstExit(model, treatment, from_Hz, to_Hz, outside(0.10));
    result.minus3dB_Hz = firstExit(model, treatment, from_Hz, to_Hz,
        [](double ratio) { return std::numbers::sqrt2 / 2.0 - ratio; });
}

} // namespace

std::complex<double> modelResponse(
    const SensorModel &model, ResponseTreatment treatment, double frequency_Hz)
{
    const std::complex<double> jw(0.0, kTwoPi * frequency_Hz);
    const bool isStep = isStepTreatment(treatment);
    std::complex<double> G = isStep ? model.plateauGain : 0.0;
    for (Index i = 0; i < sensorPoles(model); ++i)
        G += model.amplitudes[i] * (isStep ? jw : 1.0) / (jw - rate(model, i));
    return G;
}

ResponseCurve modelCurve(const SensorModel &model, ResponseTreatment treatment, double from_Hz,
    double to_Hz, Index count)
{
    ResponseCurve curve{Eigen::VectorXd(count), Eigen::VectorXd(count), Eigen::VectorXd(count)};
    double phase = 0.0;
    for (Index k = 0; k < count; ++k) {
        const double share
            = count > 1 ? static_cast<double>(k) / static_cast<double>(count - 1) : 0.0;
        curve.frequency_Hz[k] = from_Hz * std::pow(to_Hz / from_Hz, share);
        const std::complex<double> G = modelResponse(model, treatment, curve.frequency_Hz[k]);
        curve.magnitude[k] = std::abs(G);
        // Unwrapped against the point before; a negative plateau starts at +pi, not -pi.
        phase += std::remainder(std::arg(G) - phase, kTwoPi);
        curve.phase_rad[k] = phase;
    }
    return curve;
}

StepCharacteristics stepCharacteristics(const SensorModel &model, ResponseTreatment treatment)
{
    StepCharacteristics result;
    if (!hasStepResponse(model, treatment))
        return result;
    describeStep(model, result);
    describeBands(model, treatment, result);
    return result;
}

} // namespace dyncal
