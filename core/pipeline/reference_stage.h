// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/project/recipe.h"
#include "core/reference/chain_response.h"
#include "core/reference/reference_records.h"
#include "core/shock/shock_conditions.h"
#include "core/signal/response_window.h"

#include <optional>

namespace dyncal {

/// What the response is related to besides the computed step.
struct ReferenceStageResult
{
    std::optional<ReferenceRecords> records; ///< empty unless the comparison is enabled
    std::optional<ChainResponse> chain; ///< divided out of S(f); empty where none is stated
    ShockConditionsSet steps; ///< as the reference saw them; empty without one

    const ReferenceRecords *transducer() const { return records ? &*records : nullptr; }
    const ReferenceSensitivity *chainRelative() const { return chain ? &chain->relative : nullptr; }
};

/// The chain's response; records and sensitivity of the reference transducer. Fails as
/// chainResponse() and referenceRecords(), and (Usage)
/// where the response is asked for against a transducer without a comparison, or is no step.
Result<ReferenceStageResult> referenceStage(const CaptureSet &set, const WindowResult &window,
    const ShockConditionsSet &shock, const Recipe &recipe);

/// The pressure steps that the recipe's response is related to.
const ShockConditionsSet &stepsUsed(const ReferenceStageResult &reference,
    const ShockConditionsSet &shock, const ResponseSettings &settings);

} // namespace dyncal
