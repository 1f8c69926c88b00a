// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/realization/model/sensor_model.h"
#include "core/signal/response_window.h"

#include <complex>
#include <vector>

namespace dyncal {

/// What a drift behind the onset is taken for: heat of the shocked gas is not the sensor's; AC
/// coupling belongs to its chain and stays in its response.
enum class DriftKind { None, Heat, AcCoupling, Undetermined };

const char *driftKindName(DriftKind kind); ///< "none", "heat", "ac-coupling", "undetermined"

/// How far one shot has drifted from the level at the onset to the settle band, read from the
/// record there, not extrapolated; and the curve 1 - h (1 - e^(-t/tau)) through it (docs/method/
/// onset.md).
struct ShotDrift
{
    Index shot = 0;
    double tau_s = 0.0;
    double share = 0.0; ///< h
    double relative = 0.0; ///< (level in the settle band)/(level at the onset) - 1
    double u = 0.0; ///< of `relative`, k = 1
    double at_s = 0.0; ///< middle of the settle band, behind the onset
};

/// The drift of a calibration.
struct DriftResult
{
    DriftKind kind = DriftKind::None;
    std::vector<ShotDrift> shots; ///< empty without a drift, or where the shots were averaged

    const ShotDrift *ofShot(Index shot) const;
    /// What stays in the sensor's S(f): 1 - h + h jw tau/(1 + jw tau) with the shots' mean h and
    /// tau for a drift that is or may be its chain's, 1 for heat and without a drift.
    std::complex<double> keptAt(double frequency_Hz) const;
};

/// `span_s`: of the model input, from the start on, over which the model knows the drift.
DriftResult findDrift(
    const std::vector<WindowedResponse> &responses, const SensorModel &model, double span_s);

/// What the drift makes of a step in the model, pooled: (c0 + sum h_i jw/(jw - s_i))/L; 1 without
/// one. The model's response over it is that of the sensor alone.
std::complex<double> modelledDrift(const SensorModel &model, double frequency_Hz);

} // namespace dyncal
