// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/system/issued_job.h"
#include "tests/system/results_of_years.h"

#include <nlohmann/json.hpp>

#include <QtTest>

#include <cmath>

namespace {

nlohmann::json parsed(const QByteArray &text)
{
    return nlohmann::json::parse(text.toStdString());
}

} // namespace

/// Earlier results of a sensor over time, by the built program.
class TestHistory : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_simulated;
    IssuedJob m_job; ///< with certificate 1, of 2026-01-07
    QByteArray m_issued; ///< its results.json

    QString certificate() const { return m_job.output() + "/1"; }

    /// A folder with results of these years, each in its own.
    bool write(const QTemporaryDir &folder, const QList<Year> &years) const
    {
        return std::ranges::all_of(years, [&](const Year &one) {
            const QString path = folder.filePath(QString::number(one.year));
            return QDir().mkpath(path)
                && writeBytes(path + "/results.json", resultsOf(m_issued, one));
        });
    }

private slots:
    void initTestCase()
    {
        QVERIFY(simulateShortCapture(m_simulated.filePath("shot.h5"), 7));
        QVERIFY(m_job.begin(m_simulated.filePath("shot.h5")));
        const Answer issued = m_job.issue({"--by", "A. Berg"});
        QVERIFY2(issued.exitCode <= 1, issued.out + issued.err);
        m_issued = bytesOf(certificate() + "/results.json");
        QVERIFY(!m_issued.isEmpty());
    }

    void certificate_isAPointWithItsNumber();
    void years_areInTheirOrderWithTheirErrors();
    void table_isForPeople();
    void csv_isWritten();
    void stableSensor_isDone();
    void severalSensors_areAskedFor();
    void sensors_areListed();
    void withdrawnAndReplaced_areLeftOut();
    void anotherRegistry_saysNothing();
    void unreadable_isSaidAndTheOthersShown();
    void changedCertificate_isRefused();
    void inputs_areNeverReplaced();
    void nothing_isTouched();
    void wrongInput_isSaidInOneSentence_data();
    void wrongInput_isSaidInOneSentence();
};

void TestHistory::certificate_isAPointWithItsNumber()
{
    const Answer answer = runDyncal({"history", m_job.output(), "--at", "10000", "--json"});
    QVERIFY2(answer.exitCode == 0, answer.out + answer.err);
    const nlohmann::json root = parsed(answer.out), issued = parsed(m_issued);
    QCOMPARE(root["sensor"].get<std::string>(), std::string("17"));
    QCOMPARE(root["points"].size(), std::size_t(1));
    QCOMPARE(root["points"][0]["certificate"].get<int>(), 1);
    QCOMPARE(root["points"][0]["time"].get<std::string>(), std::string("2026-01-07"));
    const nlohmann::json &sensitivity = root["series"][2]["values"][0];
    QCOMPARE(sensitivity["value"], issued["sensitivity"]["value"]);
    QCOMPARE(sensitivity["u"], issued["sensitivity"]["u"]);
    for (const auto &one : issued["characteristics"])
        if (one["quantity"] == "f0_hz")
            QCOMPARE(root["series"][0]["values"][0]["value"], one["value"]);
    const double f_Hz = root["series"][3]["frequency_hz"].get<double>();
    QVERIFY(std::abs(f_Hz - 1e4) <= 300.0);
    const auto &rows = issued["response"]["frequency_hz"];
    const auto at = std::ranges::find(rows, nlohmann::json(f_Hz)) - rows.begin();
    QCOMPARE(root["series"][3]["values"][0]["value"],
        issued["response"]["magnitude"][static_cast<std::size_t>(at)]);
}

