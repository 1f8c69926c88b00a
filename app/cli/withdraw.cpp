// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/console.h"
#include "app/cli/registry_options.h"
#include "app/cli/verbs.h"

#include <iostream>
#include <memory>

namespace dyncal {
namespace {

struct WithdrawOptions
{
    Index number = 0;
    std::string registry, by, reason;
};

int withdraw(const WithdrawOptions &options)
{
    const auto record
        = changedNow(options.registry, [&](CertificateRegister &registry, const std::string &utc) {
              return registry.withdraw(options.number, options.by, options.reason, utc);
          });
    if (!record)
        return report(record.error());
    std::cout << "Certificate " << record->number << " is withdrawn.\n";
    return static_cast<int>(ExitCode::Done);
}

} // namespace

void addWithdraw(CLI::App &program, VerbAction &action)
{
    const auto options = std::make_shared<WithdrawOptions>();
    CLI::App *verb = program.add_subcommand(
        "withdraw", "Withdraw a certificate: the registry says so, its folder stays as it is");
    verb->add_option("number", options->number, "Number of the certificate")
        ->required()
        ->check(CLI::PositiveNumber)
        ->type_name("NUMBER");
    declareRegistry(*verb, options->registry);
    declareReason(*verb, options->by, options->reason);
    verb->footer(
        "Example:\n  dyncal withdraw 17 --by \"A. Berg\" --reason \"reference found damaged\"");
    verb->callback([options, &action] { action = [options] { return withdraw(*options); }; });
}

} // namespace dyncal
