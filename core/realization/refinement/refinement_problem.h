// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/exponentials/exponential_regression.h"
#include "core/realization/refinement/refinement.h"

#include <Eigen/Core>

#include <cmath>
#include <complex>
#include <vector>

namespace dyncal {

/// Whether a real pole is so slow, for its number of time constants over the record, that its part
/// is a ramp but for a quarter.
inline bool isNearlyRamp(double timeConstants)
{
    constexpr double kMost = 0.5;
    return std::abs(timeConstants) <= kMost;
}

/// Whether a real pole, for its number of time constants over the record, has not died out at its
/// end: its rate is known from the curvature of a slope.
inline bool isRelaxing(double timeConstants)
{
    constexpr double kMost = 3.0; // 5 % of its part is left
    return std::abs(timeConstants) <= kMost;
}

/// The least squares of refinePoles() as a function of one vector of parameters: poles first, then
/// per record n amplitudes, maybe c0, and per nuisance term Re and Im of pole and amplitude; of
/// relaxing poles the slope in place of the amplitude, and the level in place of c0
/// (Refinement::relaxing), in which the problem stays regular where a rate passes 0. Times are
/// scaled by `unit_s`, so that all parameters of the sensor are of order one. Keeps a reference to
/// the records.
class RefinementProblem
{
public:
    /// `startPoles_rad_s`: pairs together, the upper half first. Without any pole there is nothing
    /// to fit, and unit_s() is 0.
    RefinementProblem(const std::vector<RefinementRecord> &records,
        const std::vector<std::complex<double>> &startPoles_rad_s, bool withConstant,
        bool realPolesAnywhere = false);

    const std::vector<RefinementRecord> &records() const { return m_records; }
    /// Per mode: conjugate pair, or one real pole.
    const std::vector<bool> &isPair() const { return m_isPair; }
    /// Positions of the real poles that start unsettled; none without a constant.
    const std::vector<Index> &relaxing() const { return m_relaxing; }
    bool withConstant() const { return m_withConstant; }
    double unit_s() const { return m_unit_s; }

    Index poles() const { return m_start.size(); }
    Index parameters() const { return offset(m_records.size()); }
    Index offset(std::size_t record) const;
    Index nuisanceOffset(std::size_t record, std::size_t term) const;
    /// Samples that take part, of all records.
    Index samples() const;

    /// Parameters at the poles to start from, amplitudes zero.
    Eigen::VectorXd start() const;
    /// J^T J, J^T r and r^T r of all records, weighted.
    RegressionEquations equations(const Eigen::VectorXd &theta) const;
    /// Best amplitudes for the poles of `theta`.
    void solveAmplitudes(Eigen::VectorXd &theta) const;
    /// The same with amplitudes and c0 in place of slopes and levels.
    Eigen::VectorXd amplitudes(const Eigen::VectorXd &theta) const;
    /// Moves relaxing poles off rate 0, where their amplitude is infinite, by so little that it
    /// cannot be seen.
    void leaveZero(Eigen::VectorXd &theta) const;
    /// Whether every pole decays, unless it is nearly a ramp, and every mode still describes the
    /// oscillation or relaxation it started from; of real poles only as asked for.
    bool isNearStart(const Eigen::VectorXd &theta) const;

private:
    Index perRecord() const { return poles() + (m_withConstant ? 1 : 0); }
    double step(std::size_t record) const { return 1.0 / m_records[record].rate_Hz / m_unit_s; }
    bool isWorthAThread() const;
    bool isUnsettled(Index place, double rate) const;
    std::vector<RegressionMode> modes(const Eigen::VectorXd &theta, std::size_t record) const;
    void toSlopes(
        const Eigen::VectorXd &amplitudes, std::size_t record, RegressionEquations &local) const;
    std::vector<Index> amplitudePlaces(std::size_t record) const;
    std::vector<Index> places(std::size_t record) const;

    const std::vector<RefinementRecord> &m_records;
    std::vector<ExponentialRegression> m_regressions; ///< one per record
    std::vector<bool> m_isPair;
    std::vector<Index> m_relaxing;
    bool m_withConstant;
    bool m_realPolesAnywhere;
    double m_unit_s = 0.0;
    double m_length = 0.0; ///< of the longest record, in that unit
    Eigen::VectorXd m_start; ///< of the poles
};

/// The records as means of `factor` samples, without incomplete means at their ends and those that
/// contain samples left out. Exponentials keep their poles.
std::vector<RefinementRecord> averaged(const std::vector<RefinementRecord> &records, Index factor);

} // namespace dyncal
