// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/checks_of_signals.h"

#include "core/base/constants.h"
#include "core/decomposition/principal_components.h"
#include "core/selftest/known_records.h"
#include "core/selftest/second_order_truth.h"
#include "core/signal/power_spectrum.h"
#include "core/signal/resampler.h"
#include "core/signal/window_cutting.h"

#include <cmath>
#include <complex>

namespace dyncal {
namespace {

constexpr SecondOrderTruth kWellDamped{10e3, 0.7};
constexpr double kWindowRate_Hz = 10e6;

/// Baseline 2, step 3, at a quarter behind sample 4000.
std::optional<WindowedResponse> knownWindow(DataChange &change)
{
    Eigen::VectorXd values = Eigen::VectorXd::Constant(20000, 2.0);
    values.tail(16000) += 3.0 * kWellDamped.sampled(kWindowRate_Hz, 16000, -0.25);
    const auto cut = cutWindows(
        knownSet({knownChannel("DUT", ChannelRole::Dut, change(values), kWindowRate_Hz)}), {}, {});
    return cut && !cut->responses.empty() ? std::optional(cut->responses.front()) : std::nullopt;
}

double baselineOfWindow(DataChange &change)
{
    const auto window = knownWindow(change);
    return window ? window->baseline : kUnknown;
}

double stepOfWindow(DataChange &change)
{
    const auto window = knownWindow(change);
    return window ? window->step : kUnknown;
}

/// The first value of the window is that of the sample behind the onset.
double firstValueOfWindow(DataChange &change)
{
    const auto window = knownWindow(change);
    if (!window)
        return kUnknown;
    const double t_s = window->start_s - 4000.25 / kWindowRate_Hz;
    return window->window()[0] - kWellDamped.step(t_s);
}

double riseTimeOfWindow(DataChange &change)
{
    const auto window = knownWindow(change);
    return window ? window->riseTime_s.value_or(kUnknown) * kWellDamped.f0_Hz : kUnknown;
}

double overshootOfWindow_percent(DataChange &change)
{
    const auto window = knownWindow(change);
    return window ? window->overshoot_percent.value_or(kUnknown) : kUnknown;
}

/// 3 cos over 50 whole periods of 1024 samples at 1024 Hz: bins of 1 Hz.
double densityOfCosine(DataChange &change)
{
    const Eigen::VectorXd values = Eigen::VectorXd::NullaryExpr(1024,
        [](Index n) { return 3.0 * std::cos(kTwoPi * 50.0 * static_cast<double>(n) / 1024.0); });
    const auto spectrum = computePowerSpectrum(change(values), 1024.0, {});
    if (!spectrum)
        return kUnknown;
    for (Index k = 0; k < spectrum->psd.size(); ++k)
        if (std::abs(spectrum->frequency_Hz[k] - 50.0) < 0.5)
            return spectrum->psd[k];
    return kUnknown;
}

/// Three shots made of two components with singular values 5 and 3.
PrincipalComponents knownComponents(DataChange &change)
{
    Eigen::MatrixXd shots(8, 3);
    const Eigen::Vector3d first(2.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0),
        second(-1.0 / 3.0, 2.0 / 3.0, -2.0 / 3.0);
    for (Index n = 0; n < 8; ++n) {
        const double even = 1.0 / std::sqrt(8.0), turning = n % 2 == 0 ? even : -even;
        shots.row(n) = 5.0 * even * first + 3.0 * turning * second;
        for (double &value : shots.row(n))
            value = change(value);
    }
    return computePrincipalComponents(shots, false);
}

double secondComponent(DataChange &change)
{
    return knownComponents(change).singularValues[1];
}

double explainedByFirst_percent(DataChange &change)
{
    return knownComponents(change).explainedCumulative_percent[0];
}

const AntiAliasFilter &tenthOfTheRate()
{
    static const AntiAliasFilter filter = designAntiAliasFilter(10.0, 10e6);
    return filter;
}

/// A symmetric filter passes a ramp unchanged: the largest difference of 50 outputs.
double errorOfDecimatedRamp(DataChange &change)
{
    const AntiAliasFilter &filter = tenthOfTheRate();
    const Index first = filter.halfLength() + 3;
    const Eigen::VectorXd ramp = change(Eigen::VectorXd::LinSpaced(1000, 0.0, 999.0));
    const Eigen::VectorXd reduced = decimate(ramp, filter, first, 50);
    const double begin = static_cast<double>(first);
    return (reduced - Eigen::VectorXd::LinSpaced(50, begin, begin + 490.0)).cwiseAbs().maxCoeff();
}

double gainAtNewNyquist(DataChange &change)
{
    return std::abs(tenthOfTheRate().gain({0.0, kTwoPi * change(0.5e6)}));
}

/// e^(s t) comes out as gain(s) e^(s t), however fast it decays.
double errorOfDecimatedExponential(DataChange &change)
{
    const AntiAliasFilter &filter = tenthOfTheRate();
    const double s_rad_s = -2e5;
    const Eigen::VectorXd decay = Eigen::VectorXd::NullaryExpr(
        1000, [&](Index n) { return std::exp(s_rad_s * static_cast<double>(n) / 10e6); });
    const Eigen::VectorXd reduced = decimate(change(decay), filter, 100, 80);
    double sum = 0.0; // the gain written out
    for (Index k = 0; k < filter.taps.size(); ++k)
        sum += filter.taps[k]
            * std::exp(s_rad_s * static_cast<double>(k - filter.halfLength()) / 10e6);
    return reduced[40] / (sum * decay[500]) + filter.gain(s_rad_s).real() / sum - 2.0;
}

std::vector<CheckSpec> checksOfWindow()
{
    const Message closed{DYNCAL_TEXT("core", "second-order step in closed form, zeta = 0.7"), {}};
    return {{"window", {DYNCAL_TEXT("core", "baseline of a record"), {}}, closed, 2.0, 1e-9,
                baselineOfWindow},
        {"window", {DYNCAL_TEXT("core", "step of a record"), {}}, closed, 3.0, 1e-6, stepOfWindow},
        {"window", {DYNCAL_TEXT("core", "first value behind the start, error"), {}}, closed, 0.0,
            1e-9, firstValueOfWindow},
        {"window", {DYNCAL_TEXT("core", "rise time of a record, times f0"), {}}, closed, 0.338396,
            5e-6, riseTimeOfWindow},
        {"window", {DYNCAL_TEXT("core", "overshoot of a record, %"), {}}, closed, 4.59879, 1e-4,
            overshootOfWindow_percent}};
}

} // namespace

std::vector<CheckSpec> checksOfSignals()
{
    const Message construction{DYNCAL_TEXT("core", "by construction"), {}};
    const Message parseval{
        DYNCAL_TEXT("core", "Parseval: amplitude squared over 2 in one bin of 1 Hz"), {}};
    const Message symmetry{DYNCAL_TEXT("core", "what a symmetric filter must pass"), {}};
    std::vector<CheckSpec> checks = checksOfWindow();
    checks.insert(checks.end(),
        {{"spectrum", {DYNCAL_TEXT("core", "density of a cosine at its bin"), {}}, parseval, 4.5,
             1e-12, densityOfCosine},
            {"components", {DYNCAL_TEXT("core", "second singular value of three shots"), {}},
                construction, 3.0, 1e-13, secondComponent},
            {"components", {DYNCAL_TEXT("core", "share explained by the first component, %"), {}},
                construction, 100.0 * 25.0 / 34.0, 1e-12, explainedByFirst_percent},
            {"model_input", {DYNCAL_TEXT("core", "ramp at a tenth of the rate, largest error"), {}},
                symmetry, 0.0, 1e-9, errorOfDecimatedRamp},
            {"model_input", {DYNCAL_TEXT("core", "gain of the filter at half the new rate"), {}},
                {DYNCAL_TEXT("core", "half of the amplitude, -6 dB"), {}}, 0.5, 1e-3,
                gainAtNewNyquist},
            {"model_input",
                {DYNCAL_TEXT("core", "decaying exponential at a tenth of the rate, error"), {}},
                symmetry, 0.0, 1e-12, errorOfDecimatedExponential}});
    return checks;
}

} // namespace dyncal
