// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"
#include "tests/system/quick_recipe.h"

#include <QDir>
#include <QJsonArray>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace {

/// The truth of the preset optic3 as the capture states it; damping is known less well than
/// frequency because it shows in the decay only.
constexpr double kLargestErrorF0 = 0.001;
constexpr double kLargestErrorZeta = 0.03;

const QStringList kEpoch{"SOURCE_DATE_EPOCH=1767225600"};

/// The sensor's pole with the largest amplitude above the real axis.
QJsonObject mainPole(const QJsonObject &results)
{
    QJsonObject strongest;
    for (const QJsonValue &pole : results["model"]["poles"].toArray()) {
        const bool rings = pole["class"].toString() == "sensor" && pole["im"].toDouble() > 0.0;
        if (rings && pole["amplitude"].toDouble() > strongest["amplitude"].toDouble())
            strongest = pole.toObject();
    }
    return strongest;
}

/// A value of the truth table that `simulate` prints, in SI.
double printedTruth(const QByteArray &table, int column)
{
    const QString row = QString::fromUtf8(table).section("\n1     ", 1).section('\n', 0, 0);
    const QStringList cells = row.split(QRegularExpression(" {2,}"), Qt::SkipEmptyParts);
    const QString value = cells.value(column).section(' ', 0, 0);
    const QString unit = cells.value(column).section(' ', 1);
    const double factor = unit.startsWith('M') ? 1e6 : unit.startsWith('k') ? 1e3 : 1.0;
    return value.toDouble() * factor;
}

QJsonObject characteristic(const QJsonObject &results, const QString &quantity)
{
    for (const QJsonValue &one : results["characteristics"].toArray())
        if (one["quantity"].toString() == quantity)
            return one.toObject();
    return {};
}

} // namespace

/// The whole chain on the simulated example: what a lab script sees.
class TestCalibrationRun : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QByteArray m_truth;
    Answer m_answer; ///< of the example, which lies in "a"
    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }

    Answer runExample(const char *output, const QStringList &more = {}) const
    {
        return runOf("example.h5", output, more);
    }
    /// Of the same sensor at a fifth of the rate: for what does not hang on the record.
    Answer runSmall(const char *output, const QStringList &more = {}) const
    {
        return runOf("small.h5", output, more);
    }
    Answer runOf(const char *capture, const char *output, const QStringList &more) const
    {
        return runDyncal(QStringList{"run", path(capture), "-o", path(output)} + more
                + (more.contains("--recipe") ? QStringList() : quickly()),
            kEpoch);
    }

