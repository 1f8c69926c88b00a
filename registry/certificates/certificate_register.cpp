// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/certificates/certificate_register.h"

#include "registry/certificates/certificate_table.h"
#include "registry/store/registry_schema.h"
#include "registry/store/trail_table.h"

#include <algorithm>

namespace dyncal {
namespace {

using Records = std::vector<CertificateRecord>;

/// Finding id of what is refused because it was issued already.
constexpr const char *kIssuedAlready = "CER-006";

AuditEntry entryFor(const std::string &utc, const std::string &who, const char *action,
    const std::string &reason = {})
{
    return {.utc = utc, .who = who, .action = action, .reason = reason, .program = programText()};
}

tl::unexpected<Error> wrongState(const CertificateRecord &record, const char *needed)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core", "Certificate %1 is %2; only one that is %3 can be used for this."),
            {std::to_string(record.number), certificateStateName(record.state), needed}});
}

tl::unexpected<Error> hasAnother(const CertificateRecord &record)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core", "This job has number %1 already, which is %2; leave --number out."),
            {std::to_string(record.number), certificateStateName(record.state)}});
}

tl::unexpected<Error> reservedBefore(const CertificateRecord &record)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "Number %1 is reserved for an earlier state of this job, which was not issued; go on with it by --number %1, or give it up by dyncal registry void %1 --reason TEXT."),
            {std::to_string(record.number)}});
}

tl::unexpected<Error> isIssued(const CertificateRecord &record)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "These recordings have certificate %1, which is never changed; issue an amendment by --amends %1 --reason TEXT."),
            {std::to_string(record.number)}},
        kIssuedAlready);
}

CertificateRecord requested(const NumberRequest &request, Index number)
{
    return {.number = number,
        .job = request.job,
        .jobSha256 = request.jobSha256,
        .reservedUtc = request.utc,
        .by = request.by,
        .reviewedBy = request.reviewedBy,
        .sensor = request.sensor,
        .customer = request.customer,
        .amends = request.amends,
        .reason = request.reason};
}

/// The very same job with a number already; null if there is none, or only void ones.
const CertificateRecord *sameJob(const Records &ofJob, const std::string &jobSha256)
{
    const auto found = std::ranges::find_if(ofJob, [&](const CertificateRecord &record) {
        return record.jobSha256 == jobSha256 && record.state != CertificateState::Void;
    });
    return found == ofJob.end() ? nullptr : &*found;
}

Result<void> bothNeeded(const std::string &who, const std::string &reason)
{
    if (!who.empty() && !reason.empty())
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT(
             "core", "A name (--by) and a reason (--reason) are needed for the audit trail."),
            {}});
}

/// With its tables as they are used so: to be read as they are, else brought up to date.
Result<RegistryDatabase> openedDatabase(const std::string &text, RegistryAccess access)
{
    const Result<RegistryAddress> address = registryAddress(text);
    if (!address)
        return tl::unexpected<Error>(address.error());
    Result<RegistryDatabase> database = RegistryDatabase::open(*address, access);
    if (!database)
        return database;
    const Result<void> ready
        = access == RegistryAccess::Read ? checkSchema(*database) : bringUpToDate(*database);
    if (!ready)
        return tl::unexpected<Error>(ready.error());
    return database;
}

} // namespace

CertificateRegister::CertificateRegister(RegistryDatabase database)
    : m_database(std::move(database))
{
}

Result<CertificateRegister> CertificateRegister::openFor(
    RegistryAccess access, const std::string &text)
{
    Result<RegistryDatabase> database = openedDatabase(text, access);
    if (!database)
        return tl::unexpected<Error>(std::move(database.error()));
    return CertificateRegister(std::move(*database));
}

Result<CertificateRegister> CertificateRegister::open(const std::string &text)
{
    return openFor(RegistryAccess::Write, text);
}

Result<CertificateRegister> CertificateRegister::openToChange(const std::string &text)
{
    return openFor(RegistryAccess::Change, text);
}

Result<CertificateRegister> CertificateRegister::openToRead(const std::string &text)
{
    return openFor(RegistryAccess::Read, text);
}

Result<Records> CertificateRegister::all()
{
    return certificates(m_database);
}

