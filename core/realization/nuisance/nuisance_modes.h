// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/realization/input/model_input.h"
#include "core/realization/input/nuisance_term.h"
#include "core/realization/input/realization_settings.h"
#include "core/signal/response_window.h"
#include "core/signal/spectrum_analysis.h"

#include <Eigen/Core>

#include <complex>
#include <optional>
#include <vector>

namespace dyncal {

// Modes that are not the sensor's (docs/method/nuisance-modes.md): oscillations of the gas in the
// tube, and whatever else the operator marks. Each shot has its own frequency, damping, size and
// phase of each mode.

/// Frequency at which each mode is expected in a shot (number from 1 of the capture set), empty
/// where the recipe gives none for it. `soundSpeeds_m_s` of region 5, per shot of the set where
/// known: a tube mode with one frequency moves with them.
std::vector<std::optional<double>> expectedFrequencies_Hz(const std::vector<NuisanceMode> &modes,
    Index shot, const std::vector<std::optional<double>> &soundSpeeds_m_s);

/// The spectra without resonances that are nuisance modes, so that model rate and length are not
/// chosen for one. `responses` are the shots of the spectra.
SpectrumResult withoutNuisancePeaks(const SpectrumResult &spectrum,
    const std::vector<WindowedResponse> &responses, const std::vector<NuisanceMode> &modes,
    const std::vector<std::optional<double>> &soundSpeeds_m_s);

/// Whether any mode was found in any series.
bool hasNuisance(const ModelInput &input);

/// The input with the correction applied: what the Hankel decomposition and the order see.
ModelInput sensorOnly(const ModelInput &input);

/// Poles (z plane, paired) without those that are a nuisance mode of the input.
std::vector<std::complex<double>> withoutNuisancePoles(
    const ModelInput &input, const std::vector<std::complex<double>> &poles);

/// Amplitudes of the sensor's response to the step alone, from those of its response to the step
/// and the tube's modes that the step excites: 1 + sum Re(a e^(s_m t)) from the onset on, a =
/// A/G(s_m). `amplitudes` and `terms` at the onset; terms that existed before the step change
/// nothing.
Eigen::VectorXcd amplitudesOfStep(const Eigen::VectorXcd &poles_rad_s,
    const Eigen::VectorXcd &amplitudes, double constant, const std::vector<NuisanceTerm> &terms);

/// The terms with time 0 moved to `onset_s`.
std::vector<NuisanceTerm> termsAt(const std::vector<NuisanceTerm> &terms, double onset_s);

} // namespace dyncal
