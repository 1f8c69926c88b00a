// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "tests/support/file_bytes.h"
#include "tests/support/test_program.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/event_loop_watchdog.h"
#include "tests/ui/support/quick_pipeline.h"
#include "ui/session/example.h"
#include "ui/shell/files/file_actions.h"
#include "ui/stages/frame/stage_page.h"

#include <QAction>
#include <QDir>
#include <QSignalSpy>
#include <QtTest>

using namespace dyncal;
using testing::bytesOf;

namespace {

constexpr int kPatience_ms = 60'000;
constexpr double kDuration_s = 0.004;

} // namespace

/// Plots as files, one and all of them.
class TestPlotExport : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void allPlots_ofAllPages_inOrder();
    void allPlots_again_replaceNothing();
    void allPlots_anotherLanguageMeanwhile_ends();
    void allPlots_intoUnwritableFolder_saysSo();
    void onePlot_isWritten_asItsNameSays();
    void onePlot_overARecording_isRefused();
    void onePlot_ofAnUnknownFormat_isRefused();
    void outOfDate_isNotWritten(); // the last: it changes the settings

private:
    Session &session() { return m_bench.window->session(); }
    QString file(const QString &name) const { return m_bench.folder.filePath(name); }
    QStringList lastProblems(qsizetype before) const
    {
        return m_bench.prompts.shownProblems().mid(before);
    }
    void saveAll(const QString &folder)
    {
        m_bench.prompts.setNextFile(folder);
        m_bench.find<QAction>("saveAllPlotsAction")->trigger();
    }

    test::WindowBench m_bench{test::quickPipeline()};
};

void TestPlotExport::initTestCase()
{
    const Result<CaptureSet> example = exampleCaptures({}, kDuration_s);
    QVERIFY(example);
    QVERIFY(writeHdf5Capture(
        *example, {file("shots.h5").toStdString()}, "2026-01-31T12:00:00Z", "Three shots."));
    m_bench.window->resize(1366, 768);
    m_bench.window->show();
    m_bench.window->files().openPaths({file("shots.h5")});
    QTRY_VERIFY_WITH_TIMEOUT(session().state().hasShots() && session().isUpToDate(), kPatience_ms);
    QVERIFY(!session().error());
}

void TestPlotExport::allPlots_ofAllPages_inOrder()
{
    QDir().mkdir(file("plots"));
    const QSignalSpy finished(&m_bench.window->files(), &FileActions::idle);
    test::EventLoopWatchdog watchdog;
    saveAll(file("plots"));
    QTRY_VERIFY_WITH_TIMEOUT(!finished.isEmpty(), kPatience_ms);
    qsizetype expected = 0;
    for (const StagePage *page : m_bench.window->pages())
        for (const PlotWidget *plot : page->plots())
            expected += plot->content().curves.empty() ? 0 : 1;
    QVERIFY(expected > 15);
    QCOMPARE(QDir(file("plots")).entryList(QDir::Files).size(), expected);
    qInfo("longest time without an answer: %lld ms (aim 100 ms)", watchdog.longestGap_ms());
    const QStringList names = QDir(file("plots")).entryList(QDir::Files, QDir::Name);
    QCOMPARE(names.first(), QString("01-raw-dut.svg"));
    QVERIFY2(names.filter("singular-value").size() == 1, qPrintable(names.join(' ')));
    for (qsizetype i = 0; i < names.size(); ++i) {
        QVERIFY(names[i].startsWith(QString("%1-").arg(i + 1, 2, 10, QLatin1Char('0'))));
        const QByteArray svg = bytesOf(file("plots/" + names[i]));
        QVERIFY(svg.contains("<svg") && svg.contains("</svg>"));
    }
}

void TestPlotExport::allPlots_again_replaceNothing()
{
    const QString last = file("plots/02-raw-side.svg");
    QFile other(last);
    QVERIFY(other.open(QIODevice::WriteOnly) && other.write("mine") == 4);
    other.close();
    const qsizetype before = m_bench.prompts.shownProblems().size();
    saveAll(file("plots"));
    QTRY_COMPARE_WITH_TIMEOUT(lastProblems(before).size(), qsizetype(1), kPatience_ms);
    QVERIFY2(lastProblems(before).first().contains("01-raw-dut.svg"),
        qPrintable(lastProblems(before).first()));
    QTest::qWait(50);
    QCOMPARE(bytesOf(last), QByteArray("mine"));
}

