// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/sensor_response.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"
#include "ui/plot/values/plot_content.h"

#include <memory>
#include <optional>
#include <vector>

namespace dyncal {

inline constexpr std::size_t kMostOverlaid = 4;

/// The model of another order, laid over that of the chosen one in a style of its own.
struct OverlaidModel
{
    CurveRole role = CurveRole::Candidate1;
    std::shared_ptr<const SensorModel> model;
    std::shared_ptr<const ResponseResult> response; ///< may be null
};

/// Role of the k-th overlaid model, k < kMostOverlaid.
CurveRole candidateRole(std::size_t k);

/// Add the candidates to a plot of the chosen model. `series` is a position; without it the first
/// series is drawn. Simulations and errors of models that diverge are left out.
void overlaySimulations(PlotContent &content, const ModelInput &input,
    const std::vector<OverlaidModel> &candidates, std::optional<std::size_t> series = {});
void overlayErrors(PlotContent &content, const ModelInput &input,
    const std::vector<OverlaidModel> &candidates, std::optional<std::size_t> series = {});
void overlayMagnitudes(PlotContent &content, const std::vector<OverlaidModel> &candidates);
void overlayPhases(PlotContent &content, const std::vector<OverlaidModel> &candidates);
void overlayPoles(PlotContent &content, const std::vector<OverlaidModel> &candidates);

} // namespace dyncal
