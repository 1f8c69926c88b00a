// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "core/capture/opening/capture_open.h"
#include "core/certificate/certificate.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/layout_faults.h"
#include "tests/ui/support/quick_pipeline.h"
#include "ui/session/example.h"
#include "ui/session/work_state.h"
#include "ui/shell/banner/banner.h"
#include "ui/shell/findings/problem_panel.h"
#include "ui/shell/stage_list.h"
#include "ui/stages/frame/stage_page.h"
#include "ui/text/core_text.h"

#include <QDialog>
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QtTest>

using namespace dyncal;

namespace {

constexpr int kPatience_ms = 60'000;
constexpr int kSeen_ms = 2000; ///< so soon a change is known
constexpr double kDuration_s = 0.004;
constexpr int kHarms = 4;

} // namespace

/// A recording is changed, cut, removed or replaced while a page shows it.
class TestChangedSources : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void everyPage_everyHarm_isSaidAndNothingIsExported();
    void readAgain_ofWhatCannotBeRead_keepsTheJob();
    void movedRecordings_areLocated();
    void otherRecordingOfTheName_isNotTakenForIt();
    void projectOfMovedRecordings_isLocatedFolderByFolder();
    void projectWithoutItsRecordings_showsTheKeptResults();
    void exampleHasNoFiles_andNoNotice();

private:
    Session &session() { return m_bench.window->session(); }
    QString file(const QString &name) const { return m_bench.folder.filePath(name); }
    QString recording(int shot) const { return file(QString("shot_%1.h5").arg(shot)); }
    Banner &banner() const { return *m_bench.find<Banner>("sourceBanner"); }
    QString sentence() const { return m_bench.find<QLabel>("sourceSentence")->text(); }
    void click(const char *name) { banner().findChild<QPushButton *>(name)->click(); }

    void writeRecordings();
    void harm(int kind, const QString &path);
    void expectRefused();
    void putBackAndReadAgain();
    void waitForResults();
    void expectSettled();

    test::WindowBench m_bench{test::quickPipeline()};
    std::string m_results; ///< key of the last stage
};

void TestChangedSources::writeRecordings()
{
    const Result<CaptureSet> example = exampleCaptures({}, kDuration_s);
    QVERIFY(example);
    for (std::size_t i = 0; i < example->shots.size(); ++i) {
        CaptureSet one;
        one.shots = {example->shots[i]};
        const QString path = recording(static_cast<int>(i) + 1);
        QVERIFY(writeHdf5Capture(one, {path.toStdString()}, "2026-01-31T12:00:00Z", "A shot."));
        QVERIFY(QFile::copy(path, path + ".kept"));
    }
}

void TestChangedSources::waitForResults()
{
    QTRY_VERIFY_WITH_TIMEOUT(session().state().hasShots() && session().isUpToDate(), kPatience_ms);
    QVERIFY2(
        !session().error(), session().error() ? english(session().error()->message).c_str() : "");
}

void TestChangedSources::initTestCase()
{
    writeRecordings();
    m_bench.window->resize(1366, 768);
    m_bench.window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_bench.window.get()));
    m_bench.window->files().openPaths({recording(1), recording(2), recording(3)});
    waitForResults();
    m_results = session().results().keys[kStageCount - 1];
    QVERIFY(!banner().isVisible());
}

/// Changed, cut, removed, or another recording in its place.
void TestChangedSources::harm(int kind, const QString &path)
{
    QFile harmed(path);
    switch (kind) {
    case 0:
        QVERIFY(harmed.open(QIODevice::ReadWrite) && harmed.seek(harmed.size() / 2));
        QVERIFY(harmed.write("x") == 1);
        break;
    case 1:
        QVERIFY(harmed.resize(harmed.size() / 3));
        break;
    case 2:
        QVERIFY(harmed.remove());
        break;
    default:
        QVERIFY(harmed.remove() && QFile::copy(recording(1) + ".kept", path));
        break;
    }
}

void TestChangedSources::expectRefused()
{
    const QString folder = file("out");
    QDir().mkdir(folder);
    FileActions &files = m_bench.window->files();
    const qsizetype before = m_bench.prompts.shownProblems().size();
    for (const auto exports :
        {&FileActions::exportResults, &FileActions::exportCertificate, &FileActions::exportModel}) {
        m_bench.prompts.setNextFile(
            folder + (exports == &FileActions::exportCertificate ? "/c.pdf" : ""));
        (files.*exports)();
        m_bench.prompts.dropAnswers();
        QTRY_VERIFY_WITH_TIMEOUT(!files.isBusy(), kPatience_ms);
    }
    const QStringList problems = m_bench.prompts.shownProblems().mid(before);
    QCOMPARE(problems, QStringList(3, sentence()));
    QVERIFY(QDir(folder).isEmpty());
}

