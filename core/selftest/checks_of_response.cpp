// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/checks_of_response.h"

#include "core/base/constants.h"
#include "core/model_analysis/model_characteristics.h"
#include "core/model_analysis/model_response.h"
#include "core/model_analysis/step_transform.h"
#include "core/realization/exponentials/front.h"
#include "core/selftest/second_order_truth.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace dyncal {
namespace {

constexpr SecondOrderTruth kRinging{300e3, 0.02};
constexpr SecondOrderTruth kFlat{1.0, 0.7}; ///< times and frequencies in units of f0
constexpr SecondOrderTruth kPeaked{1.0, 0.2};

/// That sensor as a model, its poles and amplitudes written down.
SensorModel modelOfTruth(const SecondOrderTruth &truth, DataChange &change)
{
    const std::complex<double> upper = truth.pole_rad_s();
    const std::complex<double> s(change(upper.real()), change(upper.imag()));
    const std::complex<double> c = std::conj(s) / (s - std::conj(s)); // y(0) = y'(0) = 0
    SensorModel model;
    model.order = 2;
    model.plateauGain = 1.0;
    model.amplitudes = Eigen::Vector2cd(c, std::conj(c));
    for (const std::complex<double> &half : {s, std::conj(s)}) {
        Pole pole;
        pole.s_rad_s = half;
        pole.z = std::exp(half / (100.0 * truth.f0_Hz));
        pole.poleClass = PoleClass::Sensor;
        pole.frequency_Hz = truth.f0_Hz;
        pole.dampingRatio = truth.zeta;
        model.poles.push_back(pole);
    }
    return model;
}

constexpr double kStepRate_Hz = 10e6;
constexpr double kOnsetOfStep_s = -0.5 / kStepRate_Hz; ///< half a sample before the first

/// S(f) from a step that began half a sample before the first, over the true one.
std::complex<double> transformOverTruth(double frequency_Hz, DataChange &change)
{
    const Eigen::VectorXd y = change(kRinging.sampled(kStepRate_Hz, 8000, 0.5));
    return stepTransforms(y, kStepRate_Hz, transformEnds(y, 0), kOnsetOfStep_s, frequency_Hz).back()
        / kRinging.response(frequency_Hz);
}

double magnitudeOverTruth(DataChange &change)
{
    return std::abs(transformOverTruth(1e5, change));
}

double phaseLessTruth_rad(DataChange &change)
{
    return std::arg(transformOverTruth(1e5, change));
}

/// Gans and Nahman: the record with its mirror image behind it, at the odd bins, is twice the
/// transform of the differences. Largest relative difference over some bins.
double differenceFromGansNahman(DataChange &change)
{
    const Index N = 500;
    const Eigen::VectorXd y = change(kRinging.sampled(kStepRate_Hz, N, 0.5));
    const TransformEnd end{N, 1, y[N - 1]};
    double largest = 0.0;
    for (const int bin : {1, 11, 101}) {
        const double x = kTwoPi * bin / static_cast<double>(2 * N);
        std::complex<double> sum = 0.0;
        for (Index n = 0; n < 2 * N; ++n)
            sum += (n < N ? y[n] : y[N - 1] - y[n - N])
                * std::polar(1.0, -x * static_cast<double>(n));
        const std::complex<double> classic = 0.5 * sum * std::complex<double>(0.0, x);
        const std::complex<double> found
            = stepTransforms(y, kStepRate_Hz, {end}, 0.0, x * kStepRate_Hz / kTwoPi).back();
        largest = std::max(largest, std::abs(found / classic - 1.0));
    }
    return largest;
}

double magnitudeOfModel(DataChange &change)
{
    return std::abs(modelResponse(
        modelOfTruth(kPeaked, change), ResponseTreatment::StepDeflated, kPeaked.f0_Hz));
}

double phaseOfModel_rad(DataChange &change)
{
    return std::arg(modelResponse(
        modelOfTruth(kPeaked, change), ResponseTreatment::StepDeflated, kPeaked.f0_Hz));
}

StepCharacteristics characteristicsOf(const SecondOrderTruth &truth, DataChange &change)
{
    return stepCharacteristics(modelOfTruth(truth, change), ResponseTreatment::StepDeflated);
}

double riseTimeOfModel(DataChange &change)
{
    return characteristicsOf(kFlat, change).riseTime_s.value_or(kUnknown);
}

double overshootOfModel_percent(DataChange &change)
{
    return characteristicsOf(kFlat, change).overshoot_percent.value_or(kUnknown);
}

double settlingOfModel(DataChange &change)
{
    return characteristicsOf(kPeaked, change).settlingTime_s.value_or(kUnknown);
}

double bandWithin5percent(DataChange &change)
{
    return characteristicsOf(kPeaked, change).within5percent_Hz.value_or(kUnknown);
}

double bandWithin10percent(DataChange &change)
{
    return characteristicsOf(kPeaked, change).within10percent_Hz.value_or(kUnknown);
}

double bandTo3dB(DataChange &change)
{
    return characteristicsOf(kPeaked, change).minus3dB_Hz.value_or(kUnknown);
}

/// A front of 1 us at 250 kHz.
double gainOfFront(DataChange &change)
{
    return frontFactor(change(1e-6), {0.0, kTwoPi * change(250e3)}).real();
}

std::vector<CheckSpec> checksOfTransform()
{
    const Message closed{
        DYNCAL_TEXT(
            "core", "second order in closed form, f0 = 300 kHz, 10 MHz; aliasing below 1e-6"),
        {}};
    return {
        {"response", {DYNCAL_TEXT("core", "magnitude from a step over the true one, 100 kHz"), {}},
            closed, 1.0, 1e-5, magnitudeOverTruth},
        {"response", {DYNCAL_TEXT("core", "phase from a step less the true one, rad"), {}}, closed,
            0.0, 1e-5, phaseLessTruth_rad},
        {"response", {DYNCAL_TEXT("core", "largest relative difference from Gans and Nahman"), {}},
            {DYNCAL_TEXT("core", "Gans and Nahman 1982, exact"), {}}, 0.0, 1e-11,
            differenceFromGansNahman},
        {"response", {DYNCAL_TEXT("core", "attenuation by a front of 1 us at 250 kHz"), {}},
            {DYNCAL_TEXT("core", "sin x / x"), {}},
            std::sin(0.25 * kTwoPi / 2.0) / (0.25 * kTwoPi / 2.0), 1e-14, gainOfFront}};
}

std::vector<CheckSpec> checksOfModelResponse()
{
    const Message closed{DYNCAL_TEXT("core", "second order in closed form"), {}};
    const Message table{
        DYNCAL_TEXT("core", "roots of the second-order response, zeta 0.2 and 0.7, six digits"),
        {}};
    return {{"response", {DYNCAL_TEXT("core", "magnitude of the model at f0"), {}}, closed,
                1.0 / (2.0 * kPeaked.zeta), 1e-13, magnitudeOfModel},
        {"response", {DYNCAL_TEXT("core", "phase of the model at f0, rad"), {}}, closed,
            -0.25 * kTwoPi, 1e-13, phaseOfModel_rad},
        {"response", {DYNCAL_TEXT("core", "rise time of the model, times f0"), {}}, table, 0.338396,
            5e-7, riseTimeOfModel},
        {"response", {DYNCAL_TEXT("core", "overshoot of the model, %"), {}}, table, 4.59879, 5e-6,
            overshootOfModel_percent},
        {"response", {DYNCAL_TEXT("core", "settling time of the model, times f0"), {}}, table,
            2.187495, 5e-7, settlingOfModel},
        {"response", {DYNCAL_TEXT("core", "band within 5 %, over f0"), {}}, table, 0.228028, 5e-7,
            bandWithin5percent},
        {"response", {DYNCAL_TEXT("core", "band within 10 %, over f0"), {}}, table, 0.315797, 5e-7,
            bandWithin10percent},
        {"response", {DYNCAL_TEXT("core", "band to -3 dB, over f0"), {}}, table, 1.509577, 5e-7,
            bandTo3dB}};
}

} // namespace

std::vector<CheckSpec> checksOfResponse()
{
    std::vector<CheckSpec> checks = checksOfTransform();
    for (CheckSpec &check : checksOfModelResponse())
        checks.push_back(std::move(check));
    return checks;
}

} // namespace dyncal
