// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/file_bytes.h"
#include "tests/support/test_program.h"
#include "tests/ui/shell/window_bench.h"
#include "ui/shell/banner/banner.h"
#include "ui/stages/frame/prompts.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QPushButton>
#include <QtTest>

using namespace dyncal;
using testing::bytesOf;
using testing::writeBytes;

namespace {

PipelineOutcome noResults(const std::shared_ptr<const CaptureSet> &, const Recipe &, ResultCache &,
    StageId, const JobControl &)
{
    return {};
}

/// One person's window.
struct Person : test::WindowBench
{
    explicit Person(const char *name)
        : WindowBench(&noResults)
    {
        window->files().holdProjectsAs(name, "lab-1");
        window->show();
    }

    FileActions &files() const { return window->files(); }
    bool open(const QString &path) const
    {
        files().openProjectFile(path);
        return QTest::qWaitFor([&] { return !files().isBusy(); }, 20000)
            && files().projectPath() == path;
    }
    void edit(const char *words) const
    {
        Recipe next = window->session().recipe();
        next.certificate.fields["customer"] = words;
        window->session().apply(next, "edit");
    }
    bool isSaidAbove() const { return find<Banner>("projectBanner")->isVisible(); }
    QString said() const { return find<QLabel>("projectSentence")->text(); }
    void click(const char *name) const
    {
        find<Banner>("projectBanner")->findChild<QPushButton *>(name)->click();
    }
    bool isReadOnly() const { return files().readOnlyReason().has_value(); }
};

} // namespace

/// Two people on one project; projects of issued certificates; projects of older versions.
class TestProjectAccess : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(writeBytes(project(), projectBytes({}, m_folder->path())));
    }

    void second_isReadOnlyAndToldByWhom();
    void readOnly_isSavedElsewhereOnly();
    void closedThere_isSavedHere();
    void openedAgain_onceItIsClosedThere();
    void whoLeavesAProject_givesItBack();
    void savedUnderAHeldName_isRefused();
    void savedOverALink_isHeldWhereItIsWritten();
    void openedThroughALink_isHeldWhereItIsSaved();
    void issuedProjectBehindALink_isReadOnlyToo();
    void openedTwiceInOneWindow_staysOurs();
    void restoredWork_isHeldToo();
    void withoutAName_nobodyIsTold();
    void issuedProject_isNeverSavedOver();
    void olderVersion_isNamedBeforeItIsSaved();

private:
    QString project() const { return m_folder->filePath("job.dyncal"); }
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestProjectAccess::second_isReadOnlyAndToldByWhom()
{
    const Person anna("anna");
    QVERIFY(anna.open(project()));
    QVERIFY(!anna.isReadOnly() && !anna.isSaidAbove());
    const Person bert("bert");
    QVERIFY(bert.open(project()));
    QVERIFY(bert.isReadOnly() && bert.isSaidAbove());
    QVERIFY2(bert.said().contains("held by anna on lab-1 since 2026-01-31T12:00:00Z"),
        qPrintable(bert.said()));
    QVERIFY(bert.window->windowTitle().contains("read-only"));
    QVERIFY(!anna.window->windowTitle().contains("read-only"));
    bert.click("closeBanner");
    bert.edit("looked at");
    QVERIFY(!bert.isSaidAbove() && bert.isReadOnly());
    QVERIFY(bert.open(project())); // said again
    QVERIFY(bert.isSaidAbove());
}

void TestProjectAccess::readOnly_isSavedElsewhereOnly()
{
    Person anna("anna");
    Person bert("bert");
    QVERIFY(anna.open(project()) && bert.open(project()));
    const QByteArray before = bytesOf(project());
    bert.edit("of bert");
    bert.prompts.setNextFile(project()); // refused
    QVERIFY(!bert.files().save());
    QCOMPARE(bytesOf(project()), before);
    QVERIFY(bert.prompts.shownProblems().last().contains("anna"));
    bert.prompts.setNextFile(m_folder->filePath("copy.dyncal"));
    QVERIFY(bert.files().save());
    QCOMPARE(bytesOf(project()), before);
    QVERIFY(bytesOf(m_folder->filePath("copy.dyncal")).contains("of bert"));
    QVERIFY(!bert.isReadOnly() && !bert.isSaidAbove());
    anna.edit("of anna");
    QVERIFY(anna.files().save());
    QVERIFY(bytesOf(project()).contains("of anna"));
}

