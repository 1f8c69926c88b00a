// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "registry/certificates/certificate_register.h"
#include "tests/support/scratch_folder.h"

#include <cstdlib>
#include <string>

namespace dyncal::testing {

/// The time of everything in these tests.
inline const std::string kNoon = "2026-01-31T12:00:00Z";

/// A job that asks for a number: `job` stands for the recordings, `state` for all the rest.
inline NumberRequest numberRequest(const std::string &job, const std::string &state = "a")
{
    NumberRequest request;
    request.job = job;
    request.jobSha256 = job + state;
    request.utc = kNoon;
    request.by = "A. Berg";
    request.sensor = "Acme 5 17";
    request.customer = "Customer of " + job;
    return request;
}

/// The register, or the test ends.
inline CertificateRegister openedRegister(const std::string &address)
{
    Result<CertificateRegister> opened = CertificateRegister::open(address);
    if (!opened) {
        qWarning("%s", english(opened.error().message).c_str());
        std::abort();
    }
    return std::move(*opened);
}

/// Reserves and issues; the number, 0 if it was refused.
inline Index issueAs(CertificateRegister &registry, const NumberRequest &request)
{
    const auto reserved = registry.reserve(request);
    if (!reserved)
        return 0;
    const auto issued
        = registry.markIssued(reserved->record.number, {{"results.json", "hash"}}, kNoon);
    return issued ? issued->number : 0;
}

} // namespace dyncal::testing
