// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/file_bytes.h"
#include "tests/support/test_program.h"
#include "ui/session/project_hold.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

#include <array>
#include <csignal>
#include <ctime>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace dyncal;
using testing::writeBytes;

namespace {

const ProjectHolder kAnna{"anna", "lab-1", "2026-01-31T12:00:00Z"};
const ProjectHolder kBert{"bert", "lab-2", "2026-01-31T12:05:00Z"};

/// What a machine that our locks do not reach left in the file, and for how long it has been
/// silent.
void writeForeign(const QString &path, const ProjectHolder &holder, int silent_s)
{
    const QJsonObject json{{"format", "dyncal-hold"}, {"name", QString::fromStdString(holder.name)},
        {"machine", QString::fromStdString(holder.machine)},
        {"since_utc", QString::fromStdString(holder.sinceUtc)}, {"boot", "of another machine"}};
    QVERIFY(writeBytes(path, QJsonDocument(json).toJson()));
    struct stat status = {};
    QVERIFY(::stat(path.toLocal8Bit().constData(), &status) == 0);
    std::array<timespec, 2> times{status.st_atim, status.st_mtim};
    times[1].tv_sec -= silent_s;
    QVERIFY(::utimensat(AT_FDCWD, path.toLocal8Bit().constData(), times.data(), 0) == 0);
}

} // namespace

/// Who has a project open, and who is told.
class TestProjectHold : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(writeBytes(project(), "{}"));
    }

    void second_isToldByWhom();
    void givenBack_leavesNothing();
    void otherProject_isFree();
    void everyNameOfAProject_isTheSame();
    void holderKilled_isFreeAtOnce();
    void otherMachine_holdsAsLongAsItGivesSigns();
    void silentMachine_isTakenOverAndItsHoldStaysOurs();
    void beat_isASign();
    void nonsenseInItsPlace_isTakenOver();
    void folderThatCannotBeWritten_holdsNothing();

