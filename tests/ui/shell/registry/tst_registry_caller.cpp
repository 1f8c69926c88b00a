// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/shell/preferences/preferences.h"
#include "ui/shell/registry/registry_caller.h"

#include <QtTest>

using namespace dyncal;

/// Commands on the registry: which answers count.
class TestRegistryCaller : public QObject
{
    Q_OBJECT

private:
    static constexpr int kPatience_ms = 30'000;
    QTemporaryDir m_folder;

    /// A program that waits for the seconds of its first argument and prints the second.
    QString slowEcho() const
    {
        QFile file(m_folder.filePath("slow"));
        if (file.open(QIODevice::WriteOnly)) {
            file.write("#!/bin/sh\nsleep \"$1\"\necho \"$2\"\n");
            file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        }
        return file.fileName();
    }

private slots:
    void answerThatIsOutOfDate_isGivenUp()
    {
        Preferences preferences(m_folder.filePath("settings.ini"));
        RegistryCaller caller(preferences, nullptr);
        caller.setProgram(slowEcho());
        QObject reader, other;
        QStringList answers;
        QSignalSpy failed(&caller, &RegistryCaller::failed);
        const auto take
            = [&](const ProgramAnswer &answer) { answers << QString(answer.out).trimmed(); };
        caller.read(reader, {"0.5", "old"}, take);
        caller.read(other, {"0.5", "of another reader"}, take);
        caller.read(reader, {"0", "new"}, take);
        QTRY_VERIFY_WITH_TIMEOUT(!caller.isBusy(), kPatience_ms);
        QCOMPARE(answers, QStringList({"new", "of another reader"}));
        QVERIFY(failed.isEmpty());
    }

    void address_isUsedOnceItIsAnother()
    {
        Preferences preferences(m_folder.filePath("address.ini"));
        RegistryCaller caller(preferences, nullptr);
        QVERIFY(!caller.useAddress("  "));
        QVERIFY(caller.useAddress(" /a/registry.sqlite "));
        QVERIFY(!caller.useAddress("/a/registry.sqlite"));
        QCOMPARE(RegistryCaller(preferences, nullptr).address(), QString("/a/registry.sqlite"));
    }
};

DYNCAL_TEST(TestRegistryCaller)
#include "tst_registry_caller.moc"
