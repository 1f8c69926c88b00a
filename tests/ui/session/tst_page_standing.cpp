// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/stage_table.h"
#include "tests/support/test_program.h"
#include "ui/session/page_standing.h"

#include <QtTest>

using namespace dyncal;

namespace {

/// A run that came to its end and found nothing, with every field filled in.
WorkState settled()
{
    WorkState work;
    work.stages.fill(StageStatus::Done);
    return work;
}

WorkState with(std::initializer_list<Finding> findings)
{
    WorkState work = settled();
    work.findings = findings;
    return work;
}

Finding finding(const char *id, Severity severity, Index shot = 0)
{
    return {.id = id, .severity = severity, .shot = shot, .message = {"A sentence.", {}}};
}

/// A run that ended in a stage, by an error of which the findings say the id.
WorkState stoppedAt(StageId stage, const char *id)
{
    WorkState work = with({finding(id, Severity::Block)});
    work.stopped = true;
    work.failedStage = stage;
    for (int i = static_cast<int>(stage); i < kStageCount; ++i)
        work.stages[static_cast<std::size_t>(i)] = StageStatus::Blocked;
    return work;
}

WorkState withFields(WorkState work, int empty, int wrong)
{
    work.unfilled.resize(static_cast<std::size_t>(empty + wrong));
    for (int i = 0; i < wrong; ++i)
        work.unfilled[static_cast<std::size_t>(i)].wrong = true;
    return work;
}

WorkState accepted(WorkState work, const char *id, Index shot)
{
    work.accepted.push_back({id, shot, "looked at"});
    return work;
}

} // namespace

class TestPageStanding : public QObject
{
    Q_OBJECT

private slots:
    void page_stands_data();
    void page_stands();
    void everyStage_whileItRuns_isOnItsPage();
    void everyPrefix_ofTheCatalogue_hasAPage();
    void blockOf_isTheFindingThatTheStandingSpeaksOf();
};

