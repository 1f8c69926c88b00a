// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>

#include <complex>
#include <optional>
#include <vector>

namespace dyncal {

/// What the pressure adds to its step and loses with time (heat of the gas): amplitude
/// e^(rate (t - onset)) in the record.
struct StepDrift
{
    double rate = 0.0;
    double amplitude = 0.0;
};

/// One record of the second-order sensor K w0^2/(s^2 + 2 zeta w0 s + w0^2): its response to a step
/// at `onset` and to the modes of the tube, as a sum of exponentials (docs/method/model.md). Times
/// in any unit.
class SecondOrderStep
{
public:
    /// Re(amplitude e^(pole t)) in the record.
    struct Mode
    {
        std::complex<double> pole;
        std::complex<double> amplitude;
        bool startsWithStep = true; ///< it is part of the pressure from the onset on
    };

    double logOmega = 0.0;
    double logZeta = 0.0;
    double plateau = 0.0; ///< K
    double onset = 0.0;
    double front = 0.0; ///< duration of the step's rise, about `onset`
    std::optional<StepDrift> drift;
    std::vector<Mode> modes;

    /// logOmega, logZeta, (rate of the drift,) plateau, onset, (amplitude of the drift,) then Re,
    /// Im of pole and of amplitude of each mode.
    Index parameters() const { return 4 + 2 * drifts() + 4 * std::ssize(modes); }
    void setParameters(const Eigen::VectorXd &values);
    Eigen::VectorXd parameterValues() const;

    /// zeta, kept 1e-4 away from 1, where the two poles meet.
    double zeta() const;

    /// Whether the two poles are a pair.
    bool rings() const { return zeta() < 1.0; }

    /// Whether it drifts, as a number of poles.
    Index drifts() const { return drift ? 1 : 0; }

    /// (Rate of the drift;) Re s, Im s (or two real poles); Re, Im of each mode's pole; (gain of
    /// the drift;) Re g, Im g of Re(g e^(s t)) (or two real gains); Re, Im of each mode's
    /// amplitude; K.
    Eigen::VectorXd exponentials() const;

    /// d exponentials / d parameters, by central differences: smooth, small and the same for both
    /// branches.
    Eigen::MatrixXd derivatives() const;

private:
    /// What the step's response is to e^(s t) of the pressure: K/(r^2 + 2 zeta r + 1), r = s/w0.
    std::complex<double> gainAt(std::complex<double> s) const;

    /// Factor by which the front, the drift and the tube's modes change the amplitude of e^(s t)
    /// that a sharp step alone would give.
    std::complex<double> factorOfPressure(std::complex<double> s) const;
};

} // namespace dyncal
