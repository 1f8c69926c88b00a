// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/atomic_file.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>
#include <unistd.h>

using dyncal::ErrorKind;
using dyncal::writeFileAtomically;

class TestAtomicFile : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    std::string path(const char *name) const { return m_folder.filePath(name).toStdString(); }
    QByteArray content(const char *name) const
    {
        QFile file(m_folder.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(none)");
    }
    QStringList entries() const
    {
        return QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden | QDir::System);
    }

private slots:
    void newFile_holdsTheBytes()
    {
        const std::string bytes("a\0b\n", 4);
        QVERIFY(writeFileAtomically(path("new"), bytes).has_value());
        QCOMPARE(content("new"), QByteArray("a\0b\n", 4));
    }

    void existingFile_isReplacedAndNothingIsLeftBehind()
    {
        QVERIFY(writeFileAtomically(path("new"), "longer than before").has_value());
        QVERIFY(writeFileAtomically(path("new"), "short").has_value());
        QCOMPARE(content("new"), QByteArray("short"));
        QCOMPARE(entries(), QStringList("new"));
    }

    void mode_followsTheUmask()
    {
        const mode_t before = ::umask(027);
        const bool written = writeFileAtomically(path("masked"), "x").has_value();
        ::umask(before);
        QVERIFY(written);
        struct stat status = {};
        QCOMPARE(::stat(path("masked").c_str(), &status), 0);
        QCOMPARE(status.st_mode & 0777U, 0640U);
    }

    void missingFolder_isAUsageErrorThatNamesThePath()
    {
        const auto done = writeFileAtomically(path("none/file"), "x");
        QVERIFY(!done.has_value());
        QVERIFY(done.error().kind == ErrorKind::Usage);
        QVERIFY(dyncal::english(done.error().message).starts_with(path("none/file")));
    }

    void folder_isRefused()
    {
        QVERIFY(QDir(m_folder.path()).mkdir("folder"));
        const auto done = writeFileAtomically(path("folder"), "x");
        QVERIFY(!done.has_value());
        QVERIFY(done.error().kind == ErrorKind::Usage);
    }

    void device_isRefusedAndSurvives()
    {
        QVERIFY(!writeFileAtomically("/dev/null", "x").has_value());
        struct stat status = {};
        QCOMPARE(::stat("/dev/null", &status), 0);
        QVERIFY(S_ISCHR(status.st_mode));
    }

    void pipe_isRefusedWithoutWaitingForAReader()
    {
        QCOMPARE(::mkfifo(path("pipe").c_str(), 0600), 0);
        QVERIFY(!writeFileAtomically(path("pipe"), "x").has_value());
    }

    void staleTemporary_doesNotHinder()
    {
        const QString stale = m_folder.filePath(QStringLiteral("free.part-%1-0").arg(::getpid()));
        QFile left(stale);
        QVERIFY(left.open(QIODevice::WriteOnly));
        QVERIFY(writeFileAtomically(path("free"), "x").has_value());
        QCOMPARE(content("free"), QByteArray("x"));
        QVERIFY(QFile::exists(stale));
    }
};

DYNCAL_TEST(TestAtomicFile)
#include "tst_atomic_file.moc"
