// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/json_text.h"
#include "core/recheck/method_changes.h"
#include "tests/support/test_program.h"
#include "tests/system/quick_recipe.h"
#include "tests/system/short_capture.h"

#include <QCryptographicHash>
#include <QDir>
#include <QDirIterator>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <csignal>

namespace {

const QStringList kEpoch{"SOURCE_DATE_EPOCH=1767225600"};

QString keptRuns()
{
    return qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/tests/data/kept_runs";
}

Answer recheck(const QStringList &arguments)
{
    return runDyncal(QStringList{"recheck"} + arguments, kEpoch);
}

QJsonArray rowsOf(const QStringList &arguments)
{
    return QJsonDocument::fromJson(recheck(arguments + QStringList{"--json"}).out).array();
}

QStringList kindsOf(const QJsonArray &rows)
{
    QStringList kinds;
    for (const QJsonValue &row : rows)
        kinds << row["kind"].toString();
    return kinds;
}

QByteArray sha256(const QString &path)
{
    return QCryptographicHash::hash(bytesOf(path), QCryptographicHash::Sha256).toHex();
}

bool changeResults(const QString &folder, const std::function<void(nlohmann::json &)> &change)
{
    nlohmann::json root = nlohmann::json::parse(bytesOf(folder + "/results.json").toStdString());
    change(root);
    return writeBytes(folder + "/results.json", QByteArray::fromStdString(dyncal::jsonText(root)));
}

/// Every file below with its bytes and time of change.
QMap<QString, QByteArray> stateBelow(const QString &folder)
{
    QMap<QString, QByteArray> files;
    for (QDirIterator entry(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
         entry.hasNext();) {
        const QFileInfo file = entry.nextFileInfo();
        files[file.filePath()]
            = bytesOf(file.filePath()) + file.lastModified().toString(Qt::ISODateWithMs).toUtf8();
    }
    return files;
}

} // namespace

/// Earlier results computed again by the built program.
class TestRecheck : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_simulated;

    /// A laboratory's folder with a recording "shot.h5" and its results in "out".
    struct Laboratory
    {
        QTemporaryDir folder;
        QString path(const QString &name) const { return folder.filePath(name); }
    };

    void prepare(const Laboratory &lab) const
    {
        QVERIFY(QFile::copy(m_simulated.filePath("shot.h5"), lab.path("shot.h5")));
        QVERIFY(QDir().mkpath(lab.path("out")));
        for (const char *name : {"results.json", "recipe.json", "written.json"})
            QVERIFY(QFile::copy(
                m_simulated.filePath(QString("out/") + name), lab.path(QString("out/") + name)));
    }

private slots:
    void initTestCase()
    {
        QVERIFY(simulateShortCapture(m_simulated.filePath("shot.h5"), 7));
        QVERIFY(runDyncal(QStringList{"run", m_simulated.filePath("shot.h5"), "-o",
                              m_simulated.filePath("out")}
                        + quickly(),
                    kEpoch)
                    .exitCode
            <= 1);
    }

    void ownResults_haveNone();
    void everythingOfAFolder_staysAsItIs();
    void keptRuns_areComputedAgain_data();
    void keptRuns_areComputedAgain();
    void keptRuns_ofTheseMethods_areAsIssued();
    void differenceOverU_isListedWithItsSize();
    void worstOfAllFolders_comesFirst();
    void missingRecording_stopsNoOtherFolder();
    void changedRecording_isNamed();
    void renamedRecording_isReadByItsOldName();
    void treeOfABatch_isTakenWhole();
    void nowBlocked_isSaid();
    void readerThatRefuses_isBlocked();
    void wrongInput_isSaidInOneSentence_data();
    void wrongInput_isSaidInOneSentence();
    void interrupted_leavesNothing();
};

void TestRecheck::ownResults_haveNone()
{
    const Answer text = recheck({m_simulated.filePath("out")});
    QCOMPARE(text.exitCode, 0);
    QVERIFY(text.out.startsWith((m_simulated.filePath("out") + ": none\n").toUtf8()));
    QVERIFY2(text.out.contains("all exactly as issued"), text.out);
    QVERIFY(text.out.contains("methods     as now"));
    QCOMPARE(text.err, QByteArray());
    const Answer json = recheck({m_simulated.filePath("out"), "--json"});
    QCOMPARE(json.exitCode, 0);
    QCOMPARE(json.out, QByteArray("[]\n"));
}

void TestRecheck::everythingOfAFolder_staysAsItIs()
{
    const auto before = stateBelow(m_simulated.path());
    QCOMPARE(recheck({m_simulated.path()}).exitCode, 0);
    QCOMPARE(stateBelow(m_simulated.path()), before);
}

