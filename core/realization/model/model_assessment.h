// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/capture/capture_set.h"
#include "core/realization/model/sensor_model.h"
#include "core/realization/second_order/second_order_model.h"

#include <optional>
#include <vector>

namespace dyncal {

/// The same order with the nuisance modes left in the response (before) and without them (after).
struct NuisanceEffect
{
    struct Side
    {
        double residualRms = kUnknown; ///< over the model inputs, in the units of the series
        double fit_percent = kUnknown;
        double f0_Hz = kUnknown; ///< of the main resonance
        double u_f0_Hz = kUnknown;
        double zeta = kUnknown;
        double u_zeta = kUnknown;
        double plateauGain = kUnknown;
    };
    Side before;
    Side after;
};

/// The main resonance and the plateau of one shot, or of the shots of one level together,
/// fitted to these alone: the trend with the step. Unknown where that fit does not converge.
struct LevelPole
{
    std::vector<Index> shots; ///< numbers from 1
    ShotLevel level = ShotLevel::None;
    double step = kUnknown; ///< mean of the shots' steps, in the unit of the recording
    double frequency_Hz = kUnknown;
    double u_frequency_Hz = kUnknown;
    double dampingRatio = kUnknown;
    double u_dampingRatio = kUnknown;
    double plateauGain = kUnknown; ///< c0, in the units of the series
    double u_plateauGain = kUnknown;
    double coverageFactor = kUnknown; ///< k of these u at 95 %
};

/// Test whether the shots share the model's poles, at 1 % (docs/method/model.md); values are those
/// of the pole on which they agree least.
struct Homogeneity
{
    double frequency_Hz = 0.0;
    double statistic = 0.0; ///< chi square
    double dof = 0.0;
    double probability = 1.0; ///< of so much scatter by chance, times the poles tested
    bool passed = true;
};

/// How good one fitted model is; made by assessModel(). It belongs to that model and must never be
/// shown beside another.
struct ModelAssessment
{
    /// The model's poles, in its order, with what the assessment adds: u, coverageFactor,
    /// "shots-disagree" and "integrator".
    std::vector<Pole> poles;
    std::optional<NuisanceEffect> nuisanceEffect; ///< where both sides could be refined
    std::vector<LevelPole> perShot; ///< in shot order
    std::vector<LevelPole> perLevel; ///< from low to high; only shots with a level
    std::optional<Homogeneity> homogeneity; ///< empty with fewer than two shots, or where no
                                            ///< pole of them could be compared
    std::optional<SecondOrderModel> secondOrder; ///< the 2nd-order sensor fitted beside the model
    Findings findings; ///< MOD-010, MOD-011, MOD-017, MOD-019, MOD-020; listed after the model's
};

/// The poles as assessed; if `assessment` is null as fitted, with unknown uncertainties.
const std::vector<Pole> &polesOf(const SensorModel &model, const ModelAssessment *assessment);

/// The main resonance among them.
const Pole *mainPole(const SensorModel &model, const ModelAssessment *assessment);

/// Undamped natural frequency and damping ratio of the sensor. A sensor of damping ratio 1 and more
/// has them too, but no pole that rings.
struct SensorResonance
{
    double frequency_Hz = kUnknown;
    double u_frequency_Hz = kUnknown;
    double dampingRatio = kUnknown;
    double u_dampingRatio = kUnknown;
    double coverageFactor = kUnknown; ///< k: value +- k u is a 95 % interval of both
};

/// Of the second-order sensor where that is the model, else of the main resonance; empty where
/// there is neither, or `model` is null. If `assessment` is null its uncertainties are unknown.
std::optional<SensorResonance> sensorResonance(
    const SensorModel *model, const ModelAssessment *assessment);

} // namespace dyncal
