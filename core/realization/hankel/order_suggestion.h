// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/base/progress.h"
#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/input/model_input.h"

#include <Eigen/Core>

namespace dyncal {

/// Suggested order with the sentence that says why.
struct OrderSuggestion
{
    Index order = 0;
    Message reason;
    Eigen::VectorXd bic; ///< of orders 1..bic.size(); empty where it could not be formed
};

/// BIC on the pre-whitened response (docs/method/order.md): an AR model of the pre-trigger noise
/// filters the response (poles survive a FIR filter), then BIC over orders 1..20. After a stop the
/// suggestion is meaningless.
OrderSuggestion suggestOrder(const ModelInput &input, const HankelDecomposition &decomposition,
    const JobControl &control = {});

} // namespace dyncal