void TestRecheck::keptRuns_areComputedAgain_data()
{
    QTest::addColumn<QString>("folder");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QStringList>("overU");
    QTest::newRow("before the level at the onset")
        << "2026-11-24" << 1
        << QStringList{"response.magnitude[0]", "shock[0].velocity_m_s", "shock[1].velocity_m_s"};
    QTest::newRow("one budget for everything") << "2026-11-26" << 0 << QStringList();
    QTest::newRow("Monte Carlo of the chain") << "2026-11-26-monte-carlo" << 0 << QStringList();
}

/// Whatever is changed later: these stay readable, and every step that changed since is named.
void TestRecheck::keptRuns_areComputedAgain()
{
    QFETCH(QString, folder);
    QFETCH(int, exitCode);
    QFETCH(QStringList, overU);
    const QString path = keptRuns() + "/" + folder;
    const Answer answer = recheck({path});
    QVERIFY2(answer.exitCode == exitCode, answer.out + answer.err);
    const QJsonObject methods
        = fileJson(path + "/results.json")["software"].toObject()["method"].toObject();
    for (const auto &[step, version] : dyncal::methodVersions()) {
        const int then = methods[QString::fromStdString(step)].toInt();
        const std::string words = then == 0
            ? step + " " + std::to_string(version) + " (new)"
            : step + " " + std::to_string(then) + " -> " + std::to_string(version);
        QVERIFY2(answer.out.contains(words.c_str()) == (then != version), words.c_str());
    }
    QStringList over;
    for (const QJsonValue &row : rowsOf({path})) {
        if (row["kind"] != "over-u")
            continue;
        over << row["of"].toString();
        QVERIFY(row["difference_over_u"].toDouble() > 1.0);
        QCOMPARE(row["amendment_needed"], QJsonValue(true));
    }
    QCOMPARE(over, overU);
}

/// Results of the same methods may differ by the rounding of another machine alone.
void TestRecheck::keptRuns_ofTheseMethods_areAsIssued()
{
    for (const QString &folder : QDir(keptRuns()).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        const QString path = keptRuns() + "/" + folder;
        const auto results = nlohmann::json::parse(bytesOf(path + "/results.json").toStdString());
        if (dyncal::statedMethods(results) != dyncal::methodVersions())
            continue;
        const QByteArray text = recheck({path}).out;
        const auto said = QRegularExpression("within U is ([0-9.e-]+) U").match(text);
        QVERIFY2(
            text.contains("all exactly as issued") || said.captured(1).toDouble() < 1e-4, text);
    }
}

void TestRecheck::differenceOverU_isListedWithItsSize()
{
    const Laboratory lab;
    prepare(lab);
    double U = 0.0;
    QVERIFY(changeResults(lab.path("out"), [&](nlohmann::json &root) {
        nlohmann::json &step = root["shock"][0];
        U = step["u_step_pa"].get<double>() * step["step_k"].get<double>();
        step["step_pa"] = step["step_pa"].get<double>() + 3.0 * U;
    }));
    const Answer text = recheck({lab.path("out")});
    QCOMPARE(text.exitCode, 1);
    QVERIFY2(text.out.contains("3       shock[0].step_pa (shot 1)"), text.out);
    QVERIFY(text.out.contains("results.json is not the file that the run wrote"));
    const QJsonArray rows = rowsOf({lab.path("out")});
    QCOMPARE(rows.size(), 1);
    QCOMPARE(rows[0]["of"], QJsonValue("shock[0].step_pa"));
    QVERIFY(std::abs(rows[0]["difference_over_u"].toDouble() - 3.0) < 1e-9);
    QVERIFY(std::abs(rows[0]["u_expanded"].toDouble() / U - 1.0) < 1e-12);
    QCOMPARE(rows[0]["method_issued"], QJsonValue(QJsonObject()));
}

void TestRecheck::worstOfAllFolders_comesFirst()
{
    const Laboratory lab;
    prepare(lab);
    QVERIFY(QDir().rename(lab.path("out"), lab.path("a")));
    QVERIFY(QDir().mkpath(lab.path("b")));
    QVERIFY(QFile::copy(lab.path("a/results.json"), lab.path("b/results.json")));
    const auto shift = [](double byU) {
        return [byU](nlohmann::json &root) {
            nlohmann::json &f0 = root["characteristics"][0];
            f0["value"] = f0["value"].get<double>() + byU * f0["u"].get<double>();
        };
    };
    QVERIFY(changeResults(lab.path("a"), shift(4.0)));
    QVERIFY(changeResults(lab.path("b"), shift(40.0)));
    const QJsonArray rows = rowsOf({lab.folder.path()});
    QCOMPARE(kindsOf(rows), (QStringList{"over-u", "over-u"}));
    QCOMPARE(rows[0]["folder"].toString(), lab.path("b"));
    QCOMPARE(rowsOf({lab.path("a"), lab.path("a/"), lab.path("a")}).size(), 1); // once
}