void TestPageStanding::page_stands_data()
{
    using enum StageStatus;
    QTest::addColumn<WorkState>("work");
    QTest::addColumn<int>("page");
    QTest::addColumn<PageStanding>("wanted");
    const auto row = [](const char *name, const WorkState &work, Page page, PageStanding wanted) {
        QTest::newRow(name) << work << static_cast<int>(page) << wanted;
    };
    const Severity block = Severity::Block;
    const Severity caution = Severity::Caution;
    using enum Page;

    row("nothing open", {}, Certificate, {.status = NotStarted});
    row("all done", settled(), Certificate, {.status = Done});
    row("info only", with({finding("SPC-001", Severity::Info)}), Spectrum, {.status = Done});

    row("own block", with({finding("CAP-008", block)}), Captures, {.status = Blocked});
    row("block before", with({finding("CAP-008", block)}), Window,
        {.status = Blocked, .blockedBy = Captures});
    row("block does not reach back", with({finding("WIN-002", block)}), Captures, {.status = Done});
    row("step does not carry the window", with({finding("SHK-001", block)}), Window,
        {.status = Done});
    row("unstable model", with({finding("MOD-001", block)}), Page::Model, {.status = Blocked});
    row("unstable model, where it is chosen", with({finding("MOD-001", block)}), Order,
        {.status = Blocked});
    row("unstable model, before it", with({finding("MOD-001", block)}), Shock, {.status = Done});
    row("unstable model, certificate", with({finding("MOD-001", block)}), Certificate,
        {.status = Blocked, .blockedBy = Page::Model});
    row("step blocked, certificate", with({finding("SHK-001", block)}), Certificate,
        {.status = Blocked, .blockedBy = Shock});

    const WorkState noStep = stoppedAt(StageId::Window, "CAP-009");
    row("stopped by captures: captures", noStep, Captures, {.status = Blocked});
    row("stopped by captures: window", noStep, Page::Window,
        {.status = Blocked, .blockedBy = Captures});
    row("stopped by captures: order", noStep, Order, {.status = Blocked, .blockedBy = Captures});
    row("stopped by captures: certificate", withFields(noStep, 12, 0), Certificate,
        {.status = Blocked, .blockedBy = Captures, .emptyFields = 12});
    const WorkState tooSlow = stoppedAt(StageId::ModelInput, "MIN-001");
    row("stopped by model input: itself", tooSlow, Page::ModelInput, {.status = Blocked});
    row("stopped by model input: spectrum stands", tooSlow, Spectrum, {.status = Done});
    row("stopped by model input: model", tooSlow, Page::Model,
        {.status = Blocked, .blockedBy = Page::ModelInput});
    WorkState internal = stoppedAt(StageId::Components, "");
    row("stopped without id: itself", internal, Page::Components, {.status = Blocked});
    row("stopped without id: after", internal, Order,
        {.status = Blocked, .blockedBy = Page::Components});
    internal.findings.clear(); // an error that nobody is told of
    row("stopped without a word", internal, Order,
        {.status = Blocked, .blockedBy = Page::Components});

    const WorkState careful
        = with({finding("WIN-001", caution, 2), finding("WIN-001", caution, 3)});
    row("cautions", careful, Page::Window, {.status = DoneWithCautions, .cautions = 2});
    row("cautions elsewhere", careful, Spectrum, {.status = Done});
    row("cautions of all, certificate", careful, Certificate,
        {.status = DoneWithCautions, .cautions = 2});
    row("one accepted", accepted(careful, "WIN-001", 2), Page::Window,
        {.status = DoneWithCautions, .cautions = 1});
    row("accepted for all shots", accepted(careful, "WIN-001", 0), Page::Window, {.status = Done});
    row("a block is never accepted", accepted(with({finding("CAP-007", block, 1)}), "CAP-007", 1),
        Captures, {.status = Blocked});

    row("empty fields", withFields(settled(), 12, 0), Certificate,
        {.status = Incomplete, .emptyFields = 12});
    row("a date that is none", withFields(settled(), 0, 1), Certificate,
        {.status = Incomplete, .wrongFields = 1});
    row("empty fields and cautions", withFields(careful, 3, 0), Certificate,
        {.status = Incomplete, .cautions = 2, .emptyFields = 3});

    WorkState computing = withFields(settled(), 12, 0);
    computing.stages[static_cast<std::size_t>(StageId::Model)] = Computing;
    row("computing: model", computing, Page::Model, {.status = Computing});
    row("computing: certificate", computing, Certificate, {.status = Computing});
    row("computing: captures", computing, Captures, {.status = Done});
    computing.stages[static_cast<std::size_t>(StageId::Model)] = Stale;
    row("out of date: certificate", computing, Certificate, {.status = Stale});
}

void TestPageStanding::page_stands()
{
    QFETCH(WorkState, work);
    QFETCH(int, page);
    QFETCH(PageStanding, wanted);
    const PageStanding found = standingOf(static_cast<Page>(page), work);
    QCOMPARE(found.status, wanted.status);
    QCOMPARE(found.blockedBy, wanted.blockedBy);
    QVERIFY(found == wanted);
}

/// Whatever runs late is seen on a page, and the certificate is never done before it.
void TestPageStanding::everyStage_whileItRuns_isOnItsPage()
{
    for (int i = 0; i < kStageCount; ++i) {
        WorkState work = settled();
        work.stages[static_cast<std::size_t>(i)] = StageStatus::Stale;
        QCOMPARE(standingOf(Page::Certificate, work).status, StageStatus::Stale);
    }
}

void TestPageStanding::everyPrefix_ofTheCatalogue_hasAPage()
{
    for (const char *prefix :
        {"CAP", "SHK", "FIL", "WIN", "SPC", "PCA", "MIN", "NUI", "ORD", "MOD", "RSP", "PRJ"})
        QVERIFY2(pageOfFinding(std::string(prefix) + "-001"), prefix);
    QVERIFY(!pageOfFinding(""));
}

void TestPageStanding::blockOf_isTheFindingThatTheStandingSpeaksOf()
{
    const WorkState work = with({finding("SHK-009", Severity::Block),
        finding("MOD-001", Severity::Block), finding("MOD-002", Severity::Caution)});
    QCOMPARE(blockOf(Page::Model, work)->id, std::string("MOD-001"));
    QCOMPARE(blockOf(Page::Certificate, work)->id, std::string("SHK-009"));
    QVERIFY(!blockOf(Page::Captures, work));
}

DYNCAL_TEST(TestPageStanding)
#include "tst_page_standing.moc"
