// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/weak_modes.h"

#include "core/uncertainty/model_shape.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

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

} // namespace

std::optional<SensorModel> withoutWeakModes(
    const SensorModel &model, const std::pair<std::size_t, std::size_t> &main)
{
    std::vector<std::complex<double>> weak_rad_s;
    for (std::size_t at = 0; at < static_cast<std::size_t>(model.amplitudes.size()); ++at)
        if (at != main.first && at != main.second && isWeak(model, at))
            weak_rad_s.push_back(model.poles[at].s_rad_s);
    if (weak_rad_s.empty())
        return std::nullopt;
    return withAmplitudes(model, [&](std::complex<double> s_rad_s) {
        const bool isOneOfThem = std::ranges::find(weak_rad_s, s_rad_s) != weak_rad_s.end();
        return std::complex<double>(isOneOfThem ? 0.0 : 1.0);
    });
}

} // namespace dyncal
