// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/certificates/certificate_record.h"

#include "tests/support/hostile_text.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <set>

using namespace dyncal;

namespace {

/// Every member with a value of its own.
CertificateRecord fullRecord()
{
    return {.number = 17,
        .state = CertificateState::Amended,
        .job = "job",
        .jobSha256 = "hash",
        .reservedUtc = "2026-01-31T12:00:00Z",
        .issuedUtc = "2026-01-31T12:00:05Z",
        .by = "A. Berg",
        .reviewedBy = "B. Ek",
        .sensor = "Acme 5 17",
        .customer = "Customer \"quoted\"\nin two lines",
        .amends = 3,
        .replacedBy = 21,
        .reason = "corrected",
        .head = "head",
        .files = {{"a", "1"}, {"b", "2"}}};
}

} // namespace

/// A row as JSON.
class TestCertificateRecord : public QObject
{
    Q_OBJECT

private slots:
    void everyMember_comesBack()
    {
        QVERIFY(parseRecord(recordJson(fullRecord())) == fullRecord());
        QVERIFY(parseRecord(recordJson({})) == CertificateRecord());
    }

    /// The contract of `dyncal registry list --json`, written out.
    void json_isThatOfTheContract()
    {
        CertificateRecord record;
        record.number = 2;
        record.by = "A";
        record.files = {{"results.json", "x"}};
        QCOMPARE(recordJson(record),
            R"({"amends":0,"by":"A","customer":"","files":{"results.json":"x"},"head":"",)"
            R"("issued_utc":"","job":"","job_sha256":"","number":2,"reason":"","replaced_by":0,)"
            R"("reserved_utc":"","reviewed_by":"","sensor":"","state":"reserved"})");
    }

    void oneLine_whateverIsInIt()
    {
        for (const std::string &text : test::hostileTexts()) {
            CertificateRecord record = fullRecord();
            record.customer = record.reason = text;
            const std::string json = recordJson(record);
            QVERIFY(json.find('\n') == json.npos);
            const auto read = parseRecord(json);
            QVERIFY(read);
            QCOMPARE(recordJson(*read), json); // the second time nothing changes any more
        }
    }

    void states_haveTheirNames()
    {
        std::set<std::string> names;
        for (const auto state :
            {CertificateState::Reserved, CertificateState::Issued, CertificateState::Amended,
                CertificateState::Replaced, CertificateState::Withdrawn, CertificateState::Void}) {
            names.insert(certificateStateName(state));
            QVERIFY(certificateState(certificateStateName(state)) == state);
            QCOMPARE(isInForce(state),
                state == CertificateState::Issued || state == CertificateState::Amended);
        }
        QVERIFY((names
            == std::set<std::string>{
                "reserved", "issued", "amended", "replaced", "withdrawn", "void"}));
        QVERIFY(!certificateState("draft"));
        QVERIFY(!certificateState(""));
    }

    void whatIsNoRecord_isNone()
    {
        const std::string whole = recordJson(fullRecord());
        for (const std::string &wrong : {std::string(), std::string("{}"), std::string("[]"),
                 std::string("nonsense"), whole.substr(1)})
            QVERIFY(!parseRecord(wrong));
        std::string other = whole;
        other.replace(other.find("amended"), 7, "drafted");
        QVERIFY(!parseRecord(other));
        other = whole;
        other.replace(other.find("17"), 2, "\"17\"");
        QVERIFY(!parseRecord(other));
    }

    void object_isNamedByTheNumber() { QCOMPARE(certificateObject(17), "certificate 17"); }
};

DYNCAL_TEST(TestCertificateRecord)
#include "tst_certificate_record.moc"
