// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"
#include "tests/system/quick_recipe.h"

#include <QCryptographicHash>
#include <QDir>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace {

constexpr double kTwelveDigits = 1e-12;

bool isSame(const QJsonValue &a, const QJsonValue &b)
{
    if (a.isNull() || b.isNull())
        return a.isNull() && b.isNull();
    return std::abs(a.toDouble() - b.toDouble()) <= kTwelveDigits * std::abs(b.toDouble());
}

/// The pole of results.json that compare speaks of: the upper half with that frequency.
QJsonObject poleAt(const QJsonObject &results, double frequency_Hz)
{
    for (const QJsonValue &pole : results["model"]["poles"].toArray()) {
        if (pole["im"].toDouble() > 0.0 && pole["class"].toString() == "sensor"
            && std::abs(pole["frequency_hz"].toDouble() / frequency_Hz - 1.0) < kTwelveDigits)
            return pole.toObject();
    }
    return {};
}

int countOf(const QJsonObject &results, const char *poleClass)
{
    int count = 0;
    for (const QJsonValue &pole : results["model"]["poles"].toArray())
        count += pole["class"].toString() == QLatin1String(poleClass) ? 1 : 0;
    return count;
}

} // namespace

/// `dyncal compare` and `dyncal export` as a laboratory uses them.
class TestCompareAndExport : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString m_capture;
    QString path(const QString &name) const { return m_folder.filePath(name); }

