// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/command_line.h"

#include "app/base/interrupt.h"
#include "app/base/open_files.h"
#include "app/cli/console.h"
#include "app/cli/verbs.h"

#include "core/base/message.h"
#include "core/base/version.h"
#include "core/project/nearest_word.h"

#include <algorithm>
#include <array>
#include <exception>
#include <iostream>
#include <new>
#include <string_view>
#include <system_error>
#include <vector>

namespace dyncal {
namespace {

constexpr std::array<std::string_view, 17> kVerbs{"simulate", "info", "import", "check", "run",
    "batch", "compare", "export", "correct", "recheck", "history", "dcc", "issue", "withdraw",
    "verify", "registry", "selftest"};
/// Files open at once while a recording is read and results are written.
constexpr int kFilesOfAVerb = 12;
/// A word that differs by more letters than this is not taken for a misspelt subcommand.
constexpr Index kMostMisspelt = 2;

Error usageError(const std::string &sentence)
{
    return {ErrorKind::Usage,
        {DYNCAL_TEXT("core", "Wrong usage: %1; see dyncal --help."), {sentence}}, {}, 0};
}

/// The complaint of the parser, to be part of a sentence.
std::string withoutFullStop(std::string text)
{
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (!text.empty() && (text.back() == '.' || text.back() == ' '))
        text.pop_back();
    return text;
}

int parseAndAct(int argc, char **argv)
{
    CLI::App program(
        "Dynamic calibration of pressure sensors. Without a subcommand the workbench opens, with the files given.",
        "dyncal");
    program.set_version_flag(
        "--version", std::string("dyncal ") + versionText() + " (build " + buildText() + ")");
    program.require_subcommand(0, 1); // asked for below, so that a wrong option is named first
    program.footer(
        "Example:\n  dyncal simulate -o example.h5\n  dyncal run example.h5 -o out\n\n"
        "Exit codes: 0 done, 1 done with cautions, 2 blocked by data quality, 3 a file cannot be read,\n4 wrong usage, 5 internal error, 130 stopped on request.");
    VerbAction action;
    addSimulate(program, action);
    addInfo(program, action);
    addImport(program, action);
    addCheck(program, action);
    addRun(program, action);
    addBatch(program, action);
    addCompare(program, action);
    addExport(program, action);
    addCorrect(program, action);
    addRecheck(program, action);
    addHistory(program, action);
    addDcc(program, action);
    addIssue(program, action);
    addWithdraw(program, action);
    addVerify(program, action);
    addRegistry(program, action);
    addSelfTest(program, action);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError &e) {
        if (e.get_exit_code() == 0) // --help and --version
            return program.exit(e);
        return report(usageError(withoutFullStop(e.what())));
    }
    if (!action)
        return report(usageError("a subcommand is missing"));
    if (!areFilesLeft(kFilesOfAVerb))
        return report(tooFewFiles());
    return action();
}

Error internalError(const char *what)
{
    return {ErrorKind::Internal,
        {DYNCAL_TEXT("core", "Internal error (%1); please report it with the files that show it."),
            {what}},
        {}, 0};
}

Error notEnoughMemory()
{
    return {ErrorKind::Internal,
        {DYNCAL_TEXT("core",
             "There is not enough memory for this; close other programs or raise the memory limit."),
            {}},
        {}, 0};
}

Error unsaid()
{
    return {ErrorKind::Internal,
        {DYNCAL_TEXT("core", "The answer could not be written to the standard output."), {}}, {},
        0};
}

/// Memory kept back for the sentence that says that none is left.
constexpr std::size_t kLastWords = 1 << 16;

} // namespace

bool isCommandLine(int argc, const char *const *argv)
{
    if (argc < 2)
        return false;
    const std::string_view first = argv[1];
    return first.starts_with('-') || std::find(kVerbs.begin(), kVerbs.end(), first) != kVerbs.end();
}

int runCommandLine(int argc, char **argv)
{
    int code = 0;
    std::vector<char> lastWords(kLastWords);
    const auto reportMemory = [&] {
        lastWords = {};
        return report(notEnoughMemory());
    };
    try {
        interruptToken(); // before any thread
        code = parseAndAct(argc, argv);
    } catch (const std::bad_alloc &) {
        code = reportMemory();
    } catch (const std::system_error &e) { // a thread that the system could not give
        const bool noThread = e.code() == std::errc::resource_unavailable_try_again;
        code = noThread ? reportMemory() : report(internalError(e.what()));
    } catch (const std::exception &e) {
        code = report(internalError(e.what()));
    }
    if (!std::cout.flush())
        code = isStopRequested() ? report({ErrorKind::Cancelled, {}, {}, 0}) : report(unsaid());
    return code;
}

bool isStopRequested()
{
    return interruptToken().stop_requested();
}

std::string similarVerb(const std::string &word)
{
    for (const std::string_view verb : kVerbs) {
        if (editDistance(word, verb) <= kMostMisspelt)
            return std::string(verb);
    }
    return {};
}

} // namespace dyncal
