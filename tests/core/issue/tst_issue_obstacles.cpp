// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/issue/issue_obstacles.h"

#include "tests/support/example_results.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <limits>

using namespace dyncal;

namespace {

/// A job that nothing keeps from being issued, to be spoilt.
struct Job
{
    PipelineOutcome outcome;
    Recipe recipe;
    IssueNames names{"A. Berg", {}, "2026-11-21T12:00:00Z"};

    Job()
    {
        outcome.results = example::calibration();
        recipe.certificate.fields = example::certificateFields();
    }

    UncertaintyReport &report()
    {
        auto copy = std::make_shared<UncertaintyReport>(*outcome.results.uncertainty);
        outcome.results.uncertainty = copy;
        return *copy;
    }
    void find(Finding finding)
    {
        auto captures = std::make_shared<PreparedCaptures>(*outcome.results.captures);
        captures->findings.push_back(std::move(finding));
        outcome.results.captures = captures;
    }
    Findings obstacles() const { return issueObstacles(outcome, recipe, names); }
    std::string ids() const
    {
        std::string ids;
        for (const Finding &finding : obstacles()) {
            if (finding.severity != Severity::Block)
                return "an obstacle that does not block";
            ids += (ids.empty() ? "" : " ") + finding.id;
        }
        return ids;
    }
    std::string said() const { return english(obstacles().front().message); }
};

bool holds(const std::string &text, const std::string &part)
{
    return text.find(part) != text.npos;
}

Finding caution(Index shot = 0)
{
    return {.id = "CAP-014",
        .severity = Severity::Caution,
        .shot = shot,
        .message = {DYNCAL_TEXT("core", "Stopped on request."), {}}};
}

ProfileMark profileThat(const std::string &sections)
{
    return {"Lab", "3", std::string(64, '0'), sections};
}

} // namespace

/// What keeps a certificate from being issued.
class TestIssueObstacles : public QObject
{
    Q_OBJECT

private slots:
    void completeJob_hasNone() { QCOMPARE(Job().ids(), std::string()); }

    void emptyAndWrongFields_areNamedTogether()
    {
        Job job;
        job.recipe.certificate.fields.erase("customer_address");
        job.recipe.certificate.fields["date_received"] = "soon";
        QCOMPARE(job.ids(), "CER-001");
        QVERIFY2(job.said().starts_with("2 required fields"), job.said().c_str());
        QVERIFY(holds(job.said(), "Address of the customer"));
        QVERIFY(holds(job.said(), "Date of receipt"));
    }

    void cautions_needAReason()
    {
        Job job;
        job.find(caution(2));
        QCOMPARE(job.ids(), "CER-002");
        QVERIFY2(holds(job.said(), "CAP-014 (2)"), job.said().c_str());
        job.recipe.acknowledge = {{"CAP-014", 3, "of another shot"}};
        QCOMPARE(job.ids(), "CER-002");
        job.recipe.acknowledge = {{"CAP-014", 2, "  "}};
        QCOMPARE(job.ids(), "CER-002");
        job.recipe.acknowledge = {{"CAP-014", 2, "small step on purpose"}};
        QCOMPARE(job.ids(), "");
        job.recipe.acknowledge = {{"CAP-014", 0, "of all shots"}};
        QCOMPARE(job.ids(), "");
    }

    void blocks_keepAllElseBack()
    {
        Job job;
        Finding block = caution(1);
        block.severity = Severity::Block;
        block.id = "CAP-007";
        job.find(block);
        job.recipe.certificate.fields.clear();
        job.recipe.acknowledge = {{"CAP-007", 0, "never lifts a block"}};
        QCOMPARE(job.ids(), "CAP-007");
        job.outcome.error = Error{ErrorKind::DataBlocked, {"stopped", {}}, "WIN-002", 1};
        QCOMPARE(job.ids(), "WIN-002");
    }

    void endedReference_isNoEmptyField()
    {
        Job job;
        job.recipe.uncertainty.budget
            = {{.quantity = "p1_pa", .u = 1.0, .certificate = "P-1", .due = "2026-11-19"}};
        QCOMPARE(job.ids(), "CER-003");
        QVERIFY2(holds(job.said(), "P-1") && holds(job.said(), "2026-11-19"), job.said().c_str());
        job.recipe.uncertainty.budget[0].due = "2026-11-20"; // the day of the measurement
        QCOMPARE(job.ids(), "");
    }

