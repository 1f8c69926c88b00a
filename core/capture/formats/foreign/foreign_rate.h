// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/formats/foreign/foreign_tree.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// A rate as a file states it: "sample_rate" = 1e6, "dt_us" = 0.01, "fs" = "100 MHz".
struct StatedRate
{
    double rate_Hz = 0.0;
    std::string text; ///< for messages: "dt_us = 0.01"
};

/// Reads name, value and (possibly empty) unit as a rate. Empty if the name is no word for a rate,
/// if the unit is none of frequency or time, or if without a unit the rate would be below
/// kCredibleRate_Hz (the unit is then in doubt).
std::optional<StatedRate> statedRate(
    const std::string &name, double value, const std::string &unit);

/// How the samples of a channel lie in time; rate 0 = unknown.
struct SampleTiming
{
    double rate_Hz = 0.0;
    double t0_s = 0.0;
};

/// Looks for sample rates beside datasets: in attributes and single values of the dataset and of
/// the groups around it, the nearest first, and in a dataset of times of the same length.
class TimingFinder
{
public:
    /// Reads the datasets that may state rates or times.
    static Result<TimingFinder> make(const Hdf5File &file,
        const std::vector<ForeignDataset> &datasets, const JobControl &control);

    /// Timing of a dataset of so many samples. Where statements differ by more than 0.1 % the rate
    /// is unknown (CAP-003), also for times that are not uniform (CAP-016).
    SampleTiming timingOf(const ForeignDataset &dataset, Index samples, Findings &findings) const;

    /// Whether the dataset was taken as times.
    bool isTimes(const ForeignDataset &dataset) const;

private:
    struct Axis
    {
        const ForeignDataset *dataset = nullptr;
        Index samples = 0;
        bool uniform = false;
        double rate_Hz = 0.0;
        double first_s = 0.0;
    };

    explicit TimingFinder(std::string path)
        : m_path(std::move(path))
    {
    }
    Result<void> read(const Hdf5File &file, const std::vector<ForeignDataset> &datasets,
        const JobControl &control);
    std::optional<StatedRate> statedFor(const ForeignDataset &dataset, Findings &findings) const;
    const Axis *axisFor(const ForeignDataset &dataset, Index samples) const;

    std::string m_path;
    std::map<const Hdf5Object *, std::vector<StatedRate>> m_scalars; ///< by the group they are in
    std::vector<Axis> m_axes;
};

} // namespace dyncal
