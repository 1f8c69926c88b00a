// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace dyncal {

/// What the chosen subcommand does once all arguments are read; returns the exit code.
using VerbAction = std::function<int()>;

/// Each declares its subcommand with options, help and example, and sets `action` when chosen.
void addSimulate(CLI::App &program, VerbAction &action);
void addInfo(CLI::App &program, VerbAction &action);
void addImport(CLI::App &program, VerbAction &action);
void addCheck(CLI::App &program, VerbAction &action);
void addRun(CLI::App &program, VerbAction &action);
void addBatch(CLI::App &program, VerbAction &action);
void addCompare(CLI::App &program, VerbAction &action);
void addExport(CLI::App &program, VerbAction &action);
void addCorrect(CLI::App &program, VerbAction &action);
void addRecheck(CLI::App &program, VerbAction &action);
void addDcc(CLI::App &program, VerbAction &action);
void addHistory(CLI::App &program, VerbAction &action);
void addIssue(CLI::App &program, VerbAction &action);
void addWithdraw(CLI::App &program, VerbAction &action);
void addVerify(CLI::App &program, VerbAction &action);
void addRegistry(CLI::App &program, VerbAction &action);
void addSelfTest(CLI::App &program, VerbAction &action);

} // namespace dyncal
