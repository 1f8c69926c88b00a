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

/// 60 for any HDF5 file: our own captures and MAT files are surer of themselves.
int recogniseForeignHdf5(const std::string &path, std::string_view head);

/// Reads an HDF5 file of another program as one shot. Its channels are those that
/// `settings.channels` names (DatasetEntry::channels in foreign_datasets.h); without any, all 1-D
/// datasets of the longest length that several share, or else the columns of the longest table.
/// Rates, units, scale and offset come from attributes where they cannot be mistaken, and from
/// datasets of times; a rate that is not stated stays 0. What was left out is a finding (CAP-026).
/// Fails: CAP-001 nothing to read, CAP-018 damaged, or a scale that is no number.
Result<CaptureSet> readForeignHdf5(
    const std::string &path, const ImportSettings &settings, const JobControl &control);

/// The same for a file that is described already; nothing it claims is believed.
Result<CaptureSet> readForeignHdf5(
    const Hdf5File &file, const ImportSettings &settings, const JobControl &control);

/// A dataset that can be channels, or cannot (then it has no names).
struct ChannelCandidate
{
    ForeignDataset dataset;
    ForeignChannels channels; ///< with the names that the shot's channels get
    std::vector<std::size_t> columns; ///< those that are wanted
};

/// One that offers all its channels, if it has any.
ChannelCandidate candidateOf(ForeignDataset dataset, ForeignChannels channels);

/// What readForeignHdf5 does once it knows the candidates; `all` may also state rates and times.
Result<CaptureSet> readCandidates(const Hdf5File &file, const std::vector<ForeignDataset> &all,
    const std::vector<ChannelCandidate> &candidates, const ImportSettings &settings,
    const JobControl &control);

} // namespace dyncal