void TestRecheck::missingRecording_stopsNoOtherFolder()
{
    const Laboratory lab;
    prepare(lab);
    QVERIFY(QFile::remove(lab.path("shot.h5")));
    const Answer answer = recheck({lab.path("out"), m_simulated.filePath("out")});
    QCOMPARE(answer.exitCode, 3);
    QCOMPARE(answer.complaints().size(), 1);
    QVERIFY(answer.err.startsWith("The recording shot.h5 (SHA-256 "));
    QVERIFY(answer.err.contains(sha256(m_simulated.filePath("shot.h5"))));
    QVERIFY(answer.err.contains("with --recordings"));
    QVERIFY(answer.out.contains((m_simulated.filePath("out") + ": none").toUtf8()));
    const QJsonArray rows = rowsOf({lab.path("out"), m_simulated.filePath("out")});
    QCOMPARE(kindsOf(rows), QStringList{"unreadable"});
    QCOMPARE(rows[0]["folder"].toString(), lab.path("out"));
}

void TestRecheck::changedRecording_isNamed()
{
    const Laboratory lab;
    prepare(lab);
    QFile file(lab.path("shot.h5"));
    QVERIFY(file.open(QIODevice::ReadWrite) && file.seek(file.size() - 1) && file.putChar('x'));
    file.close();
    const Answer answer = recheck({lab.path("out")});
    QCOMPARE(answer.exitCode, 3);
    QVERIFY2(answer.err.contains("shot.h5 of the results in"), answer.err);
    QVERIFY(answer.err.contains("was changed since"));
    QVERIFY(answer.err.contains(sha256(lab.path("shot.h5"))));
    QVERIFY(QDir().mkpath(lab.path("archive"))); // the one of the archive is taken instead
    QVERIFY(QFile::copy(m_simulated.filePath("shot.h5"), lab.path("archive/2025-07.dat")));
    QCOMPARE(recheck({lab.path("out"), "--recordings", lab.path("archive")}).exitCode, 0);
}

/// Settings of single files go by their names.
void TestRecheck::renamedRecording_isReadByItsOldName()
{
    const Laboratory lab;
    prepare(lab);
    QVERIFY(
        writeBytes(lab.path("scaled.json"), R"({"import": {"files": {"shot.h5": {"polarity": -1}}},
            "uncertainty": {"monte_carlo_trials": 100}})"));
    QVERIFY(runDyncal({"run", lab.path("shot.h5"), "--recipe", lab.path("scaled.json"), "-o",
                          lab.path("out")},
                kEpoch)
                .exitCode
        <= 1);
    QVERIFY(
        fileJson(lab.path("out/results.json"))["sensitivity"].toObject()["value"].toDouble() < 0.0);
    QVERIFY(QFile::rename(lab.path("shot.h5"), lab.path("night shift.bin")));
    const Answer answer = recheck({lab.path("out")});
    QVERIFY2(answer.exitCode == 0, answer.out + answer.err);
    QVERIFY(answer.out.contains("all exactly as issued"));
}

void TestRecheck::treeOfABatch_isTakenWhole()
{
    const Laboratory lab;
    for (int i : {1, 2}) {
        QVERIFY(QDir().mkpath(lab.path(QString("in/SN-%1").arg(i))));
        QVERIFY(simulateShortCapture(lab.path(QString("in/SN-%1/shot.h5").arg(i)), i));
        QVERIFY(writeBytes(lab.path(QString("in/SN-%1/notes.txt").arg(i)), "left out of it"));
    }
    QCOMPARE(runDyncal(QStringList{"batch", "plan", lab.path("in"), "-o", lab.path("night.jsonl")}
                 + quickly())
                 .exitCode,
        0);
    QVERIFY(runDyncal({"batch", "run", lab.path("night.jsonl")}, kEpoch).exitCode <= 1);
    const Answer answer = recheck({lab.path("night.out"), "--recordings", lab.path("in")});
    QVERIFY2(answer.exitCode == 0, answer.err);
    for (int i : {1, 2})
        QVERIFY(answer.out.contains(
            (lab.path(QString("night.out/SN-%1/calibration: none").arg(i))).toUtf8()));
    QCOMPARE(rowsOf({lab.path("night.out"), "--recordings", lab.path("in")}), QJsonArray());
    QCOMPARE(recheck({lab.path("night.out")}).exitCode, 3); // they do not lie beside
}

