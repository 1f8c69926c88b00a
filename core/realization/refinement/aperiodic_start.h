// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/realization/input/model_input.h"
#include "core/realization/refinement/model_draft.h"
#include "core/realization/refinement/refinement.h"

#include <complex>
#include <optional>
#include <vector>

namespace dyncal {

/// Whether all poles are in order of |s|, and the records can hold the fastest.
bool areWithin(const std::vector<RefinementRecord> &records,
    const std::vector<std::complex<double>> &poles_rad_s);

/// Second starts of the refinement for a sensor that does not ring, where that from the realised
/// poles has failed (docs/method/model.md). Realised poles of such a response may lie beyond any
/// neighbourhood of the truth: all that noise leaves of the faster one are a few samples. One
/// pole alone is fitted from the slowest settled one that stands out, then from there two real
/// poles and a well-damped pair, each with the unsettled poles that stand out. Taken is the one of
/// the smallest BIC, if it leaves no more than the noise. Empty where the response rings, or
/// nothing of this holds.
std::optional<Refinement> refineAperiodic(const ModelInput &input, const ModelDraft &draft,
    const std::vector<RefinementRecord> &records, const JobControl &control);

} // namespace dyncal
