// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/support/sample_results.h"
#include "ui/session/example.h"
#include "ui/session/project_file.h"
#include "ui/session/recovery_store.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QtTest>

using namespace dyncal;

namespace {

QDateTime at(const char *time)
{
    return QDateTime::fromString(QStringLiteral("2026-01-31T%1Z").arg(time), Qt::ISODate);
}

ProjectState job(const char *customer = "A")
{
    ProjectState state;
    state.captures = std::make_shared<const CaptureSet>(test::sampleCaptures());
    state.recipe.certificate.fields["customer"] = customer;
    return state;
}

QString said(const Error &error)
{
    return QString::fromStdString(english(error.message));
}

} // namespace

class TestRecoveryStore : public QObject
{
    Q_OBJECT

private slots:
    void init();
    void file_firstProgram_isTheFirstOfANewFolder();
    void file_everyRunningProgram_hasItsOwn();
    void file_unusableFolder_isSaid();
    void leftBehind_stoppedProgram_isToldInFull();
    void leftBehind_lockOfADeadProgram_countsForNothing();
    void leftBehind_runningProgram_isItsOwn();
    void leftBehind_offeredByOneProgram_isNotOfferedByAnother();
    void leftBehind_several_newestFirst();
    void signOfLife_movesTheStopOnly();
    void signOfLife_removedFile_staysAway();
    void opened_theJobIsTheSame();
    void unreadable_isSetAsideAndNamed_data();
    void unreadable_isSetAsideAndNamed();
    void unreadable_twice_overwritesNothing();
    void halfWritten_isTidiedUp();
    void discard_removesFileAndLock();
    void adopt_givesUpItsOwn();

private:
    QString write(const QString &name, const QDateTime &time = at("12:00:00")) const
    {
        const QString file = QDir(m_place).filePath(name);
        return writeRecoveryFile(file, job(), m_folder->filePath("job.dyncal"), time) ? file
                                                                                      : QString();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_place;
};

void TestRecoveryStore::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_place = m_folder->filePath("state/recovery");
    QVERIFY(QDir().mkpath(m_place));
}

void TestRecoveryStore::file_firstProgram_isTheFirstOfANewFolder()
{
    QVERIFY(QDir(m_place).removeRecursively());
    const RecoveryStore store(m_place);
    QVERIFY(store.file());
    QCOMPARE(*store.file(), m_place + "/work-1.dyncal");
    QVERIFY(!QFile::exists(*store.file())); // there is nothing to keep yet
    QVERIFY(store.leftBehind().empty());
}

void TestRecoveryStore::file_everyRunningProgram_hasItsOwn()
{
    const RecoveryStore one(m_place);
    auto two = std::make_unique<RecoveryStore>(m_place);
    QCOMPARE(*two->file(), m_place + "/work-2.dyncal");
    two.reset();
    QCOMPARE(*RecoveryStore(m_place).file(), m_place + "/work-2.dyncal");
}

