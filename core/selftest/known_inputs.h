// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"

#include <Eigen/Core>

#include <optional>

namespace dyncal {

inline constexpr double kModelRate_Hz = 1e6;

/// One series at that rate, nothing filtered, its noise not known.
ModelInput inputOf(const Eigen::VectorXd &y, ResponseTreatment treatment);

/// By the usual settings; empty where it fails.
std::optional<HankelDecomposition> decomposed(const ModelInput &input);
std::optional<SensorModel> modelOf(const ModelInput &input); ///< of order 2

} // namespace dyncal
