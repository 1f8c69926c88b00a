// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/realization/exponentials/exponential_sum.h"

#include <Eigen/Core>

#include <complex>

namespace dyncal {

/// Response at one frequency from a sampled step response, without any model
/// (docs/method/response.md): S(f) = D(f) [jwTs / (1 - e^(-jwTs))] e^(jw onset), D(f) = sum (y_n -
/// y_(n-1)) e^(-jwnTs). `y` starts at time 0 (y before it is 0) and is continued by `endLevel`
/// after its last sample; the bracket turns the sampled unit step into the true one. Exact up to
/// aliasing and truncation.
std::complex<double> stepTransform(const Eigen::Ref<const Eigen::VectorXd> &y, double rate_Hz,
    double endLevel, double onset_s, double frequency_Hz);

/// Error of stepTransform() for a known step response (`sum` from the onset on, 0 before; `onset_s`
/// in the record), sampled `samples` times and continued by its constant: its result less the true
/// response G(f) = c0 + sum c_i jw/(jw - s_i). It contains aliasing and truncation; in closed form
/// (docs/method/response.md).
std::complex<double> stepTransformError(
    const ExponentialSum &sum, Index samples, double rate_Hz, double onset_s, double frequency_Hz);

/// Standard deviation of Re S and of Im S from white noise of standard deviation `noiseSd` in y.
double stepTransformNoise(Index samples, double rate_Hz, double noiseSd, double frequency_Hz);

} // namespace dyncal
