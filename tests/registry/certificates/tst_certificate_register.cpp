// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/certificates/certificate_register.h"

#include "registry/certificates/registry_check.h"
#include "registry/store/trail_table.h"
#include "tests/support/hostile_text.h"
#include "tests/support/made_registry.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;
using State = CertificateState;

namespace {

/// A registry in a folder of its own.
struct Laboratory
{
    ScratchFolder folder;
    CertificateRegister registry = openedRegister(folder.file("registry.sqlite"));

    State stateOf(Index number) { return registry.find(number)->state; }
    std::string fault()
    {
        const auto check = checkRegistry(registry);
        return !check                ? english(check.error().message)
            : check->firstDifference ? english(*check->firstDifference)
                                     : std::string();
    }
};

std::string whyNot(const Result<ReservedNumber> &refused)
{
    return refused ? "not refused" : english(refused.error().message);
}

} // namespace

/// Numbers, states and what is refused.
class TestCertificateRegister : public QObject
{
    Q_OBJECT

private slots:
    void numbers_areConsecutiveFrom1()
    {
        Laboratory lab;
        for (Index number = 1; number <= 5; ++number)
            QCOMPARE(issueAs(lab.registry, numberRequest("job" + std::to_string(number))), number);
        const auto all = lab.registry.all();
        QCOMPARE(all->size(), 5U);
        for (std::size_t i = 0; i < all->size(); ++i) {
            QCOMPARE((*all)[i].number, static_cast<Index>(i) + 1);
            QCOMPARE((*all)[i].state, State::Issued);
        }
        QCOMPARE(lab.fault(), std::string());
    }

    /// A restart finds its number, also in another program.
    void sameJob_hasTheSameNumber()
    {
        Laboratory lab;
        const auto first = lab.registry.reserve(numberRequest("a"));
        QVERIFY(lab.registry.reserve(numberRequest("b")));
        CertificateRegister other = openedRegister(lab.folder.file("registry.sqlite"));
        NumberRequest later = numberRequest("a");
        later.utc = "2027-02-02T00:00:00Z";
        const auto again = other.reserve(later);
        QCOMPARE(again->record, first->record);
        QVERIFY(again->trail == first->trail);
        QCOMPARE(again->record.reservedUtc, kNoon);
        QCOMPARE(lab.registry.all()->size(), 2U);
    }

    void issuedJob_isAnsweredAgain()
    {
        Laboratory lab;
        QCOMPARE(issueAs(lab.registry, numberRequest("a")), 1);
        const auto again = lab.registry.reserve(numberRequest("a"));
        QCOMPARE(again->record.state, State::Issued);
        QCOMPARE(again->record.files.at("results.json"), "hash");
        QVERIFY(!lab.registry.markIssued(1, {}, kNoon));
        QCOMPARE(lab.registry.all()->size(), 1U);
    }

    /// The answer of the first time may have been lost with the connection.
    void issuedTwice_isIssuedOnce()
    {
        Laboratory lab;
        QVERIFY(lab.registry.reserve(numberRequest("a")));
        const auto first = lab.registry.markIssued(1, {{"a", "1"}}, kNoon);
        const auto again = lab.registry.markIssued(1, {{"a", "1"}}, "2027-01-01T00:00:00Z");
        QVERIFY(again);
        QCOMPARE(*again, *first);
        QVERIFY(!lab.registry.markIssued(1, {{"a", "2"}}, kNoon));
        QCOMPARE(allEntries(lab.registry.database())->size(), 2U);
    }