Result<CertificateRecord> CertificateRegister::find(Index number)
{
    const Result<Records> found
        = certificates(m_database, "WHERE number = ?", {static_cast<qint64>(number)});
    if (!found)
        return tl::unexpected<Error>(found.error());
    if (found->empty())
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT(
                 "core", "The registry %1 has no certificate %2; see dyncal registry list."),
                {m_database.address().shown(), std::to_string(number)}});
    return found->front();
}

Result<CertificateRecord> CertificateRegister::newNumber(const NumberRequest &request)
{
    const Result<Index> number = nextNumber(m_database);
    if (!number)
        return tl::unexpected<Error>(number.error());
    const CertificateRecord record = requested(request, *number);
    return putCertificate(
        m_database, {}, record, entryFor(request.utc, request.by, "reserved", request.reason))
        .map([&] { return record; });
}

/// A reserved number for what its job is now.
Result<CertificateRecord> CertificateRegister::takenOver(const NumberRequest &request)
{
    const Result<CertificateRecord> before = find(request.number);
    if (!before)
        return before;
    if (before->state != CertificateState::Reserved || before->job != request.job)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "Number %1 is %2 and not reserved for these recordings; leave --number out, and the job gets its own."),
                {std::to_string(before->number), certificateStateName(before->state)}});
    const CertificateRecord after = requested(request, request.number);
    return putCertificate(
        m_database, *before, after, entryFor(request.utc, request.by, "reserved", request.reason))
        .map([&] { return after; });
}

Result<void> CertificateRegister::checkAmended(Index number, Index by)
{
    const Result<CertificateRecord> amended = find(number);
    if (!amended)
        return tl::unexpected<Error>(amended.error());
    if (!isInForce(amended->state))
        return wrongState(*amended, "issued");
    const Result<Records> everything = all();
    if (!everything)
        return tl::unexpected<Error>(everything.error());
    for (const CertificateRecord &other : *everything)
        if (other.amends == number && other.number != by
            && other.state == CertificateState::Reserved)
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core",
                     "Certificate %1 is being amended by number %2, which is reserved; finish that, or give it up by dyncal registry void %2 --reason TEXT."),
                    {std::to_string(number), std::to_string(other.number)}});
    return {};
}

Result<void> CertificateRegister::checkFree(const NumberRequest &request)
{
    const Result<Records> ofJob
        = certificates(m_database, "WHERE job = ?", {QString::fromStdString(request.job)});
    if (!ofJob)
        return tl::unexpected<Error>(ofJob.error());
    for (const CertificateRecord &record : *ofJob) {
        if (record.state == CertificateState::Reserved && record.number != request.number)
            return reservedBefore(record);
        if (isInForce(record.state) && record.number != request.amends)
            return isIssued(record);
    }
    return request.amends > 0 ? checkAmended(request.amends, request.number) : Result<void>();
}

Result<ReservedNumber> CertificateRegister::withTrail(CertificateRecord record)
{
    const auto own = entriesOf(m_database, certificateObject(record.number));
    if (!own || own->empty())
        return own
            ? fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "The registry %1 has no entry of the audit trail about certificate %2; see dyncal verify."),
                    {m_database.address().shown(), std::to_string(record.number)}})
            : tl::unexpected<Error>(own.error());
    auto head = own->end() - 1;
    if (record.state != CertificateState::Reserved)
        head = std::ranges::find(*own, record.head, &AuditEntry::sha256);
    if (head == own->end())
        return wrongState(record, certificateStateName(CertificateState::Reserved));
    record.head = head->sha256;
    return entriesBetween(m_database, own->front().sequence, head->sequence)
        .map([&](std::vector<AuditEntry> trail) {
            return ReservedNumber{record, std::move(trail)};
        });
}

