// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/batch/batch_plan.h"

#include <string>

namespace dyncal {

/// What is asked of a plan.
struct BatchRequest
{
    std::string root;
    std::string recipe; ///< path; empty: the defaults
    std::string profile; ///< path; empty: none
    bool eachFile = false;
    std::string plan; ///< path of the plan; outputs go into a folder beside it, NAME.out
};

/// The sensors below the root in natural order (findSensors), each with the hashes of its files and
/// of its recipe over the profile: its own recipe where there is one, else the common one. What
/// cannot be planned stays in the plan with its reason. Two runs on the same files give the same
/// plan. Fails as findSensors and readRecipeFiles (of the common recipe); (Usage) if the plan would
/// lie below the root, or nothing that may be a sensor is found; (Cancelled) where that is asked
/// for.
Result<BatchPlan> planBatch(const BatchRequest &request, const JobControl &control = {});

/// Fails (Usage) if a sensor was planned for other versions of the methods than this program has.
Result<void> checkMethods(const BatchPlan &plan);

/// The plan as the text of its file.
std::string planText(const BatchPlan &plan);

} // namespace dyncal
