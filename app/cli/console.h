// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/progress.h"
#include "core/base/result.h"

namespace dyncal {

/// Exit codes of the program: a contract with scripts.
enum class ExitCode {
    Done = 0,
    DoneWithCautions = 1, ///< a success for scripts
    Blocked = 2,
    FileUnreadable = 3,
    Usage = 4,
    Internal = 5,
    Interrupted = 130, ///< as a shell reports SIGINT
};

ExitCode exitCodeOf(const Error &error);
/// By the gravest finding: Blocked, DoneWithCautions or Done.
ExitCode exitCodeOf(const Findings &findings);

/// Writes the error to stderr as one plain sentence and returns its exit code.
int report(const Error &error);

/// "SHK-005 (info, shot 3): ...": the shot is named unless the sentence begins with it.
std::string lineOf(const Finding &finding);

/// Writes cautions and blocks to stderr, one line each with its id.
void reportFindings(const Findings &findings);

/// Progress on stderr while it lives, if that is a terminal: "Computing 42 %".
class ProgressLine
{
public:
    explicit ProgressLine(const char *work);
    ~ProgressLine();
    ProgressLine(const ProgressLine &) = delete;
    ProgressLine &operator=(const ProgressLine &) = delete;

    ProgressSink sink();

private:
    const char *m_work;
    bool m_shown;
    int m_percent = -1;
};

} // namespace dyncal