Result<ReservedNumber> CertificateRegister::reserveNow(const NumberRequest &request)
{
    const Result<Records> ofJob
        = certificates(m_database, "WHERE job = ?", {QString::fromStdString(request.job)});
    if (!ofJob)
        return tl::unexpected<Error>(ofJob.error());
    if (const CertificateRecord *same = sameJob(*ofJob, request.jobSha256)) {
        if (request.number > 0 && request.number != same->number)
            return hasAnother(*same);
        if (same->state != CertificateState::Reserved && !isInForce(same->state))
            return wrongState(*same, "issued");
        return withTrail(*same);
    }
    if (const Result<void> free = checkFree(request); !free)
        return tl::unexpected<Error>(free.error());
    const Result<CertificateRecord> record
        = request.number > 0 ? takenOver(request) : newNumber(request);
    if (!record)
        return tl::unexpected<Error>(record.error());
    std::vector<AuditEntry> more;
    for (const JobDecision &decision : request.decisions)
        more.push_back(entryFor(request.utc, request.by, decision.action.c_str(), decision.reason));
    if (!request.reviewedBy.empty())
        more.push_back(entryFor(request.utc, request.reviewedBy, "reviewed"));
    for (AuditEntry &entry : more) {
        entry.object = certificateObject(record->number);
        if (const auto added = appendEntry(m_database, entry); !added)
            return tl::unexpected<Error>(added.error());
    }
    return withTrail(*record);
}

Result<ReservedNumber> CertificateRegister::reserve(const NumberRequest &request)
{
    Result<ReservedNumber> reserved;
    const Result<void> done = m_database.transaction([&]() -> Result<void> {
        reserved = reserveNow(request);
        return reserved.map([](const auto &) {});
    });
    return done ? reserved : tl::unexpected<Error>(done.error());
}

Result<CertificateRecord> CertificateRegister::markIssued(
    Index number, const std::map<std::string, std::string> &files, const std::string &utc)
{
    CertificateRecord issued;
    const auto work = [&]() -> Result<void> {
        const Result<CertificateRecord> before = find(number);
        if (!before)
            return tl::unexpected<Error>(before.error());
        issued = *before;
        if (isInForce(before->state) && before->files == files)
            return {}; // by another program, or by this one before it lost the connection
        if (before->state != CertificateState::Reserved)
            return wrongState(*before, "reserved");
        const Result<ReservedNumber> reserved = withTrail(*before);
        if (!reserved)
            return tl::unexpected<Error>(reserved.error());
        issued = reserved->record;
        issued.state = issued.amends > 0 ? CertificateState::Amended : CertificateState::Issued;
        issued.files = files;
        issued.issuedUtc = utc;
        if (const Result<void> done = putCertificate(m_database, *before, issued,
                entryFor(utc, issued.by, certificateStateName(issued.state)));
            !done || issued.amends == 0)
            return done;
        const Result<CertificateRecord> old = find(issued.amends);
        if (!old || !isInForce(old->state))
            return old ? wrongState(*old, "issued") : tl::unexpected<Error>(old.error());
        CertificateRecord replaced = *old;
        replaced.state = CertificateState::Replaced;
        replaced.replacedBy = number;
        return putCertificate(
            m_database, *old, replaced, entryFor(utc, issued.by, "replaced", issued.reason));
    };
    const Result<void> done = m_database.transaction(work);
    return done ? Result<CertificateRecord>(issued) : tl::unexpected<Error>(done.error());
}

Result<CertificateRecord> CertificateRegister::moved(
    Index number, CertificateState to, AuditEntry entry)
{
    CertificateRecord after;
    const Result<void> done = m_database.transaction([&]() -> Result<void> {
        const Result<CertificateRecord> before = find(number);
        if (!before)
            return tl::unexpected<Error>(before.error());
        const bool isVoid = to == CertificateState::Void;
        if (isVoid ? before->state != CertificateState::Reserved : !isInForce(before->state))
            return wrongState(*before, isVoid ? "reserved" : "issued");
        after = *before;
        after.state = to;
        after.reason = entry.reason;
        return putCertificate(m_database, *before, after, entry);
    });
    return done ? Result<CertificateRecord>(after) : tl::unexpected<Error>(done.error());
}

Result<CertificateRecord> CertificateRegister::markVoid(
    Index number, const std::string &who, const std::string &reason, const std::string &utc)
{
    if (const Result<void> said = bothNeeded(who, reason); !said)
        return tl::unexpected<Error>(said.error());
    return moved(number, CertificateState::Void, entryFor(utc, who, "void", reason));
}

Result<CertificateRecord> CertificateRegister::withdraw(
    Index number, const std::string &who, const std::string &reason, const std::string &utc)
{
    if (const Result<void> said = bothNeeded(who, reason); !said)
        return tl::unexpected<Error>(said.error());
    return moved(number, CertificateState::Withdrawn, entryFor(utc, who, "withdrawn", reason));
}

} // namespace dyncal