private slots:
    void initTestCase()
    {
        m_capture = path("example.h5");
        QCOMPARE(runDyncal({"simulate", "-o", m_capture, "--duration-s", "0.004", "--seed", "3"})
                     .exitCode,
            0);
    }

    void compare_everyOrder_isThatOfARun()
    {
        const Answer answer = runDyncal(
            QStringList{"compare", m_capture, "--orders", "2,3,50", "--json"} + quickly());
        QVERIFY2(answer.exitCode == 0 || answer.exitCode == 1, answer.err);
        const QJsonObject compared = answer.json();
        QCOMPARE(compared["schema"].toString(), QString("dyncal-compare/1"));
        QCOMPARE(compared["orders"].toArray().size(), 3);
        for (const QJsonValue &one : compared["orders"].toArray()) {
            const QString order = QString::number(one["order"].toInt());
            const QString out = path("run-" + order);
            const Answer run
                = runDyncal(QStringList{"run", m_capture, "--order", order, "-o", out} + quickly());
            QVERIFY2(run.exitCode <= 2, run.err);
            const QJsonObject results = fileJson(out + "/results.json");
            QVERIFY(isSame(one["fit_percent"], results["model"]["fit_percent"]));
            QVERIFY(
                isSame(one["fit_attainable_percent"], results["model"]["fit_attainable_percent"]));
            QCOMPARE(one["unstable_poles"].toInt(), countOf(results, "unstable"));
            QCOMPARE(one["nyquist_poles"].toInt(), countOf(results, "nyquist"));
            if (one["frequency_hz"].isNull())
                continue;
            const QJsonObject pole = poleAt(results, one["frequency_hz"].toDouble());
            QVERIFY(!pole.isEmpty());
            for (const char *key : {"u_frequency_hz", "damping_ratio", "u_damping_ratio"})
                QVERIFY2(isSame(one[QLatin1String(key)], pole[QLatin1String(key)]), key);
        }
    }

    void compare_table_hasALinePerOrder()
    {
        const Answer answer
            = runDyncal(QStringList{"compare", m_capture, "--orders", "2,3,100"} + quickly());
        const QList<QByteArray> lines = answer.out.trimmed().split('\n');
        QCOMPARE(lines.size(), 5); // heading, three orders, the suggestion's reason
        QVERIFY(lines[0].contains("attainable") && lines[0].contains("whiteness p"));
        QVERIFY(lines[1].contains("MHz (u "));
        QVERIFY(lines[4].startsWith("Order 2 has the smallest BIC"));
        for (const char *nonsense : {"nan", "inf", "e+"})
            QVERIFY2(!answer.out.contains(nonsense), answer.out);
    }

    void compare_withoutOrders_takesTheRecipesAndItsOwn()
    {
        QVERIFY(writeBytes(path("recipe.json"),
            R"({"realization": {"candidates": [5],
                "candidate_notes": [{"order": 5, "note": "odd one"}]},
                "uncertainty": {"monte_carlo_trials": 100}})"));
        const Answer answer
            = runDyncal({"compare", m_capture, "--recipe", path("recipe.json"), "--json"});
        QList<int> orders;
        for (const QJsonValue &one : answer.json()["orders"].toArray())
            orders << one["order"].toInt();
        QCOMPARE(orders.mid(0, 2), QList<int>({2, 5}));
        QVERIFY(orders.last() > 5);
        QCOMPARE(
            answer.json()["orders"].toArray()[1].toObject()["note"].toString(), QString("odd one"));
        QVERIFY(answer.json()["orders"].toArray()[0].toObject()["note"].isNull());
    }

    void compare_wrongUsage_isSaid_data()
    {
        QTest::addColumn<QString>("orders");
        QTest::addColumn<QByteArray>("named");
        QTest::newRow("a word") << "2,auto" << QByteArray("auto");
        QTest::newRow("zero") << "0" << QByteArray("0");
        QTest::newRow("a fraction") << "2.5" << QByteArray("2.5");
        QTest::newRow("more than the data allow") << "2,1999" << QByteArray("1999");
    }

    void compare_wrongUsage_isSaid()
    {
        QFETCH(QString, orders);
        QFETCH(QByteArray, named);
        const Answer answer = runDyncal({"compare", m_capture, "--orders", orders});
        QCOMPARE(answer.exitCode, 4);
        QVERIFY2(answer.complaints().last().contains(named), answer.err);
    }

    void compare_unreadableFile_isThree()
    {
        QVERIFY(writeBytes(path("broken.h5"), "no capture"));
        QCOMPARE(runDyncal({"compare", path("broken.h5")}).exitCode, 3);
        const Answer help = runDyncal({"compare", "--help"});
        QCOMPARE(help.exitCode, 0);
        QVERIFY(help.out.contains("Example:"));
    }

    void export_givesTheFilesOfARun()
    {
        const QString out = path("exported");
        const Answer answer
            = runDyncal(QStringList{"export", m_capture, "--order", "3", "-o", out} + quickly());
        QVERIFY2(answer.exitCode <= 1, answer.err);
        const QString run = path("run-export");
        runDyncal(QStringList{"run", m_capture, "--order", "3", "-o", run} + quickly());
        QStringList names = QDir(out).entryList(QDir::Files);
        QVERIFY(names.removeOne("written.json"));
        QCOMPARE(names, QDir(run + "/model").entryList(QDir::Files));
        QVERIFY(names.contains("model.mat") && names.contains("model.py"));
        for (const QString &name : names)
            QCOMPARE(bytesOf(out + "/" + name), bytesOf(run + "/model/" + name));
        QCOMPARE(answer.out.trimmed().split('\n').size(), names.size());
    }

    void export_ofAProject_refusesAnotherRecipe_data()
    {
        QTest::addColumn<QString>("option");
        QTest::addColumn<QString>("file");
        QTest::newRow("recipe") << "--recipe" << path("other.json");
        QTest::newRow("profile") << "--profile" << path("other.json");
        QTest::newRow("no such recipe") << "--recipe" << path("nowhere.json");
    }

    void export_ofAProject_refusesAnotherRecipe()
    {
        QFETCH(QString, option);
        QFETCH(QString, file);
        QVERIFY(writeBytes(path("other.json"), R"({"import": {"scale": 5}})"));
        const Answer answer
            = runDyncal({"export", path("any.dyncal"), option, file, "-o", path("other")});
        QCOMPARE(answer.exitCode, 4);
        QCOMPARE(answer.complaints().size(), 1);
        QVERIFY2(
            answer.err.contains("any.dyncal") && answer.err.contains(file.toUtf8()), answer.err);
        QVERIFY(!QFile::exists(path("other")));
    }

    void optionWithoutAValue_isRefused_data()
    {
        QTest::addColumn<QStringList>("words");
        for (const char *verb : {"run", "check", "compare", "export", "import", "info"})
            for (const char *option : {"--recipe", "--profile"})
                QTest::addRow("%s %s", verb, option) << QStringList{verb, m_capture, option, ""};
        for (const char *verb : {"run", "export"})
            QTest::addRow("%s --order", verb) << QStringList{verb, m_capture, "--order", ""};
    }

    void optionWithoutAValue_isRefused()
    {
        QFETCH(QStringList, words);
        const QString out = path(words.front() == "import" ? "empty.h5" : "empty");
        if (QStringList{"run", "export", "import"}.contains(words.front()))
            words << "-o" << out;
        const Answer answer = runDyncal(words);
        QCOMPARE(answer.exitCode, 4);
        QCOMPARE(answer.complaints().size(), 1);
        QVERIFY2(
            answer.err.contains(words[2].toUtf8() + ": it is given without a value"), answer.err);
        QVERIFY(!QFile::exists(out));
    }

    void export_ofAProject_takesItsRecipe()
    {
        const QByteArray sha256
            = QCryptographicHash::hash(bytesOf(m_capture), QCryptographicHash::Sha256).toHex();
        QVERIFY(writeBytes(path("job.dyncal"),
            R"({"format": "dyncal-project", "version": 2, "recipe": {"realization": {"order": 4},
                "uncertainty": {"monte_carlo_trials": 100}},
                "captures": [{"path": "example.h5", "sha256": ")"
                + sha256 + R"("}]})"));
        const QString out = path("of-project");
        const Answer answer
            = runDyncal({"export", path("job.dyncal"), "--format", "json", "-o", out});
        QVERIFY2(answer.exitCode <= 1, answer.err);
        QCOMPARE(fileJson(out + "/model.json")["order"].toInt(), 4);
        QVERIFY(writeBytes(path("no.dyncal"), "{}"));
        QCOMPARE(runDyncal({"export", path("no.dyncal"), "-o", out}).exitCode, 3);
    }

    void export_ofAChangedRecording_writesNoModel()
    {
        QVERIFY(writeBytes(path("changed.dyncal"),
            R"({"format": "dyncal-project", "version": 2, "recipe": {},
                "captures": [{"path": "example.h5", "sha256": ")"
                + QByteArray(64, 'a') + R"("}]})"));
        const QString out = path("of-changed");
        const Answer answer = runDyncal({"export", path("changed.dyncal"), "-o", out});
        QCOMPARE(answer.exitCode, 2);
        QVERIFY2(answer.err.contains("CAP-015 (block): example.h5 changed"), answer.err);
        QVERIFY2(answer.err.contains("No model was written."), answer.err);
        QVERIFY(answer.out.isEmpty());
        QVERIFY(!QFile::exists(out));
    }

    void changedCapture_isBlockedInEveryVerb()
    {
        QByteArray bytes = bytesOf(m_capture);
        const qsizetype creator = bytes.indexOf("dyncal ");
        QVERIFY(creator > 0);
        bytes[creator] = 'D';
        const QString changed = path("changed.h5");
        QVERIFY(writeBytes(changed, bytes));
        const QString out = path("of-changed-capture");
        for (const QStringList &call : {QStringList{"info", changed}, {"check", changed},
                 QStringList{"compare", changed, "--orders", "2"} + quickly(),
                 QStringList{"run", changed, "-o", out} + quickly(),
                 QStringList{"export", changed, "-o", path("model-of-changed")} + quickly(),
                 {"import", changed, "-o", path("washed.h5")}}) {
            const Answer answer = runDyncal(call);
            QVERIFY2(answer.exitCode == 2, call[0].toLatin1() + ": " + answer.err);
            QVERIFY2((answer.err + answer.out).contains("CAP-015 (block)"), answer.err);
            QVERIFY2(
                (answer.err + answer.out).contains("changed since it was written"), answer.err);
        }
        QCOMPARE(QDir(out).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
            QStringList({"recipe.json", "results.json", "written.json"}));
        QVERIFY(fileJson(out + "/results.json")["model"].isObject());
        QVERIFY(!QFile::exists(path("model-of-changed")));
        QVERIFY(!QFile::exists(path("washed.h5")));
    }

    void info_saysWhetherACaptureStatesItsContent()
    {
        QCOMPARE(runDyncal({"info", m_capture, "--json"})
                     .json()["files"][0]["content_sha256"]
                     .toString()
                     .size(),
            64);
        QVERIFY(!runDyncal({"info", m_capture}).out.contains("no content hash"));
    }

    void export_someFormats_andWrongOnes()
    {
        const QString out = path("some");
        QVERIFY(
            runDyncal(QStringList{"export", m_capture, "--format", "json,m", "-o", out} + quickly())
                .exitCode
            <= 1);
        QCOMPARE(QDir(out).entryList(QDir::Files),
            QStringList({"model.json", "model.m", "written.json"}));
        QCOMPARE(runDyncal({"export", m_capture, "--format", "xls", "-o", out}).exitCode, 4);
        QCOMPARE(runDyncal({"export", m_capture, "--what", "plots", "-o", out}).exitCode, 4);
        QCOMPARE(runDyncal({"export", m_capture}).exitCode, 4);
        QVERIFY(runDyncal({"export", "--help"}).out.contains("Example:"));
    }

    void run_tellsWhyThisOrder()
    {
        QVERIFY(writeBytes(path("reason.json"),
            R"({"realization": {"order": 2, "adopted_reason": "lowest that fits"},
                "uncertainty": {"monte_carlo_trials": 100}})"));
        const QString out = path("why");
        runDyncal({"run", m_capture, "--recipe", path("reason.json"), "-o", out});
        const QJsonValue section = fileJson(out + "/results.json")["realization"];
        QCOMPARE(section["adopted_reason"].toString(), QString("lowest that fits"));
        QVERIFY(section["why"].toArray().size() >= 5);
        QVERIFY(section["why"][0].toString().startsWith("Order 2 has the smallest BIC"));
        QVERIFY(section["leave_one_out_percent"].toArray().size() >= 10);
        QCOMPARE(section["spread"]["from_order"].toInt(), 2);
    }
};

DYNCAL_TEST(TestCompareAndExport)
#include "tst_compare_and_export.moc"
