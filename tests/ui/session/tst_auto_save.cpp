// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/support/sample_results.h"
#include "ui/session/auto_save.h"
#include "ui/session/project_file.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

using namespace dyncal;
using namespace std::chrono_literals;

namespace {

/// A second passes with every look at it.
struct Clock
{
    std::shared_ptr<int> seconds = std::make_shared<int>(0);

    QDateTime time(int second) const
    {
        return QDateTime::fromString("2026-01-31T12:00:00Z", Qt::ISODate).addSecs(second);
    }
    Result<std::string> operator()() const
    {
        return time(++*seconds).toString(Qt::ISODate).toStdString();
    }
};

/// A session over formula results whose unsaved work is kept in a folder of the test's own.
struct Bench
{
    QTemporaryDir folder;
    Clock clock;
    Session session{test::samplePipeline};
    RecoveryStore store;
    AutoSave autoSave;
    int order = 2;

    explicit Bench(const AutoSaveDelays &delays = {20ms, 200ms, 1h})
        : store(folder.filePath("recovery"))
        , autoSave(session, store, clock, delays)
    {
        session.reset({std::make_shared<const CaptureSet>(test::sampleCaptures()), {}});
    }

    void edit(const QString &mergeKey = {})
    {
        Recipe next = session.recipe();
        next.realization.order = ++order;
        session.apply(next, "Order", mergeKey);
    }
    bool hasFile() const { return QFile::exists(*store.file()); }
    Index keptOrder() const
    {
        const Result<ProjectFile> project = readProjectFile(*store.file());
        if (!project)
            return 0;
        const Result<Recipe> recipe = recipeOfProject(project->content);
        return recipe ? recipe->realization.order.value.value_or(0) : 0;
    }
};

} // namespace

class TestAutoSave : public QObject
{
    Q_OBJECT

private slots:
    void openedJob_withoutChanges_keepsNothing();
    void change_afterARest_isKeptWithItsProject();
    void changes_withoutARest_areKeptAtLatest();
    void saved_removesTheFile();
    void undoneToTheSavedState_removesTheFile();
    void anotherJob_removesTheFile();
    void projectSavedElsewhere_isNoted();
    void sealed_recordingsGetTheirHash();
    void signsOfLife_goOnWithoutChanges();
    void failure_isToldAndTriedAgain();
    void unusableFolder_isTold();
    void end_removesTheFileAndKeepsNothingMore();
    void adopted_goesOnInThatFile();
};

void TestAutoSave::openedJob_withoutChanges_keepsNothing()
{
    Bench bench;
    QTest::qWait(100);
    QVERIFY(!bench.hasFile());
}

void TestAutoSave::change_afterARest_isKeptWithItsProject()
{
    Bench bench;
    QSignalSpy saved(&bench.autoSave, &AutoSave::saved);
    bench.autoSave.setProject(bench.folder.filePath("job.dyncal"));
    bench.edit();
    QVERIFY(!bench.hasFile()); // not at once: the hand may go on
    QTRY_COMPARE(saved.count(), 1);
    QCOMPARE(bench.keptOrder(), Index(3));
    const Result<RecoveredWork> work = readRecoveryFile(*bench.store.file());
    QVERIFY(work);
    QCOMPARE(work->project, bench.folder.filePath("job.dyncal"));
    QCOMPARE(work->saved, saved[0][0].toDateTime());
    QCOMPARE(work->saved, work->stopped);
    bench.edit();
    QTRY_COMPARE(bench.keptOrder(), Index(4));
}

void TestAutoSave::changes_withoutARest_areKeptAtLatest()
{
    Bench bench({10s, 100ms, 1h});
    QElapsedTimer clock;
    clock.start();
    while (!bench.hasFile() && clock.elapsed() < 5000) {
        bench.edit("drag");
        QTest::qWait(5);
    }
    QVERIFY(bench.hasFile());
    QVERIFY(clock.elapsed() >= 100);
}

void TestAutoSave::saved_removesTheFile()
{
    Bench bench;
    bench.edit();
    QTRY_VERIFY(bench.hasFile());
    bench.session.undoStack().setClean();
    QTRY_VERIFY(!bench.hasFile());
    bench.edit();
    QTRY_COMPARE(bench.keptOrder(), Index(4));
}

void TestAutoSave::undoneToTheSavedState_removesTheFile()
{
    Bench bench;
    bench.edit();
    QTRY_VERIFY(bench.hasFile());
    bench.session.undoStack().undo();
    QTRY_VERIFY(!bench.hasFile());
    bench.session.undoStack().redo();
    QTRY_COMPARE(bench.keptOrder(), Index(3));
}