    void headAndTrail_areThoseBeforeIssuing()
    {
        Laboratory lab;
        QVERIFY(lab.registry.reserve(numberRequest("other")));
        NumberRequest request = numberRequest("a");
        request.reviewedBy = "B. Ek";
        request.decisions = {{"accepted WIN-001, shot 3", "seen"}};
        const auto reserved = lab.registry.reserve(request);
        QCOMPARE(reserved->trail.size(), 3U);
        QCOMPARE(reserved->trail[0].action, "reserved");
        QCOMPARE(reserved->trail[1].action, "accepted WIN-001, shot 3");
        QCOMPARE(reserved->trail[1].reason, "seen");
        QCOMPARE(reserved->trail[1].who, "A. Berg");
        QCOMPARE(reserved->trail[2].action, "reviewed");
        QCOMPARE(reserved->trail[2].who, "B. Ek");
        QCOMPARE(reserved->record.head, reserved->trail[2].sha256);
        QVERIFY(lab.registry.reserve(numberRequest("later")));
        QCOMPARE(lab.registry.markIssued(2, {}, kNoon)->head, reserved->record.head);
        QCOMPARE(lab.fault(), std::string());
    }

    void changedJob_isRefusedWithItsWays()
    {
        Laboratory lab;
        QVERIFY(lab.registry.reserve(numberRequest("a", "before")));
        QVERIFY(whyNot(lab.registry.reserve(numberRequest("a", "after")))
                    .starts_with("Number 1 is reserved for an earlier state of this job"));
        NumberRequest goingOn = numberRequest("a", "after");
        goingOn.number = 1;
        QCOMPARE(lab.registry.reserve(goingOn)->record.jobSha256, "aafter");
        QVERIFY(lab.registry.markIssued(1, {}, kNoon));
        const auto third = lab.registry.reserve(numberRequest("a", "third"));
        QVERIFY(whyNot(third).starts_with("These recordings have certificate 1"));
        QCOMPARE(third.error().findingId, "CER-006");
        QCOMPARE(lab.registry.all()->size(), 1U);
        QCOMPARE(lab.fault(), std::string());
    }

    void numberOfAnother_isNotTakenOver()
    {
        Laboratory lab;
        QVERIFY(lab.registry.reserve(numberRequest("a")));
        NumberRequest wrong = numberRequest("b");
        wrong.number = 1;
        QVERIFY(whyNot(lab.registry.reserve(wrong)).starts_with("Number 1 is reserved and not"));
        NumberRequest own = numberRequest("a");
        own.number = 2;
        QVERIFY(whyNot(lab.registry.reserve(own)).starts_with("This job has number 1 already"));
        wrong.number = 7;
        QVERIFY(
            whyNot(lab.registry.reserve(wrong)).find("has no certificate 7") != std::string::npos);
        QCOMPARE(lab.registry.all()->size(), 1U);
    }

    void amendment_replaces()
    {
        Laboratory lab;
        QCOMPARE(issueAs(lab.registry, numberRequest("a")), 1);
        NumberRequest amendment = numberRequest("a", "corrected");
        amendment.amends = 1;
        amendment.reason = "serial number corrected";
        QVERIFY(lab.registry.reserve(amendment));
        QCOMPARE(lab.stateOf(1), State::Issued); // until the other is there
        QCOMPARE(issueAs(lab.registry, amendment), 2);
        QCOMPARE(lab.stateOf(1), State::Replaced);
        QCOMPARE(lab.registry.find(1)->replacedBy, 2);
        QCOMPARE(lab.stateOf(2), State::Amended);
        QCOMPARE(lab.registry.find(2)->amends, 1);
        NumberRequest second = numberRequest("a", "again");
        second.amends = 1;
        QVERIFY(!lab.registry.reserve(second)); // a replaced one is not amended
        second.amends = 2;
        QCOMPARE(issueAs(lab.registry, second), 3);
        QCOMPARE(lab.fault(), std::string());
    }

    void twoAmendments_areNotMadeAtOnce()
    {
        Laboratory lab;
        QCOMPARE(issueAs(lab.registry, numberRequest("a")), 1);
        NumberRequest one = numberRequest("b"), other = numberRequest("c");
        one.amends = other.amends = 1;
        QVERIFY(lab.registry.reserve(one));
        QVERIFY(whyNot(lab.registry.reserve(other))
                    .starts_with("Certificate 1 is being amended by number 2"));
        QVERIFY(lab.registry.markVoid(2, "A", "broke", kNoon));
        QVERIFY(lab.registry.reserve(other));
    }

