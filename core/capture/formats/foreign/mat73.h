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

// MAT files of version 7.3 are HDF5 after a user block of 512 bytes that says so; every variable is
// a dataset with its MATLAB_class, and dimensions are stored in reverse.

/// 100 for a MAT file of version 7.3.
int recogniseMat73(const std::string &path, std::string_view head);
bool isMat73(const std::string &path);

/// Reads the numeric variables as one shot: a vector is a channel named as the variable, an N x k
/// matrix the channels "x(:,1)" to "x(:,k)". As in readForeignHdf5: the named ones, or else all
/// vectors of the longest length that several share. A vector time or t in seconds, or a number fs
/// or dt, gives the rate. Structures, cells, texts and other variables are left out (CAP-026).
Result<CaptureSet> readMat73(
    const std::string &path, const ImportSettings &settings, const JobControl &control);

/// The same for a file that is described already; its claims are checked.
Result<CaptureSet> readMat73(
    const Hdf5File &file, const ImportSettings &settings, const JobControl &control);

/// What a variable can be as channels; names without the slash, columns counted from 1.
ForeignChannels mat73ChannelsOf(const ForeignDataset &variable, const std::string &file);

} // namespace dyncal