void TestChangedSources::putBackAndReadAgain()
{
    for (int shot = 1; shot <= 3; ++shot) {
        QFile::remove(recording(shot));
        QVERIFY(QFile::copy(recording(shot) + ".kept", recording(shot)));
    }
    QTRY_VERIFY_WITH_TIMEOUT(banner().isVisible(), kSeen_ms);
    click("readAgain");
    QTRY_VERIFY_WITH_TIMEOUT(!m_bench.window->files().isBusy(), kPatience_ms);
    expectSettled();
}

/// The results are the earlier ones, and may be exported.
void TestChangedSources::expectSettled()
{
    waitForResults();
    QTest::qWait(kSeen_ms);
    QVERIFY2(!banner().isVisible(), qPrintable(sentence()));
    QCOMPARE(session().results().keys[kStageCount - 1], m_results);
    QVERIFY(m_bench.find<ProblemPanel>("problemPanel")->problems().empty());
}

void TestChangedSources::everyPage_everyHarm_isSaidAndNothingIsExported()
{
    const auto pages = static_cast<int>(m_bench.window->pages().size());
    const int rounds = trials::count(kHarms, kHarms * pages);
    for (int round = 0; round < rounds; ++round) {
        m_bench.window->showPage(trials::count(2 * round + 1, round / kHarms));
        const QString path = recording(2 + round % 2);
        harm(round % kHarms, path);
        QTRY_VERIFY_WITH_TIMEOUT(banner().isVisible(), kSeen_ms);
        QVERIFY2(sentence().contains(path), qPrintable(sentence()));
        const WorkState work = workStateOf(session());
        QCOMPARE(standingOf(Page::Captures, work).status, StageStatus::Blocked);
        QCOMPARE(standingOf(Page::Certificate, work).status, StageStatus::Blocked);
        const QStringList faults = test::LayoutFaults(*m_bench.window).found();
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join("\n")));
        const StagePage *page = m_bench.window->pages()[static_cast<std::size_t>(
            m_bench.find<StageList>("stageList")->currentRow())];
        QVERIFY(page->findChild<QLabel *>("pageStatus")->text().contains("blocked"));
        expectRefused();
        putBackAndReadAgain();
        if (QTest::currentTestFailed())
            return;
    }
    std::printf("changed sources: %d rounds\n", rounds);
}

void TestChangedSources::readAgain_ofWhatCannotBeRead_keepsTheJob()
{
    harm(1, recording(2));
    QTRY_VERIFY_WITH_TIMEOUT(banner().isVisible(), kSeen_ms);
    click("readAgain");
    QTRY_COMPARE_WITH_TIMEOUT(
        m_bench.find<ProblemPanel>("problemPanel")->problems().size(), 1U, kPatience_ms);
    QCOMPARE(session().state().captures->shots.size(), 3U);
    QVERIFY(banner().isVisible());
    putBackAndReadAgain();
}

void TestChangedSources::movedRecordings_areLocated()
{
    const QString elsewhere = file("elsewhere");
    QVERIFY(QDir().mkdir(elsewhere));
    for (int shot = 2; shot <= 3; ++shot)
        QVERIFY(QFile::rename(recording(shot), elsewhere + QString("/shot_%1.h5").arg(shot)));
    QTRY_VERIFY_WITH_TIMEOUT(banner().isVisible(), kSeen_ms);
    QTRY_VERIFY_WITH_TIMEOUT(sentence().contains("1 more file"), kSeen_ms);
    m_bench.prompts.setNextFile(elsewhere);
    click("locateRecordings");
    QTRY_VERIFY_WITH_TIMEOUT(!m_bench.window->files().isBusy(), kPatience_ms);
    expectSettled();
    const auto &inputs = session().state().captures->inputs;
    QCOMPARE(inputs[0].path, recording(1).toStdString());
    QCOMPARE(inputs[2].path, (elsewhere + "/shot_3.h5").toStdString());

    session().undoStack().undo(); // back to files that are not there
    QTRY_VERIFY_WITH_TIMEOUT(banner().isVisible(), kSeen_ms);
    session().undoStack().redo();
    expectSettled();
}