void TestAutoSave::anotherJob_removesTheFile()
{
    Bench bench;
    bench.edit();
    QTRY_VERIFY(bench.hasFile());
    bench.session.reset({std::make_shared<const CaptureSet>(test::sampleCaptures()), {}});
    QTRY_VERIFY(!bench.hasFile());
    QTest::qWait(100);
    QVERIFY(!bench.hasFile());
}

void TestAutoSave::projectSavedElsewhere_isNoted()
{
    Bench bench;
    bench.edit();
    QTRY_VERIFY(bench.hasFile());
    bench.autoSave.setProject(bench.folder.filePath("other.dyncal"));
    QTRY_COMPARE(
        readRecoveryFile(*bench.store.file())->project, bench.folder.filePath("other.dyncal"));
}

void TestAutoSave::sealed_recordingsGetTheirHash()
{
    Bench bench;
    bench.edit();
    QTRY_VERIFY(bench.hasFile());
    CaptureSet set = test::sampleCaptures();
    set.inputs[0].sha256 = std::string(64, 'b');
    ProjectState next = bench.session.state();
    next.captures = std::make_shared<const CaptureSet>(set);
    bench.session.applyState(next, "Recordings");
    const auto kept = [&] {
        return readProjectFile(*bench.store.file())->content["captures"][0]["sha256"].toString();
    };
    QTRY_COMPARE(kept(), QString(64, 'b'));
}

void TestAutoSave::signsOfLife_goOnWithoutChanges()
{
    Bench bench({10ms, 100ms, 20ms});
    bench.edit();
    QTRY_VERIFY(bench.hasFile());
    const QDateTime saved = readRecoveryFile(*bench.store.file())->saved;
    QTRY_VERIFY(readRecoveryFile(*bench.store.file())->stopped > saved.addSecs(2));
    QCOMPARE(readRecoveryFile(*bench.store.file())->saved, saved);
}

void TestAutoSave::failure_isToldAndTriedAgain()
{
    Bench bench;
    QSignalSpy failed(&bench.autoSave, &AutoSave::failed);
    QSignalSpy saved(&bench.autoSave, &AutoSave::saved);
    QVERIFY(QDir().mkpath(*bench.store.file())); // no file can be put there
    bench.edit();
    QTRY_VERIFY(failed.count() >= 2);
    QVERIFY(QString::fromStdString(english(failed[0][0].value<Error>().message))
                .contains("work-1.dyncal"));
    QCOMPARE(saved.count(), 0);
    QVERIFY(QDir().rmdir(*bench.store.file()));
    QTRY_COMPARE(saved.count(), 1); // nobody has changed anything meanwhile
    QCOMPARE(bench.keptOrder(), Index(3));
}

void TestAutoSave::unusableFolder_isTold()
{
    QTemporaryDir folder;
    QFile file(folder.filePath("file"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    RecoveryStore store(folder.filePath("file/recovery"));
    Session session(test::samplePipeline);
    AutoSave autoSave(session, store, Clock(), {10ms, 20ms, 10ms});
    QSignalSpy failed(&autoSave, &AutoSave::failed);
    session.reset({std::make_shared<const CaptureSet>(test::sampleCaptures()), {}});
    Recipe next = session.recipe();
    next.realization.order = 5;
    session.apply(next, "Order");
    QTRY_COMPARE(failed.count(), 1);
    session.undoStack().setClean();
    autoSave.end();
}

void TestAutoSave::end_removesTheFileAndKeepsNothingMore()
{
    Bench bench;
    bench.edit();
    QTRY_VERIFY(bench.hasFile());
    bench.edit();
    bench.autoSave.end();
    QVERIFY(!bench.hasFile());
    bench.edit();
    QTest::qWait(100);
    QVERIFY(!bench.hasFile());
}

void TestAutoSave::adopted_goesOnInThatFile()
{
    QTemporaryDir folder;
    const QString place = folder.filePath("recovery");
    QVERIFY(QDir().mkpath(place));
    const QString left = place + "/work-1.dyncal";
    const ProjectState state{std::make_shared<const CaptureSet>(test::sampleCaptures()), {}};
    QVERIFY(writeRecoveryFile(left, state, {}, Clock().time(0)));
    RecoveryStore store(place);
    Session session(test::samplePipeline);
    AutoSave autoSave(session, store, Clock(), {20ms, 200ms, 1h});
    session.reset(state);
    session.undoStack().resetClean();
    autoSave.adopt(left);
    QVERIFY(QFile::exists(left)); // at no time is the work nowhere
    QTest::qWait(100);
    QVERIFY(QFile::exists(left));
    session.undoStack().setClean();
    QTRY_VERIFY(!QFile::exists(left));
}

DYNCAL_TEST(TestAutoSave)
#include "tst_auto_save.moc"