/// The pages are built anew for a language: those that were to be written are gone.
void TestPlotExport::allPlots_anotherLanguageMeanwhile_ends()
{
    test::WindowBench bench{test::quickPipeline()};
    bench.window->show();
    bench.window->files().openPaths({file("shots.h5")});
    QTRY_VERIFY_WITH_TIMEOUT(
        bench.window->session().state().hasShots() && bench.window->session().isUpToDate(),
        kPatience_ms);
    const QDir folder(bench.folder.filePath("cut short"));
    QVERIFY(folder.mkpath("."));
    const QSignalSpy finished(&bench.window->files(), &FileActions::idle);
    bench.prompts.setNextFile(folder.path());
    bench.find<QAction>("saveAllPlotsAction")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!folder.entryList(QDir::Files).isEmpty(), kPatience_ms);
    bench.find<QAction>("languageAction_sv")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!finished.isEmpty(), kPatience_ms);
    bench.find<QAction>("languageAction_en")->trigger();
    QVERIFY(folder.entryList(QDir::Files).size() < 15);
}

void TestPlotExport::allPlots_intoUnwritableFolder_saysSo()
{
    const qsizetype before = m_bench.prompts.shownProblems().size();
    saveAll(file("shots.h5/plots")); // within a file
    QTRY_COMPARE_WITH_TIMEOUT(lastProblems(before).size(), qsizetype(1), kPatience_ms);
    QVERIFY2(lastProblems(before).first().contains("01-raw-dut.svg"),
        qPrintable(lastProblems(before).first()));
}

void TestPlotExport::onePlot_isWritten_asItsNameSays()
{
    auto *plot = m_bench.find<PlotWidget>("rawPlot_dut");
    for (const auto &[name, begin] : {std::pair{"a.svg", "<?xml"}, {"a.png", "\x89PNG"},
             {"a.pdf", "%PDF"}, {"a.csv", "Time"}, {"b", "<?xml"}}) {
        m_bench.prompts.setNextFile(file(name));
        emit plot->exportRequested();
        const QString written = file(QString(name) == "b" ? "b.svg" : name);
        QVERIFY2(
            bytesOf(written).startsWith(begin), qPrintable(m_bench.prompts.shownProblems().last()));
    }
}

void TestPlotExport::onePlot_overARecording_isRefused()
{
    const QByteArray recording = bytesOf(file("shots.h5"));
    QVERIFY(QFile::link(file("shots.h5"), file("link.svg")));
    for (const char *name : {"shots.h5", "link.svg"}) {
        const qsizetype before = m_bench.prompts.shownProblems().size();
        m_bench.prompts.setNextFile(file(name));
        emit m_bench.find<PlotWidget>("rawPlot_dut")->exportRequested();
        QCOMPARE(lastProblems(before).size(), 1);
        QCOMPARE(bytesOf(file("shots.h5")), recording);
    }
}

void TestPlotExport::onePlot_ofAnUnknownFormat_isRefused()
{
    const qsizetype before = m_bench.prompts.shownProblems().size();
    m_bench.prompts.setNextFile(file("a.gif"));
    emit m_bench.find<PlotWidget>("rawPlot_dut")->exportRequested();
    QCOMPARE(lastProblems(before).size(), 1);
    QVERIFY2(
        lastProblems(before).first().contains("a.gif"), qPrintable(lastProblems(before).first()));
    QVERIFY(!QFile::exists(file("a.gif")));
}

void TestPlotExport::outOfDate_isNotWritten()
{
    Recipe blocked = session().recipe();
    blocked.window.baseline_s = Interval{1e-5, 2e-5}; // over the step
    session().apply(blocked, "Break it");
    m_bench.window->showPage(2);
    auto *plot = m_bench.find<PlotWidget>("windowPlot");
    QTRY_VERIFY_WITH_TIMEOUT(
        !session().isComputing() && session().error() && !plot->notice().isEmpty(), kPatience_ms);
    const qsizetype before = m_bench.prompts.shownProblems().size();
    m_bench.prompts.setNextFile(file("old.svg"));
    emit plot->exportRequested();
    QCOMPARE(lastProblems(before).size(), 1);
    QVERIFY2(lastProblems(before).first().contains(plot->notice()),
        qPrintable(lastProblems(before).first()));
    QVERIFY(!QFile::exists(file("old.svg")));
}

DYNCAL_TEST(TestPlotExport)
#include "tst_plot_export.moc"
