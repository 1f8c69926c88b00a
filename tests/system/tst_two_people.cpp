// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/system/short_capture.h"
#include "tests/system/window_process.h"
#include "tests/system/written_project.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

namespace {

constexpr const char *kSaid = "text projectSentence";

} // namespace

/// Two programs on one project in a folder that both have: each its own process, with a user's
/// settings of its own.
class TestTwoPeople : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString path(const QString &name) const { return m_folder.filePath(name); }
    QString project() const { return path("work/job.dyncal"); }
    QStringList names() const
    {
        return QDir(path("work")).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }

private slots:
    void initTestCase()
    {
        for (const char *name : {"anna", "bert", "work"})
            QVERIFY(QDir(m_folder.path()).mkpath(name));
        QVERIFY(simulateShortCapture(path("work/shot.h5"), 3));
    }
    void init() { QVERIFY(writeProject(project(), {path("work/shot.h5")}, {})); }

    void second_isReadOnly_untilTheFirstEnds()
    {
        WindowProcess anna(path("anna"), {project()});
        QVERIFY2(anna.waitFor("title", "job[*]"), anna.last());
        WindowProcess bert(path("bert"), {project()});
        QVERIFY2(bert.waitFor("title", "job (read-only)"), bert.last());
        const QString said = bert.ask(kSaid);
        QVERIFY2(said.contains("Project job.dyncal is held by "), qPrintable(said));
        QVERIFY2(
            said.contains(" on " + QSysInfo::machineHostName() + " since 20"), qPrintable(said));
        QCOMPARE(anna.ask(kSaid), QString("-"));

        QCOMPARE(anna.ask("trigger quitAction"), QString("done"));
        QVERIFY(anna.hasEndedWell());
        WindowProcess third(path("anna"), {project()});
        QVERIFY2(third.waitFor("title", "job[*]"), third.last());
        QCOMPARE(third.ask("trigger quitAction"), QString("done"));
        QVERIFY(third.hasEndedWell());
        QCOMPARE(bert.ask("trigger quitAction"), QString("done"));
        QVERIFY(bert.hasEndedWell());
        QCOMPARE(names(), (QStringList{"job.dyncal", "shot.h5"}));
    }

    void killedProgram_holdsNothing()
    {
        WindowProcess anna(path("anna"), {project()});
        QVERIFY2(anna.waitFor("title", "job[*]"), anna.last());
        anna.stop(SIGKILL);
        QCOMPARE(names().size(), 3);
        WindowProcess bert(path("bert"), {project()});
        QVERIFY2(bert.waitFor("title", "job"), bert.last());
        QVERIFY2(!bert.ask("title").contains("read-only"), bert.last());
        bert.stop(SIGTERM);
        QCOMPARE(names(), (QStringList{"job.dyncal", "shot.h5"}));
    }

    /// The command line only reads projects: what the window holds can be issued and verified.
    void commands_readWhatIsHeld()
    {
        WindowProcess anna(path("anna"), {project()});
        QVERIFY2(anna.waitFor("title", "job[*]"), anna.last());
        QCOMPARE(runDyncal({"verify", project()}).exitCode, 1); // without checksums
        const QStringList model{"export", project(), "--format", "json", "-o", path("out")};
        QVERIFY(runDyncal(model).exitCode <= 1);
        QVERIFY(QFile::exists(path("out/model.json")));
    }
};

DYNCAL_TEST(TestTwoPeople)
#include "tst_two_people.moc"