void TestProjectAccess::closedThere_isSavedHere()
{
    auto anna = std::make_unique<Person>("anna");
    Person bert("bert");
    QVERIFY(anna->open(project()) && bert.open(project()));
    anna.reset();
    bert.edit("of bert");
    QVERIFY(bert.files().save());
    QVERIFY(bytesOf(project()).contains("of bert"));
    QVERIFY(!bert.isReadOnly() && !bert.isSaidAbove());
}

void TestProjectAccess::openedAgain_onceItIsClosedThere()
{
    auto anna = std::make_unique<Person>("anna");
    const Person bert("bert");
    QVERIFY(anna->open(project()) && bert.open(project()));
    anna->edit("of anna");
    QVERIFY(anna->files().save());
    anna.reset();
    bert.click("readAgain");
    QTRY_VERIFY(!bert.isReadOnly() && !bert.files().isBusy());
    QCOMPARE(bert.window->session().recipe().certificate.fields.at("customer"), "of anna");
}

void TestProjectAccess::whoLeavesAProject_givesItBack()
{
    Person anna("anna");
    QVERIFY(anna.open(project()));
    anna.prompts.setNextFile(m_folder->filePath("moved.dyncal"));
    QVERIFY(anna.files().saveAs());
    const Person bert("bert");
    QVERIFY(bert.open(project()) && !bert.isReadOnly());
    QVERIFY(bert.open(m_folder->filePath("moved.dyncal")) && bert.isReadOnly());
}

void TestProjectAccess::savedUnderAHeldName_isRefused()
{
    const Person anna("anna");
    QVERIFY(anna.open(project()));
    const QByteArray before = bytesOf(project());
    Person bert("bert");
    bert.edit("of bert");
    bert.prompts.setNextFile(project());
    QVERIFY(!bert.files().saveAs());
    QVERIFY(bert.prompts.shownProblems().last().contains("anna"));
    QCOMPARE(bytesOf(project()), before);
    QVERIFY(bert.files().projectPath().isEmpty());
}

/// A save replaces a link by the project: the file that it led to is another, and free.
void TestProjectAccess::savedOverALink_isHeldWhereItIsWritten()
{
    const QString link = m_folder->filePath("link.dyncal");
    QVERIFY(QFile::link(project(), link));
    const QByteArray before = bytesOf(project());
    Person anna("anna");
    anna.edit("of anna");
    anna.prompts.setNextFile(link);
    QVERIFY(anna.files().saveAs());
    QVERIFY(!QFileInfo(link).isSymLink());
    QCOMPARE(bytesOf(project()), before);
    const Person bert("bert");
    QVERIFY(bert.open(project()) && !bert.isReadOnly());
    QVERIFY(bert.open(link) && bert.isReadOnly());
    anna.edit("once more");
    QVERIFY(anna.files().save());
    QVERIFY(bert.open(link) && bert.isReadOnly());
}

void TestProjectAccess::openedThroughALink_isHeldWhereItIsSaved()
{
    const QString link = m_folder->filePath("link.dyncal");
    QVERIFY(QFile::link(project(), link));
    Person anna("anna");
    QVERIFY(anna.open(link));
    Person bert("bert");
    QVERIFY(bert.open(project()) && bert.isReadOnly());
    bert.edit("of bert");
    bert.prompts.setNextFile(link); // anna has it open by this name
    QVERIFY(!bert.files().saveAs());
    anna.edit("of anna");
    QVERIFY(anna.files().save());
    QVERIFY(bert.open(link) && bert.isReadOnly());
    QVERIFY(bert.open(project()) && !bert.isReadOnly());
}