void TestRecoveryStore::file_unusableFolder_isSaid()
{
    QFile file(m_folder->filePath("file"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    const QString place = m_folder->filePath("file/recovery");
    const RecoveryStore store(place);
    QVERIFY(!store.file());
    QVERIFY(said(store.file().error()).contains(place));
    QVERIFY(store.leftBehind().empty());
}

void TestRecoveryStore::leftBehind_stoppedProgram_isToldInFull()
{
    const QString file = write("work-1.dyncal", at("14:02:31"));
    markAlive(file, at("14:02:43"));
    const RecoveryStore store(m_place);
    QCOMPARE(store.leftBehind().size(), std::size_t(1));
    const RecoveredWork &work = store.leftBehind()[0];
    QCOMPARE(work.file, file);
    QCOMPARE(work.project, m_folder->filePath("job.dyncal"));
    QCOMPARE(work.saved, at("14:02:31"));
    QCOMPARE(work.stopped, at("14:02:43"));
    QCOMPARE(work.recordings, QStringList{"low.h5"});
    QCOMPARE(*store.file(), m_place + "/work-2.dyncal"); // its own is another
}

void TestRecoveryStore::leftBehind_lockOfADeadProgram_countsForNothing()
{
    // A program that is killed leaves its lock file, with nobody who holds it.
    const QString file = write("work-1.dyncal");
    QFile lock(file + ".lock");
    QVERIFY(lock.open(QIODevice::WriteOnly));
    lock.close();
    QCOMPARE(RecoveryStore(m_place).leftBehind().size(), std::size_t(1));
}

void TestRecoveryStore::leftBehind_runningProgram_isItsOwn()
{
    const RecoveryStore running(m_place);
    QVERIFY(writeRecoveryFile(*running.file(), job(), {}, at("12:00:00")));
    const RecoveryStore other(m_place);
    QVERIFY(other.leftBehind().empty());
    QVERIFY(QFile::exists(*running.file()));
    QCOMPARE(*other.file(), m_place + "/work-2.dyncal");
}

void TestRecoveryStore::leftBehind_offeredByOneProgram_isNotOfferedByAnother()
{
    write("work-1.dyncal");
    {
        const RecoveryStore offers(m_place);
        QCOMPARE(offers.leftBehind().size(), std::size_t(1));
        QVERIFY(RecoveryStore(m_place).leftBehind().empty());
    }
    QCOMPARE(RecoveryStore(m_place).leftBehind().size(), std::size_t(1)); // never answered
}

void TestRecoveryStore::leftBehind_several_newestFirst()
{
    write("work-1.dyncal", at("10:00:00"));
    write("work-2.dyncal", at("12:00:00"));
    write("work-7.dyncal", at("11:00:00"));
    const RecoveryStore store(m_place);
    QCOMPARE(store.leftBehind().size(), std::size_t(3));
    QCOMPARE(store.leftBehind()[0].saved, at("12:00:00"));
    QCOMPARE(store.leftBehind()[1].saved, at("11:00:00"));
    QCOMPARE(store.leftBehind()[2].saved, at("10:00:00"));
    QCOMPARE(*store.file(), m_place + "/work-3.dyncal");
}

void TestRecoveryStore::signOfLife_movesTheStopOnly()
{
    const QString file = write("work-1.dyncal", at("14:00:00"));
    QCOMPARE(readRecoveryFile(file)->stopped, at("14:00:00"));
    markAlive(file, at("15:00:00"));
    QCOMPARE(readRecoveryFile(file)->stopped, at("15:00:00"));
    QCOMPARE(readRecoveryFile(file)->saved, at("14:00:00"));
}

void TestRecoveryStore::signOfLife_removedFile_staysAway()
{
    const QString file = QDir(m_place).filePath("work-1.dyncal");
    markAlive(file, at("15:00:00"));
    QVERIFY(!QFile::exists(file));
}

void TestRecoveryStore::opened_theJobIsTheSame()
{
    ProjectState state = job("Åsa & \"Co\"");
    const Result<CaptureSet> example = exampleCaptures();
    QVERIFY(example);
    state.captures = std::make_shared<const CaptureSet>(*example);
    state.recipe.window.end_s = 1.0 / 3.0;
    const QString file = QDir(m_place).filePath("work-1.dyncal");
    QVERIFY(writeRecoveryFile(file, state, {}, at("12:00:00")));
    QCOMPARE(readRecoveryFile(file)->project, QString());
    const Result<ProjectState> opened = openProject(file);
    QVERIFY(opened);
    QVERIFY(opened->recipe == state.recipe);
    QCOMPARE(opened->captures->shots.size(), state.captures->shots.size());
}

void TestRecoveryStore::unreadable_isSetAsideAndNamed_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTemporaryDir folder;
    const QString file = folder.filePath("work-1.dyncal");
    QVERIFY(writeRecoveryFile(file, job(), {}, at("12:00:00")));
    QFile written(file);
    QVERIFY(written.open(QIODevice::ReadOnly));
    const QByteArray whole = written.readAll();
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("zeros") << QByteArray(4096, '\0');
    QTest::newRow("cut short") << whole.left(whole.size() / 2);
    QTest::newRow("deep") << QByteArray(50000, '[');
    QTest::newRow("another program's") << QByteArray("{\"a\": 1}");
    QTest::newRow("newer") << QByteArray(whole).replace("\"version\": 2", "\"version\": 3");
    QTest::newRow("no time") << QByteArray(whole).replace("saved_utc", "saved_xtc");
    QTest::newRow("unknown setting") << QByteArray(whole).replace("\"end_s\"", "\"fin_s\"");
    QTest::newRow("recording without a name") << QByteArray(whole).replace("\"path\"", "\"place\"");
}

void TestRecoveryStore::unreadable_isSetAsideAndNamed()
{
    QFETCH(QByteArray, bytes);
    QFile file(QDir(m_place).filePath("work-1.dyncal"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
    file.close();
    const RecoveryStore store(m_place);
    QVERIFY(store.leftBehind().empty());
    QCOMPARE(store.unreadable().size(), std::size_t(1));
    QCOMPARE(store.unreadable()[0].keptAs, m_place + "/work-1.dyncal.unreadable-1");
    QVERIFY(!said(store.unreadable()[0].error).isEmpty());
    QFile kept(store.unreadable()[0].keptAs);
    QVERIFY(kept.open(QIODevice::ReadOnly));
    QCOMPARE(kept.readAll(), bytes);
    QCOMPARE(*store.file(), m_place + "/work-1.dyncal"); // free again
    QVERIFY(RecoveryStore(m_place).unreadable().empty()); // told once
}

void TestRecoveryStore::unreadable_twice_overwritesNothing()
{
    for (const char *bytes : {"one", "two"}) {
        QFile file(QDir(m_place).filePath("work-1.dyncal"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        QCOMPARE(RecoveryStore(m_place).unreadable().size(), std::size_t(1));
    }
    QCOMPARE(QDir(m_place).entryList({"*.unreadable-*"}).size(), 2);
}

void TestRecoveryStore::halfWritten_isTidiedUp()
{
    const QString file = write("work-1.dyncal");
    QFile part(file + ".part-1234-0");
    QVERIFY(part.open(QIODevice::WriteOnly));
    part.write("{\"for");
    part.close();
    QCOMPARE(RecoveryStore(m_place).leftBehind().size(), std::size_t(1));
    QVERIFY(!part.exists());
}

void TestRecoveryStore::discard_removesFileAndLock()
{
    const QString file = write("work-1.dyncal");
    RecoveryStore store(m_place);
    store.discard(file);
    QVERIFY(store.leftBehind().empty());
    QVERIFY(!QFile::exists(file));
    QVERIFY(!QFile::exists(file + ".lock"));
}

void TestRecoveryStore::adopt_givesUpItsOwn()
{
    const QString file = write("work-1.dyncal");
    {
        RecoveryStore store(m_place);
        const QString own = *store.file();
        QVERIFY(writeRecoveryFile(own, job(), {}, at("12:00:00")));
        store.adopt(file);
        QCOMPARE(*store.file(), file);
        QVERIFY(store.leftBehind().empty());
        QVERIFY(!QFile::exists(own));
        QVERIFY(RecoveryStore(m_place).leftBehind().empty()); // still under its lock
    }
    QCOMPARE(RecoveryStore(m_place).leftBehind().size(), std::size_t(1));
}

DYNCAL_TEST(TestRecoveryStore)
#include "tst_recovery_store.moc"
