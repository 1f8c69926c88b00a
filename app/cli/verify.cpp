// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/console.h"
#include "app/cli/registry_options.h"
#include "app/cli/verbs.h"
#include "app/cli/verifying.h"

#include "core/base/json_text.h"

#include <iostream>
#include <memory>

namespace dyncal {
namespace {

int verify(const VerifyOptions &options, bool json)
{
    const Result<std::vector<Verified>> all = verifyAll(options);
    if (!all)
        return report(all.error());
    std::cout << (json ? jsonText(verifiedJson(*all)) : verifiedText(*all));
    return exitCodeOf(*all);
}

} // namespace

void addVerify(CLI::App &program, VerbAction &action)
{
    const auto options = std::make_shared<VerifyOptions>();
    const auto json = std::make_shared<bool>(false);
    CLI::App *verb = program.add_subcommand("verify",
        "Hold issued certificates, registries, projects and recordings against what they state");
    verb->add_option("files", options->files,
            "Folders of certificates or above such, registries, projects, recordings, single files")
        ->required()
        ->type_name("FILE|FOLDER");
    declareRegistry(*verb, options->registry);
    verb->add_option("--recordings", options->recordings,
            "Where the recordings of certificates are, by content; without it they are not looked at")
        ->type_name("DIR");
    verb->add_flag("--json", *json, "As JSON");
    verb->footer(
        "Exit codes: 0 valid, 1 valid with remarks (unsigned, withdrawn, replaced), 2 changed or\ncontradicting, 3 unreadable, 4 usage.\n\n"
        "Example:\n  dyncal verify certificates/17 --registry registry.sqlite\n"
        "  dyncal verify certificates registry.sqlite --recordings archive --json");
    verb->callback(
        [options, json, &action] { action = [options, json] { return verify(*options, *json); }; });
}

} // namespace dyncal
