// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <string>

namespace dyncal {

/// Where a registry is: a file, or a database of a PostgreSQL server.
struct RegistryAddress
{
    std::string file; ///< of SQLite; empty: a server
    std::string host, user, password, database;
    int port = -1; ///< -1: the usual one

    bool isServer() const { return file.empty(); }
    /// For sentences and lists: never with the password.
    std::string shown() const;
};

/// Takes FILE or "postgresql://USER[:PASSWORD]@HOST[:PORT]/DATABASE" apart; "" is the file of this
/// user, made when it is first written. Fails (Usage) on another scheme and a URL without host or
/// database.
Result<RegistryAddress> registryAddress(const std::string &text);

} // namespace dyncal
