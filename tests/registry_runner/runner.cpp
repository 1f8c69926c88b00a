// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A program that issues certificates one after the other, as fast as it can, for tests that run two
// of it at once, kill it, or stop the server: registry_runner REGISTRY DIR NAME COUNT
// Job I of NAME is always the same, so a restart goes on where the last one was. Every third
// certificate is amended. A registry that does not answer is asked again for a minute.
#include "registry/issued/issued_files.h"
#include "tests/support/made_certificate.h"
#include "tests/support/made_registry.h"

#include <QCoreApplication>

#include <chrono>
#include <cstdio>
#include <optional>
#include <thread>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr const char *kUtc = "2026-01-31T12:00:00Z";

Result<CertificateRecord> issueOnce(
    const std::string &address, const std::string &folder, const NumberRequest &request)
{
    Result<CertificateRegister> registry = CertificateRegister::open(address);
    if (!registry)
        return tl::unexpected<Error>(registry.error());
    const auto reserved = registry->reserve(request);
    if (!reserved)
        return tl::unexpected<Error>(reserved.error());
    if (reserved->record.state != CertificateState::Reserved)
        return reserved->record;
    const auto hashes = writeIssuedFolder(folder, *reserved, madeCertificate(reserved->record), {});
    if (!hashes)
        return tl::unexpected<Error>(hashes.error());
    return registry->markIssued(reserved->record.number, *hashes, kUtc);
}

/// Until the registry answers; 0 where it never does, or refuses.
Index issueAtLast(
    const std::string &address, const std::string &folder, const NumberRequest &request)
{
    using namespace std::chrono;
    const auto end = steady_clock::now() + minutes(1);
    for (;;) {
        const Result<CertificateRecord> record = issueOnce(address, folder, request);
        if (record)
            return record->number;
        if (steady_clock::now() > end) {
            std::fprintf(stderr, "%s\n", english(record.error().message).c_str());
            return 0;
        }
        std::this_thread::sleep_for(milliseconds(100));
    }
}

/// The number of a job that was issued in an earlier start of this program.
std::optional<Index> doneBefore(
    const std::vector<CertificateRecord> &before, const NumberRequest &request)
{
    for (const CertificateRecord &record : before)
        if (record.jobSha256 == request.jobSha256 && record.state != CertificateState::Reserved)
            return record.number;
    return std::nullopt;
}

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication application(argc, argv);
    if (argc != 5)
        return 2;
    const std::string address = argv[1], folder = argv[2], name = argv[3];
    std::vector<CertificateRecord> before;
    if (Result<CertificateRegister> registry = CertificateRegister::open(address))
        before = registry->all().value_or(before);
    const int count = std::stoi(argv[4]);
    for (int i = 0; i < count; ++i) {
        NumberRequest request = numberRequest(name + std::to_string(i));
        const auto done = doneBefore(before, request);
        const Index number = done ? *done : issueAtLast(address, folder, request);
        if (number == 0)
            return 1;
        if (i % 3 != 2)
            continue;
        NumberRequest amendment = numberRequest(name + std::to_string(i), "amended");
        amendment.amends = number;
        amendment.reason = "corrected";
        if (!doneBefore(before, amendment) && issueAtLast(address, folder, amendment) == 0)
            return 1;
    }
    return 0;
}
