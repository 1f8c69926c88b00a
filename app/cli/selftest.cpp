// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/clock.h"
#include "app/base/interrupt.h"
#include "app/cli/columns_text.h"
#include "app/cli/console.h"
#include "app/cli/drawing_process.h"
#include "app/cli/spoken.h"
#include "app/cli/verbs.h"

#include "core/base/foreign_text.h"
#include "core/base/number_text.h"
#include "core/base/writing/folder_write.h"
#include "core/selftest/selftest_files.h"

#include <QtGlobal>

#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>

namespace dyncal {
namespace {

struct SelfTestOptions
{
    std::optional<std::string> output; ///< folder
    Index calibrations = SelfTestSettings{}.calibrations;
    bool json = false;
};

Result<SelfTestReport> testInstallation(const SelfTestOptions &options)
{
    ProgressLine progress("Testing");
    return runSelfTest(
        {options.calibrations, {{"Qt", qVersion()}}}, {interruptToken(), progress.sink()});
}

constexpr std::size_t kWidthOfNames = 66;

void printRow(const std::string &step, const std::string &name, const std::string &expected,
    const std::string &found, const std::string &tolerance, const std::string &change,
    const std::string &verdict)
{
    std::cout << std::left << std::setw(21) << step << filledTo(kWidthOfNames, name) << std::right
              << std::setw(15) << expected << std::setw(18) << found << std::setw(10) << tolerance
              << std::setw(9) << change << "  " << verdict << '\n';
}

void printTable(const SelfTestReport &report)
{
    printRow("Step", "What", "Expected", "Found", "Tolerance", "1e-12", "Verdict");
    for (const SelfCheck &check : report.checks)
        printRow(check.step, spoken(check.name), numberText(check.expected, 10),
            numberText(check.found, 10), numberText(check.tolerance, 2),
            numberText(check.sensitivity, 2), check.holds() ? "holds" : "DEVIATES");
    std::cout << "1e-12: "
              << spoken({DYNCAL_TEXT("core",
                             "how far the result moves when all data change by a part in 10^12."),
                     {}})
              << '\n'
              << presentable(spoken(report.verdict())) << '\n';
}

/// Both files as one transaction.
Result<void> writeReport(
    const SelfTestReport &report, const std::string &createdUtc, FolderWrite &folder)
{
    const auto drawn = drawWithoutWindow(selfTestDocument(report, createdUtc, "en"), kSelfTestPdf);
    if (!drawn)
        return tl::unexpected<Error>(drawn.error());
    const std::string json = selfTestJson(report, createdUtc);
    return folder.commit(
        {{kSelfTestJson, json}, {kSelfTestPdf, drawn->front().bytes}}, {interruptToken(), {}});
}

int concludeSelfTest(const SelfTestReport &report)
{
    return static_cast<int>(report.deviations() == 0 ? ExitCode::Done : ExitCode::Blocked);
}

int selfTest(const SelfTestOptions &options)
{
    const Result<std::string> createdUtc = currentUtc();
    if (!createdUtc)
        return report(createdUtc.error());
    std::optional<FolderWrite> folder;
    if (options.output) {
        Result<FolderWrite> begun = FolderWrite::begin(selfTestFolder(*options.output));
        if (!begun)
            return report(begun.error());
        folder.emplace(std::move(*begun));
    }
    const Result<SelfTestReport> tested = testInstallation(options);
    if (!tested)
        return report(tested.error());
    if (folder)
        if (const Result<void> written = writeReport(*tested, *createdUtc, *folder); !written)
            return report(written.error());
    if (options.json)
        std::cout << selfTestJson(*tested, *createdUtc);
    else
        printTable(*tested);
    return concludeSelfTest(*tested);
}

} // namespace

void addSelfTest(CLI::App &program, VerbAction &action)
{
    const auto options = std::make_shared<SelfTestOptions>();
    CLI::App *verb = program.add_subcommand("selftest",
        "What this installation computes against what is known (ISO/IEC 17025, 7.11.2)");
    verb->add_option(
            "-o,--output", options->output, "Folder for the report, selftest.pdf and selftest.json")
        ->type_name("DIR");
    verb->add_option("--calibrations", options->calibrations,
            "Of the coverage study (40); 0 leaves it out, else at least 6")
        ->type_name("N");
    verb->add_flag("--json", options->json, "As JSON");
    verb->footer("Exit code 2 where something deviates.\n"
                 "Example:\n  dyncal selftest\n  dyncal selftest -o evidence");
    verb->callback([options, &action] { action = [options] { return selfTest(*options); }; });
}

} // namespace dyncal
