// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/capture_seal.h"
#include "core/certificate/certificate.h"
#include "core/pipeline/pipeline.h"
#include "tests/support/test_program.h"
#include "ui/session/kept_results.h"
#include "ui/session/project_file.h"

#include <QDir>
#include <QtTest>

#include <set>

using namespace dyncal;

namespace {

QString keptFolder()
{
    return qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/tests/data";
}

/// What changes from one program to the next, or with the folder that a project is in.
bool isOfTheProgram(const QString &line)
{
    return line.contains("Software") || line.contains("build ");
}

/// Every field, paragraph and cell as a line: "section: label: value".
QStringList linesOf(const CertificateData &certificate)
{
    QStringList lines;
    const auto add
        = [&](const CertificateSection &section, const QString &what, const Message &value) {
              const QString line = QString::fromStdString(english(section.title)) + ": " + what
                  + ": " + QString::fromStdString(english(value));
              if (!isOfTheProgram(line))
                  lines << line;
          };
    for (const CertificateSection &section : certificate.sections) {
        for (const Message &paragraph : section.paragraphs)
            add(section, "text", paragraph);
        for (const CertificateField &field : section.fields)
            add(section, QString::fromStdString(english(field.label)), field.value);
        for (const CertificateTable &table : section.tables)
            for (const auto &row : table.rows)
                for (const Message &cell : row)
                    add(section, QString::fromStdString(english(table.caption)), cell);
    }
    return lines;
}

} // namespace

/// Projects that earlier versions of the program saved, opened and computed by that of today.
class TestKeptProjects : public QObject
{
    Q_OBJECT

private slots:
    void everyVersion_isThere();
    void opened_isComputedAsItWasKept_data();
    void opened_isComputedAsItWasKept();

private:
    static QStringList names()
    {
        return QDir(keptFolder() + "/kept_projects").entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    }
    static Result<ProjectFile> read(const QString &name)
    {
        return readProjectFile(keptFolder() + "/kept_projects/" + name + "/job.dyncal");
    }
};

void TestKeptProjects::everyVersion_isThere()
{
    std::set<int> versions;
    for (const QString &name : names()) {
        const Result<ProjectFile> file = read(name);
        QVERIFY2(file, qPrintable(name));
        versions.insert(file->version);
    }
    for (int version = 1; version <= kProjectVersion; ++version)
        QVERIFY2(versions.contains(version), qPrintable(QString::number(version)));
}

void TestKeptProjects::opened_isComputedAsItWasKept_data()
{
    QTest::addColumn<QString>("name");
    for (const QString &name : names())
        QTest::newRow(qPrintable(name)) << name;
}

void TestKeptProjects::opened_isComputedAsItWasKept()
{
    QFETCH(QString, name);
    const Result<ProjectFile> file = read(name);
    QVERIFY(file);
    QCOMPARE(olderVersion(*file).has_value(), file->version < kProjectVersion);
    const auto kept = keptResults(file->content);
    QVERIFY(kept);
    const Result<ProjectState> opened = openProject(*file, {}, {keptFolder() + "/kept_runs"});
    QVERIFY2(opened, opened ? "" : english(opened.error().message).c_str());
    QVERIFY(opened->captures->findings.empty()); // neither project nor recording was changed
    const Result<CaptureSet> sealed = sealCaptures(*opened->captures);
    QVERIFY(sealed);
    ResultCache cache;
    const PipelineOutcome outcome
        = runPipeline(std::make_shared<const CaptureSet>(*sealed), opened->recipe, cache);
    QVERIFY2(!outcome.error, outcome.error ? english(outcome.error->message).c_str() : "");
    const QStringList then = linesOf(kept->certificate);
    const QStringList now
        = linesOf(makeCertificate(outcome.results, opened->recipe, kept->savedUtc));
    QVERIFY(then.size() > 100);
    for (const QString &line : then)
        QVERIFY2(now.contains(line), qPrintable(line));
    QCOMPARE(now, then);
}

DYNCAL_TEST(TestKeptProjects)
#include "tst_kept_projects.moc"
