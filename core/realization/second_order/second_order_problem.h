// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/realization/exponentials/exponential_regression.h"
#include "core/realization/refinement/refinement.h"
#include "core/realization/second_order/second_order_step.h"

#include <Eigen/Core>

#include <vector>

namespace dyncal {

/// The records of one second-order sensor as a problem of least squares, and its parameters theta:
/// logOmega, logZeta, with a drift its rate, then plateau, onset, the drift's amplitude and modes
/// of each record, as in SecondOrderStep.
class SecondOrderProblem
{
public:
    /// `records` must outlive it; `unit_s`: of the times in theta.
    SecondOrderProblem(const std::vector<RefinementRecord> &records, double unit_s, double front_s,
        bool withDrift);

    const std::vector<RefinementRecord> &records() const { return m_records; }
    double unit_s() const { return m_unit_s; }
    bool withDrift() const { return m_drifts > 0; }
    void lengthenFront(double by_s) { m_front_s += by_s; }

    Index parameters() const { return plateauAt(m_records.size()); }
    Index samples() const;
    /// Place of a record's plateau in theta; its onset follows.
    Index plateauAt(std::size_t record) const;
    SecondOrderStep step(const Eigen::VectorXd &theta, std::size_t record) const;
    void setStep(const SecondOrderStep &step, std::size_t record, Eigen::VectorXd &theta) const;
    RegressionEquations normalEquations(const Eigen::VectorXd &theta) const;

    /// The same as poles with the amplitudes of every record, in seconds, without covariance.
    Refinement asExponentials(const Eigen::VectorXd &theta) const;

    /// d (parameters of asExponentials()) / d theta.
    Eigen::MatrixXd derivatives(const Eigen::VectorXd &theta, const Refinement &fit) const;

private:
    std::vector<Index> places(std::size_t record) const;
    Index shared() const { return 2 + m_drifts; }
    double interval(std::size_t record) const { return 1.0 / m_records[record].rate_Hz / m_unit_s; }

    const std::vector<RefinementRecord> &m_records;
    std::vector<ExponentialRegression> m_regressions;
    double m_unit_s = 1.0;
    double m_front_s = 0.0;
    Index m_drifts = 0; ///< 0 or 1
};

} // namespace dyncal
