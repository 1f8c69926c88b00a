// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/capture/formats/foreign/foreign_tree.h"
#include "core/capture/import_settings.h"

#include <string>
#include <string_view>

namespace dyncal {

/// 60 for any HDF5 file; the readers of our captures and of MAT files give more for theirs.
int recogniseForeignHdf5(const std::string &path, std::string_view head);

/// Reads an HDF5 file of another program as one shot. Its channels are those that
/// `settings.channels` names (DatasetEntry::channels in foreign_datasets.h); without any, all 1-D
/// datasets of the longest length that several share, or else the columns of the longest table.
/// Rates, units, scale and offset come from attributes where these are unambiguous; rates also from
/// datasets of times. A rate that is not stated stays 0. Whatever is left out is a finding
/// (CAP-026). Fails: CAP-001 nothing to read, CAP-018 damaged, or a scale that is no number.
Result<CaptureSet> readForeignHdf5(
    const std::string &path, const ImportSettings &settings, const JobControl &control);

/// The same for a file that is described already; its claims are checked.
Result<CaptureSet> readForeignHdf5(
    const Hdf5File &file, const ImportSettings &settings, const JobControl &control);

/// A dataset and the channels it can become (without names if it cannot).
struct ChannelCandidate
{
    ForeignDataset dataset;
    ForeignChannels channels; ///< with the names that the shot's channels get
    std::vector<std::size_t> columns; ///< those that are wanted
};

/// A candidate with all its channels wanted.
ChannelCandidate candidateOf(ForeignDataset dataset, ForeignChannels channels);

/// What readForeignHdf5 does once it knows the candidates; `all` may also state rates and times.
Result<CaptureSet> readCandidates(const Hdf5File &file, const std::vector<ForeignDataset> &all,
    const std::vector<ChannelCandidate> &candidates, const ImportSettings &settings,
    const JobControl &control);

} // namespace dyncal
