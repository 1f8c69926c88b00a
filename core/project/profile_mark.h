// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>

namespace dyncal {

/// Which profile of the laboratory a recipe was joined with, and what that held, so that a
/// certificate can name its version and what differs from it (recipe section "profile").
struct ProfileMark
{
    std::string name;
    std::string version;
    std::string sha256; ///< of the profile's file
    std::string sections; ///< of the profile, as JSON in one line

    bool operator==(const ProfileMark &) const = default;
};

} // namespace dyncal
