// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/registry_options.h"

#include "app/base/clock.h"
#include "app/base/user_name.h"

namespace dyncal {

void declareRegistry(CLI::App &verb, std::string &registry)
{
    verb.add_option("--registry", registry,
            "The laboratory's registry: a file, or a database of a PostgreSQL server; else a file of this user's")
        ->type_name("FILE|postgresql://USER@HOST:PORT/DATABASE");
}

void declareReason(CLI::App &verb, std::string &by, std::string &reason)
{
    by = userName();
    verb.add_option("--by", by, "Who does it, for the audit trail; else the name of the account")
        ->type_name("NAME");
    verb.add_option("--reason", reason, "Why, for the audit trail")->required()->type_name("TEXT");
}

Result<CertificateRecord> changedNow(const std::string &registry,
    const std::function<Result<CertificateRecord>(CertificateRegister &, const std::string &)>
        &change)
{
    const Result<std::string> now = currentUtc();
    if (!now)
        return tl::unexpected<Error>(now.error());
    Result<CertificateRegister> opened = CertificateRegister::openToChange(registry);
    if (!opened)
        return tl::unexpected<Error>(opened.error());
    return change(*opened, *now);
}

} // namespace dyncal
