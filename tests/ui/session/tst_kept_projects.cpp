// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/capture_seal.h"
#include "core/certificate/certificate.h"
#include "core/pipeline/pipeline.h"
#include "tests/support/test_program.h"
#include "ui/session/kept_results.h"
#include "ui/session/project_file.h"

#include <QDir>
#include <QStringList>
#include <QtTest>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

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

/// The number that a line ends with as it is today: uncertainty 8 (U of resonance, edges, rise time
/// and overshoot know the mounting) and model 9 (no sample that a start was found by).
QString withTodaysNumbers(QString line)
{
    static const std::vector<std::pair<QString, QString>> kNumbers{{"0.016", "0.026"},
        {"0.011 kHz", "0.017 kHz"}, {"0.015 kHz", "0.023 kHz"}, {"0.11 kHz", "0.18 kHz"},
        {"2.8127 \xC2\xB5s", "2.814 \xC2\xB5s"}, {"0.0089 \xC2\xB5s", "0.014 \xC2\xB5s"},
        {"0.13 %", "0.22 %"}, {"60.0044 kHz", "60.0042 kHz"}, {"0.05003", "0.05002"},
        {"9.993", "9.996"}, {"59.8540 kHz", "59.8538 kHz"}, {"13.129 kHz", "13.131 kHz"},
        {"18.143 kHz", "18.145 kHz"}, {"93.06 kHz", "93.05 kHz"}, {"85.43 %", "85.41 %"},
        {"0.912563 \xC2\xB1 j0.360840", "0.912567 \xC2\xB1 j0.360841"}, {"0.50059", "0.50047"},
        {"0.00085", "0.00091"}, {"-87.11 \xC2\xB0", "-87.10 \xC2\xB0"},
        {"-172.7 \xC2\xB0", "-172.6 \xC2\xB0"}, {"1.83 \xC2\xB5V/Pa", "1.82 \xC2\xB5V/Pa"},
        {"agree for 16 of 28 values and rows", "agree for 17 of 28 values and rows"}};
    for (const auto &[then, now] : kNumbers)
        if (line.endsWith(' ' + then))
            return line.chopped(then.size()) + now;
    return line;
}

/// A line of a kept certificate as a program of today says it: other words, five digits of a
/// temperature, and k = 2 where 1.96 was printed (with U of 2 u, whose two digits are the same
/// here), and the numbers that a later method changed on purpose (docs/accuracy.md).
QString inTodaysWords(QString line)
{
    constexpr std::pair<const char *, const char *> kWords[]{
        {"Reference of the budget: p1_pa", "Reference standard: initial pressure"},
        {"Reference of the budget: t1_k", "Reference standard: initial temperature"},
        {"Reference of the budget: distance_m", "Reference standard: distance along the tube"},
        {"Reference of the budget: gain_relative",
            "Reference standard: gain of the measuring chain"},
        {"Reference of the budget: clock_relative", "Reference standard: sample clock"},
        {"GUM validated by Monte Carlo (JCGM 101): 1000 trials: ",
            "Comparison of GUM and Monte Carlo (JCGM 101): 1000 trials: both agree for "},
        {"294.1 K", "294.15 K"}, {"Relative humidity (ratio)", "Relative humidity"},
        {" (k = 1.96)", " (k = 2)"}, {"Pressure steps: 1.96", "Pressure steps: 2"},
        {"% of 99.18 % attainable with this noise",
            "%; in this noise the true model would reach 99.18 % on average"}};
    for (const auto &[then, now] : kWords)
        line.replace(then, now);
    return withTodaysNumbers(line);
}

/// What one has and the other has not; both agree but for their order where it is empty.
QString differences(const QStringList &then, const QStringList &now)
{
    QStringList lines;
    for (const QString &line : then)
        lines += now.contains(line) ? "" : "then: " + line;
    for (const QString &line : now)
        lines += then.contains(line) ? "" : "now:  " + line;
    lines.removeAll("");
    return lines.join('\n');
}

/// Of a field or table that no kept certificate has.
bool isNew(const QString &line)
{
    return line.contains("by Monte Carlo reaches beyond the one that U gives")
        || line.contains("What the uncertainty of the sensitivity is made of")
        || line.contains("Gas before the item") || line.contains("not divided out");
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
    QStringList then = linesOf(kept->certificate);
    std::ranges::transform(then, then.begin(), inTodaysWords);
    QStringList now = linesOf(makeCertificate(outcome.results, opened->recipe, kept->savedUtc));
    now.removeIf(isNew);
    QVERIFY(then.size() > 100);
    QVERIFY2(now == then, qPrintable(differences(then, now)));
}

DYNCAL_TEST(TestKeptProjects)
#include "tst_kept_projects.moc"
