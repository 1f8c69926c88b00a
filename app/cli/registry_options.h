// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace dyncal {

/// --registry FILE|postgresql://...
void declareRegistry(CLI::App &verb, std::string &registry);

/// --reason TEXT, which is needed, and --by NAME, else the name of the account.
void declareReason(CLI::App &verb, std::string &by, std::string &reason);

} // namespace dyncal
