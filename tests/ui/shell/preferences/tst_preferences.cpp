// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/shell/preferences/language.h"
#include "ui/shell/preferences/preferences.h"
#include "ui/stages/frame/prompts.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

using namespace dyncal;

class TestPreferences : public QObject
{
    Q_OBJECT

private slots:
    void values_survive();
    void recentFiles_newestFirst_onlyExisting_atMostTen();
    void language_unknown_isEnglish();
    void plurals_ofEnglish_areThereInEveryLocale();
    void scriptedPrompts_withoutAnswer_cancel();
    void saveFile_withoutSuffix_getsOne();
};

void TestPreferences::values_survive()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("settings.ini");
    {
        Preferences preferences(path);
        preferences.setLanguage("sv");
        preferences.setWindow("geometry", "layout");
        preferences.setLastFolder("/somewhere");
    }
    const Preferences again(path);
    QCOMPARE(again.language(), QString("sv"));
    QCOMPARE(again.geometry(), QByteArray("geometry"));
    QCOMPARE(again.layout(), QByteArray("layout"));
    QCOMPARE(again.lastFolder(), QString("/somewhere"));
}

void TestPreferences::recentFiles_newestFirst_onlyExisting_atMostTen()
{
    const QTemporaryDir folder;
    Preferences preferences(folder.filePath("settings.ini"));
    for (int i = 0; i < 12; ++i) {
        const QString path = folder.filePath(QString("%1.dyncal").arg(i));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        preferences.addRecentFile(path);
    }
    preferences.addRecentFile(folder.filePath("5.dyncal"));
    QStringList recent = preferences.recentFiles();
    QCOMPARE(recent.size(), 10);
    QCOMPARE(recent[0], folder.filePath("5.dyncal"));
    QCOMPARE(recent[1], folder.filePath("11.dyncal"));
    QCOMPARE(recent.count(folder.filePath("5.dyncal")), 1);
    QFile::remove(folder.filePath("11.dyncal"));
    recent = preferences.recentFiles();
    QVERIFY(!recent.contains(folder.filePath("11.dyncal")));
}

void TestPreferences::language_unknown_isEnglish()
{
    const QTemporaryDir folder;
    Preferences preferences(folder.filePath("settings.ini"));
    preferences.setLanguage("xx");
    QCOMPARE(preferences.language(), QString("en"));
}

/// "12 notes", not "12 note(s)": English has a translation of its plurals, whatever the desktop is.
void TestPreferences::plurals_ofEnglish_areThereInEveryLocale()
{
    const QByteArray before = qgetenv("LC_ALL");
    const auto notes = [](int count) {
        return QCoreApplication::translate("dyncal::FindingsPanel", "%n note(s)", nullptr, count);
    };
    for (const char *locale : {"C", "POSIX", "sv_SE.UTF-8", ""}) {
        qputenv("LC_ALL", locale);
        QTemporaryDir folder;
        Language language;
        language.install(Preferences(folder.filePath("settings.ini")).language());
        if (language.code() == "sv")
            language.install("en");
        QCOMPARE(notes(12), QString("12 notes"));
        QCOMPARE(notes(1), QString("1 note"));
        language.install("sv");
        language.install("en");
        QCOMPARE(notes(0), QString("0 notes"));
    }
    qputenv("LC_ALL", before);
}

void TestPreferences::scriptedPrompts_withoutAnswer_cancel()
{
    Prompts prompts;
    prompts.setScripted();
    QVERIFY(prompts.openFiles(nullptr, {}, {}, {}).isEmpty());
    QVERIFY(prompts.saveFile(nullptr, {}, {}, {}, "pdf").isEmpty());
    QCOMPARE(prompts.saveChanges(nullptr, {}), dyncal::Answer::Cancel);
    QVERIFY(!prompts.sentence(nullptr, {}, {}));
    prompts.showProblem(nullptr, "one");
    QCOMPARE(prompts.shownProblems(), QStringList{"one"});
}

void TestPreferences::saveFile_withoutSuffix_getsOne()
{
    Prompts prompts;
    prompts.setScripted();
    prompts.setNextFile("/tmp/a");
    QCOMPARE(prompts.saveFile(nullptr, {}, {}, {}, "dyncal"), QString("/tmp/a.dyncal"));
    prompts.setNextFile("/tmp/a.dyncal");
    QCOMPARE(prompts.saveFile(nullptr, {}, {}, {}, "dyncal"), QString("/tmp/a.dyncal"));
}

DYNCAL_TEST(TestPreferences)
#include "tst_preferences.moc"
