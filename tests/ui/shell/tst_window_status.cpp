// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/in_swedish.h"
#include "tests/ui/support/quick_pipeline.h"
#include "tests/ui/support/sample_results.h"
#include "ui/session/work_state.h"
#include "ui/shell/findings/findings_panel.h"
#include "ui/shell/next_steps.h"
#include "ui/shell/stage_list.h"
#include "ui/stages/frame/stage_page.h"
#include "ui/stages/frame/status_text.h"

#include <QLabel>
#include <QtTest>

using namespace dyncal;

namespace {

constexpr int kPatience_ms = 120'000;
constexpr int kCertificateRow = static_cast<int>(Page::Certificate);
constexpr int kModelRow = 7;

struct Bench : test::WindowBench
{
    explicit Bench(Session::Pipeline pipeline = test::samplePipeline)
        : WindowBench(std::move(pipeline))
    {
        window->show();
    }

    void openSample()
    {
        window->session().reset({std::make_shared<const CaptureSet>(test::sampleCaptures()), {}});
        waitComputed();
    }
    void waitComputed()
    {
        QTRY_VERIFY_WITH_TIMEOUT(!window->session().isComputing(), kPatience_ms);
    }
    /// What the stage list says below the title.
    QString listed(int row) const
    {
        return find<StageList>("stageList")->item(row)->text().section('\n', 1);
    }
    /// What the head of the page says, without its sign.
    QString head(int row) const
    {
        window->showPage(row);
        const auto *page = window->pages()[static_cast<std::size_t>(row)];
        return page->findChild<QLabel *>("pageStatus")->text().section(' ', 1);
    }
};

/// A picture of a sign, as the list shows it.
QImage signOf(const StageList &list, int row)
{
    return list.item(row)->icon().pixmap(list.iconSize()).toImage();
}

} // namespace

/// How the stages stand, as the window says it.
class TestWindowStatus : public QObject
{
    Q_OBJECT

private slots:
    void pages_areThoseOfTheTable();
    void listAndHeads_agree();
    void unstableOrder_blocksTheCertificate();
    void stopped_namesTheStageToMend();
    void faultWithoutAnId_leadsToItsPage();
    void everyBadShot_isListedAtOnce();
    void signs_differInShapeToo();
};

/// The table of pages (page_standing.h) is that of the window, in both languages.
void TestWindowStatus::pages_areThoseOfTheTable()
{
    const auto compare = [](const MainWindow &window) {
        QCOMPARE(window.pages().size(), std::size_t(kPageCount));
        for (std::size_t row = 0; row < window.pages().size(); ++row) {
            const StagePage &page = *window.pages()[row];
            QCOMPARE(page.page(), static_cast<Page>(row));
            QCOMPARE(page.stages(), stagesOf(static_cast<Page>(row)));
            QCOMPARE(pageTitle(static_cast<Page>(row)), page.text().title);
        }
    };
    compare(*Bench().window);
    Bench bench;
    bench.language.install("sv");
    QTRY_VERIFY(bench.window->pages()[1]->text().title != "Reference step");
    compare(*bench.window);
    bench.language.install("en");
    QCoreApplication::processEvents();
}

void TestWindowStatus::listAndHeads_agree()
{
    Bench bench;
    bench.openSample();
    for (int row = 0; row < kPageCount; ++row)
        QCOMPARE(bench.head(row), bench.listed(row));
    QVERIFY2(bench.listed(kCertificateRow).startsWith("not complete: "),
        qPrintable(bench.listed(kCertificateRow)));
}

/// Order 53 of the example has an unstable pole.
void TestWindowStatus::unstableOrder_blocksTheCertificate()
{
    Bench bench(test::quickPipeline());
    bench.window->files().openExample();
    QTRY_VERIFY_WITH_TIMEOUT(bench.window->session().state().hasShots(), kPatience_ms);
    bench.waitComputed();
    QVERIFY2(bench.listed(kCertificateRow).startsWith("not complete: "),
        qPrintable(bench.listed(kCertificateRow)));
    Recipe recipe = bench.window->session().recipe();
    recipe.realization.order = Index(53);
    bench.window->session().apply(recipe, "Change the order");
    bench.waitComputed();
    const Findings findings = bench.window->session().findings();
    QVERIFY(std::ranges::find(findings, "MOD-001", &Finding::id) != findings.end());
    QCOMPARE(bench.listed(kModelRow), QString("blocked"));
    QCOMPARE(bench.listed(kCertificateRow), QString("blocked by Model"));
    QCOMPARE(bench.head(kCertificateRow), QString("blocked by Model"));
    bench.window->files().exportCertificate(); // refused, as ever
    QVERIFY(!bench.prompts.shownProblems().isEmpty());
}

