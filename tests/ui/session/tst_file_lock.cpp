// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/session/file_lock.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

using namespace dyncal;

class TestFileLock : public QObject
{
    Q_OBJECT

private slots:
    void taken_isHadByOneOnly();
    void letGo_leavesNothing();
    void leftByNobody_isFree();
    void holderKilled_isFree();
    void impossiblePlace_isNotTaken();

private:
    QTemporaryDir m_folder;
    QString m_path = m_folder.filePath("a.lock");
};

void TestFileLock::taken_isHadByOneOnly()
{
    const auto lock = FileLock::take(m_path);
    QVERIFY(lock);
    QVERIFY(!FileLock::take(m_path));
    QVERIFY(QFile::exists(m_path));
}

void TestFileLock::letGo_leavesNothing()
{
    auto lock = FileLock::take(m_path);
    QVERIFY(lock);
    lock.reset();
    QVERIFY(!QFile::exists(m_path));
    QVERIFY(FileLock::take(m_path));
}

void TestFileLock::leftByNobody_isFree()
{
    QFile file(m_path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.close();
    QVERIFY(FileLock::take(m_path));
}

void TestFileLock::holderKilled_isFree()
{
    int told[2] = {};
    QCOMPARE(::pipe(told), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const auto lock = FileLock::take(m_path);
        const char answer = lock ? 'y' : 'n';
        if (::write(told[1], &answer, 1) == 1)
            ::pause();
        ::_exit(1);
    }
    QVERIFY(child > 0);
    char answer = 0;
    QCOMPARE(::read(told[0], &answer, 1), ssize_t(1));
    QCOMPARE(answer, 'y');
    QVERIFY(!FileLock::take(m_path));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    QVERIFY(QFile::exists(m_path));
    QVERIFY(FileLock::take(m_path));
}

void TestFileLock::impossiblePlace_isNotTaken()
{
    QVERIFY(!FileLock::take(m_folder.filePath("no/such/folder/a.lock")));
    QVERIFY(!FileLock::take(m_folder.path())); // a folder
}

DYNCAL_TEST(TestFileLock)
#include "tst_file_lock.moc"
