// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <vector>

namespace dyncal {

/// Opens the workbench with `files` (a project, or captures; none = empty) and runs it until it is
/// closed. Returns the exit code of the program.
/// With the arguments `--screenshot-tour DIR` it shows every page of the example, writes them as
/// PNG into DIR and ends.
int runGui(int argc, char **argv, const std::vector<std::string> &files);

} // namespace dyncal
