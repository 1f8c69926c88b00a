// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/capture/capture_set.h"

#include <string>
#include <vector>

namespace dyncal {

/// A file that is no longer as it was when it was opened.
struct ChangedSource
{
    bool isMissing = false; ///< not where it was; else it was changed or replaced
    Finding finding; ///< CAP-015, which blocks; with the shot if the file holds only one

    bool operator==(const ChangedSource &) const = default;
};

/// The inputs whose files have another size or other times than when they were opened. Looks at no
/// content, so it may be asked every second; inputs without a stamp (the built-in example) are left
/// out.
std::vector<ChangedSource> changedSources(const CaptureSet &set);

/// Fails with CAP-015 for the first of changedSources(): nothing may leave the program then.
Result<void> checkSources(const CaptureSet &set);

/// The set with the paths of files that are not where they were changed to those of the same name
/// in `folder`, where there are such. Each has to be the recording that it was: its hash, if it is
/// known, becomes the expected one. An empty `folder` changes nothing.
CaptureSet relocated(CaptureSet set, const std::string &folder);

} // namespace dyncal
