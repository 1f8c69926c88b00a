// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/realization/model/sensor_model.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dyncal {

/// How a pole compares with those of the order one lower.
enum class PoleStability {
    New, ///< nothing near it
    Frequency, ///< the frequency was there
    FrequencyAndDamping, ///< frequency and damping ratio were there
    Unstable, ///< outside the unit circle
};

const char *poleStabilityName(PoleStability stability); ///< "new", "frequency", ...

/// One oscillating pole (the upper half of a pair) of one order, as realised, without refinement.
struct OrderPole
{
    Index order = 0;
    double frequency_Hz = 0.0; ///< undamped, |s| / 2 pi
    double dampingRatio = 0.0;
    PoleStability stability = PoleStability::New;
    bool standsOut = false; ///< its part of the response is well above the noise
    double amplitude = 0.0; ///< |c| at the input's first sample over the noise, rms over the shots
};

/// f0 and zeta over the consecutive orders in which a pole is stable: means, and half the distance
/// between the largest and the smallest (a rectangular distribution's half width).
struct OrderSpread
{
    Index fromOrder = 0;
    Index toOrder = 0;
    double frequency_Hz = 0.0;
    double frequencySpread_Hz = 0.0;
    double dampingRatio = 0.0;
    double dampingSpread = 0.0;
};

/// What all orders together show for the choice of one (docs/method/order.md). Depends on the
/// decomposition and the tolerances, not on the order chosen.
struct OrderEvidence
{
    std::vector<OrderPole> poles; ///< by order, then frequency; without the step's pole
    Eigen::VectorXd fit_percent; ///< aligned, orders 1.., poles not refined; NaN where it diverges
    double fitAttainable_percent = kUnknown; ///< what the true model would score
    std::vector<Index> unstable; ///< poles outside the unit circle, orders 1..
    std::vector<Index> nyquist; ///< poles at the Nyquist frequency, orders 1..
    Eigen::VectorXd crossShot_percent; ///< leave-one-shot-out NRMSE, orders 1..; may be empty
    /// FIT of each shot by the others' poles, orders x shots; empty as crossShot_percent.
    Eigen::MatrixXd crossShotFit_percent;
    std::vector<Index> crossShots; ///< numbers of the shots, columns of crossShotFit_percent
    std::optional<OrderSpread> spread; ///< of the main pole around the suggested order
    std::vector<Message> words; ///< why the suggested order, sentence by sentence
    Findings findings; ///< ORD-002
};

} // namespace dyncal
