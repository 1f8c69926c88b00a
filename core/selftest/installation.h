// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <vector>

namespace dyncal {

/// A library that the program computes or draws with, as it is loaded now.
struct UsedLibrary
{
    std::string name;
    std::string version;
};

/// What the numbers of this program depend on beside its own sources.
struct Installation
{
    std::string version; ///< of the program
    std::string build;
    std::string compiler;
    std::string processor; ///< as the system calls it
    std::string system; ///< distribution and kernel
    std::vector<UsedLibrary> libraries;
};

/// Of this process. `others`: libraries that core does not know of. What the system does not tell
/// is "unknown".
Installation thisInstallation(std::vector<UsedLibrary> others = {});

} // namespace dyncal
