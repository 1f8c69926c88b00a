// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace dyncal {

/// What a history follows.
enum class FollowedKind { NaturalFrequency, DampingRatio, Sensitivity, Magnitude, Phase };

struct FollowedQuantity
{
    FollowedKind kind = FollowedKind::NaturalFrequency;
    double asked_Hz = kUnknown; ///< of magnitude and phase: the frequency that was asked for
    double row_Hz = kUnknown; ///< of the row that serves for it; NaN: there is none

    bool isOverFrequency() const;
    /// "f0_hz", "damping_ratio", "sensitivity", "magnitude", "phase_rad": as in results.json.
    const char *name() const;
};

/// A value as results state it.
struct FollowedValue
{
    double value = kUnknown; ///< NaN: not stated
    double u = kUnknown; ///< k = 1; NaN: not stated, or not complete
    double k = kUnknown; ///< that U is stated with, as on the certificate
    std::string unit;
    std::string missing; ///< why there is no value, else why there is no u; empty: both are there

    double U() const { return k * u; }
};

/// The value of a results.json (parseResults()). U is the certificate's, k = statedFactor(). An f0
/// and a damping ratio of results without `characteristics`, and a magnitude whose u does not hold
/// that of the step, have no complete u; the former are not stated then. A magnitude and a phase
/// are those of the row at `row_Hz` within kSameRow: nothing is interpolated.
FollowedValue followedValue(const nlohmann::json &results, const FollowedQuantity &quantity);

/// Rows at frequencies that differ by no more, relative, are the same.
inline constexpr double kSameRow = 1e-6;
/// A row this near, relative, serves for a frequency that was asked for: 1250 Hz is 1258.93 Hz.
inline constexpr double kServingRow = 0.03;

/// The frequency of the row with a magnitude that is nearest to `asked_Hz` in any of the results,
/// of equally near ones that of the last; NaN where none is within kServingRow.
double servingRow_Hz(const std::vector<const nlohmann::json *> &results, double asked_Hz);

} // namespace dyncal
