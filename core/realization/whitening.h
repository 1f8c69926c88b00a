// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>

namespace dyncal {

/// Coefficients a_1..a_p of e_k = x_k + a_1 x_(k-1) + ... + a_p x_(k-p) that make `noise` white
/// (Yule-Walker by Levinson's recursion, always stable). Empty if the record has fewer than
/// 10 (p + 1) values or does not vary.
Eigen::VectorXd autoregressiveModel(const Eigen::Ref<const Eigen::VectorXd> &noise, Index order);

/// x filtered by 1 + sum a_i z^-i; the first a.size() values, which would need samples before the
/// record, are left out. Poles of a sum of exponentials survive a FIR filter.
Eigen::VectorXd whitened(const Eigen::Ref<const Eigen::VectorXd> &x, const Eigen::VectorXd &a);

} // namespace dyncal
