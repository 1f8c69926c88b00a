// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/response_settings.h"
#include "core/uncertainty/reported_value.h"

#include <cmath>

namespace dyncal {

/// What a value of another calibration is compared with.
enum class KnownAgainst {
    Nothing,
    Sensitivity, ///< the level at the onset, below the band; with the model's rise to the frequency
    Row ///< S(f) without a model, at exactly its frequency
};

/// A value of another calibration beside this one's.
struct KnownValue
{
    KnownSensitivity stated;
    ReportedValue other; ///< that value in the unit of S(f); unknown where its unit is no such
    ReportedValue here; ///< this calibration's; unknown where it is not compared
    KnownAgainst against = KnownAgainst::Nothing;
    double e_n = kUnknown; ///< (here - other)/sqrt(U^2 + U^2), ISO 13528 9.7
    Message missing = {}; ///< why it is not compared

    bool isCompared() const { return against != KnownAgainst::Nothing; }
    double difference_relative() const { return here.value / other.value - 1.0; }
    /// Only what agrees within U belongs to one curve.
    bool isJoined() const { return std::abs(e_n) <= 1.0; }
};

} // namespace dyncal
