// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/base/uncertain_value.h"
#include "core/capture/capture_set.h"
#include "core/shock/shock_uncertainty.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

// Lines of a mean sensitivity that are no inputs of the step.
inline constexpr const char *kLevelRelative = "level_relative"; ///< noise of the level of a shot
inline constexpr const char *kScatterOfShots = "scatter_of_shots"; ///< in place of own parts

/// Sensitivity of one shot: the level of its step, at the onset, over the pressure step. Its u is
/// complete (step and level) or absent.
struct ShotSensitivity
{
    Index shot = 0;
    std::optional<double> sensitivity = std::nullopt; ///< empty = not determined (no pressure step)
    std::string unit = {}; ///< "V/Pa"
    ShotLevel level = ShotLevel::None;
    std::optional<double> step_Pa = std::nullopt;
    double uLevel_relative = kUnknown; ///< of the level alone
    std::optional<double> u = std::nullopt; ///< standard uncertainty, in `unit`
    double k = kUnknown; ///< for 95 %, Student's factor at `dof`
    double dof = kUnknown; ///< effective, Welch-Satterthwaite; infinite where nothing limits it
};

/// Mean over shots, with the factors that they share kept apart (docs/method/sensitivity.md).
struct SensitivityMean
{
    ShotLevel level = ShotLevel::None; ///< None: over all
    double value = kUnknown;
    std::optional<double> u;
    double k = kUnknown;
    double dof = kUnknown;
    std::vector<UncertaintyLine> lines = {}; ///< of `u`, relative to `value`; "level_relative" and
                                             ///< "scatter_of_shots" are no inputs of the step
};

/// The shot that differs most from the others, by its own u.
struct FarthestShot
{
    Index shot = 0;
    double value = kUnknown;
    double others = kUnknown; ///< generalised mean of the others
    double u = kUnknown; ///< of the difference, common factors removed
};

/// What the shots of a calibration say together.
struct SensitivitySummary
{
    std::optional<SensitivityMean> mean;
    std::vector<SensitivityMean> perLevel; ///< from low to high; only shots with a level
    std::optional<double> homogeneity_p; ///< chance of as much scatter; empty below two shots
    bool shotsAgree = true;
    std::optional<FarthestShot> farthest; ///< where homogeneity_p is known
    std::optional<double> linearity_per_Pa; ///< (dS/dstep) / S; empty where the steps are alike
    std::optional<double> uLinearity_per_Pa;
    Findings findings; ///< RSP-002
};

/// u, k and dof of one shot from u of its step and of its level; they stay empty where one of them
/// is unknown. `levelDof`: degrees of freedom of the noise's estimate.
void addUncertainty(const StepUncertainty *step, double levelDof, ShotSensitivity &shot);

/// Mean, homogeneity and trend. `steps`: the budget of each shot's step, null where unknown; the
/// contributions of its common inputs are the same error in every shot, so they cancel in the chi
/// square of the differences: V = diag(own^2 + 0.05 %^2) + C C^T, chi^2 = r^T V^-1 r about the
/// generalised least squares mean (n - 1 degrees of freedom). Where the chance is below 0.1 % the
/// shots' scatter takes the place of their own parts (Type A, n - 1; within the levels where these
/// hold several shots). A shot whose u is unknown is compared with 1 %, and the mean has then no u
/// and no trend. Nothing where a shot has no sensitivity.
SensitivitySummary summarise(
    const std::vector<ShotSensitivity> &shots, const std::vector<const StepUncertainty *> &steps);

} // namespace dyncal
