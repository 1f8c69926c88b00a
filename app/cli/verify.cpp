// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/clock.h"
#include "app/cli/console.h"
#include "app/cli/registry_options.h"
#include "app/cli/verbs.h"
#include "app/cli/verifying.h"

#include "core/base/calendar_date.h"
#include "core/base/json_text.h"

#include <iostream>
#include <memory>

namespace dyncal {
namespace {

constexpr std::size_t kMomentSize = 20; ///< letters of 2026-01-31T12:00:00Z

/// --trust and --at, as they are typed.
struct TrustOptions
{
    std::string anchors; ///< file
    std::string at;
};

Result<std::string> momentOf(const std::string &typed)
{
    if (typed.empty())
        return currentUtc();
    if (isCalendarDate(typed))
        return calendarDate(typed) + "T12:00:00Z";
    if (typed.size() == kMomentSize && daysSince1970(typed))
        return typed;
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "%1 is no moment (--at); write it in UTC as 2026-01-31T12:00:00Z, or a day as 2026-01-31."),
            {typed}});
}

Result<TrustSettings> trustOf(const TrustOptions &options)
{
    TrustSettings trust;
    const Result<std::string> moment = momentOf(options.at);
    if (!moment)
        return tl::unexpected<Error>(moment.error());
    trust.utc = *moment;
    if (options.anchors.empty())
        return trust;
    const Result<std::string> anchors = readAnchors(options.anchors);
    if (!anchors)
        return tl::unexpected<Error>(anchors.error());
    trust.anchors = *anchors;
    return trust;
}

int verify(VerifyOptions options, const TrustOptions &trusted, bool json)
{
    const Result<TrustSettings> trust = trustOf(trusted);
    if (!trust)
        return report(trust.error());
    options.trust = *trust;
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
    const auto trust = std::make_shared<TrustOptions>();
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
    verb->add_option("--trust", trust->anchors,
            "Certificates that are trusted, PEM; signatures of others are of an unknown signer")
        ->type_name("CA.pem");
    verb->add_option("--at", trust->at,
            "The moment at which certificates of signers must be valid; else now")
        ->type_name("TIME");
    verb->add_flag("--json", *json, "As JSON");
    verb->footer(
        "Exit codes: 0 valid, 1 valid with remarks (unsigned, unknown signer, expired,\nwithdrawn, replaced), 2 changed or\ncontradicting, 3 unreadable, 4 usage.\n\n"
        "Example:\n  dyncal verify certificates/17 --registry registry.sqlite --trust ca.pem\n"
        "  dyncal verify certificates registry.sqlite --recordings archive --json");
    verb->callback([=, &action] { action = [=] { return verify(*options, *trust, *json); }; });
}

} // namespace dyncal
