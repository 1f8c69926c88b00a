// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>

namespace dyncal {

/// Whether the arguments are for the command line (a subcommand or an option) and not files for
/// the workbench.
bool isCommandLine(int argc, const char *const *argv);

/// Runs the subcommand and returns the exit code (ExitCode in console.h). Never throws.
int runCommandLine(int argc, char **argv);

/// Whether INT, TERM or HUP has asked a subcommand to end.
bool isStopRequested();

/// The subcommand that a word is close to, or empty.
std::string similarVerb(const std::string &word);

} // namespace dyncal