private slots:
    void initTestCase()
    {
        const Answer answer
            = runDyncal({"simulate", "-o", path("example.h5"), "--preset", "optic3"}, kEpoch);
        QCOMPARE(answer.exitCode, 0);
        m_truth = answer.out;
        QCOMPARE(runDyncal({"simulate", "-o", path("small.h5"), "--preset", "optic3",
                               "--sample-rate-hz", "2e7", "--duration-s", "0.006"},
                     kEpoch)
                     .exitCode,
            0);
        m_answer = runExample("a");
        QVERIFY2(m_answer.exitCode == 0 || m_answer.exitCode == 1, m_answer.err);
    }

    void run_makesNoFolderForTemporaryFiles()
    {
        const QString nowhere = path("tmp/deep");
        for (const QString &runtime : {QString(), path("runtime")}) {
            const Answer answer = runDyncal(
                QStringList{"run", path("small.h5"), "-o", path("strayless")} + quickly(),
                {"TMPDIR=" + nowhere, "XDG_RUNTIME_DIR=" + runtime});
            QVERIFY2(answer.exitCode <= 1, answer.err);
            QVERIFY(QFile::exists(path("strayless/certificate.pdf")));
            QVERIFY(!QFile::exists(path("tmp")));
            QVERIFY(!QFile::exists(path("runtime")));
        }
    }

    /// The recipe lay in another folder, beside the table that it names; the run's own folder is
    /// enough to repeat it, wherever that is moved to.
    void repeatedFromItsFolder_sameResults()
    {
        QVERIFY(QDir(m_folder.path()).mkpath("laboratory"));
        QFile table(path("laboratory/amp.csv"));
        QVERIFY(table.open(QIODevice::WriteOnly));
        table.write("frequency_hz,magnitude,u_magnitude\n500,1,1e-3\n5e3,1,1e-3\n5e4,1,1e-3\n"
                    "5e5,0.999,1e-3\n5e6,0.98,2e-3\n");
        table.close();
        QFile recipe(path("laboratory/recipe.json"));
        QVERIFY(recipe.open(QIODevice::WriteOnly));
        recipe.write(R"({"schema": "dyncal-recipe/1", "chain": {"source": "amp.csv"},
            "uncertainty": {"monte_carlo_trials": 100}})");
        recipe.close();
        const Answer first = runSmall("with_chain", {"--recipe", path("laboratory/recipe.json")});
        QVERIFY2(first.exitCode <= 1, first.err);
        QVERIFY(QDir(m_folder.path()).rename("with_chain", "moved"));
        QVERIFY(QDir(path("laboratory")).removeRecursively());
        const Answer again = runSmall("again", {"--recipe", path("moved/recipe.json")});
        QVERIFY2(again.exitCode <= 1, again.err);
        QCOMPARE(bytesOf(path("again/results.json")), bytesOf(path("moved/results.json")));
        QCOMPARE(QDir(path("again/sources")).entryList(QDir::Files),
            QDir(path("moved/sources")).entryList(QDir::Files));
        const Answer without = runSmall("again"); // a run that needs none leaves none
        QVERIFY(without.exitCode <= 1 && !QFile::exists(path("again/sources")));
    }

    void certificate_saysWhatResultsSay()
    {
        QProcess reader;
        reader.start("pdftotext", {"-layout", path("a/certificate.pdf"), "-"});
        if (!reader.waitForStarted())
            QSKIP("pdftotext (package poppler-utils) is missing: the PDF was not read.");
        QVERIFY(reader.waitForFinished());
        const QString text = QString::fromUtf8(reader.readAllStandardOutput());
        const QJsonObject results = fileJson(path("a/results.json"));
        const QJsonObject pole = mainPole(results);
        const auto printed = [&text](const char *pattern) {
            const QRegularExpression expression(QString::fromUtf8(pattern));
            return expression.match(text);
        };
        const auto frequency = printed("natural frequency +([0-9.]+) MHz +([0-9.]+) MHz +2\\s");
        QVERIFY(frequency.hasMatch());
        const double expanded_Hz = frequency.captured(2).toDouble() * 1e6;
        // printed to the second digit of U: half a unit of that digit
        QVERIFY(std::abs(frequency.captured(1).toDouble() * 1e6 - pole["frequency_hz"].toDouble())
            <= 0.05 * expanded_Hz);
        const QJsonObject f0 = characteristic(results, "f0_hz"); // complete: with the clock
        QVERIFY(f0["u"].toDouble() > pole["u_frequency_hz"].toDouble());
        QVERIFY(std::abs(expanded_Hz / (2.0 * f0["u"].toDouble()) - 1.0) < 0.06);
        const auto damping = printed("Damping ratio +([0-9.]+) +([0-9.]+) +2\\s");
        QVERIFY(damping.hasMatch());
        QVERIFY(std::abs(damping.captured(1).toDouble() - pole["damping_ratio"].toDouble())
            <= 0.05 * damping.captured(2).toDouble());
        QVERIFY(text.contains(results["inputs"].toArray().first()["sha256"].toString()));
        QVERIFY(text.contains("DRAFT") || text.contains("Draft"));
    }
    void example_givesTheTruth()
    {
        const QJsonObject results = fileJson(path("a/results.json"));
        QCOMPARE(results["schema"].toString(), QStringLiteral("dyncal-results/1"));
        QCOMPARE(results["created_utc"].toString(), QStringLiteral("2026-01-01T00:00:00Z"));
        QCOMPARE(results["realization"]["suggested_order"].toInt(), 2);
        QCOMPARE(results["model"]["order"].toInt(), 2);
        const QJsonObject pole = mainPole(results);
        const double f0 = printedTruth(m_truth, 1);
        const double zeta = printedTruth(m_truth, 2);
        QVERIFY2(f0 > 1e3 && zeta > 0.0, m_truth);
        QVERIFY2(std::abs(pole["frequency_hz"].toDouble() / f0 - 1.0) < kLargestErrorF0,
            QByteArray::number(pole["frequency_hz"].toDouble()));
        QVERIFY2(std::abs(pole["damping_ratio"].toDouble() / zeta - 1.0) < kLargestErrorZeta,
            QByteArray::number(pole["damping_ratio"].toDouble()));
    }

    void example_writesEveryFileItNames()
    {
        const QString written = QString::fromUtf8(m_answer.out).section("Written:\n", 1);
        const QStringList lines = written.split('\n', Qt::SkipEmptyParts);
        QVERIFY2(lines.size() > 3, m_answer.out);
        for (const QString &line : lines)
            QVERIFY2(QFile::exists(line.trimmed()), qPrintable(line));
        for (const char *name : {"a/results.json", "a/recipe.json", "a/certificate.pdf",
                 "a/csv/spectrum_shot_001.csv", "a/csv/singular_values.csv", "a/csv/components.csv",
                 "a/csv/frequency_response.csv"})
            QVERIFY2(QFile::exists(path(name)), name);
        QVERIFY(!QDir(path("a/plots")).entryList({"*.svg"}).isEmpty());
        QVERIFY(bytesOf(path("a/certificate.pdf")).startsWith("%PDF-"));
        QVERIFY(QDir(path("files")).entryList({"*.part*"}, QDir::Files | QDir::Hidden).isEmpty());
    }

    void summary_showsTheKeyResults()
    {
        for (const char *label : {"Natural frequency f0", "Damping ratio zeta", "Sensitivity",
                 "of attainable", "Order", "Findings"})
            QVERIFY2(m_answer.out.contains(label), m_answer.out);
    }

    void secondRun_inAnotherLocale_isByteIdentical()
    {
        QVERIFY(runDyncal(QStringList{"run", path("example.h5"), "-o", path("b")} + quickly(),
                    kEpoch + QStringList{"LC_ALL=sv_SE.UTF-8", "LANG=sv_SE.UTF-8"})
                    .exitCode
            <= 1);
        QVERIFY(!bytesOf(path("a/results.json")).isEmpty());
        QVERIFY(bytesOf(path("a/results.json")) == bytesOf(path("b/results.json")));
        const QStringList tables = QDir(path("a/csv")).entryList(QDir::Files);
        QVERIFY(!tables.isEmpty());
        for (const QString &name : tables)
            QVERIFY2(
                bytesOf(path("a/csv/") + name) == bytesOf(path("b/csv/") + name), qPrintable(name));
    }

    void recipeAsUsed_repeatsTheRun()
    {
        QVERIFY(runExample("again", {"--recipe", path("a/recipe.json")}).exitCode <= 1);
        QVERIFY(bytesOf(path("a/results.json")) == bytesOf(path("again/results.json")));
    }

    void orderAskedFor_isUsedAndTheSuggestionStays()
    {
        const Answer answer = runExample("ten", {"--order", "10"});
        QVERIFY2(answer.exitCode <= 2, answer.err);
        const QJsonObject results = fileJson(path("ten/results.json"));
        QCOMPARE(results["model"]["order"].toInt(), 10);
        QCOMPARE(results["model"]["poles"].toArray().size(), 10);
        QCOMPARE(results["realization"]["suggested_order"].toInt(), 2);
        QCOMPARE(results["recipe"]["realization"]["order"].toInt(), 10);
    }

    void thesisTreatment_countsTheStepAsAState()
    {
        QVERIFY(writeBytes(path("thesis.json"), R"({"input": {"treatment": "step-as-impulse"},
                "uncertainty": {"monte_carlo_trials": 100}})"));
        const Answer answer = runSmall("thesis", {"--recipe", path("thesis.json"), "--order", "3"});
        QVERIFY2(answer.exitCode <= 1, answer.err);
        const QJsonObject results = fileJson(path("thesis/results.json"));
        QCOMPARE(results["input"]["combine"].toString(), QStringLiteral("pca-average"));
        QVERIFY(results["model"]["fit_listing_percent"].isDouble());
        QStringList classes;
        for (const QJsonValue &pole : results["model"]["poles"].toArray())
            classes << pole["class"].toString();
        QCOMPARE(classes.count("step"), 1);
        QCOMPARE(results["model"]["D"][0][0].toDouble(), 0.0);
        const double f0 = printedTruth(m_truth, 1);
        const double found = mainPole(results)["frequency_hz"].toDouble();
        QVERIFY2(std::abs(found / f0 - 1.0) < 10.0 * kLargestErrorF0, QByteArray::number(found));
    }

    void noStep_isBlockedAndKeepsWhatThereIs()
    {
        QCOMPARE(
            runDyncal({"simulate", "-o", path("nostep.h5"), "--defect", "nostep"}, kEpoch).exitCode,
            0);
        const Answer answer = runDyncal({"run", path("nostep.h5"), "-o", path("nostep")}, kEpoch);
        QCOMPARE(answer.exitCode, 2);
        QVERIFY2(answer.err.contains("CAP-009"), answer.err);
        const QJsonObject results = fileJson(path("nostep/results.json"));
        QVERIFY(results["model"].isNull());
        QVERIFY(!results["model_reason"].toString().isEmpty());
        QCOMPARE(results["shots"].toArray().size(), 3);
        QVERIFY(!QFile::exists(path("nostep/certificate.pdf")));
        bool listed = false;
        for (const QJsonValue &finding : results["findings"].toArray())
            listed = listed || finding["id"].toString() == "CAP-009";
        QVERIFY(listed);
    }

    void onlyTheDut_isCalibratedWithoutPressureAndSaysSo()
    {
        QVERIFY(writeBytes(path("only-dut.json"),
            R"({"schema": "dyncal-recipe/1", "import": {"channels":
                {"Driven side": "other", "Driver": "other"}},
                "uncertainty": {"monte_carlo_trials": 100}})"));
        const Answer answer = runSmall("only-dut", {"--recipe", path("only-dut.json")});
        QVERIFY2(answer.exitCode <= 1, answer.err);
        const QJsonObject results = fileJson(path("only-dut/results.json"));
        QVERIFY(results["model"].isObject()); // frequency and damping need no pressure
        const QJsonObject shot = results["shock"].toArray().first().toObject();
        QVERIFY(shot["step_pa"].isNull() && !shot["step_pa_reason"].toString().isEmpty());
        QVERIFY(shot["u_step_pa"].isNull() && shot["arrivals"].toArray().isEmpty());
        QVERIFY(results["shots"].toArray().first()["sensitivity"].isNull());
        QVERIFY2(answer.out.contains("not determined"), answer.out);
        QVERIFY2(answer.out.contains("the shock velocity is unknown"), answer.out);
    }

    void checkedShots_areNamed()
    {
        const Answer answer = runDyncal({"check", path("example.h5")}, kEpoch);
        for (const char *line : {"SHK-005 (info, shot 1)", "SHK-005 (info, shot 3)"})
            QVERIFY2(answer.out.contains(line), answer.out);
        QVERIFY2(!answer.out.contains("shot 1): Shot 1"), answer.out);
    }

    void blockedRun_removesTheCertificateOfAnEarlierOne()
    {
        QCOMPARE(QProcess::execute("cp", {"-R", path("a"), path("reused")}), 0);
        QVERIFY(QFile::exists(path("reused/certificate.pdf")));
        QVERIFY(QFile::exists(path("reused/csv/poles.csv")));
        QCOMPARE(runDyncal({"simulate", "-o", path("none.h5"), "--defect", "nostep"}).exitCode, 0);
        QCOMPARE(runDyncal({"run", path("none.h5"), "-o", path("reused")}).exitCode, 2);
        QVERIFY(!QFile::exists(path("reused/certificate.pdf")));
        QVERIFY(!QFile::exists(path("reused/csv/poles.csv")));
        QVERIFY(fileJson(path("reused/results.json"))["model"].isNull());
    }

    void otherFilesInAFolderWithSpacesAndLetters_areLeftAlone()
    {
        const QString folder = path("ut å ö/dir");
        QVERIFY(QDir().mkpath(folder + "/csv"));
        QVERIFY(writeBytes(folder + "/certificate.pdf.note", "mine"));
        QVERIFY(writeBytes(folder + "/csv/mine.csv", "mine")); // no earlier run: not ours
        QVERIFY(runDyncal(QStringList{"run", path("small.h5"), "-o", folder} + quickly()).exitCode
            <= 1);
        QVERIFY(QFile::exists(folder + "/results.json"));
        QCOMPARE(bytesOf(folder + "/certificate.pdf.note"), QByteArray("mine"));
        QCOMPARE(bytesOf(folder + "/csv/mine.csv"), QByteArray("mine"));
    }
};

DYNCAL_TEST(TestCalibrationRun)
#include "tst_calibration_run.moc"
