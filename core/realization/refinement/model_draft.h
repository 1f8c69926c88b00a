// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/exponentials/exponential_sum.h"
#include "core/realization/input/model_input.h"
#include "core/realization/input/nuisance_term.h"
#include "core/realization/refinement/noise_basis.h"
#include "core/realization/refinement/refinement.h"

#include <complex>
#include <optional>
#include <vector>

namespace dyncal {

/// Where the step of a record arrives, relative to the detected start.
struct FittedOnset
{
    double time_s = 0.0;
    double u_s = 0.0;
};

/// Poles and, per series, the response they give, while the model is being built.
struct ModelDraft
{
    std::vector<std::complex<double>> poles_rad_s; ///< without the step pole
    std::vector<std::complex<double>> realizedPoles_rad_s; ///< the same before any refinement
    std::vector<ExponentialSum> series; ///< at time 0 = detected start
    std::vector<std::vector<NuisanceTerm>> nuisance; ///< per series, beside them
    std::optional<Refinement> refinement;
    NoiseBasis noise; ///< what the refinement's covariance rests on
    std::vector<FittedOnset>
        onsets; ///< per series where the fit has them as parameters, else empty
    std::vector<double> onsetsOfSecondPole_s; ///< per series, as a second real pole has them that
                                              ///< noise may hide; empty where there is none
};

/// Energy of the part of pole `i` over the input, 2 sum |c p^k|^2, over the variance of the noise.
double energyOverNoise(const ModelSeries &series, const ExponentialSum &sum, Index i, double dt_s);

/// Energy over noise beyond which a part stands out: ten times what a fitted pair takes from white
/// noise.
inline constexpr double kStandsOut = 20.0;

/// Whether the part of each pole stands out of the noise of any series.
std::vector<bool> standingOut(const ModelInput &input, const ModelDraft &draft);

} // namespace dyncal