/// E_n from the numbers of results.json, by arithmetic of its own.
void TestHistory::years_areInTheirOrderWithTheirErrors()
{
    const QTemporaryDir folder;
    QVERIFY(write(folder, {{2023, 1.05}, {2021, 1.0}, {2022, 0.99}, {2024, 1.0}, {2025, 1.001}}));
    const Answer answer = runDyncal({"history", folder.path(), certificate(), "--json"});
    QVERIFY2(answer.exitCode == 1, answer.out + answer.err); // 5 % are not within U
    const nlohmann::json root = parsed(answer.out), issued = parsed(m_issued);
    std::string days;
    for (const auto &point : root["points"])
        days += point["time"].get<std::string>().substr(0, 4) + ' ';
    QCOMPARE(days, std::string("2021 2022 2023 2024 2025 2026 "));
    const double value = issued["sensitivity"]["value"].get<double>(),
                 U = issued["sensitivity"]["u"].get<double>()
        * std::max(2.0, issued["sensitivity"]["k"].get<double>());
    const std::vector<double> factors{1.0, 0.99, 1.05, 1.0, 1.001, 1.0};
    const nlohmann::json &series = root["series"][2];
    double ranges = 0.0;
    for (std::size_t i = 1; i < factors.size(); ++i) {
        const double needed = (factors[i] - factors[i - 1]) * value / (std::sqrt(2.0) * U);
        const double found = series["values"][i]["e_n"].get<double>();
        QVERIFY(std::abs(found - needed) < 1e-9 * std::abs(needed));
        ranges += std::abs(factors[i] - factors[i - 1]) / 5.0;
    }
    QVERIFY(std::abs(series["limits"]["sigma"].get<double>() / (value * ranges / 1.128379167) - 1.0)
        < 1e-9);
    QCOMPARE(series["drift"]["calibrations"].get<int>(), 6);
    QVERIFY(root["points"][5]["methods_changed"].is_null());
}

void TestHistory::table_isForPeople()
{
    const QTemporaryDir folder;
    QVERIFY(write(folder, {{2021}, {2022}}));
    const Answer answer
        = runDyncal({"history", folder.path(), certificate(), "--at", "1000,10000"});
    QVERIFY2(answer.exitCode == 0, answer.out + answer.err);
    QVERIFY(answer.out.startsWith("Sensor 17\n"));
    for (const char *words : {"2021-03-01", "2026-01-07", "f0_hz", "damping_ratio", "sensitivity",
             "magnitude at 1", "phase_rad at 1", "V/Pa", "Limits need at least 5 calibrations; 3",
             "drift in a year: ", "E_n", "the same tube, references and method"})
        QVERIFY2(answer.out.contains(words), answer.out);
    QCOMPARE(answer.err, QByteArray());
}

void TestHistory::csv_isWritten()
{
    const QTemporaryDir folder;
    QVERIFY(write(folder, {{2021}, {2022}}));
    const QString csv = folder.filePath("history.csv");
    const Answer answer = runDyncal({"history", folder.path(), "-o", csv});
    QVERIFY2(answer.exitCode == 0, answer.out + answer.err);
    QVERIFY(answer.out.contains("Written:"));
    const QByteArray text = bytesOf(csv);
    QVERIFY(
        text.startsWith("quantity,frequency_hz,unit,time,certificate,value,u,k,u_expanded,e_n"));
    QCOMPARE(text.count('\n'), 1 + 3 * 2);
    QVERIFY(runDyncal({"history", folder.path(), "-o", csv}).exitCode == 0); // its own is replaced
    QCOMPARE(bytesOf(csv), text);
}

void TestHistory::stableSensor_isDone()
{
    const QTemporaryDir folder;
    QVERIFY(write(folder, {{2020}, {2021}, {2022}, {2023}, {2024}, {2025}}));
    const Answer answer = runDyncal({"history", folder.path(), "--json"});
    QVERIFY2(answer.exitCode == 0, answer.out + answer.err);
    for (const auto &series : parsed(answer.out)["series"])
        for (const auto &value : series["values"])
            QCOMPARE(value["control_state"].get<std::string>(), std::string("inside"));
}