    void secondName_whereTheProfileDemandsOne()
    {
        Job job;
        job.recipe.profile = profileThat(R"({"issue":{"second_name":true}})");
        QCOMPARE(job.ids(), "CER-005");
        job.names.reviewedBy = "A. Berg";
        QCOMPARE(job.ids(), "CER-005");
        job.names.reviewedBy = " ";
        QCOMPARE(job.ids(), "CER-005");
        job.names.reviewedBy = "B. Ek";
        QCOMPARE(job.ids(), "");
        job.names.reviewedBy = "A. Operator"; // whoever calibrated, where nobody else issues
        QCOMPARE(job.ids(), "");
        job.names.by.clear();
        QCOMPARE(job.ids(), "CER-005");
        for (const char *sections :
            {"{}", R"({"issue":{"second_name":false}})", R"({"issue":[]})"}) {
            job.recipe.profile = profileThat(sections);
            QCOMPARE(job.ids(), "");
        }
    }

    void incompleteQuantities_areNamed()
    {
        {
            Job job;
            job.report().sensitivity = ReportedValue{"sensitivity", 1e-5, "V/Pa"};
            QCOMPARE(job.ids(), "CER-008");
            QVERIFY(holds(job.said(), "sensitivity"));
        }
        {
            Job job;
            job.report().ofModel[1].u.reset();
            QCOMPARE(job.ids(), "CER-008");
            QVERIFY(holds(job.said(), "damping_ratio"));
        }
        {
            Job job;
            job.report().rows.u_magnitude[3] = std::numeric_limits<double>::quiet_NaN();
            QCOMPARE(job.ids(), "CER-008");
            QVERIFY2(holds(job.said(), "S(f): 1"), job.said().c_str());
        }
        Job job;
        job.outcome.results.uncertainty.reset();
        QCOMPARE(job.ids(), "CER-008");
    }

    /// What is not determined is not stated, and needs no U.
    void unknownQuantities_areNoObstacle()
    {
        Job job;
        job.report().ofModel.clear();
        auto response = std::make_shared<ResponseResult>(*job.outcome.results.response);
        response->magnitude[3] = std::numeric_limits<double>::quiet_NaN();
        job.outcome.results.response = response;
        job.report().rows.u_magnitude[3] = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(job.ids(), "");
    }

    void measuredInputs_needACertificate()
    {
        Job job;
        ReportedValue sensitivity{"sensitivity", 1e-5, "V/Pa"};
        sensitivity.u = 1e-7;
        for (const char *source : {"t1_k", "distance_m[Driven side]", "noise", "gamma"})
            sensitivity.lines.push_back({.quantity = source, .u = 1.0});
        job.report().sensitivity = sensitivity;
        QCOMPARE(job.ids(), "CER-009");
        QVERIFY2(holds(job.said(), "distance_m, t1_k"), job.said().c_str());
        job.recipe.uncertainty.budget = {{.quantity = "t1_k", .u = 1.0, .certificate = "T-1"},
            {.quantity = "distance_m", .u = 1.0, .certificate = " "}};
        QCOMPARE(job.ids(), "CER-009");
        QVERIFY(!holds(job.said(), "t1_k"));
        job.recipe.uncertainty.budget[1].certificate = "L-1";
        QCOMPARE(job.ids(), "");
    }

    /// All pressure comes through the reference transducer: without its certificate nothing is
    /// traceable, whatever the budget names.
    void referenceTransducer_needsACertificate()
    {
        Job job;
        ReportedValue sensitivity{"sensitivity", 1e-5, "V/Pa"};
        sensitivity.u = 1e-7;
        sensitivity.lines.push_back({.quantity = "reference_sensitivity_relative", .u = 0.003});
        job.report().sensitivity = sensitivity;
        const auto with = [](const std::string &certificate) {
            auto reference = std::make_shared<ReferenceStageResult>();
            const auto made = ReferenceSensitivity::fromModel({2e-8, 6e-11, 4e5, 1e3, 0.2, 0.01});
            reference->records = ReferenceRecords{made.value()};
            reference->records->certificate = certificate;
            return reference;
        };
        for (const char *none : {"", " "}) {
            job.outcome.results.reference = with(none);
            QCOMPARE(job.ids(), "CER-009");
            QVERIFY2(holds(job.said(), "comparison.certificate"), job.said().c_str());
        }
        job.outcome.results.reference = with("R-1");
        QCOMPARE(job.ids(), "");
    }

    void allOfThem_areNamedAtOnce()
    {
        Job job;
        job.recipe.certificate.fields.erase("customer");
        job.find(caution());
        job.recipe.profile = profileThat(R"({"issue":{"second_name":true}})");
        job.report().ofModel[0].u.reset();
        QCOMPARE(job.ids(), "CER-001 CER-002 CER-005 CER-008");
    }
};

DYNCAL_TEST(TestIssueObstacles)
#include "tst_issue_obstacles.moc"