void TestProjectAccess::issuedProjectBehindALink_isReadOnlyToo()
{
    const QString folder = m_folder->filePath("1");
    QVERIFY(QDir().mkpath(folder));
    QVERIFY(QFile::copy(project(), folder + "/project.dyncal"));
    QVERIFY(writeBytes(folder + "/manifest.json",
        R"({"schema": "dyncal-manifest/1", "number": 1, "files": {"project.dyncal": ""}})"));
    const QString link = m_folder->filePath("link.dyncal");
    QVERIFY(QFile::link(folder + "/project.dyncal", link));
    const Person anna("anna");
    QVERIFY(anna.open(link) && anna.isReadOnly());
    QVERIFY(!QFile::exists(holdFile(link))); // nothing is added to what was issued
}

void TestProjectAccess::openedTwiceInOneWindow_staysOurs()
{
    Person anna("anna");
    QVERIFY(anna.open(project()) && anna.open(project()));
    QVERIFY(!anna.isReadOnly());
    const Person bert("bert");
    QVERIFY(bert.open(project()) && bert.isReadOnly());
    anna.edit("of anna");
    QVERIFY(anna.files().save());
}

void TestProjectAccess::restoredWork_isHeldToo()
{
    const QString work = m_folder->filePath("work-1.dyncal");
    ProjectState state;
    state.recipe.certificate.fields["customer"] = "not saved";
    QVERIFY(writeRecoveryFile(work, state, project(),
        QDateTime::fromString("2026-01-31T12:00:00Z", Qt::ISODate), projectFileHash(project())));
    const auto restoreInto = [&](const Person &person) {
        person.files().restoreWork(*readRecoveryFile(work));
        return QTest::qWaitFor([&] { return !person.files().isBusy(); }, 20000);
    };
    const Person anna("anna");
    QVERIFY(restoreInto(anna) && !anna.isReadOnly());
    const Person bert("bert");
    QVERIFY(restoreInto(bert));
    QVERIFY(bert.isReadOnly() && bert.files().isModified() && bert.isSaidAbove());
}

void TestProjectAccess::withoutAName_nobodyIsTold()
{
    const ProjectAccess access = accessTo(project(), {});
    QVERIFY(!access.hold && !access.readOnly);
    QVERIFY(!QFile::exists(holdFile(project())));
}

void TestProjectAccess::issuedProject_isNeverSavedOver()
{
    const QString frozen = m_folder->filePath("project.dyncal");
    QVERIFY(QFile::copy(project(), frozen));
    const QByteArray before = bytesOf(frozen);
    QVERIFY(writeBytes(m_folder->filePath("manifest.json"),
        R"({"schema": "dyncal-manifest/1", "number": 17, "files": {"project.dyncal": ""}})"));
    Person anna("anna");
    QVERIFY(anna.open(frozen));
    QVERIFY(!QFile::exists(holdFile(frozen))); // nothing is added to what was issued
    QVERIFY2(anna.said().contains("issued certificate 17"), qPrintable(anna.said()));
    anna.edit("changed");
    anna.prompts.setNextFile(frozen);
    QVERIFY(!anna.files().save());
    QCOMPARE(bytesOf(frozen), before);
    anna.prompts.setNextFile(m_folder->filePath("amendment.dyncal"));
    QVERIFY(anna.files().save());
    QVERIFY(!anna.isReadOnly());
    QVERIFY(writeBytes(m_folder->filePath("manifest.json"), "of another program"));
    QVERIFY(anna.open(frozen) && !anna.isReadOnly());
}

void TestProjectAccess::olderVersion_isNamedBeforeItIsSaved()
{
    QJsonObject json = QJsonDocument::fromJson(bytesOf(project())).object();
    json["version"] = 1;
    QVERIFY(writeBytes(project(), QJsonDocument(json).toJson()));
    Person anna("anna");
    QVERIFY(anna.open(project()));
    QVERIFY(anna.isSaidAbove());
    QVERIFY2(
        anna.said().contains("as version 1; saving it writes version 2"), qPrintable(anna.said()));
    anna.edit("of anna");
    QVERIFY(anna.isSaidAbove());
    QVERIFY(anna.files().save());
    QVERIFY(!anna.isSaidAbove());
    QCOMPARE(QJsonDocument::fromJson(bytesOf(project()))["version"].toInt(), kProjectVersion);
}

DYNCAL_TEST(TestProjectAccess)
#include "tst_project_access.moc"
