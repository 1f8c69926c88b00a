// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/console.h"
#include "app/cli/spoken.h"
#include "app/cli/verbs.h"

#include "core/base/foreign_text.h"
#include "core/base/json_text.h"
#include "core/dcc/dcc_check.h"
#include "core/xml/xml_file.h"

#include <iostream>
#include <memory>

namespace dyncal {
namespace {

struct DccOptions
{
    std::string file;
    std::string schemas;
    bool json = false;
};

nlohmann::json jsonOf(const DccOptions &options, const DccCheck &check)
{
    nlohmann::json findings = nlohmann::json::array();
    for (const DccFinding &finding : check.findings)
        findings.push_back({{"rule", finding.rule}, {"where", finding.where},
            {"found", finding.found}, {"needed", spoken(finding.needed)}});
    return {{"schema", "dyncal-dcc-check/1"}, {"file", options.file}, {"version", check.version},
        {"number", check.number}, {"schema_checked", check.isSchemaChecked},
        {"valid", check.findings.empty()}, {"findings", findings}};
}

void print(const DccOptions &options, const DccCheck &check)
{
    for (const DccFinding &finding : check.findings)
        std::cout << finding.rule << ": " << presentableInBrief(finding.where) << ": found \""
                  << presentableInBrief(finding.found) << "\". " << spoken(finding.needed) << '\n';
    std::cout << presentable(options.file) << ": DCC " << presentableInBrief(check.version)
              << ", number " << presentableInBrief(check.number) << ", "
              << (check.findings.empty() ? "all rules hold" : "not as it must be")
              << (check.isSchemaChecked ? "."
                                        : "; not held against the XML schema (--schemas FOLDER).")
              << '\n';
}

int checkFile(const DccOptions &options)
{
    const Result<std::string> xml = xmlFileBytes(options.file);
    if (!xml)
        return report(xml.error());
    const Result<DccCheck> check = checkDcc(*xml, options.schemas);
    if (!check)
        return report(check.error());
    if (options.json)
        std::cout << jsonText(jsonOf(options, *check));
    else
        print(options, *check);
    return static_cast<int>(check->findings.empty() ? ExitCode::Done : ExitCode::Blocked);
}

} // namespace

void addDcc(CLI::App &program, VerbAction &action)
{
    const auto options = std::make_shared<DccOptions>();
    CLI::App *verb
        = program.add_subcommand("dcc", "Digital calibration certificates: check one by its rules");
    verb->require_subcommand(1);
    CLI::App *check = verb->add_subcommand("check", "What of a DCC is not as it must be");
    check->add_option("file", options->file, "A digital calibration certificate")
        ->required()
        ->type_name("FILE");
    check
        ->add_option("--schemas", options->schemas,
            "Folder with PTB's XML schemas by their addresses (ptb.de/dcc/v3.3.0/dcc.xsd)")
        ->check(CLI::ExistingDirectory)
        ->type_name("FOLDER");
    check->add_flag("--json", options->json, "Print JSON");
    check->footer("Example:\n  dyncal dcc check out/dcc.xml\n"
                  "  dyncal dcc check dcc.xml --schemas schemas --json");
    check->callback([options, &action] { action = [options] { return checkFile(*options); }; });
}

} // namespace dyncal