void TestHistory::severalSensors_areAskedFor()
{
    const QTemporaryDir folder;
    QVERIFY(write(folder, {{2021}, {2022, 1.0, "18"}, {2023, 1.0, "18"}}));
    const Answer asked = runDyncal({"history", folder.path()});
    QCOMPARE(asked.exitCode, 4);
    QCOMPARE(asked.out, QByteArray());
    QVERIFY2(asked.err.contains("17, 18"), asked.err);
    QCOMPARE(asked.complaints().size(), 1);
    const Answer chosen = runDyncal({"history", folder.path(), "--sensor", "18", "--json"});
    QCOMPARE(chosen.exitCode, 0);
    QCOMPARE(parsed(chosen.out)["points"].size(), std::size_t(2));
}

void TestHistory::sensors_areListed()
{
    const QTemporaryDir folder;
    QVERIFY(write(folder, {{2021}, {2022, 1.0, "18"}, {2023, 1.0, "18"}}));
    QCOMPARE(runDyncal({"history", folder.path(), "--sensors"}).out, QByteArray("17  1\n18  2\n"));
    const Answer answer = runDyncal({"history", folder.path(), "--sensors", "--json"});
    QCOMPARE(answer.exitCode, 0);
    QCOMPARE(parsed(answer.out)["sensors"].dump(),
        std::string(R"([{"calibrations":1,"serial":"17"},{"calibrations":2,"serial":"18"}])"));
}

void TestHistory::withdrawnAndReplaced_areLeftOut()
{
    const IssuedJob job;
    QVERIFY(job.begin(m_simulated.filePath("shot.h5")));
    QVERIFY(job.issue().exitCode <= 1);
    const QStringList asked{
        "history", job.output(), "--in-force", "--registry", job.registry(), "--json"};
    QCOMPARE(parsed(runDyncal(asked).out)["points"].size(), std::size_t(1));
    QVERIFY(job.issue({"--amends", "1", "--reason", "another template"}).exitCode <= 1);
    nlohmann::json root = parsed(runDyncal(asked).out);
    QCOMPARE(root["points"].size(), std::size_t(1));
    QCOMPARE(root["points"][0]["certificate"].get<int>(), 2);
    QCOMPARE(root["left_out"][0]["why"].get<std::string>(), std::string("not_in_force"));
    QCOMPARE(root["left_out"][0]["reason"].get<std::string>(),
        std::string("Certificate 1 was replaced by certificate 2."));
    QCOMPARE(runDyncal({"withdraw", "2", "--reason", "wrong gas", "--registry", job.registry()})
                 .exitCode,
        0);
    root = parsed(runDyncal(asked).out);
    QCOMPARE(root["points"].size(), std::size_t(0));
    QCOMPARE(root["left_out"][1]["reason"].get<std::string>(),
        std::string("Certificate 2 was withdrawn: wrong gas"));
}

/// Its certificate 1 is another one.
void TestHistory::anotherRegistry_saysNothing()
{
    const IssuedJob other;
    QVERIFY(other.begin(m_simulated.filePath("shot.h5"), [] {
        QJsonObject recipe = completeRecipe();
        QJsonObject fields = completeFields();
        fields["customer"] = "Another Ltd";
        recipe["certificate"] = QJsonObject{{"fields", fields}};
        return recipe;
    }()));
    QVERIFY(other.issue().exitCode <= 1);
    QCOMPARE(
        runDyncal({"withdraw", "1", "--reason", "lost", "--registry", other.registry()}).exitCode,
        0);
    const Answer answer = runDyncal(
        {"history", certificate(), "--in-force", "--registry", other.registry(), "--json"});
    QCOMPARE(answer.exitCode, 0);
    QCOMPARE(parsed(answer.out)["points"].size(), std::size_t(1));
    const Answer lost = runDyncal(
        {"history", certificate(), "--in-force", "--registry", "/nowhere/registry.sqlite"});
    QVERIFY2(lost.exitCode > 1 && lost.complaints().size() == 1, lost.err);
}

