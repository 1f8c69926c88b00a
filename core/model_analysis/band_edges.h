// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/model/sensor_model.h"

#include <optional>

namespace dyncal {

/// Lowest frequencies in hertz at which |S(f)/S(0)| leaves 1 +- 5 %, 1 +- 10 %, and falls below
/// 1/sqrt(2); empty where it does not.
struct BandEdges
{
    std::optional<double> within5percent_Hz;
    std::optional<double> within10percent_Hz;
    std::optional<double> minus3dB_Hz;
};

/// Of a model whose poles all decay, of a step treatment and with a plateau other than 0. Looked
/// for at 400 points per decade, from 1e-3 of the slowest to 20 times the fastest pole, and at
/// every resonance, which may be narrower than their spacing; then by bisection. The sensor's own
/// part where the model has slow poles.
BandEdges bandEdges(const SensorModel &model, ResponseTreatment treatment);

} // namespace dyncal
