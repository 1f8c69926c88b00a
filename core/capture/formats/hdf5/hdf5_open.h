// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/file_samples.h"
#include "core/capture/formats/bytes/expansion_budget.h"
#include "core/capture/formats/hdf5/hdf5_tree.h"

#include <memory>
#include <string>
#include <string_view>

namespace dyncal {

/// An HDF5 file as a helper process described it. libhdf5 crashes, hangs or takes all memory on
/// some damaged files, so the program itself opens only its own new files with it.
struct Hdf5File
{
    std::string path;
    std::shared_ptr<const SampleFile> file;
    Hdf5Tree tree;
    std::shared_ptr<ExpansionBudget> budget; ///< of all that is read of the file

    const Hdf5Object &root() const { return tree.objects.front(); }
};

/// Describes the file; no samples are read. `maxExpansion` as import.max_expansion. Fails with
/// CAP-018.
Result<Hdf5File> openHdf5(const std::string &path, double maxExpansion, const JobControl &control);

/// Attributes of the root alone; empty if they cannot be read.
Hdf5Attributes hdf5RootAttributes(const std::string &path);

/// Whether the file begins as HDF5; the signature may come after a user block (MATLAB 7.3).
bool hasHdf5Signature(std::string_view head);

} // namespace dyncal
