// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/defect_kinds.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

constexpr double kShortest_s = 1e-6; ///< time constants
constexpr double kLongest_s = 1.0;

constexpr std::array<DefectDescription, 31> kDescriptions{{
    {DefectKind::Clip, "clip", "converter range of the sensor under test too small"},
    {DefectKind::Nan, "nan", "three invalid samples"},
    {DefectKind::Swap, "swap", "roles of the sensor under test and the side sensor exchanged"},
    {DefectKind::NoStep, "nostep", "the diaphragm held"},
    {DefectKind::Short, "short", "records end 0.4 ms after the step"},
    {DefectKind::Fs50, "fs50", "half the sample rate"},
    {DefectKind::Drift, "drift", "the baseline rises by 2 % of the step per millisecond"},
    {DefectKind::Psi, "psi", "values in psi under the unit bar"},
    {DefectKind::RingVar, "ringvar", "one shot rings differently", {}, {}, DefectScope::MiddleShot},
    {DefectKind::TubeMode, "tubemode", "a mode of the gas near 6.8 kHz"},
    {DefectKind::Heat, "heat", "the output sags by this share, with this time constant in s",
        DefectNumber{0.02, -0.5, 0.5}, DefectNumber{0.5e-3, kShortest_s, kLongest_s}},
    {DefectKind::AcCoupling, "ac", "AC coupling with this time constant in s",
        DefectNumber{5e-3, kShortest_s, kLongest_s}},
    {DefectKind::Echo, "echo", "a copy of this share of the step, this many s late",
        DefectNumber{0.03, -0.5, 0.5}, DefectNumber{0.1e-3, 0.0, 0.01}},
    {DefectKind::Gain, "gain", "the sensitivity of one shot is multiplied",
        DefectNumber{1.5, 0.01, 100.0}, {}, DefectScope::MiddleShot},
    {DefectKind::Scatter, "scatter",
        "the shots' sensitivities scatter with this standard deviation",
        DefectNumber{0.02, 0.0, 0.1}},
    {DefectKind::Attenuation, "attenuation", "W(x) = W (1 + SIZE x), x in m from the end wall",
        DefectNumber{0.01, -0.05, 0.05}},
    {DefectKind::SideDelay, "delay", "the side sensor answers later by so many of its rise times",
        DefectNumber{1.0, 0.0, 20.0}},
    {DefectKind::Distance, "distance", "the side sensor's distance is noted wrong by so many m",
        DefectNumber{-0.015, -0.3, 0.3}, {}, DefectScope::Capture},
    {DefectKind::Temperature, "temperature", "T1 is noted wrong by so many K",
        DefectNumber{10.0, -90.0, 90.0}},
    {DefectKind::Pressure, "pressure", "p1 is noted wrong by this share",
        DefectNumber{0.05, -0.9, 9.0}},
    {DefectKind::OtherGas, "gas", "this share of the driven gas is nitrogen, air is noted",
        DefectNumber{1.0, 0.0, 1.0}},
    {DefectKind::Humidity, "humidity", "the true relative humidity, while 0 is noted",
        DefectNumber{0.5, 0.0, 1.0}},
    {DefectKind::Rate, "rate", "the rate of all channels is stated so many times the true one",
        DefectNumber{2.0, 0.01, 100.0}},
    {DefectKind::Scale, "scale",
        "the volts of the sensor under test are stated so many times too large",
        DefectNumber{1000.0, 1e-6, 1e6}},
    {DefectKind::Levels, "levels",
        "this shot and the next of another level are named for each other", {}, {},
        DefectScope::MiddleShot},
    {DefectKind::Front, "front", "the step is a ramp of so many s",
        DefectNumber{200e-9, 0.0, 1e-4}},
    {DefectKind::Tilt, "tilt", "the front is tilted by so many degrees over a disc of 5.5 mm",
        DefectNumber{1.0, 0.0, 10.0}},
    {DefectKind::Clock, "clock", "the true rate is higher by this share than the stated one",
        DefectNumber{100e-6, -0.01, 0.01}},
    {DefectKind::Bow, "bow",
        "the converter reads so many codes too much in the middle of its range",
        DefectNumber{4.0, -1000.0, 1000.0}},
    {DefectKind::Autoregressive, "ar", "noise x_k = SIZE x_(k-1) + e_k instead of white",
        DefectNumber{0.9, -0.9999, 0.9999}},
    {DefectKind::Flicker, "flicker", "1/f noise instead of white"},
}};

} // namespace

std::span<const DefectDescription> defectDescriptions()
{
    return kDescriptions;
}

const DefectDescription &describedDefect(DefectKind kind)
{
    return *std::find_if(kDescriptions.begin(), kDescriptions.end(),
        [kind](const DefectDescription &description) { return description.kind == kind; });
}

std::string defectNames()
{
    std::string names;
    for (const DefectDescription &description : kDescriptions)
        names.append(names.empty() ? "" : ", ").append(description.name);
    return names;
}

} // namespace dyncal