/// The file that is found is another recording: it blocks, as in a project.
void TestChangedSources::otherRecordingOfTheName_isNotTakenForIt()
{
    const QString other = file("other");
    QVERIFY(QDir().mkdir(other));
    QVERIFY(QFile::copy(recording(1) + ".kept", other + "/shot_2.h5"));
    QVERIFY(QFile::remove(file("elsewhere/shot_2.h5")));
    QTRY_VERIFY_WITH_TIMEOUT(banner().isVisible(), kSeen_ms);
    m_bench.prompts.setNextFile(other);
    click("locateRecordings");
    QTRY_VERIFY_WITH_TIMEOUT(!m_bench.window->files().isBusy(), kPatience_ms);
    waitForResults();
    QVERIFY(std::ranges::any_of(session().findings(), [](const Finding &finding) {
        return finding.id == "CAP-015" && finding.severity == Severity::Block;
    }));
    QCOMPARE(standingOf(Page::Certificate, workStateOf(session())).status, StageStatus::Blocked);
}

void TestChangedSources::projectOfMovedRecordings_isLocatedFolderByFolder()
{
    std::vector<std::string> paths;
    for (int shot = 1; shot <= 3; ++shot) {
        QFile::remove(recording(shot));
        QVERIFY(QFile::copy(recording(shot) + ".kept", recording(shot)));
        paths.push_back(recording(shot).toStdString());
    }
    const Result<CaptureSet> read = readCaptures(paths, {});
    QVERIFY(read);
    const QString project = file("job.dyncal");
    QVERIFY(saveProject(project, {std::make_shared<const CaptureSet>(*read), {}}, {}));
    for (int shot = 1; shot <= 3; ++shot) {
        const QString place = file(shot == 3 ? "place_2" : "place_1");
        QVERIFY(QDir().mkpath(place));
        QVERIFY(QFile::rename(recording(shot), place + QString("/shot_%1.h5").arg(shot)));
    }

    FileActions &files = m_bench.window->files();
    session().undoStack().setClean();
    const auto before = session().state().captures;
    files.openProjectFile(project); // and no: what is open stays
    QTRY_VERIFY_WITH_TIMEOUT(!files.isBusy(), kPatience_ms);
    QCOMPARE(session().state().captures, before);
    QVERIFY(m_bench.prompts.shownProblems().last().contains(recording(1)));

    for (const char *place : {"place_1", "place_2"}) {
        m_bench.prompts.setNextMissing(MissingRecordings::Locate);
        m_bench.prompts.setNextFile(file(place));
    }
    files.openProjectFile(project);
    QTRY_COMPARE_WITH_TIMEOUT(files.projectPath(), project, kPatience_ms);
    QVERIFY(!m_bench.prompts.shownProblems().last().contains(recording(1)));
    QVERIFY(m_bench.prompts.shownProblems().last().contains(recording(3)));
    QVERIFY(files.isModified()); // where they are now
    waitForResults();
    QVERIFY(!banner().isVisible());
    QCOMPARE(session().results().keys[kStageCount - 1], m_results);
}

/// The words and numbers of the certificate, as they stood when the project was saved.
void TestChangedSources::projectWithoutItsRecordings_showsTheKeptResults()
{
    FileActions &files = m_bench.window->files();
    QVERIFY(files.save());
    const CertificateData certificate
        = makeCertificate(session().results(), session().recipe(), "2026-01-31T12:00:00Z");
    QVERIFY(QDir(file("place_1")).removeRecursively());
    m_bench.prompts.setNextMissing(MissingRecordings::ViewResults);
    files.openProjectFile(files.projectPath());
    QTRY_VERIFY_WITH_TIMEOUT(
        m_bench.window->findChild<QTreeWidget *>("keptResultsTree"), kPatience_ms);
    const auto *tree = m_bench.find<QTreeWidget>("keptResultsTree");
    QCOMPARE(tree->topLevelItemCount(), static_cast<int>(certificate.sections.size()));
    int values = 0;
    for (const CertificateSection &section : certificate.sections)
        for (const CertificateField &field : section.fields) {
            const auto found
                = tree->findItems(translated(field.label), Qt::MatchExactly | Qt::MatchRecursive);
            QVERIFY(std::ranges::any_of(found, [&](const QTreeWidgetItem *item) {
                return item->text(1) == translated(field.value);
            }));
            ++values;
        }
    QVERIFY(values > 20);
    m_bench.find<QDialog>("keptResults")->close();
}

void TestChangedSources::exampleHasNoFiles_andNoNotice()
{
    session().undoStack().setClean();
    m_bench.window->files().setExampleDuration(kDuration_s);
    m_bench.window->files().openExample();
    QTRY_VERIFY_WITH_TIMEOUT(session().state().captures->inputs.size() == 1, kPatience_ms);
    QTest::qWait(kSeen_ms);
    QVERIFY(!banner().isVisible());
}

DYNCAL_TEST(TestChangedSources)
#include "tst_changed_sources.moc"