void TestHistory::unreadable_isSaidAndTheOthersShown()
{
    const QTemporaryDir folder;
    QVERIFY(write(folder, {{2021}, {2022}, {2023}}));
    const QString damaged = folder.filePath("2022/results.json");
    QVERIFY(writeBytes(damaged, bytesOf(damaged).chopped(1000)));
    const Answer answer = runDyncal({"history", folder.path(), "--json"});
    QCOMPARE(answer.exitCode, 3);
    QCOMPARE(answer.complaints().size(), 1);
    QVERIFY2(answer.err.contains("2022/results.json"), answer.err);
    const nlohmann::json root = parsed(answer.out);
    QCOMPARE(root["points"].size(), std::size_t(2));
    QCOMPARE(root["unread"][0]["file"].get<std::string>(), damaged.toStdString());
    const Answer alone = runDyncal({"history", damaged});
    QCOMPARE(alone.exitCode, 3);
    QCOMPARE(alone.out, QByteArray());
}

/// A changed number in an issued folder must not become a point.
void TestHistory::changedCertificate_isRefused()
{
    const QTemporaryDir folder;
    QVERIFY(QDir().mkpath(folder.filePath("1")));
    QVERIFY(QFile::copy(certificate() + "/manifest.json", folder.filePath("1/manifest.json")));
    QVERIFY(writeBytes(folder.filePath("1/results.json"), resultsOf(m_issued, {2021, 1.1})));
    const Answer answer = runDyncal({"history", folder.path()});
    QCOMPARE(answer.exitCode, 3);
    QVERIFY2(answer.err.contains("the manifest of certificate 1 has another hash"), answer.err);
}

void TestHistory::inputs_areNeverReplaced()
{
    const QTemporaryDir folder;
    QVERIFY(write(folder, {{2021}}));
    const QString results = folder.filePath("2021/results.json");
    const QByteArray before = bytesOf(results);
    const Answer answer = runDyncal({"history", folder.path(), "-o", results});
    QCOMPARE(answer.exitCode, 4);
    QCOMPARE(answer.complaints().size(), 1);
    QCOMPARE(bytesOf(results), before);
}

void TestHistory::nothing_isTouched()
{
    const auto before = bytesBelow(m_job.folder.path());
    QCOMPARE(runDyncal({"history", m_job.folder.path()}).exitCode, 0);
    QCOMPARE(bytesBelow(m_job.folder.path()), before);
}

void TestHistory::wrongInput_isSaidInOneSentence_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exitCode");
    const QString kept = qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/tests/data/kept_runs";
    QTest::newRow("nothing given") << QStringList{} << 4;
    QTest::newRow("not there") << QStringList{"/nowhere/results.json"} << 3;
    QTest::newRow("no results below") << QStringList{kept + "/../../support"} << 3;
    QTest::newRow("no results") << QStringList{kept + "/2026-11-26/recipe.json"} << 3;
    QTest::newRow("a recording") << QStringList{kept + "/recording.h5"} << 3;
    QTest::newRow("without serial numbers") << QStringList{kept} << 4;
    QTest::newRow("no such sensor") << QStringList{certificate(), "--sensor", "no such"} << 4;
    QTest::newRow("no frequency") << QStringList{certificate(), "--at", "often"} << 4;
    QTest::newRow("negative") << QStringList{certificate(), "--at=-5"} << 4;
    QTest::newRow("infinite") << QStringList{certificate(), "--at", "inf"} << 4;
    QTest::newRow("no folder to write to")
        << QStringList{certificate(), "-o", "/nowhere/history.csv"} << 4;
}

void TestHistory::wrongInput_isSaidInOneSentence()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, exitCode);
    const Answer answer = runDyncal(QStringList{"history"} + arguments);
    QVERIFY2(answer.exitCode == exitCode, answer.out + answer.err);
    QCOMPARE(answer.out, QByteArray());
    QVERIFY2(answer.complaints().size() == 1 && answer.err.endsWith(".\n"), answer.err);
}

DYNCAL_TEST(TestHistory)
#include "tst_history.moc"
