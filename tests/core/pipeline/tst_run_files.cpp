// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/atomic_file.h"
#include "core/pipeline/model_export.h"
#include "core/pipeline/results_csv.h"
#include "core/pipeline/results_json.h"
#include "core/pipeline/run_files.h"
#include "tests/support/example_results.h"

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

using namespace dyncal;

namespace {

constexpr const char *kCreated = "2026-11-21T03:04:05Z";

RunFiles exampleRun()
{
    RunFiles run;
    run.outcome.results = example::calibration();
    run.createdUtc = kCreated;
    run.drawn
        = {{"certificate.pdf", "%PDF"}, {"plots/01-a.svg", "<svg>a"}, {"plots/02-b.svg", "<svg>b"}};
    return run;
}

QByteArray bytesOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TestRunFiles : public QObject
{
    Q_OBJECT

private slots:
    void write_completeRun_givesEveryFile();
    void write_runWithoutResults_givesRecipeAndResultsOnly();
    void write_overAnEarlierRun_removesItsFilesOnly();
    void write_resultsJson_isTheLast();
    void write_stoppedAtAnyFile_leavesNoResultsJson();
    void write_stoppedBefore_changesNothing();
    void write_tablesNameTaken_failsAndNamesIt();
    void makeFolder_nestedOrTaken();
    void progress_risesToOne();
};

void TestRunFiles::write_completeRun_givesEveryFile()
{
    const QTemporaryDir folder;
    const RunFiles run = exampleRun();
    const auto paths = writeRunFiles(run, folder.path().toStdString());
    QVERIFY(paths.has_value());
    QCOMPARE(*paths,
        (std::vector<std::string>{folder.filePath("results.json").toStdString(),
            folder.filePath("recipe.json").toStdString(),
            folder.filePath("certificate.pdf").toStdString(),
            folder.filePath("plots/").toStdString(), folder.filePath("csv/").toStdString(),
            folder.filePath("model/").toStdString()}));
    QCOMPARE(bytesOf(folder.filePath("results.json")).toStdString(),
        resultsJson(run.outcome, run.recipe, kCreated));
    QCOMPARE(bytesOf(folder.filePath("recipe.json")).toStdString(), recipeJson(run.recipe));
    QCOMPARE(bytesOf(folder.filePath("plots/02-b.svg")), QByteArray("<svg>b"));
    const std::vector<CsvFile> tables = resultsCsv(run.outcome.results);
    QVERIFY(!tables.empty());
    QCOMPARE(QDir(folder.filePath("csv")).entryList(QDir::Files).size(),
        static_cast<qsizetype>(tables.size()));
    for (const CsvFile &table : tables)
        QCOMPARE(bytesOf(folder.filePath("csv/" + QString::fromStdString(table.name))),
            QByteArray::fromStdString(table.text));
    for (const ModelFile &file : modelFiles(run.outcome.results))
        QCOMPARE(bytesOf(folder.filePath("model/" + QString::fromStdString(file.name))),
            QByteArray::fromStdString(file.bytes));
}

void TestRunFiles::write_runWithoutResults_givesRecipeAndResultsOnly()
{
    const QTemporaryDir folder;
    RunFiles run;
    run.createdUtc = kCreated;
    run.outcome.error = Error{ErrorKind::DataBlocked, {"Blocked.", {}}, "CAP-009", 1};
    const auto paths = writeRunFiles(run, folder.path().toStdString());
    QVERIFY(paths.has_value());
    QCOMPARE(paths->size(), std::size_t(2));
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
        QStringList({"recipe.json", "results.json"}));
}

void TestRunFiles::write_overAnEarlierRun_removesItsFilesOnly()
{
    const QTemporaryDir folder;
    const auto put = [&](const char *name) {
        const QString path = folder.filePath(name);
        QVERIFY(QFileInfo(path).dir().mkpath("."));
        QVERIFY(writeFileAtomically(path.toStdString(), "old"));
    };
    for (const char *name : {"dcc.xml", "certificate.pdf", "csv/old.csv", "plots/99-old.svg",
             "model/model.mat", "notes.txt", "csv/notes.txt", "plots/photo.png", "model/my.m"})
        put(name);
    RunFiles run = exampleRun();
    run.drawn.clear();
    run.outcome.results.model = nullptr; // nor does its model stay
    QVERIFY(writeRunFiles(run, folder.path().toStdString())); // no recipe.json: not ours
    QVERIFY(QFile::exists(folder.filePath("dcc.xml")));
    QVERIFY(QFile::exists(folder.filePath("csv/old.csv")));
    QVERIFY(writeRunFiles(run, folder.path().toStdString()));
    for (const char *gone :
        {"dcc.xml", "certificate.pdf", "csv/old.csv", "plots/99-old.svg", "model/model.mat"})
        QVERIFY2(!QFile::exists(folder.filePath(gone)), gone);
    for (const char *kept : {"notes.txt", "csv/notes.txt", "plots/photo.png", "model/my.m"})
        QCOMPARE(bytesOf(folder.filePath(kept)), QByteArray("old"));
}

