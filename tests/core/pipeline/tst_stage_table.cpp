// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/stage_table.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <set>

using namespace dyncal;

namespace {

Finding finding(const char *id, Severity severity, Index shot = 0, const char *channel = "")
{
    Finding said;
    said.id = id;
    said.severity = severity;
    said.shot = shot;
    said.channel = channel;
    return said;
}

} // namespace

class TestStageTable : public QObject
{
    Q_OBJECT

private slots:
    void everyStage_hasItsLine()
    {
        std::set<std::string> names;
        for (int i = 0; i < kStageCount; ++i) {
            const Stage &stage = stageOf(static_cast<StageId>(i));
            QCOMPARE(static_cast<int>(stage.id), i);
            QVERIFY(names.insert(stage.name).second);
            QVERIFY(stage.method >= 1);
            QVERIFY(stage.cost_ms > 0.0);
        }
    }

    void emptyResults_haveNothingAndSayNothing()
    {
        const CalibrationResults none;
        for (int i = 0; i < kStageCount; ++i) {
            QVERIFY(!hasResult(none, static_cast<StageId>(i)));
            QVERIFY(findingsOf(none, static_cast<StageId>(i)).empty());
        }
        QVERIFY(allFindings(none).empty());
    }

    void findingId_leadsToTheStageOfItsPrefix()
    {
        QCOMPARE(stageOfFinding("CAP-015"), std::optional(StageId::Captures));
        QCOMPARE(stageOfFinding("ORD-001"), std::optional(StageId::Decomposition));
        QCOMPARE(stageOfFinding("MOD-011"), std::optional(StageId::Model));
        QVERIFY(!stageOfFinding("XYZ-001"));
        QVERIFY(!stageOfFinding("CAP"));
        QVERIFY(!stageOfFinding(""));
    }

    /// A later stage that says of the same channel what an earlier one said is not heard twice,
    /// unless it is graver.
    void allFindings_inStageOrder_eachOnce()
    {
        CalibrationResults results;
        auto captures = std::make_shared<PreparedCaptures>();
        captures->findings = {finding("CAP-001", Severity::Caution, 1, "a"),
            finding("CAP-002", Severity::Info, 1, "a"), finding("CAP-003", Severity::Info)};
        results.captures = captures;
        auto window = std::make_shared<WindowResult>();
        window->findings = {finding("CAP-001", Severity::Caution, 1, "a"), // told
            finding("CAP-001", Severity::Caution, 2, "a"), // another shot
            finding("CAP-002", Severity::Caution, 1, "a"), // graver
            finding("CAP-003", Severity::Info), // of no channel: both stay
            finding("WIN-001", Severity::Info)};
        results.window = window;

        QStringList ids;
        for (const Finding &told : allFindings(results))
            ids << QString::fromStdString(told.id);
        QCOMPARE(ids,
            QStringList(
                {"CAP-001", "CAP-002", "CAP-003", "CAP-001", "CAP-002", "CAP-003", "WIN-001"}));
    }
};

DYNCAL_TEST(TestStageTable)
#include "tst_stage_table.moc"
