// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/history/history_files.h"

#include <string>
#include <vector>

namespace dyncal {

/// What can be read, and what cannot, with the reason.
struct ReadCalibrations
{
    std::vector<EarlierCalibration> all;
    std::vector<UnreadResults> unread;
};

/// Each results.json, with the number of the certificate whose manifest.json lies beside it; what
/// cannot be read is told on the error output. Fails (Cancelled) on request.
Result<ReadCalibrations> readCalibrations(const std::vector<std::string> &files);

/// Which certificates are withdrawn or replaced, as the registry says (registryAddress(); "" is
/// that of this user, and where there is none yet, it knows of none). A number that another
/// registry has given (another job) is not looked up. Fails as the registry does.
Result<void> lookUpStates(const std::string &registry, std::vector<EarlierCalibration> &all);

} // namespace dyncal