void TestRunFiles::write_resultsJson_isTheLast()
{
    const QTemporaryDir folder;
    const QString results = folder.filePath("results.json");
    int reports = 0;
    int withResults = 0;
    const JobControl control{{}, [&](double) {
                                 ++reports;
                                 withResults += QFile::exists(results) ? 1 : 0;
                             }};
    QVERIFY(writeRunFiles(exampleRun(), folder.path().toStdString(), control));
    QVERIFY(reports > 5);
    QCOMPARE(withResults, 1);
}

void TestRunFiles::write_stoppedAtAnyFile_leavesNoResultsJson()
{
    const CalibrationResults results = exampleRun().outcome.results;
    const auto files
        = static_cast<int>(resultsCsv(results).size() + modelFiles(results).size() + 3 + 2);
    for (int stopAfter = 1; stopAfter < files; ++stopAfter) {
        const QTemporaryDir folder;
        std::stop_source stop;
        int written = 0;
        const JobControl control{stop.get_token(), [&](double) {
                                     if (++written == stopAfter)
                                         stop.request_stop();
                                 }};
        const auto paths = writeRunFiles(exampleRun(), folder.path().toStdString(), control);
        QVERIFY(!paths.has_value());
        QCOMPARE(paths.error().kind, ErrorKind::Cancelled);
        QVERIFY(!QFile::exists(folder.filePath("results.json")));
        // The next run must know that what is there is a run's.
        QVERIFY(QFile::exists(folder.filePath("recipe.json")));
    }
}

void TestRunFiles::write_stoppedBefore_changesNothing()
{
    const QTemporaryDir folder;
    for (const char *name : {"recipe.json", "results.json"})
        QVERIFY(writeFileAtomically(folder.filePath(name).toStdString(), "old"));
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(!writeRunFiles(exampleRun(), folder.path().toStdString(), {stop.get_token(), {}}));
    QCOMPARE(bytesOf(folder.filePath("results.json")), QByteArray("old"));
    QCOMPARE(bytesOf(folder.filePath("recipe.json")), QByteArray("old"));
}

void TestRunFiles::write_tablesNameTaken_failsAndNamesIt()
{
    const QTemporaryDir folder;
    QVERIFY(writeFileAtomically(folder.filePath("csv").toStdString(), "a file"));
    const auto paths = writeRunFiles(exampleRun(), folder.path().toStdString());
    QVERIFY(!paths.has_value());
    QCOMPARE(paths.error().kind, ErrorKind::Usage);
    const std::string sentence = english(paths.error().message);
    QVERIFY2(sentence.find("csv cannot be made") != std::string::npos, sentence.c_str());
    QVERIFY(!QFile::exists(folder.filePath("results.json")));
    QCOMPARE(bytesOf(folder.filePath("csv")), QByteArray("a file"));
}

void TestRunFiles::makeFolder_nestedOrTaken()
{
    const QTemporaryDir folder;
    QVERIFY(makeFolder(folder.filePath("a/b/c").toStdString()));
    QVERIFY(makeFolder(folder.filePath("a/b/c").toStdString())); // there already
    QVERIFY(QDir(folder.filePath("a/b/c")).exists());
    QVERIFY(writeFileAtomically(folder.filePath("taken").toStdString(), "x"));
    QVERIFY(!makeFolder(folder.filePath("taken").toStdString()));
    QVERIFY(!makeFolder(folder.filePath("taken/below").toStdString()));
}

void TestRunFiles::progress_risesToOne()
{
    const QTemporaryDir folder;
    double last = 0.0;
    bool rises = true;
    const JobControl control{{}, [&](double done) {
                                 rises = rises && done > last;
                                 last = done;
                             }};
    QVERIFY(writeRunFiles(exampleRun(), folder.path().toStdString(), control));
    QVERIFY(rises);
    QCOMPARE(last, 1.0);
}

QTEST_APPLESS_MAIN(TestRunFiles)
#include "tst_run_files.moc"
