// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/realization/exponentials/exponential_sum.h"
#include "core/realization/input/model_input.h"
#include "core/realization/refinement/model_draft.h"
#include "core/realization/refinement/refinement.h"

#include <complex>
#include <vector>

namespace dyncal {

/// Poles that are refined at most: beyond, spurious ones make the fit ill-posed.
inline constexpr Index kLargestRefined = 12;

/// A fit of a series' samples, extrapolated to time 0, with the filter's gain divided out.
ExponentialSum atStart(const ModelSeries &series,
    const std::vector<std::complex<double>> &poles_rad_s, const AmplitudeFit &fit);

/// Amplitudes by least squares at the model rate for the poles given (z plane, without the step's),
/// extrapolated to time 0, the filter's gain divided out. Poles sorted by |s|.
ModelDraft linearDraft(const ModelInput &input, const std::vector<std::complex<double>> &poles);

/// What the refinement fits: the series at their own rate, weighted by their noise, with their
/// nuisance terms, without the sample that the start was found by.
std::vector<RefinementRecord> refinementRecords(const ModelInput &input);

/// The same, with the nuisance terms as the draft has them.
std::vector<RefinementRecord> refinementRecords(const ModelInput &input, const ModelDraft &draft);

/// The noise of every series before its start, at its own rate.
std::vector<NoiseCovariance> noiseBeforeStart(const ModelInput &input);

/// Refines poles and amplitudes on the records at their own rate from the start on, where no filter
/// distorts the onset. Where that cannot begin at the realised poles, or does not converge, a
/// response that does not ring has other starts (aperiodic_start.h), with poles fewer than the
/// order. Else leaves the draft unchanged: in thesis mode, beyond order 12, for poles that do not
/// decay, and where the refinement does not converge.
void refineDraft(const ModelInput &input, ModelDraft &draft, const JobControl &control);

} // namespace dyncal
