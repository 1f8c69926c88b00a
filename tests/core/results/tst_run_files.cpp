// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/content_hash.h"
#include "core/base/writing/atomic_file.h"
#include "core/capture/capture_seal.h"
#include "core/capture/file_samples.h"
#include "core/results/model_export.h"
#include "core/results/results_csv.h"
#include "core/results/results_json.h"
#include "core/results/run_files.h"
#include "tests/support/example_results.h"
#include "tests/support/file_bytes.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

using namespace dyncal;
using testing::bytesOf;

namespace {

constexpr const char *kCreated = "2026-11-21T03:04:05Z";

RunFiles exampleRun()
{
    RunFiles run;
    run.outcome.results = example::calibration();
    run.createdUtc = kCreated;
    run.drawn = {{"certificate.pdf", "%PDF"}, {"plots/01-raw-dut.svg", "<svg>a"},
        {"plots/02-responses.svg", "<svg>b"}};
    return run;
}

Result<std::vector<std::string>> writeInto(
    const QString &folder, const RunFiles &run, const JobControl &control = {})
{
    Result<FolderWrite> target = FolderWrite::begin(runFolder(folder.toStdString(), {}));
    return target ? writeRunFiles(run, *target, control)
                  : Result<std::vector<std::string>>(tl::unexpected(target.error()));
}

} // namespace

class TestRunFiles : public QObject
{
    Q_OBJECT

private slots:
    void write_completeRun_givesEveryFile();
    void write_runWithoutResults_givesRecipeAndResultsOnly();
    void write_blockedRun_givesRecipeAndResultsOnly();
    void write_ofABatch_hasItsRecord();
    void write_templateOfAFile_isKeptAndNamed();
    void write_overAnEarlierRun_removesItsFilesOnly();
    void write_resultsJson_isTheLast();
    void write_stoppedAtAnyFile_changesNothing();
    void write_overAFolderOfAnOlderVersion_isRefused();
    void list_claimsNoNameThatIsNotWritten();
    void model_isWrittenBesideARun();
    void write_stoppedBefore_changesNothing();
    void write_tablesNameTaken_failsAndNamesIt();
    void write_recordingGoneMeanwhile_keepsTheEarlierRun();
    void progress_risesToOne();
};

void TestRunFiles::write_completeRun_givesEveryFile()
{
    const QTemporaryDir folder;
    const RunFiles run = exampleRun();
    const auto paths = writeInto(folder.path(), run);
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
    QCOMPARE(bytesOf(folder.filePath("plots/02-responses.svg")), QByteArray("<svg>b"));
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

/// What the certificate was drawn by lies beside it; results.json and recipe.json name it there.
void TestRunFiles::write_templateOfAFile_isKeptAndNamed()
{
    const QTemporaryDir folder;
    RunFiles run = exampleRun();
    run.recipe.certificate.templateName = "/lab/ours.json";
    run.chosen.file = "/lab/ours.json";
    run.chosen.layout.figures = {"phase"};
    QVERIFY(writeInto(folder.path(), run).has_value());
    const Result<Recipe> recipe = readRecipeFile(folder.filePath("recipe.json").toStdString());
    QVERIFY(recipe);
    const std::string name = recipe->certificate.templateName;
    QVERIFY2(name.starts_with("sources/") && name.ends_with("-ours.json"), name.c_str());
    QCOMPARE(bytesOf(folder.filePath(QString::fromStdString(name))).toStdString(),
        templateJson(run.chosen.layout));
    QVERIFY(!bytesOf(folder.filePath("results.json")).contains("/lab/"));
    QVERIFY(bytesOf(folder.filePath("results.json")).contains(name.c_str()));
    QVERIFY(writeInto(folder.path(), exampleRun()).has_value());
    QVERIFY(!QFile::exists(folder.filePath(QString::fromStdString(name))));
}

/// A plain run into the same folder takes the record away: it is of other results then.
void TestRunFiles::write_ofABatch_hasItsRecord()
{
    const QTemporaryDir folder;
    RunFiles run = exampleRun();
    run.record = "{\"key\": 1}";
    QVERIFY(writeInto(folder.path(), run).has_value());
    QCOMPARE(bytesOf(folder.filePath(kBatchRecord)), QByteArray("{\"key\": 1}"));
    QVERIFY(bytesOf(folder.filePath("written.json")).contains("\"batch.json\""));
    QVERIFY(writeInto(folder.path(), exampleRun()).has_value());
    QVERIFY(!QFile::exists(folder.filePath(kBatchRecord)));
    run.outcome.error = Error{ErrorKind::DataBlocked, {"Blocked.", {}}, "CAP-009", 1};
    QVERIFY(writeInto(folder.path(), run).has_value());
    QCOMPARE(bytesOf(folder.filePath(kBatchRecord)), QByteArray("{\"key\": 1}"));
    QVERIFY(!QFile::exists(folder.filePath("certificate.pdf")));
}

void TestRunFiles::write_runWithoutResults_givesRecipeAndResultsOnly()
{
    const QTemporaryDir folder;
    RunFiles run;
    run.createdUtc = kCreated;
    run.outcome.error = Error{ErrorKind::DataBlocked, {"Blocked.", {}}, "CAP-009", 1};
    const auto paths = writeInto(folder.path(), run);
    QVERIFY(paths.has_value());
    QCOMPARE(paths->size(), std::size_t(2));
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
        QStringList({"recipe.json", "results.json", "written.json"}));
}

