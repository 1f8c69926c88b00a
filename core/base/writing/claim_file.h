// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/file_descriptor.h"
#include "core/base/writing/claim_text.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// A claim file found in a folder.
struct FoundClaim
{
    ClaimText text;
    FileDescriptor file; ///< locked by us if the program that made it is gone
    bool isLive = false;
};

/// Name of the claim file of a temporary name.
std::string claimFileName(const std::string &temporary);

/// Makes a claim file, complete and locked. Invalid on failure, with errno (EEXIST: the name is
/// taken).
FileDescriptor createClaimFile(int folder, const ClaimText &text);

/// The claims in the folder: those that are held, and those that this user's programs left behind.
/// Anything else with such a name (a link, a pipe, other content) is ignored.
std::vector<FoundClaim> findClaims(int folder);

} // namespace dyncal
