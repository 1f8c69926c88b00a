// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/pole_classes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

constexpr double kStepDistance = 1e-3;
constexpr double kRunaway = 10.0;
constexpr double kNyquistReal = -0.5;
constexpr double kNyquistAngle = 0.95 * std::numbers::pi;

} // namespace

bool isRunaway(std::complex<double> z, Index samples)
{
    return static_cast<double>(samples) * std::log(std::abs(z)) > std::log(kRunaway);
}

bool dropRunaways(std::vector<std::complex<double>> &poles, Index samples)
{
    return std::erase_if(poles, [samples](auto z) { return isRunaway(z, samples); }) > 0;
}

std::vector<PoleClass> classifyPoles(const std::vector<std::complex<double>> &poles,
    ResponseTreatment treatment, const std::vector<bool> &standsOut)
{
    std::size_t step = poles.size();
    if (treatment == ResponseTreatment::StepAsImpulse) {
        for (std::size_t i = 0; i < poles.size(); ++i) {
            const double distance = std::abs(poles[i] - 1.0);
            if (poles[i].imag() == 0.0 && distance < kStepDistance
                && (step == poles.size() || distance < std::abs(poles[step] - 1.0)))
                step = i;
        }
    }
    std::vector<PoleClass> classes;
    for (std::size_t i = 0; i < poles.size(); ++i) {
        const std::complex<double> z = poles[i];
        if (i == step)
            classes.push_back(PoleClass::Step);
        else if (std::abs(z) > 1.0 + kUnstableMargin)
            classes.push_back(PoleClass::Unstable);
        else if ((z.imag() == 0.0 && z.real() < kNyquistReal)
            || (z.imag() != 0.0 && std::abs(std::arg(z)) > kNyquistAngle))
            classes.push_back(PoleClass::Nyquist);
        else
            classes.push_back(standsOut[i] ? PoleClass::Sensor : PoleClass::Other);
    }
    return classes;
}

void sortPoles(std::vector<Pole> &poles)
{
    std::stable_sort(poles.begin(), poles.end(), [](const Pole &a, const Pole &b) {
        return a.frequency_Hz != b.frequency_Hz ? a.frequency_Hz < b.frequency_Hz
                                                : a.z.imag() > b.z.imag();
    });
}

} // namespace dyncal
