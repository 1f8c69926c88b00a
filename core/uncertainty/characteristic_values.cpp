// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/characteristic_values.h"

#include "core/model_analysis/marked_frequencies.h"
#include "core/model_analysis/model_characteristics.h"

#include <cmath>
#include <complex>

namespace dyncal {
namespace {

/// f0 and zeta of a pair, or of the sensor's two real poles.
void addResonance(
    std::complex<double> one, std::complex<double> other, CharacteristicValues &values)
{
    const double omega = std::sqrt(std::abs(one) * std::abs(other));
    values.f0_Hz = omega / kTwoPi;
    values.zeta = -0.5 * (one.real() + other.real()) / omega;
    values.q = 0.5 / values.zeta;
}

void addPeak(const SensorModel &model, ResponseTreatment treatment, CharacteristicValues &values)
{
    if (const auto peak = resonancePeak(model, treatment, values.f0_Hz, values.zeta)) {
        values.resonance_Hz = peak->frequency_Hz;
        values.resonanceGain = peak->gain;
    }
}

} // namespace

MainPair mainPair(const SensorModel &model, const ModelAssessment &assessment)
{
    if (model.secondOrder)
        return std::pair(model.poles.size() - 2, model.poles.size() - 1);
    const Pole *main = mainPole(model, &assessment);
    if (!main)
        return std::nullopt;
    const auto at = static_cast<std::size_t>(main - assessment.poles.data());
    return std::pair(at, at + 1);
}

CharacteristicValues characteristicValues(
    const SensorModel &model, const MainPair &pair, ResponseTreatment treatment)
{
    CharacteristicValues values;
    if (pair) {
        addResonance(model.poles[pair->first].s_rad_s, model.poles[pair->second].s_rad_s, values);
        if (isStepTreatment(treatment))
            addPeak(model, treatment, values);
    }
    const StepCharacteristics step = stepCharacteristics(model, treatment);
    values.within5percent_Hz = step.within5percent_Hz.value_or(kUnknown);
    values.within10percent_Hz = step.within10percent_Hz.value_or(kUnknown);
    values.minus3dB_Hz = step.minus3dB_Hz.value_or(kUnknown);
    values.riseTime_s = step.riseTime_s.value_or(kUnknown);
    values.overshoot_percent = step.overshoot_percent.value_or(kUnknown);
    values.settlingTime_s = step.settlingTime_s.value_or(kUnknown);
    return values;
}

} // namespace dyncal
