// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate.h"
#include "core/certificate/certificate_issue.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>

using namespace dyncal;

namespace {

CertificateData draft()
{
    Recipe recipe;
    recipe.certificate.fields = example::certificateFields();
    return makeCertificate(example::calibration(), recipe, "2026-11-21T12:00:00Z");
}

CertificateData issued(const CertificateIssue &issue)
{
    CertificateData data = draft();
    markIssued(issue, data);
    return data;
}

std::string fieldOf(const CertificateData &data, const char *section, const char *id)
{
    for (const CertificateField &field : data.section(section)->fields)
        if (field.id == id)
            return english(field.value);
    return "(none)";
}

const CertificateIssue kIssue{"17", {}, {}, "headhash", "resultshash", "fileshash"};

} // namespace

/// What makes a certificate of a draft.
class TestCertificateIssue : public QObject
{
    Q_OBJECT

private slots:
    void draft_saysNothingOfAnIssue()
    {
        QVERIFY(draft().draft);
        QVERIFY(draft().marks.empty());
        QVERIFY(!draft().section("issue"));
    }

    void issued_statesWhatItIsBoundTo()
    {
        const CertificateData data = issued(kIssue);
        QVERIFY(!data.draft);
        QCOMPARE(data.number, "17");
        QCOMPARE(fieldOf(data, "issue", "state"), "issued, not signed");
        QCOMPARE(fieldOf(data, "issue", "trail_head"), "headhash");
        QCOMPARE(fieldOf(data, "issue", "results_sha256"), "resultshash");
        using Marks = std::vector<std::pair<std::string, std::string>>;
        QVERIFY((data.marks
            == Marks{{"number", "17"}, {"amends", ""}, {"head", "headhash"},
                {"results", "resultshash"}, {"files", "fileshash"}}));
        QCOMPARE(fieldOf(data, "administrative", "amends"), "(none)");
    }

    /// ISO/IEC 17025, 7.8.8: on the first page.
    void amendment_namesWhatItReplaces()
    {
        CertificateIssue issue = kIssue;
        issue.amends = "9";
        issue.reason = "serial number corrected";
        const CertificateData data = issued(issue);
        QCOMPARE(fieldOf(data, "issue", "state"), "issued as an amendment, not signed");
        QCOMPARE(fieldOf(data, "administrative", "amends"),
            "certificate 9, which is no longer valid; what changed: serial number corrected");
        QCOMPARE(data.sections.front().id, "administrative");
    }

    /// All else is as in the draft, in its order.
    void otherSections_stay()
    {
        CertificateData data = issued(kIssue);
        const auto section = std::ranges::find(data.sections, "issue", &CertificateSection::id);
        QCOMPARE((section + 1)->id, "records");
        data.sections.erase(section);
        const CertificateData before = draft();
        QCOMPARE(data.sections.size(), before.sections.size());
        for (std::size_t i = 0; i < before.sections.size(); ++i) {
            QCOMPARE(data.sections[i].id, before.sections[i].id);
            QCOMPARE(data.sections[i].fields.size(), before.sections[i].fields.size());
            QCOMPARE(data.sections[i].paragraphs.size(), before.sections[i].paragraphs.size());
        }
    }

    /// A draft makes no statement of traceability; an issued certificate must.
    void traceability_isStated()
    {
        const auto last = [](const CertificateData &data) {
            return english(data.section("statements")->paragraphs.back());
        };
        QVERIFY(last(draft()).find("makes no statement of metrological traceability")
            != std::string::npos);
        QVERIFY(last(issued(kIssue))
                    .starts_with(
                        "The results are traceable to the International System of Units (SI)"));
    }
};

DYNCAL_TEST(TestCertificateIssue)
#include "tst_certificate_issue.moc"
