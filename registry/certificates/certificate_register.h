// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "registry/certificates/certificate_record.h"
#include "registry/store/registry_database.h"
#include "registry/trail/audit_entry.h"

#include <optional>
#include <vector>

namespace dyncal {

/// A decision of the job that the audit trail keeps with its reason: "accepted WIN-001, shot 3".
struct JobDecision
{
    std::string action = {};
    std::string reason = {};
};

/// What a number is asked for.
struct NumberRequest
{
    std::string job = {}; ///< as in CertificateRecord
    std::string jobSha256 = {};
    std::string utc = {}; ///< now
    std::string by = {};
    std::string reviewedBy = {};
    std::string sensor = {};
    std::string customer = {};
    Index number = 0; ///< a reserved one, for what the job is now; 0: the job's own, else the next
    Index amends = 0;
    std::string reason = {}; ///< of the amendment
    std::vector<JobDecision> decisions = {};
};

/// A number that a job has, and the trail that belongs on its certificate.
struct ReservedNumber
{
    CertificateRecord
        record; ///< state Reserved; in force where the same job has been issued before
    std::vector<AuditEntry> trail; ///< from the first entry about it to the head before issuing
};

/// Certificates and their numbers: every number from 1 is reserved, issued or void, whatever is
/// killed. Each function is one transaction, with its entries in the audit trail, and fails as
/// RegistryDatabase does; the wrong state of a certificate is a Usage error.
class CertificateRegister
{
public:
    /// Opens the registry at that address (registryAddress) and makes or changes its tables.
    static Result<CertificateRegister> open(const std::string &address);
    /// The same of one that must be there. Fails (FileUnreadable) where it is not.
    static Result<CertificateRegister> openToChange(const std::string &address);
    /// The same to look at it: nothing is made or changed.
    static Result<CertificateRegister> openToRead(const std::string &address);

    /// The number that this very job has already, or the next one. Refused (finding CER-006) if the
    /// same recordings have a certificate in force that the request does not amend, and if what it
    /// amends is not in force or is being amended.
    Result<ReservedNumber> reserve(const NumberRequest &request);

    /// The files of a reserved number lie where they belong: from now on it is issued, and what it
    /// amends is replaced. `files`: SHA-256 by name. Again with the same files it changes nothing.
    Result<CertificateRecord> markIssued(
        Index number, const std::map<std::string, std::string> &files, const std::string &utc);

    /// A reserved number that will not be issued.
    Result<CertificateRecord> markVoid(
        Index number, const std::string &who, const std::string &reason, const std::string &utc);

    /// A certificate that the laboratory does not stand by any more.
    Result<CertificateRecord> withdraw(
        Index number, const std::string &who, const std::string &reason, const std::string &utc);

    Result<CertificateRecord> find(Index number); ///< fails (Usage) where there is none
    Result<std::vector<CertificateRecord>> all(); ///< by number

    RegistryDatabase &database() { return m_database; }

private:
    explicit CertificateRegister(RegistryDatabase database);
    static Result<CertificateRegister> openFor(RegistryAccess access, const std::string &address);

    Result<ReservedNumber> reserveNow(const NumberRequest &request);
    Result<void> checkFree(const NumberRequest &request);
    Result<void> checkAmended(Index number, Index by);
    Result<CertificateRecord> newNumber(const NumberRequest &request);
    Result<CertificateRecord> takenOver(const NumberRequest &request);
    Result<ReservedNumber> withTrail(CertificateRecord record);
    Result<CertificateRecord> moved(Index number, CertificateState to, AuditEntry entry);

    RegistryDatabase m_database;
};

} // namespace dyncal
