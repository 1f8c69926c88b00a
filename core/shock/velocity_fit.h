// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/interval.h"
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

/// How a velocity that changes along the tube is treated.
enum class Attenuation {
    Automatic, ///< a change is fitted, with what is known of it beforehand as one observation
    None, ///< constant velocity
    Linear, ///< a change is fitted from three sensors (two counters) on, to them alone
};

/// What is known of the attenuation a in W(x) = W (1 + a x) before any shot, x to the end wall:
/// anything in the range is equally likely, 1/m. A shock that slows down has a > 0; one that still
/// forms, within some ten diameters of the diaphragm, may have a < 0.
inline constexpr Interval kUsualAttenuation_per_m{-0.005, 0.01};

/// The attenuation as an observation in a fit whose last coefficient is `scale` times it.
struct AttenuationObservation
{
    Interval range_per_m = kUsualAttenuation_per_m;
    double scale = 0.0;

    double value_per_m() const { return 0.5 * (range_per_m.begin + range_per_m.end); }
    double u_per_m() const; ///< of the rectangle
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
    /// What the records alone say of the attenuation, 1/m, with its u, where they can.
    std::optional<double> seenAttenuation_per_m;
    double u_seenAttenuation_per_m = 0.0;

    /// The weights of the fit, for refittedVelocity_m_s().
    Eigen::VectorXd weight; ///< of each observation
    std::optional<AttenuationObservation> attenuation; ///< with Attenuation::Automatic
};

/// The fit: times over distances by weighted least squares (weights from the uncertainty of the
/// time and of the distance over the velocity), a straight line or, with attenuation, a parabola;
/// the velocity is its slope at the end wall. With Attenuation::Automatic the parabola's curvature
/// a/(2 W) is observed once more, as what `range_per_m` says of it, so that two places suffice.
/// Where a distance has no stated uncertainty and there are more observations than parameters, all
/// weigh the same and the scatter is estimated from the residuals (Student's t with `dof`). Fails
/// (Usage) on fewer than two places, (DataBlocked, SHK-001) where the shock does not run towards
/// the wall.
Result<VelocityFit> fitVelocity(const std::vector<Sighting> &sightings, Attenuation attenuation,
    const Interval &range_per_m = kUsualAttenuation_per_m);

/// The shock's way for other inputs than those of a fit.
struct RefittedWay
{
    double velocity_m_s = 0.0; ///< at the end wall
    double attenuation_per_m = 0.0; ///< a in W(x) = W (1 + a x); 0 where none is fitted
};

/// The way for other distances, times and another observed attenuation with the weights and the
/// shape of `fit`; for propagating uncertainty.
RefittedWay refittedWay(const VelocityFit &fit, const Eigen::VectorXd &distance_m,
    const Eigen::VectorXd &time_s, double attenuation_per_m);

/// Its velocity.
double refittedVelocity_m_s(const VelocityFit &fit, const Eigen::VectorXd &distance_m,
    const Eigen::VectorXd &time_s, double attenuation_per_m);

} // namespace dyncal
