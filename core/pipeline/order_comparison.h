// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/pipeline/pipeline.h"

#include <memory>
#include <optional>
#include <vector>

namespace dyncal {

/// The results of one order, or why there are none.
struct ComparedOrder
{
    Index order = 0;
    std::shared_ptr<const SensorModel> model; ///< null with an error
    std::shared_ptr<const ModelAssessment> assessment; ///< of `model`
    std::shared_ptr<const ResponseResult> response; ///< null with an error and where it diverges
    /// p value of the hypothesis that the residuals are noise, over all series; NaN where it
    /// diverges.
    double whiteness_p = kUnknown;
    std::optional<double> bic; ///< for the orders that the suggestion tried
    std::string note; ///< the recipe's note on it
    std::optional<Error> error;
};

/// The recipe's note on an order; may be empty.
std::string noteOnOrder(const Recipe &recipe, Index order);

/// Models of several orders from one decomposition, by the functions of the pipeline, so that each
/// number is that of a run with `realization.order` of this order to the last bit. An order that
/// the data do not allow has an error in its place. Fails (Usage) without a decomposition and with
/// more than 50 orders, (Cancelled) on request.
Result<std::vector<ComparedOrder>> compareOrders(const CalibrationResults &results,
    const Recipe &recipe, const std::vector<Index> &orders, const JobControl &control = {});

/// Orders worth comparing, ascending: the suggested one, the next where that one splits a pair, a
/// high one (100 as in the thesis, or the largest possible), and those pinned.
std::vector<Index> defaultCandidates(const CalibrationResults &results, const Recipe &recipe);

} // namespace dyncal
