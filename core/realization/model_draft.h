// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/coloured_covariance.h"
#include "core/realization/exponential_sum.h"
#include "core/realization/model_input.h"
#include "core/realization/pole_refinement.h"

#include <complex>
#include <optional>
#include <vector>

namespace dyncal {

/// Poles and, per series, the response they give, while the model is being built.
struct ModelDraft
{
    std::vector<std::complex<double>> rates_rad_s; ///< without the step pole
    std::vector<std::complex<double>> realised_rad_s; ///< the same before any refinement
    std::vector<ExponentialSum> series; ///< at time 0 = detected start
    std::vector<std::vector<NuisanceTerm>> nuisance; ///< per series, beside them
    std::optional<Refinement> refinement;
    NoiseBasis noise; ///< what the refinement's covariance rests on
};

inline bool isThesisMode(const ModelInput &input)
{
    return input.treatment == ResponseTreatment::StepAsImpulse;
}

/// Sampling interval of the model.
double sampleInterval_s(const ModelInput &input);

/// s = ln(z) / dt; finite for z = 0 too.
std::complex<double> rateOf(std::complex<double> z, double dt_s);

/// z = e^(s dt) of every rate; the s of a negative real z gives that real z back.
std::vector<std::complex<double>> discretePoles(
    const std::vector<std::complex<double>> &rates_rad_s, double dt_s);

/// What was fitted to a series' samples, brought back to time 0 and freed of the filter's gain.
ExponentialSum atStart(const ModelSeries &series,
    const std::vector<std::complex<double>> &rates_rad_s, const AmplitudeFit &fit);

/// Amplitudes by least squares at the model rate for the poles given (z plane, without the step's),
/// brought back to time 0 and freed of the filter's gain. Rates sorted by |s|.
ModelDraft linearDraft(const ModelInput &input, const std::vector<std::complex<double>> &poles);

/// What the refinement fits: the series at their own rate, weighted by their noise, with their
/// nuisance terms.
std::vector<RefinementRecord> refinementRecords(const ModelInput &input);

/// Refines poles and amplitudes on the records at their own rate from the start on, where no filter
/// stands between onset and data. Leaves the draft alone in thesis mode, beyond order 12, for poles
/// that do not decay, and where the refinement does not converge.
void refineDraft(const ModelInput &input, ModelDraft &draft, const JobControl &control);

/// Energy of the part of pole `i` over the input, 2 sum |c p^k|^2, over the variance of the noise.
double energyOverNoise(const ModelSeries &series, const ExponentialSum &sum, Index i, double dt_s);

/// Energy over noise beyond which a part stands out: ten times what one fitted pair takes up of
/// white noise.
inline constexpr double kStandsOut = 20.0;

/// Whether the part of each pole stands out of the noise of any series.
std::vector<bool> standingOut(const ModelInput &input, const ModelDraft &draft);

} // namespace dyncal