    /// An amendment whose certificate was withdrawn meanwhile changes nothing.
    void withdrawnMeanwhile_isNotReplaced()
    {
        Laboratory lab;
        QCOMPARE(issueAs(lab.registry, numberRequest("a")), 1);
        NumberRequest amendment = numberRequest("a", "corrected");
        amendment.amends = 1;
        QVERIFY(lab.registry.reserve(amendment));
        QVERIFY(lab.registry.withdraw(1, "A", "damaged reference", kNoon));
        QVERIFY(!lab.registry.markIssued(2, {}, kNoon));
        QCOMPARE(lab.stateOf(2), State::Reserved);
        QCOMPARE(lab.stateOf(1), State::Withdrawn);
        QCOMPARE(lab.fault(), std::string());
    }

    void states_goOnlyTheirWay()
    {
        Laboratory lab;
        QVERIFY(lab.registry.reserve(numberRequest("a")));
        QVERIFY(!lab.registry.withdraw(1, "A", "why", kNoon)); // not issued
        QVERIFY(!lab.registry.markVoid(1, "A", "", kNoon)); // no reason
        QVERIFY(!lab.registry.markVoid(1, "", "why", kNoon)); // nobody
        QVERIFY(lab.registry.markVoid(1, "A", "why", kNoon));
        QVERIFY(!lab.registry.markIssued(1, {}, kNoon));
        QVERIFY(!lab.registry.markVoid(1, "A", "why", kNoon));
        QCOMPARE(issueAs(lab.registry, numberRequest("a")), 2); // a void number is never used again
        QVERIFY(!lab.registry.markVoid(2, "A", "why", kNoon)); // issued
        QVERIFY(lab.registry.withdraw(2, "A", "why", kNoon));
        QVERIFY(!lab.registry.withdraw(2, "A", "why", kNoon));
        QVERIFY(!lab.registry.find(3));
        QCOMPARE(lab.fault(), std::string());
    }

    /// A refused request leaves nothing behind, in no table.
    void refused_changesNothing()
    {
        Laboratory lab;
        QCOMPARE(issueAs(lab.registry, numberRequest("a")), 1);
        const auto before = allEntries(lab.registry.database());
        NumberRequest wrong = numberRequest("b");
        wrong.amends = 9;
        QVERIFY(!lab.registry.reserve(wrong));
        QVERIFY(!lab.registry.reserve(numberRequest("a", "other")));
        QVERIFY(*allEntries(lab.registry.database()) == *before);
        QCOMPARE(issueAs(lab.registry, numberRequest("b")), 2);
        QCOMPARE(lab.fault(), std::string());
    }

    void hostileTexts_areKeptAsText()
    {
        Laboratory lab;
        Index number = 0;
        for (const std::string &text : test::hostileTexts()) {
            NumberRequest request = numberRequest("job" + std::to_string(++number));
            request.by = request.customer = request.sensor = request.reviewedBy = text;
            request.decisions = {{text, text}};
            QCOMPARE(issueAs(lab.registry, request), number);
        }
        QCOMPARE(lab.fault(), std::string());
        QCOMPARE(static_cast<Index>(lab.registry.all()->size()), number);
    }

    void missingRegistry_isNotMadeByReading()
    {
        const ScratchFolder folder;
        const auto none = CertificateRegister::openToRead(folder.file("registry.sqlite"));
        QVERIFY(!none);
        QCOMPARE(none.error().kind, ErrorKind::FileUnreadable);
        QVERIFY(!std::filesystem::exists(folder.file("registry.sqlite")));
    }
};

DYNCAL_TEST(TestCertificateRegister)
#include "tst_certificate_register.moc"
