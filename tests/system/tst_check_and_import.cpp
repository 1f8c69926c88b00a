// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"
#include "tests/system/quick_recipe.h"

#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

/// `dyncal check`, `dyncal import` and `dyncal info` as a laboratory uses them.
class TestCheckAndImport : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString path(const QString &name) const { return m_folder.filePath(name); }

    QString simulated(const QString &name, const QStringList &options = {}) const
    {
        const QString file = path(name);
        const Answer answer = runDyncal(
            QStringList{"simulate", "-o", file, "--duration-s", "0.004", "--seed", "3"} + options);
        if (answer.exitCode != 0)
            qWarning("%s", answer.err.constData());
        return file;
    }

    static QStringList idsOf(const Answer &answer, const QString &severity = {})
    {
        QStringList ids;
        for (const QJsonValue &finding : answer.json()["findings"].toArray()) {
            if (severity.isEmpty() || finding["severity"].toString() == severity)
                ids << finding["id"].toString();
        }
        return ids;
    }

    /// A ringing step of this height at 1 MHz, as a table with times; `unit` of the values.
    QString writeTable(const QString &name, double height, const QByteArray &unit) const
    {
        QByteArray text = "Time [s],Pressure sensor [" + unit + "]\n";
        for (int i = 0; i < 6000; ++i) {
            const double t = i < 2000 ? 0.0 : static_cast<double>(i - 2000);
            const double clean = i < 2000 ? 0.0 : 1.0 - std::exp(-t / 300.0) * std::cos(0.3 * t);
            const double noise = 0.002 * std::sin(12.9898 * i * i + height);
            text += QByteArray::number(1e-6 * i, 'f', 6) + ','
                + QByteArray::number(height * (clean + noise), 'f', 9) + '\n';
        }
        writeBytes(path(name), text);
        return path(name);
    }

