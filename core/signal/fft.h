// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>

#include <complex>
#include <memory>

namespace dyncal {

/// Real FFT of one length, hiding FFTW. Plans are made with FFTW_ESTIMATE (the only setting whose
/// rounding is the same from run to run) under one mutex, because the planner is not thread-safe;
/// execution is. Length n >= 1; the spectrum has n/2 + 1 values, unnormalised, e^(-jwt) convention.
/// Throws std::bad_alloc where memory lacks.
class RealFft
{
public:
    explicit RealFft(Index length);
    ~RealFft();
    RealFft(RealFft &&) noexcept;
    RealFft &operator=(RealFft &&) noexcept;

    Index length() const;
    /// At most length() values; missing ones count as 0.
    Eigen::VectorXcd forward(const Eigen::Ref<const Eigen::VectorXd> &time) const;
    /// Inverse including the factor 1/n: inverse(forward(x)) == x.
    Eigen::VectorXd inverse(const Eigen::Ref<const Eigen::VectorXcd> &spectrum) const;

    /// The same in buffers of the caller, which have the full sizes already: nothing is copied. The
    /// inverse lacks the factor 1/n and destroys `spectrum`.
    void forward(const Eigen::VectorXd &time, Eigen::VectorXcd &spectrum) const;
    void inverseUnscaled(Eigen::VectorXcd &spectrum, Eigen::VectorXd &time) const;

private:
    struct Plans;
    std::unique_ptr<Plans> m_plans;
};

/// Smallest product 2^a 3^b 5^c that is >= n: a length that FFTW transforms fast.
Index fastFftLength(Index n);

} // namespace dyncal