void TestWindowStatus::stopped_namesTheStageToMend()
{
    const auto noStep = [](const std::shared_ptr<const CaptureSet> &captures, const Recipe &recipe,
                            ResultCache &cache, StageId last, const JobControl &control) {
        const PipelineOutcome whole = test::samplePipeline(captures, recipe, cache, last, control);
        PipelineOutcome outcome;
        outcome.results.captures = whole.results.captures;
        outcome.failedStage = StageId::Window;
        outcome.error
            = Error{ErrorKind::DataBlocked, {"Shot %1 has no step.", {"2"}}, "CAP-009", 2};
        return outcome;
    };
    Bench bench(noStep);
    bench.openSample();
    QCOMPARE(bench.listed(0), QString("blocked"));
    for (int row = 2; row < kPageCount; ++row) {
        QCOMPARE(bench.listed(row), QString("blocked by Captures"));
        QCOMPARE(bench.head(row), QString("blocked by Captures"));
        const auto *problem
            = bench.window->pages()[static_cast<std::size_t>(row)]->findChild<QLabel *>(
                "pageProblem");
        QVERIFY(problem->isVisible() && problem->text().contains("Shot 2 has no step."));
    }
}

/// What stops the run in the stage of the reference transducer is mended on the page Comparison.
void TestWindowStatus::faultWithoutAnId_leadsToItsPage()
{
    const auto noFile = [](const std::shared_ptr<const CaptureSet> &captures, const Recipe &recipe,
                            ResultCache &cache, StageId, const JobControl &control) {
        PipelineOutcome outcome
            = test::samplePipeline(captures, recipe, cache, StageId::Window, control);
        outcome.failedStage = StageId::Reference;
        outcome.error = Error{ErrorKind::FileUnreadable, {"No such file.", {}}, "", 0};
        return outcome;
    };
    Bench bench(noFile);
    bench.openSample();
    QCOMPARE(bench.listed(static_cast<int>(Page::Comparison)), QString("blocked"));
    QCOMPARE(bench.listed(kCertificateRow), QString("blocked by Comparison"));
    const auto steps = nextSteps(workStateOf(bench.window->session()));
    QCOMPARE(steps.front().page, Page::Comparison);
    QVERIFY2(steps.front().text.contains("Comparison"), qPrintable(steps.front().text));
    bench.window->showPage(0);
    auto *panel = bench.window->findChild<FindingsPanel *>();
    const auto rows = panel->findItems("No such file.", Qt::MatchContains);
    QVERIFY(!rows.isEmpty());
    panel->setCurrentItem(rows.front());
    QTest::keyClick(panel, Qt::Key_Return);
    QVERIFY(bench.window->pages()[static_cast<std::size_t>(Page::Comparison)]->isVisible());
}

/// Three shots with faults are three findings that block, not one after the other.
void TestWindowStatus::everyBadShot_isListedAtOnce()
{
    const auto bad = [](const std::shared_ptr<const CaptureSet> &captures, const Recipe &recipe,
                         ResultCache &cache, StageId last, const JobControl &control) {
        PipelineOutcome outcome;
        outcome.results.captures
            = test::samplePipeline(captures, recipe, cache, last, control).results.captures;
        outcome.failedStage = StageId::Window;
        const auto error = [](const char *id, Index shot) {
            return Error{
                ErrorKind::DataBlocked, {"Shot %1 is bad.", {std::to_string(shot)}}, id, shot};
        };
        outcome.error = asOneError({error("CAP-006", 1), error("CAP-007", 2), error("CAP-006", 3)});
        return outcome;
    };
    Bench bench(bad);
    bench.openSample();
    int blocks = 0;
    for (const Finding &finding : bench.window->session().findings())
        blocks += finding.severity == Severity::Block;
    QCOMPARE(blocks, 3);
    const auto *panel = bench.find<QListWidget>("findingsPanel");
    QVERIFY2(panel->item(0)->text().startsWith("■ Blocked CAP-006, shots 1 and 3: "),
        qPrintable(panel->item(0)->text()));
    QVERIFY(bench.window->findChild<QWidget *>("show_CAP-007_1"));
}

/// Colour tells nothing alone: no two signs have the same outline in grey.
void TestWindowStatus::signs_differInShapeToo()
{
    StageList list;
    std::vector<QImage> shapes;
    using enum StageStatus;
    const auto all = {NotStarted, Blocked, Computing, Stale, Incomplete, Done, DoneWithCautions};
    for (int row = 0; row < std::ssize(all); ++row) {
        list.addStage("stage");
        PageStanding standing;
        standing.status = *(all.begin() + row);
        standing.emptyFields = 1;
        list.setStanding(row, standing);
        shapes.push_back(signOf(list, row).createAlphaMask());
        for (int other = 0; other < row; ++other)
            QVERIFY2(shapes[static_cast<std::size_t>(other)] != shapes.back(),
                qPrintable(QString("%1 %2").arg(other).arg(row)));
    }
}

DYNCAL_TEST(TestWindowStatus)
#include "tst_window_status.moc"