/// Results that say they are of a recording which is blocked today.
void TestRecheck::nowBlocked_isSaid()
{
    const Laboratory lab;
    prepare(lab);
    QVERIFY(runDyncal({"simulate", "-o", lab.path("bad.h5"), "--preset", "piezo", "--duration-s",
                          "0.003", "--sample-rate-hz", "1e7", "--shots", "low", "--defect", "clip"})
                .exitCode
        == 0);
    QVERIFY(changeResults(lab.path("out"), [&](nlohmann::json &root) {
        root["inputs"][0]["sha256"] = sha256(lab.path("bad.h5")).toStdString();
    }));
    QCOMPARE(runDyncal(QStringList{"run", lab.path("bad.h5"), "-o", lab.path("bad")} + quickly())
                 .exitCode,
        2);
    const Answer answer = recheck({lab.path("out")});
    QVERIFY2(answer.exitCode == 1, answer.out + answer.err);
    QVERIFY2(answer.out.contains("out: now blocked by "), answer.out);
    const QJsonArray rows = rowsOf({lab.path("out")});
    QCOMPARE(rows[0]["kind"], QJsonValue("blocked"));
    QCOMPARE(rows[0]["amendment_needed"], QJsonValue(true));
    QVERIFY(!kindsOf(rows).contains("withdrawn"));
}

void TestRecheck::readerThatRefuses_isBlocked()
{
    const Laboratory lab;
    prepare(lab);
    QVERIFY(writeBytes(lab.path("shot.txt"), "nothing that a reader knows"));
    QVERIFY(changeResults(lab.path("out"), [&](nlohmann::json &root) {
        root["inputs"][0]
            = {{"file", "shot.txt"}, {"sha256", sha256(lab.path("shot.txt")).toStdString()}};
    }));
    const Answer answer = recheck({lab.path("out")});
    QVERIFY2(answer.exitCode == 1, answer.err);
    QVERIFY2(answer.out.contains("now blocked by CAP-001"), answer.out);
}

void TestRecheck::wrongInput_isSaidInOneSentence_data()
{
    QTest::addColumn<QString>("results"); // empty: no file
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("words");
    QTest::newRow("empty folder") << "" << QStringList{"@"} << 3 << "There is no results.json in";
    QTest::newRow("nothing") << "" << QStringList{"@/none"} << 3 << "is no folder";
    QTest::newRow("damaged") << "{\"schema" << QStringList{"@"} << 3 << "is not valid JSON";
    QTest::newRow("foreign") << "{\"a\": 1}" << QStringList{"@"} << 3
                             << "is no results.json of a calibration";
    QTest::newRow("later") << "{\"schema\": \"dyncal-results/2\"}" << QStringList{"@"} << 3
                           << "was written by a later version";
    QTest::newRow("no recordings there")
        << "{}" << QStringList{"@", "--recordings", "@/none"} << 3 << "is no folder of recordings";
    QTest::newRow("no folder given") << "" << QStringList() << 4 << "Wrong usage";
    QTest::newRow("odd option") << "{}" << QStringList{"@", "--order", "3"} << 4 << "Wrong usage";
}

void TestRecheck::wrongInput_isSaidInOneSentence()
{
    QFETCH(QString, results);
    QFETCH(QStringList, arguments);
    QFETCH(int, exitCode);
    QFETCH(QString, words);
    const QTemporaryDir folder;
    if (!results.isEmpty())
        QVERIFY(writeBytes(folder.filePath("results.json"), results.toUtf8()));
    const Answer answer = recheck(arguments.replaceInStrings("@", folder.path()));
    QCOMPARE(answer.exitCode, exitCode);
    QCOMPARE(answer.complaints().size(), 1);
    QVERIFY2(answer.err.contains(words.toUtf8()), answer.err);
    QCOMPARE(answer.out, QByteArray());
}

void TestRecheck::interrupted_leavesNothing()
{
    const Laboratory lab;
    prepare(lab);
    for (int i = 0; i < 40; ++i) { // more than is done before the signal comes
        QVERIFY(QDir().mkpath(lab.path(QString("runs/%1").arg(i))));
        QVERIFY(QFile::copy(
            lab.path("out/results.json"), lab.path(QString("runs/%1/results.json").arg(i))));
    }
    const QTemporaryDir temporary;
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("TMPDIR", temporary.path());
    process.setProcessEnvironment(environment);
    QVERIFY(QFile::rename(lab.path("shot.h5"), lab.path("renamed.h5")));
    process.start(qEnvironmentVariable("DYNCAL_BINARY"),
        {"recheck", lab.path("runs"), "--recordings", lab.folder.path()});
    QVERIFY(process.waitForStarted());
    QVERIFY(waitUntilAwaited(process, SIGINT));
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitCode(), 130);
    QCOMPARE(process.readAllStandardError(), QByteArray("Stopped on request.\n"));
    QCOMPARE(process.readAllStandardOutput(), QByteArray());
    QVERIFY(QDir(temporary.path())
                .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot)
                .isEmpty());
}

DYNCAL_TEST(TestRecheck)
#include "tst_recheck.moc"