void TestRunFiles::write_blockedRun_givesRecipeAndResultsOnly()
{
    const QTemporaryDir folder;
    RunFiles run = exampleRun(); // complete, but for what one stage found
    auto response = std::make_shared<ResponseResult>(*run.outcome.results.response);
    response->findings.push_back(
        {.id = "CAP-015", .severity = Severity::Block, .message = {"Changed.", {}}});
    run.outcome.results.response = response;
    QVERIFY(writeInto(folder.path(), run));
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
        QStringList({"recipe.json", "results.json", "written.json"}));
    QVERIFY(bytesOf(folder.filePath("results.json")).contains("CAP-015"));
}

void TestRunFiles::write_overAnEarlierRun_removesItsFilesOnly()
{
    const QTemporaryDir folder;
    QVERIFY(writeInto(folder.path(), exampleRun()));
    QVERIFY(QFile::exists(folder.filePath("model/model.mat")));
    for (const char *name : {"notes.txt", "csv/notes.csv", "plots/photo.svg", "model/my.m"})
        QVERIFY(writeFileAtomically(folder.filePath(name).toStdString(), "mine"));
    RunFiles run = exampleRun();
    run.drawn.clear();
    run.outcome.results.model = nullptr; // nor does its model stay
    QVERIFY(writeInto(folder.path(), run));
    for (const char *gone :
        {"certificate.pdf", "plots/01-raw-dut.svg", "plots/02-responses.svg", "model/model.mat"})
        QVERIFY2(!QFile::exists(folder.filePath(gone)), gone);
    for (const char *kept : {"notes.txt", "csv/notes.csv", "plots/photo.svg", "model/my.m"})
        QCOMPARE(bytesOf(folder.filePath(kept)), QByteArray("mine"));
}

void TestRunFiles::write_overAFolderOfAnOlderVersion_isRefused()
{
    const QTemporaryDir folder;
    for (const char *name : {"recipe.json", "results.json", "certificate.pdf"})
        QVERIFY(writeFileAtomically(folder.filePath(name).toStdString(), "old"));
    const auto paths = writeInto(folder.path(), exampleRun());
    QVERIFY(!paths.has_value());
    QCOMPARE(paths.error().kind, ErrorKind::Usage);
    for (const char *name : {"recipe.json", "results.json", "certificate.pdf"})
        QCOMPARE(bytesOf(folder.filePath(name)), QByteArray("old"));
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
    QVERIFY(writeInto(folder.path(), exampleRun(), control));
    QVERIFY(reports > 5);
    QCOMPARE(withResults, 0); // all files appear at once, behind the last of them
    QVERIFY(QFile::exists(results));
}

