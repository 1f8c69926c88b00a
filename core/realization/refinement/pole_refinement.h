// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/realization/refinement/refinement.h"

#include <complex>
#include <optional>
#include <vector>

namespace dyncal {

/// How far a real pole may go from its start.
enum class RealPoles { NearStart, Anywhere };

/// Nonlinear least squares (Levenberg-Marquardt) on all records at their own rate, started from
/// the realised poles (docs/method/model.md). Minimises sum w^2 |y - model|^2; the covariance is
/// (J^T J)^-1 times the larger of 1 and the reduced chi square. Empty when it does not converge to
/// decaying poles within a factor of 1.5 in frequency of the start, or when the records cannot
/// separate the poles; the realised poles are then kept. A real pole that has not died out by the
/// end of the record may change its rate at will as long as that is so (RefinementProblem). Each
/// record has its own nuisance terms, poles included; they too must stay within that factor.
/// Without any pole only they are fitted; with neither there is no result. Assumes white noise
/// within each record.
std::optional<Refinement> refinePoles(const std::vector<RefinementRecord> &records,
    const std::vector<std::complex<double>> &startPoles_rad_s, bool withConstant,
    const JobControl &control = {}, RealPoles realPoles = RealPoles::NearStart);

} // namespace dyncal