private:
    QString project() const { return m_folder->filePath("job.dyncal"); }
    QStringList names() const
    {
        return QDir(m_folder->path())
            .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestProjectHold::second_isToldByWhom()
{
    const HoldAnswer first = HoldAnswer::at(holdFile(project()), kAnna);
    QVERIFY(first.hold && !first.other);
    const HoldAnswer second = HoldAnswer::at(holdFile(project()), kBert);
    QVERIFY(!second.hold && second.other);
    QVERIFY(*second.other == kAnna);
    const HoldAnswer third = HoldAnswer::at(holdFile(project()), kBert);
    QVERIFY(!third.hold && third.other && *third.other == kAnna); // still
}

void TestProjectHold::givenBack_leavesNothing()
{
    HoldAnswer first = HoldAnswer::at(holdFile(project()), kAnna);
    QCOMPARE(names(), (QStringList{".job.dyncal.held", "job.dyncal"}));
    first.hold.reset();
    QCOMPARE(names(), QStringList{"job.dyncal"});
    QVERIFY(HoldAnswer::at(holdFile(project()), kBert).hold);
}

void TestProjectHold::otherProject_isFree()
{
    const HoldAnswer first = HoldAnswer::at(holdFile(project()), kAnna);
    QVERIFY(HoldAnswer::at(holdFile(m_folder->filePath("other.dyncal")), kBert).hold);
}

void TestProjectHold::everyNameOfAProject_isTheSame()
{
    QVERIFY(QFile::link(project(), m_folder->filePath("link.dyncal")));
    QVERIFY(QDir(m_folder->path()).mkdir("below"));
    const HoldAnswer first = HoldAnswer::at(holdFile(project()), kAnna);
    QVERIFY(HoldAnswer::at(holdFile(m_folder->filePath("link.dyncal")), kBert).other);
    QVERIFY(HoldAnswer::at(holdFile(m_folder->filePath("below/../job.dyncal")), kBert).other);
}

void TestProjectHold::holderKilled_isFreeAtOnce()
{
    int told[2] = {};
    QCOMPARE(::pipe(told), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const HoldAnswer answer = HoldAnswer::at(holdFile(project()), kAnna);
        const char word = answer.hold ? 'y' : 'n';
        if (::write(told[1], &word, 1) == 1)
            ::pause();
        ::_exit(1);
    }
    QVERIFY(child > 0);
    char word = 0;
    QCOMPARE(::read(told[0], &word, 1), ssize_t(1));
    QCOMPARE(word, 'y');
    QVERIFY(*HoldAnswer::at(holdFile(project()), kBert).other == kAnna);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    QCOMPARE(names().size(), 2);
    QVERIFY(HoldAnswer::at(holdFile(project()), kBert).hold);
    QCOMPARE(names(), QStringList{"job.dyncal"});
}

/// A network folder whose locks do not reach other machines: the lock can be taken.
void TestProjectHold::otherMachine_holdsAsLongAsItGivesSigns()
{
    writeForeign(holdFile(project()), kAnna, kLongestSilence_s - 5);
    for (int i = 0; i < 3; ++i) { // asking is no sign of it
        const HoldAnswer answer = HoldAnswer::at(holdFile(project()), kBert);
        QVERIFY(!answer.hold && answer.other);
        QVERIFY(*answer.other == kAnna);
    }
    struct stat status = {};
    QVERIFY(::stat(holdFile(project()).toLocal8Bit().constData(), &status) == 0);
    const qint64 silent_s = ::time(nullptr) - status.st_mtim.tv_sec;
    QVERIFY2(silent_s >= kLongestSilence_s - 6, qPrintable(QString::number(silent_s)));
}

void TestProjectHold::silentMachine_isTakenOverAndItsHoldStaysOurs()
{
    writeForeign(holdFile(project()), kAnna, kLongestSilence_s + 5);
    const HoldAnswer taken = HoldAnswer::at(holdFile(project()), kBert);
    QVERIFY(taken.hold);
    QVERIFY(*HoldAnswer::at(holdFile(project()), kAnna).other == kBert);
}

void TestProjectHold::beat_isASign()
{
    const HoldAnswer first = HoldAnswer::at(holdFile(project()), kAnna);
    const QByteArray path = holdFile(project()).toLocal8Bit();
    const std::array<timespec, 2> old{timespec{1000, 0}, timespec{1000, 0}};
    QVERIFY(::utimensat(AT_FDCWD, path.constData(), old.data(), 0) == 0);
    first.hold->beat();
    struct stat status = {};
    QVERIFY(::stat(path.constData(), &status) == 0);
    QVERIFY(::time(nullptr) - status.st_mtim.tv_sec < 60);
}

void TestProjectHold::nonsenseInItsPlace_isTakenOver()
{
    for (const QByteArray &bytes : {QByteArray(), QByteArray("x"), QByteArray(100000, '['),
             QByteArray("{\"format\": \"dyncal-hold\"}")}) {
        QVERIFY(writeBytes(holdFile(project()), bytes));
        const std::array<timespec, 2> old{timespec{1000, 0}, timespec{1000, 0}};
        QVERIFY(::utimensat(AT_FDCWD, holdFile(project()).toLocal8Bit().constData(), old.data(), 0)
            == 0);
        QVERIFY(HoldAnswer::at(holdFile(project()), kAnna).hold);
    }
    QCOMPARE(::mkfifo(holdFile(project()).toLocal8Bit().constData(), 0600), 0);
    const HoldAnswer answer = HoldAnswer::at(holdFile(project()), kAnna); // comes to an end
    QVERIFY(!answer.hold && !answer.other);
}

void TestProjectHold::folderThatCannotBeWritten_holdsNothing()
{
    const HoldAnswer answer
        = HoldAnswer::at(holdFile(m_folder->filePath("no/such/job.dyncal")), kAnna);
    QVERIFY(!answer.hold && !answer.other);
}

DYNCAL_TEST(TestProjectHold)
#include "tst_project_hold.moc"