void TestRunFiles::write_stoppedAtAnyFile_changesNothing()
{
    const CalibrationResults results = exampleRun().outcome.results;
    const auto files
        = static_cast<int>(resultsCsv(results).size() + modelFiles(results).size() + 3 + 2);
    for (int stopAfter = 1; stopAfter <= files; ++stopAfter) {
        const QTemporaryDir folder;
        std::stop_source stop;
        int written = 0;
        const JobControl control{stop.get_token(), [&](double) {
                                     if (++written == stopAfter)
                                         stop.request_stop();
                                 }};
        const auto paths = writeInto(folder.path(), exampleRun(), control);
        QVERIFY(!paths.has_value());
        QCOMPARE(paths.error().kind, ErrorKind::Cancelled);
        QVERIFY(
            QDir(folder.path()).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
    }
}

void TestRunFiles::write_stoppedBefore_changesNothing()
{
    const QTemporaryDir folder;
    QVERIFY(writeInto(folder.path(), exampleRun()));
    const QByteArray before = bytesOf(folder.filePath("written.json"));
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(!writeInto(folder.path(), exampleRun(), {stop.get_token(), {}}));
    QCOMPARE(bytesOf(folder.filePath("written.json")), before);
    QVERIFY(QFile::exists(folder.filePath("results.json")));
}

/// A list that names a recording, or anything else that no run writes, removes nothing.
void TestRunFiles::list_claimsNoNameThatIsNotWritten()
{
    const std::string bytes = "recording";
    for (const char *name : {"csv/shot.csv", "csv/response_shot_1.csv",
             "csv/response_shot_0001.csv", "csv/response_.csv", "csv/response_shot_001x.csv",
             "csv/measured_shot_001.csv", "csv/poles.CSV", "plots/photo.svg", "plots/01-photo.svg",
             "plots/1-step.svg", "plots/step.svg", "plots/.svg", "csv/.csv", "model/mine.m"}) {
        const QTemporaryDir folder;
        const std::string at = folder.filePath(name).toStdString();
        QVERIFY(QDir().mkpath(QFileInfo(folder.filePath(name)).path()));
        QVERIFY(writeFileAtomically(at, bytes));
        QVERIFY(writeFileAtomically(folder.filePath("written.json").toStdString(),
            writtenListText({{name, "run", sha256Hex(bytes)}})));
        QVERIFY2(!writeInto(folder.path(), exampleRun()), name);
        QCOMPARE(bytesOf(folder.filePath(name)), QByteArray("recording"));
    }
    const FolderRequest request = runFolder("out", {});
    for (const CsvFile &table : resultsCsv(exampleRun().outcome.results))
        QVERIFY2(request.mayWrite("csv/" + table.name), table.name.c_str());
    for (const char *name : {"csv/spectrum_shot_1000.csv", "csv/model_average.csv",
             "csv/model_input_shot_012.csv", "plots/21-phase.svg"})
        QVERIFY2(request.mayWrite(name), name);
}

/// Each kind of writer replaces what it wrote itself.
void TestRunFiles::model_isWrittenBesideARun()
{
    const QTemporaryDir folder;
    const auto exportModel = [&](const std::vector<std::string> &formats) {
        Result<FolderWrite> target
            = FolderWrite::begin(modelFolder(folder.path().toStdString(), {}));
        return target && writeModelFiles(exampleRun().outcome.results, formats, *target);
    };
    QVERIFY(exportModel({"mat", "py"}));
    QVERIFY(writeInto(folder.path(), exampleRun()));
    QVERIFY(QFile::exists(folder.filePath("model.mat")));
    QVERIFY(exportModel({"json"}));
    QVERIFY(!QFile::exists(folder.filePath("model.mat")));
    QVERIFY(QFile::exists(folder.filePath("model.json")));
    QVERIFY(QFile::exists(folder.filePath("results.json")));
    QVERIFY(writeInto(folder.path(), exampleRun()));
    QVERIFY(QFile::exists(folder.filePath("model.json")));
    QVERIFY(writeFileAtomically(folder.filePath("model.json").toStdString(), "edited"));
    QVERIFY(!exportModel({"json"}));
    QCOMPARE(bytesOf(folder.filePath("model.json")), QByteArray("edited"));
}

void TestRunFiles::write_tablesNameTaken_failsAndNamesIt()
{
    const QTemporaryDir folder;
    QVERIFY(writeFileAtomically(folder.filePath("csv").toStdString(), "a file"));
    const auto paths = writeInto(folder.path(), exampleRun());
    QVERIFY(!paths.has_value());
    QCOMPARE(paths.error().kind, ErrorKind::Usage);
    const std::string sentence = english(paths.error().message);
    QVERIFY2(sentence.find("csv is in the way") != std::string::npos, sentence.c_str());
    QVERIFY(!QFile::exists(folder.filePath("results.json")));
    QCOMPARE(bytesOf(folder.filePath("csv")), QByteArray("a file"));
}

void TestRunFiles::write_recordingGoneMeanwhile_keepsTheEarlierRun()
{
    const QTemporaryDir folder;
    const std::string recording = folder.filePath("a.raw").toStdString();
    QVERIFY(writeFileAtomically(recording, "abcdef"));
    SampleLayout layout;
    layout.extents = {{0, 3}};
    CaptureSet set;
    set.inputs = {stampedInput(recording, "raw")};
    set.shots.resize(1);
    set.shots[0].channels.resize(1);
    set.shots[0].channels[0].samples = *samplesInFile(*SampleFile::open(recording), layout);
    const std::string out = folder.filePath("out").toStdString();
    const auto write = [&](const FolderRequest &request, const auto &writer) {
        Result<FolderWrite> target = FolderWrite::begin(request);
        return target ? writer(*target)
                      : Result<std::vector<std::string>>(tl::unexpected(target.error()));
    };
    RunFiles run = exampleRun();
    const auto writeRun = [&](FolderWrite &target) { return writeRunFiles(run, target); };
    const auto writeModel = [&](FolderWrite &target) {
        return writeModelFiles(run.outcome.results, modelFormats(), target);
    };
    QVERIFY(write(runFolder(out, set), writeRun).has_value());
    const QByteArray before = bytesOf(folder.filePath("out/results.json"));
    QTest::qWait(20); // file systems count time in ticks
    QVERIFY(QFile::rename(folder.filePath("a.raw"), folder.filePath("b.raw")));
    run.createdUtc = "2026-11-22T03:04:05Z";
    for (const auto &refused :
        {write(runFolder(out, set), writeRun), write(modelFolder(out, set), writeModel)}) {
        QVERIFY(!refused.has_value());
        QCOMPARE(refused.error().findingId, std::string("CAP-015"));
    }
    QCOMPARE(bytesOf(folder.filePath("out/results.json")), before);
    QVERIFY(!QFile::exists(folder.filePath("out/model.mat")));
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
        QStringList({"b.raw", "out"}));
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
    QVERIFY(writeInto(folder.path(), exampleRun(), control));
    QVERIFY(rises);
    QCOMPARE(last, 1.0);
}

DYNCAL_TEST(TestRunFiles)
#include "tst_run_files.moc"
