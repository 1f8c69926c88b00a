// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/capture/formats/bytes/time_axis.h"
#include "core/capture/raw_samples.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

struct MatRate
{
    double sampleRate_Hz = 0.0; ///< 0 = unknown
    double first_s = 0.0;
};

/// What the variables of a MAT file state about time, and the rates that follow. MAT files have no
/// units, so doubtful statements give no rate: see mat.h.
class MatTime
{
public:
    /// `stated_Hz`: what the operator says.
    MatTime(std::string path, std::optional<double> stated_Hz);

    /// A scalar: a rate, an interval, a start, or nothing of interest.
    void addScalar(const std::string &name, double value);

    bool isTimeName(const std::string &name) const;
    void addVector(const std::string &name, const RawSamples &times);

    /// The first or last of these columns if it is a uniform increasing axis (and no counter).
    std::optional<Index> columnOf(const std::vector<RawSamples> &columns) const;

    /// Rate of the signals in the matrix `name` by such a column.
    MatRate rateByColumn(
        const std::string &name, Index column, const RawSamples &times, Findings &findings) const;

    /// Rate of signals of this length: by a time vector of the same length, or by a scalar.
    MatRate rateOfLength(Index length, Findings &findings) const;

private:
    struct Axis
    {
        std::string name;
        Index length = 0;
        std::optional<TimeAxis> uniform; ///< in the axis's own unit; empty = not uniform
        double unit_s = 0.0; ///< 0 = nowhere said
        bool byConvention = false; ///< a name that means seconds without saying so
    };

    static std::optional<TimeAxis> uniformAxis(const RawSamples &times);
    MatRate rateByAxis(const Axis &axis, Findings &findings) const;
    std::optional<double> stated() const;
    MatRate statedRate() const;
    Finding contradiction(const std::string &name, double step) const;

    std::string m_path;
    std::optional<Finding> contradictingScalars(bool withIntervals) const;
    std::optional<Finding> contradictingAxes(const Axis &axis) const;

    struct Scalar
    {
        std::string name;
        double value = 0.0;
        double rate_Hz = 0.0;
        bool isInterval = false;
    };

    std::optional<double> m_operator_Hz, m_rate_Hz, m_interval_s;
    std::vector<Scalar> m_scalars; ///< every statement of a rate, in order
    double m_start_s = 0.0;
    std::vector<Axis> m_axes;
};

} // namespace dyncal
