// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/checks_of_correction.h"

#include "core/base/constants.h"
#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "core/correction/correction_filter.h"
#include "core/selftest/second_order_truth.h"

#include <cmath>
#include <complex>

namespace dyncal {
namespace {

constexpr SecondOrderTruth kCorrected{300e3, 0.05};
constexpr double kSensitivity_V_Pa = 2e-9;
constexpr double kRecordingRate_Hz = 5e6;

/// The level and thirds of an octave from 1 kHz to 316 kHz, with the sensor's own shape.
KnownResponse responseOfSensor(DataChange &change)
{
    KnownResponse response;
    response.knot_Hz = Eigen::VectorXd::Zero(27);
    for (Index k = 1; k < 27; ++k)
        response.knot_Hz[k] = change(std::pow(10.0, 3.0 + 0.1 * static_cast<double>(k - 1)));
    response.atKnots.resize(27);
    for (Index k = 0; k < 27; ++k)
        response.atKnots[k] = change(kSensitivity_V_Pa) * kCorrected.response(response.knot_Hz[k]);
    const std::complex<double> pole = kCorrected.pole_rad_s();
    const std::complex<double> s(change(pole.real()), change(pole.imag())), other = std::conj(s);
    response.shape.s_rad_s = Eigen::Vector2cd(s, other);
    response.shape.c = Eigen::Vector2cd(other / (s - other), s / (other - s));
    response.u_alone = Eigen::VectorXd::Zero(27);
    response.validTo_Hz = 1e6;
    response.unit = "V/Pa";
    return response;
}

std::optional<CorrectionFilter> knownFilter(DataChange &change)
{
    auto filter = designCorrection(responseOfSensor(change), kRecordingRate_Hz, {change(150e3)});
    return filter ? std::optional(std::move(*filter)) : std::nullopt;
}

/// What taps, delay taken off, and sensor make of 100 kHz, the sum over the taps written out.
std::complex<double> passage(DataChange &change)
{
    const auto filter = knownFilter(change);
    if (!filter)
        return {kUnknown, kUnknown};
    std::complex<double> sum = 0.0;
    for (Index k = 0; k < filter->taps.size(); ++k) {
        const double n = static_cast<double>(k - filter->delaySamples);
        sum += filter->taps[k] * std::polar(1.0, -kTwoPi * 1e5 / kRecordingRate_Hz * n);
    }
    return sum * kSensitivity_V_Pa * kCorrected.response(1e5);
}

double magnitudePassed(DataChange &change)
{
    return std::abs(passage(change));
}

double phasePassed_rad(DataChange &change)
{
    return std::arg(passage(change));
}

double gainOfFilter(DataChange &change)
{
    const auto filter = knownFilter(change);
    return filter ? filter->gain() * kSensitivity_V_Pa : kUnknown;
}

double printedValue(DataChange &change)
{
    return parseNumber(roundedValue(change(2.330149e6), change(1234.0), "Hz").value)
        .value_or(kUnknown);
}

double printedUncertainty(DataChange &change)
{
    return parseNumber(roundedValue(change(2.330149e6), change(1234.0), "Hz").u).value_or(kUnknown);
}

} // namespace

std::vector<CheckSpec> checksOfCorrection()
{
    const Message inverse{DYNCAL_TEXT("core", "filter times sensor is 1 within the band"), {}};
    const Message rounding{DYNCAL_TEXT("core", "JCGM 100, 7.2.6: two digits of u"), {}};
    return {{kCorrectionStep, {DYNCAL_TEXT("core", "magnitude behind the correction, 100 kHz"), {}},
                inverse, 1.0, 4e-4, magnitudePassed},
        {kCorrectionStep, {DYNCAL_TEXT("core", "phase behind the correction, rad"), {}}, inverse,
            0.0, 4e-4, phasePassed_rad},
        {kCorrectionStep, {DYNCAL_TEXT("core", "gain of the correction at 0 Hz"), {}}, inverse, 1.0,
            4e-4, gainOfFilter},
        {kCertificateStep, {DYNCAL_TEXT("core", "2330149 Hz as printed with u, MHz"), {}}, rounding,
            2.3301, 1e-12, printedValue},
        {kCertificateStep, {DYNCAL_TEXT("core", "u = 1234 Hz as printed, MHz"), {}}, rounding,
            0.0012, 1e-15, printedUncertainty}};
}

} // namespace dyncal
