// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/uncertain_complex.h"
#include "core/model_analysis/step_transform.h"

#include <vector>

namespace dyncal {

/// stepTransforms() of the whole record at each frequency (not 0), with the covariance of Re and Im
/// that independent errors of the samples make of it: `variance` of each sample, as many as y, in
/// its unit squared, not below 0. `end` is the record's own (the last of transformEnds()): the
/// level that continues it is a mean of its last samples and varies with them. With q = e^(-jwT),
/// D = (1 - q) F + q^N level, F = sum y_n q^n, so that three sums over the record give all of it,
/// without approximation (docs/method/dft-covariance.md). stepTransformVariance() is for noise of
/// any density and states one variance for both.
std::vector<UncertainComplex> stepTransformsWithCovariance(
    const Eigen::Ref<const Eigen::VectorXd> &y, const Eigen::Ref<const Eigen::VectorXd> &variance,
    double rate_Hz, const TransformEnd &end, double onset_s,
    const Eigen::Ref<const Eigen::VectorXd> &frequency_Hz);

} // namespace dyncal
