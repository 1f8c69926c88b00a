// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/base/result.h"
#include "core/reference/comparison_settings.h"

#include <limits>
#include <optional>
#include <vector>

namespace dyncal {

/// S of a reference transducer at one frequency, as its certificate has it. Units of the
/// certificate; u at k = 1.
struct ReferencePoint
{
    double frequency_Hz = 0.0;
    double magnitude = 0.0;
    double u_magnitude = 0.0;
    double phase_rad = kUnknown; ///< lag negative; NaN where only the magnitude was calibrated
    double u_phase_rad = kUnknown;
    double dof = std::numeric_limits<double>::infinity();
};

/// S of a reference transducer over frequency.
class ReferenceSensitivity
{
public:
    /// At least one row, frequencies above 0 and rising, magnitudes above 0, u not negative, the
    /// phase in all rows or in none, unwrapped. Fails (Usage) with the row at fault, counted
    /// from 1.
    static Result<ReferenceSensitivity> fromTable(std::vector<ReferencePoint> rows);

    /// |S| = sensitivity / |1 - r^2 + 2 j zeta r|, r = f/f0; u by first order. Fails (Usage) unless
    /// sensitivity, f0 and zeta are above 0 and no u is negative.
    static Result<ReferenceSensitivity> fromModel(const ReferenceModel &model);

    /// Between the rows of a table straight lines over log f, of the u too, which has besides what
    /// a straight line may miss: h^2 s (1 - s) |y''| as half the width of a rectangle, with
    /// y'' the larger of the second differences at both rows (it may be larger between them), h the
    /// distance of the rows in log f and s the place between them; of a table of two rows half
    /// their difference in the middle. Empty outside a table: nobody calibrated the transducer
    /// there.
    std::optional<ReferencePoint> at(double frequency_Hz) const;

    /// The lowest frequency at which an uncertainty of a table is not known: 0, or below 1e-12 of
    /// the value or of a radian, where only rounding errors are left. Of a model 0 where one of its
    /// three is not. Empty where all are known.
    std::optional<double> withoutU_Hz() const;

    /// What the level of a step is divided by: the model's level, or the lowest row of a table.
    ReferencePoint lowest() const;

    /// By how much |S| may be another at 0 than in the lowest row of a table, as its rows show it:
    /// |S| is even in the frequency, so |S_2 - S_1| f_1^2/(f_2^2 - f_1^2), f_2 the first row at or
    /// above 2 f_1, else the last. 0 of a model, not a number of a single row.
    double changeBelow() const;

    /// The widest distance between two rows of a table of which a part lies from `from_Hz` to
    /// `to_Hz`; empty of a model or without one.
    struct Gap
    {
        double from_Hz = 0.0;
        double to_Hz = 0.0;
    };
    std::optional<Gap> widestGap(double from_Hz, double to_Hz) const;

    double lowest_Hz() const; ///< 0 of a model
    double highest_Hz() const; ///< infinite of a model

private:
    double missedBetween(std::size_t above, double share, double ReferencePoint::*value) const;

    std::vector<ReferencePoint> m_rows;
    std::optional<ReferenceModel> m_model;
};

} // namespace dyncal
