// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/clock.h"
#include "app/cli/console.h"
#include "app/cli/registry_options.h"
#include "app/cli/verbs.h"

#include "core/base/foreign_text.h"
#include "core/base/json_text.h"
#include "registry/certificates/certificate_register.h"

#include <iostream>
#include <memory>

namespace dyncal {
namespace {

struct RegistryOptions
{
    std::string registry, by, reason;
    Index number = 0;
    bool json = false;
};

nlohmann::json jsonOf(const std::vector<CertificateRecord> &records)
{
    nlohmann::json list = nlohmann::json::array();
    for (const CertificateRecord &record : records)
        list.push_back(nlohmann::json::parse(recordJson(record)));
    return list;
}

std::string lineOf(const CertificateRecord &record)
{
    std::string line = std::to_string(record.number) + "  " + certificateStateName(record.state)
        + "  " + (record.issuedUtc.empty() ? record.reservedUtc : record.issuedUtc);
    for (const std::string &text : {record.sensor, record.customer, record.reason})
        line += text.empty() ? "" : "  " + presentableInBrief(text);
    return line + '\n';
}

int list(const RegistryOptions &options)
{
    Result<CertificateRegister> registry = CertificateRegister::openToRead(options.registry);
    if (!registry)
        return report(registry.error());
    const auto records = registry->all();
    if (!records)
        return report(records.error());
    if (options.json)
        std::cout << jsonText(jsonOf(*records));
    for (const CertificateRecord &record : *records)
        if (!options.json)
            std::cout << lineOf(record);
    return static_cast<int>(ExitCode::Done);
}

int makeVoid(const RegistryOptions &options)
{
    const Result<std::string> now = currentUtc();
    if (!now)
        return report(now.error());
    Result<CertificateRegister> registry = CertificateRegister::open(options.registry);
    if (!registry)
        return report(registry.error());
    const auto record = registry->markVoid(options.number, options.by, options.reason, *now);
    if (!record)
        return report(record.error());
    std::cout << "Number " << record->number << " is void.\n";
    return static_cast<int>(ExitCode::Done);
}

} // namespace

void addRegistry(CLI::App &program, VerbAction &action)
{
    const auto options = std::make_shared<RegistryOptions>();
    CLI::App *verb
        = program.add_subcommand("registry", "The laboratory's registry of certificates");
    verb->require_subcommand(1);
    CLI::App *all = verb->add_subcommand("list", "Every number and what has become of it");
    declareRegistry(*all, options->registry);
    all->add_flag("--json", options->json, "As JSON");
    all->callback([options, &action] { action = [options] { return list(*options); }; });
    CLI::App *none
        = verb->add_subcommand("void", "Give up a reserved number that will not be issued");
    none->add_option("number", options->number, "A reserved number")
        ->required()
        ->check(CLI::PositiveNumber)
        ->type_name("NUMBER");
    declareRegistry(*none, options->registry);
    declareReason(*none, options->by, options->reason);
    none->callback([options, &action] { action = [options] { return makeVoid(*options); }; });
    verb->footer("Example:\n  dyncal registry list\n"
                 "  dyncal registry void 18 --by \"A. Berg\" --reason \"sensor broke\"");
}

} // namespace dyncal
