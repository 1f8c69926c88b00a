// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/console.h"

#include "app/cli/spoken.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

#include <unistd.h>

namespace dyncal {

namespace {

/// Replaces the current line of the terminal. It does not use std::cerr, which lets no control
/// characters pass (TerminalText).
void onLine(const std::string &text)
{
    std::fprintf(stderr, "\r%s\033[K", text.c_str());
    std::fflush(stderr);
}

} // namespace

ExitCode exitCodeOf(const Error &error)
{
    switch (error.kind) {
    case ErrorKind::FileUnreadable:
        return ExitCode::FileUnreadable;
    case ErrorKind::Usage:
        return ExitCode::Usage;
    case ErrorKind::DataBlocked:
        return ExitCode::Blocked;
    case ErrorKind::Cancelled:
        return ExitCode::Interrupted;
    case ErrorKind::Internal:
        return ExitCode::Internal;
    }
    return ExitCode::Internal;
}

ExitCode exitCodeOf(const Findings &findings)
{
    switch (worstSeverity(findings)) {
    case Severity::Block:
        return ExitCode::Blocked;
    case Severity::Caution:
        return ExitCode::DoneWithCautions;
    case Severity::Info:
        return ExitCode::Done;
    }
    return ExitCode::Done;
}

int report(const Error &error)
{
    if (error.kind == ErrorKind::Cancelled)
        std::cerr << "Stopped on request.\n";
    else if (error.findingId.empty())
        std::cerr << spoken(error.message) << '\n';
    else
        std::cerr << error.findingId << ": " << spoken(error.message) << '\n';
    return static_cast<int>(exitCodeOf(error));
}

std::string lineOf(const Finding &finding)
{
    const std::string message = spoken(finding.message);
    const bool namesShot = finding.shot == 0 || message.starts_with("Shot ");
    return finding.id + " (" + severityName(finding.severity)
        + (namesShot ? "" : ", shot " + std::to_string(finding.shot)) + "): " + message;
}

void reportFindings(const Findings &findings)
{
    for (const Finding &finding : findings) {
        if (finding.severity != Severity::Info)
            std::cerr << lineOf(finding) << '\n';
    }
}

ProgressLine::ProgressLine(const char *work)
    : m_work(work)
    , m_shown(::isatty(STDERR_FILENO) == 1)
{
}

ProgressLine::~ProgressLine()
{
    if (m_percent >= 0)
        onLine({});
}

ProgressSink ProgressLine::sink()
{
    if (!m_shown)
        return {};
    return [this](double fraction) {
        const int percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
        if (percent == m_percent)
            return;
        m_percent = percent;
        onLine(std::string(m_work) + ' ' + std::to_string(percent) + " %");
    };
}

} // namespace dyncal
