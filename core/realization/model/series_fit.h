// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/hankel/state_space_model.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"
#include "core/realization/refinement/model_draft.h"

#include <optional>
#include <vector>

namespace dyncal {

/// Describes series `r` of the input by the draft: plateau, onset with its uncertainty, amplitudes
/// at the onset, simulation and FIT. `isSensor`: poles that take part in the search for the onset;
/// `stateSpace`: for the simulation in thesis mode.
SeriesFit describeSeries(const ModelInput &input, const ModelDraft &draft, std::size_t r,
    const std::vector<bool> &isSensor, const StateSpaceModel &stateSpace);

/// Where `sum` begins in place of the draft's own; empty as findOnset_s().
std::optional<double> onsetOf(const ModelInput &input, const ModelDraft &draft, std::size_t r,
    const std::vector<bool> &isSensor, const ExponentialSum &sum);

/// Amplitudes of `sum` at the onset, as the step alone would give them (SeriesFit::amplitudes).
Eigen::VectorXcd amplitudesAt(const ModelInput &input, const ModelDraft &draft, std::size_t r,
    const ExponentialSum &sum, double onset_s);

} // namespace dyncal
