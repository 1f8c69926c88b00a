// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/weak_modes.h"

#include "core/uncertainty/front_effect.h"

#include <cmath>

namespace dyncal {
namespace {

double levelOf(const SensorModel &model)
{
    return std::abs(model.stepLevel.value_or(model.plateauGain));
}

/// Both poles of a pair have the same amplitude; together they swing by twice of it.
bool isWeak(const SensorModel &model, std::size_t at)
{
    const Pole &pole = model.poles[at];
    return pole.poleClass == PoleClass::Sensor && pole.s_rad_s.imag() != 0.0
        && 2.0 * std::abs(model.amplitudes[static_cast<Index>(at)]) < kWeakMode * levelOf(model);
}

void removeOfStep(std::complex<double> s_rad_s, ExponentialSum &step)
{
    for (Index i = 0; i < step.amplitudes.size(); ++i)
        if (step.poles_rad_s[i] == s_rad_s)
            step.amplitudes[i] = 0.0;
}

} // namespace

std::optional<SensorModel> withoutWeakModes(
    const SensorModel &model, const std::pair<std::size_t, std::size_t> &main)
{
    std::optional<SensorModel> reduced;
    for (std::size_t at = 0; at < static_cast<std::size_t>(model.amplitudes.size()); ++at) {
        if (at == main.first || at == main.second || !isWeak(model, at))
            continue;
        if (!reduced)
            reduced = withFront(model, 0.0, 0.0);
        reduced->amplitudes[static_cast<Index>(at)] = 0.0;
        removeOfStep(model.poles[at].s_rad_s, reduced->sensorStep);
    }
    return reduced;
}

} // namespace dyncal
