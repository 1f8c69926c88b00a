// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/recheck/finding_changes.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using FoundJson = nlohmann::json;

namespace {

FoundJson finding(const char *id, const char *severity, const FoundJson &shot = nullptr,
    const char *message = "Something is odd.")
{
    return {{"id", id}, {"severity", severity}, {"shot", shot}, {"message", message}};
}

FoundJson resultsWith(const std::vector<FoundJson> &findings)
{
    return {{"findings", findings}, {"error", nullptr}};
}

std::string idsOf(const std::vector<StatedFinding> &findings)
{
    std::string ids;
    for (const StatedFinding &one : findings)
        ids += one.id + ' ' + one.severity + ' ' + std::to_string(one.shot) + ';';
    return ids;
}

} // namespace

class TestFindingChanges : public QObject
{
    Q_OBJECT

private slots:
    void sameFindings_areNoChange()
    {
        const FoundJson results
            = resultsWith({finding("CHK-002", "caution", 1), finding("PCA-002", "info")});
        const FindingChanges changes = findingChanges(results, results);
        QVERIFY(changes.appeared.empty() && changes.gone.empty());
    }

    void otherWordsOfTheSame_areNoChange()
    {
        const FindingChanges changes
            = findingChanges(resultsWith({finding("CHK-002", "caution", 1, "3.1 U.")}),
                resultsWith({finding("CHK-002", "caution", 1, "3.2 U.")}));
        QVERIFY(changes.appeared.empty() && changes.gone.empty());
    }

    /// The recordings are given one by one now, whatever lay beside them then.
    void fileLeftOutOfAFolder_isNoChange()
    {
        const FindingChanges changes
            = findingChanges(resultsWith({finding("CAP-024", "info")}), resultsWith({}));
        QVERIFY(changes.appeared.empty() && changes.gone.empty());
    }

    /// Where no Monte Carlo was computed its findings are neither gone nor new.
    void findingsOfAMonteCarlo_areComparedWhereItWasComputed()
    {
        for (const char *id : {"SHK-012", "UNC-003"}) {
            const FoundJson with = resultsWith({finding(id, "caution", 1)});
            const FoundJson none = resultsWith({});
            QCOMPARE(findingChanges(with, none).gone.size(), std::size_t(1));
            QCOMPARE(findingChanges(none, with).appeared.size(), std::size_t(1));
            QVERIFY(findingChanges(with, none, RecheckDepth::ToEvidence).gone.empty());
            QVERIFY(findingChanges(none, with, RecheckDepth::ToEvidence).appeared.empty());
        }
        const FoundJson other = resultsWith({finding("UNC-001", "caution")});
        QCOMPARE(findingChanges(other, resultsWith({}), RecheckDepth::ToEvidence).gone.size(),
            std::size_t(1));
    }

    void whatAppearsAndGoes_isListedInItsOrder()
    {
        const FindingChanges changes = findingChanges(
            resultsWith({finding("WIN-001", "caution", 1), finding("PCA-002", "info", 2)}),
            resultsWith({finding("UNC-001", "caution"), finding("PCA-002", "info", 2),
                finding("CHK-002", "block", 3)}));
        QCOMPARE(idsOf(changes.appeared), std::string("UNC-001 caution 0;CHK-002 block 3;"));
        QCOMPARE(idsOf(changes.gone), std::string("WIN-001 caution 1;"));
    }

    void otherShotOrSeverity_isAnotherFinding()
    {
        const FindingChanges changes
            = findingChanges(resultsWith({finding("A-1", "info", 1), finding("B-1", "caution")}),
                resultsWith({finding("A-1", "info", 2), finding("B-1", "block")}));
        QCOMPARE(idsOf(changes.appeared), std::string("A-1 info 2;B-1 block 0;"));
        QCOMPARE(idsOf(changes.gone), std::string("A-1 info 1;B-1 caution 0;"));
    }

    void repeated_isCounted()
    {
        const FoundJson one = finding("A-1", "info", 1);
        const FindingChanges changes
            = findingChanges(resultsWith({one}), resultsWith({one, one, one}));
        QCOMPARE(changes.appeared.size(), std::size_t(2));
        QCOMPARE(findingChanges(resultsWith({one, one}), resultsWith({one})).gone.size(),
            std::size_t(1));
    }

    void text_namesIdSeverityAndShot()
    {
        QCOMPARE(StatedFinding({"A-1", "info", 2, "Words."}).text(),
            std::string("A-1 (info, shot 2): Words."));
        QCOMPARE(StatedFinding({"A-1", "block", 0, "Words."}).text(),
            std::string("A-1 (block): Words."));
    }

    void block_isTheErrorElseTheFirstBlockingFinding()
    {
        FoundJson results = resultsWith({finding("A-1", "caution")});
        QCOMPARE(blockOf(results), std::string());
        results["findings"].push_back(finding("CAP-007", "block", 1, "Frozen."));
        results["findings"].push_back(finding("CAP-008", "block", 1, "Flat."));
        QCOMPARE(blockOf(results), std::string("CAP-007: Frozen."));
        results["error"] = {{"stage", "window"}, {"message", "No end."}, {"finding", "WIN-003"}};
        QCOMPARE(blockOf(results), std::string("WIN-003: No end."));
        results["error"]["finding"] = nullptr;
        QCOMPARE(blockOf(results), std::string("No end."));
    }

    void oddForms_haveNoFindings()
    {
        for (const char *json : {"null", "[]", "{}", R"({"findings": 3})", R"({"error": "x"})",
                 R"({"findings": {"a": 1e300}})", R"({"findings": [[], 1, {"shot": 1e300}]})"}) {
            const FoundJson odd = FoundJson::parse(json);
            QCOMPARE(blockOf(odd), std::string());
            const FindingChanges changes = findingChanges(odd, odd);
            QVERIFY(changes.appeared.empty() && changes.gone.empty());
        }
    }
};

DYNCAL_TEST(TestFindingChanges)
#include "tst_finding_changes.moc"
