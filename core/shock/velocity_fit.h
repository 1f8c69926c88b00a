// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/result.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// Where and when the shock was seen.
struct Sighting
{
    std::string channel;
    double distance_m = 0.0; ///< to the end wall
    double u_distance_m = 0.0; ///< 0 = not stated; exact at the end wall
    double time_s = 0.0; ///< record axis, the sensor's own delay taken off
    double u_time_s = 0.0; ///< of finding the arrival in the record, in this shot alone
    double u_delay_s = 0.0; ///< of the sensor's delay, the same in every shot (rectangular)
    bool isDut = false;
};

/// Time that a counter measured between two places.
struct CounterReading
{
    double far_m = 0.0; ///< distances to the end wall, far > near
    double near_m = 0.0;
    double time_s = 0.0;
    double u_distance_m = 0.0; ///< of far - near
    double u_time_s = 0.0;
    bool operator==(const CounterReading &) const = default;
};

/// How a velocity that changes along the tube is treated.
enum class Attenuation {
    Automatic, ///< a change is fitted where it exceeds three times its uncertainty
    None, ///< constant velocity
    Linear, ///< always fitted, from three sensors (two counters) on
};

/// The shock's way along the tube, fitted to where and when it was seen.
struct VelocityFit
{
    double velocity_m_s = 0.0; ///< at the end wall
    double arrivalAtWall_s = 0.0; ///< fitted, record axis; NaN with counters
    bool attenuated = false; ///< the velocity changes along the tube
    std::optional<double> gradient_per_s; ///< dW/d(distance to the end wall) > 0: it slows down
    std::optional<double> u_gradient_per_s; ///< where it can be known
    Eigen::VectorXd residual; ///< seen minus fitted: s (counters: m/s)
    Index dof = 0; ///< observations less parameters
    bool scatterEstimated = false; ///< from the residuals, as not every uncertainty is stated
    double scatter_m_s = 0.0; ///< u of the velocity from that scatter, with `dof`
    std::optional<double> chiSquare; ///< of the residuals over the stated uncertainties

    /// The weights of the fit, for refittedVelocity_m_s().
    Eigen::VectorXd weight; ///< of each observation
};

/// The fit: times over distances by weighted least squares (weights from the uncertainty of the
/// time and of the distance over the velocity), a straight line or, with attenuation, a parabola;
/// the velocity is its slope at the end wall. Where a distance has no stated uncertainty and there
/// are more observations than parameters, all weigh the same and the scatter is estimated from the
/// residuals (Student's t with `dof`). Fails (Usage) on fewer than two places, (DataBlocked,
/// SHK-001) where the shock does not run towards the wall.
Result<VelocityFit> fitVelocity(const std::vector<Sighting> &sightings, Attenuation attenuation);

/// The velocity at the wall for other distances and times with the weights and the shape of `fit`;
/// for propagating uncertainty.
double refittedVelocity_m_s(
    const VelocityFit &fit, const Eigen::VectorXd &distance_m, const Eigen::VectorXd &time_s);

/// The same for counters: the mean velocity of each interval at its middle, fitted by a constant or
/// a straight line. Fails (Usage) without a reading or on an impossible one.
Result<VelocityFit> fitCounters(
    const std::vector<CounterReading> &readings, Attenuation attenuation);

double refittedCounterVelocity_m_s(
    const VelocityFit &fit, const std::vector<CounterReading> &readings);

} // namespace dyncal