private slots:
    void check_cleanShots_isDone()
    {
        const Answer answer = runDyncal({"check", simulated("clean.h5"), "--json"});
        QVERIFY2(answer.exitCode == 0, answer.out);
        QCOMPARE(answer.json()["schema"].toString(), QString("dyncal-check/1"));
        QCOMPARE(answer.json()["shots"].toInt(), 3);
        QCOMPARE(answer.json()["files"][0]["sha256"].toString().size(), 64);
        QCOMPARE(answer.err, QByteArray());
    }

    void import_overItsOwnRecipe_isRefused_data()
    {
        QTest::addColumn<QString>("option");
        QTest::newRow("recipe") << "--recipe";
        QTest::newRow("profile") << "--profile";
    }

    void import_overItsOwnRecipe_isRefused()
    {
        QFETCH(QString, option);
        const QString recipe = path("own.json");
        QVERIFY(writeBytes(recipe, "{}"));
        const Answer answer = runDyncal(
            {"import", simulated("whole.h5"), option, recipe, "-o", recipe, "--replace"});
        QCOMPARE(answer.exitCode, 4);
        QVERIFY2(answer.err.contains("own.json is one of the inputs"), answer.err);
        QCOMPARE(bytesOf(recipe), QByteArray("{}"));
        QVERIFY(QFile::remove(path("whole.h5")));
    }

    void check_defect_isItsFindingOnly_data()
    {
        QTest::addColumn<QString>("defect");
        QTest::addColumn<QStringList>("blocks");
        QTest::addColumn<QStringList>("cautions");
        const auto row
            = [](const char *defect, const QStringList &blocks, const QStringList &cautions) {
                  QTest::newRow(defect) << defect << blocks << cautions;
              };
        row("clip@2", {"CAP-007"}, {});
        row("nan@2", {"CAP-006"}, {});
        row("nostep@2", {"CAP-009"}, {});
        row("swap@2", {"SHK-001"}, {"CAP-031", "CAP-010"}); // the DUT is another sensor then
        row("fs50@3", {}, {"CAP-004"});
        row("drift@2", {}, {"WIN-003", "WIN-004"}); // the plateau drifts as the baseline does
        row("psi@2", {}, {"CAP-013"});
        row("short@2", {}, {});
        row("ringvar", {}, {}); // told by the components, which check does not compute
    }

    void check_defect_isItsFindingOnly()
    {
        QFETCH(QString, defect);
        QFETCH(QStringList, blocks);
        QFETCH(QStringList, cautions);
        const QString file
            = simulated(QString(defect).replace('@', '_') + ".h5", {"--defect", defect});
        const Answer answer = runDyncal({"check", file, "--json"});
        QVERIFY2(idsOf(answer, "block") == blocks, answer.out);
        QVERIFY2(idsOf(answer, "caution") == cautions, answer.out);
        QCOMPARE(answer.exitCode, !blocks.isEmpty() ? 2 : cautions.isEmpty() ? 0 : 1);
        QCOMPARE(idsOf(answer, "info").contains("CAP-005"), defect.startsWith("short"));
    }

    void check_asText_endsWithTheCount()
    {
        const Answer answer = runDyncal({"check", simulated("text.h5", {"--defect", "fs50@3"})});
        QCOMPARE(answer.exitCode, 1);
        QVERIFY2(answer.out.startsWith("CAP-004 (caution): Shots have different"), answer.out);
        QVERIFY2(answer.out.contains("Shots 3: blocking 0, cautions 1, infos "), answer.out);
    }

    void check_swappedRolesOfOneFile_areExchangedByTheRecipe()
    {
        const QString file = simulated("swapped.h5", {"--shots", "high", "--defect", "swap"});
        QCOMPARE(runDyncal({"check", file}).exitCode, 2);
        const Answer info = runDyncal({"info", file, "--json"});
        QJsonObject channels;
        for (const QJsonValue &channel : info.json()["shots"][0]["channels"].toArray()) {
            const QString role = channel["role"].toString();
            if (role == "dut")
                channels[channel["name"].toString()] = "driven_side";
            else if (role == "driven_side")
                channels[channel["name"].toString()] = "dut";
        }
        const QJsonObject recipe{{"import",
            QJsonObject{
                {"files", QJsonObject{{"swapped.h5", QJsonObject{{"channels", channels}}}}}}}};
        writeBytes(path("swap.json"), QJsonDocument(recipe).toJson());
        const Answer fixed = runDyncal({"check", file, "--recipe", path("swap.json"), "--json"});
        QVERIFY2(fixed.exitCode == 0, fixed.out + fixed.err);
    }

    void check_wrongInput_hasItsExitCode()
    {
        QCOMPARE(runDyncal({"check", path("none.h5")}).exitCode, 3);
        QCOMPARE(runDyncal({"check"}).exitCode, 4);
        writeBytes(path("bad.json"), R"({"import": {"files": {"x.h5": {"unit": "V"}}}})");
        const Answer answer
            = runDyncal({"check", simulated("bad.h5"), "--recipe", path("bad.json")});
        QCOMPARE(answer.exitCode, 4);
        QVERIFY2(answer.err.contains("'x.h5'"), answer.err);
    }

    void import_thenRun_givesTheNumbersOfTheSource()
    {
        QStringList tables;
        for (const double height : {0.4, 0.7, 1.1})
            tables << writeTable(QString("shot %1.csv").arg(height), height, "V");
        const QString capture = path("tables.h5");
        const Answer imported
            = runDyncal(QStringList{"import"} + tables + QStringList{"-o", capture});
        QVERIFY2(imported.exitCode <= 1, imported.err);
        QVERIFY2(imported.out.contains("3 shots from 3 files"), imported.out);
        const Answer direct = runDyncal(
            QStringList{"run"} + tables + quickly() + QStringList{"-o", path("direct")});
        const Answer indirect
            = runDyncal(QStringList{"run", capture, "-o", path("indirect")} + quickly());
        QVERIFY2(direct.exitCode <= 1, direct.err);
        QVERIFY2(indirect.exitCode <= 1, indirect.err);
        const QJsonObject a = fileJson(path("direct") + "/results.json");
        const QJsonObject b = fileJson(path("indirect") + "/results.json");
        for (const char *section :
            {"model", "response", "realization", "pca", "spectrum", "bands"}) {
            QVERIFY2(!a[QLatin1String(section)].isNull(), section);
            QVERIFY2(a[QLatin1String(section)] == b[QLatin1String(section)], section);
        }
        QCOMPARE(a["shots"][0]["step"], b["shots"][0]["step"]);
    }

    void import_withAProfile_appliesRolesAndUnitsOnce()
    {
        const QString table = writeTable("psi.csv", 77.7, "bar");
        writeBytes(path("laboratory.json"),
            R"({"import": {"channels": {"Pressure sensor": {"role": "dut", "unit": "psi"}}}})");
        const QString capture = path("psi.h5");
        const Answer imported
            = runDyncal({"import", table, "--profile", path("laboratory.json"), "-o", capture});
        QVERIFY2(imported.exitCode == 1, imported.err); // the file says bar
        QVERIFY2(imported.err.contains("CAP-030"), imported.err);
        const QJsonValue channel
            = runDyncal({"info", capture, "--json"}).json()["shots"][0]["channels"][0];
        QCOMPARE(channel["unit"].toString(), QString("Pa"));
        QCOMPARE(channel["role"].toString(), QString("dut"));
        QCOMPARE(channel["type"].toString(), QString("float64"));
        QCOMPARE(channel["samples"].toInt(), 6000);
        QVERIFY(
            runDyncal(QStringList{"run", capture, "-o", path("psi")} + quickly()).exitCode <= 1);
        const double step = fileJson(path("psi") + "/results.json")["shots"][0]["step"].toDouble();
        QVERIFY2(std::abs(step / 0.5357e6 - 1.0) < 1e-3, QByteArray::number(step)); // 77.7 psi
    }

    void import_neverOverwrites()
    {
        const QString table = writeTable("source.csv", 1.0, "V");
        const QByteArray before = bytesOf(table);
        const Answer onItself = runDyncal({"import", table, "-o", table});
        QCOMPARE(onItself.exitCode, 4);
        QVERIFY2(onItself.err.contains("one of the inputs"), onItself.err);
        QVERIFY(bytesOf(table) == before);
        QVERIFY(runDyncal({"import", table, "-o", path("once.h5")}).exitCode <= 1);
        const QByteArray written = bytesOf(path("once.h5"));
        const Answer again = runDyncal({"import", table, "-o", path("once.h5")});
        QCOMPARE(again.exitCode, 4);
        QVERIFY2(again.err.contains("written once"), again.err);
        QVERIFY(bytesOf(path("once.h5")) == written);
    }

    void import_samplesAreThoseOfTheSource()
    {
        const QString table = writeTable("hash.csv", 1.0, "mV");
        QVERIFY(runDyncal({"import", table, "-o", path("hash.h5")}).exitCode <= 1);
        const auto hashOf = [](const QString &file) {
            return runDyncal({"info", file, "--json"})
                .json()["shots"][0]["channels"][0]["sha256"]
                .toString();
        };
        QCOMPARE(hashOf(path("hash.h5")), hashOf(table));
        QCOMPARE(hashOf(table).size(), 64);
    }

    void profile_withMoreThanImportAndChecks_isRefused()
    {
        writeBytes(path("profile.json"), R"({"pca": {"components": 2}})");
        const Answer answer
            = runDyncal({"check", simulated("profile.h5"), "--profile", path("profile.json")});
        QCOMPARE(answer.exitCode, 4);
        QVERIFY2(answer.err.contains("\"pca\""), answer.err);
    }

    void contradictedRate_isCap003UntilAReasonIsGiven()
    {
        const QString file = simulated("rate.h5", {"--shots", "high"});
        writeBytes(path("rate.json"), R"({"import": {"sample_rate_hz": 1e7}})");
        const Answer refused = runDyncal({"check", file, "--recipe", path("rate.json"), "--json"});
        QCOMPARE(refused.exitCode, 2);
        QVERIFY2(idsOf(refused, "block") == QStringList{"CAP-003"}, refused.out);
        writeBytes(path("rate.json"),
            R"({"import": {"sample_rate_hz": 1e7, "sample_rate_reason": "counted"}})");
        const Answer said = runDyncal({"check", file, "--recipe", path("rate.json"), "--json"});
        QVERIFY2(idsOf(said, "caution").contains("CAP-025"), said.out);
    }
};

DYNCAL_TEST(TestCheckAndImport)
#include "tst_check_and_import.moc"
