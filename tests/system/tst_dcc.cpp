// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The DCC of runs and issued certificates, by the built program: valid for xmllint, by our own
// rules, and with every number of PDF and results.json for a script of its own (python3-lxml).

#include "tests/support/test_program.h"
#include "tests/system/dcc_numbers.h"
#include "tests/system/issued_job.h"

#include <QtTest>

using dyncal::testing::answerOf;
using dyncal::testing::python;

namespace {

QString sourcePath(const QString &name)
{
    return qEnvironmentVariable("DYNCAL_SOURCE_DIR") + name;
}

QString schemas()
{
    const QDir folder(sourcePath("/../shared/dcc"));
    return folder.exists("catalog.xml") ? folder.absolutePath() : QString();
}

/// "" where the folder's DCC is valid by xmllint and by the program; no network for either.
QByteArray faultsOf(const QString &folder)
{
    const QString file = folder + "/dcc.xml";
    if (!schemas().isEmpty()) {
        const auto lint = answerOf("/usr/bin/env",
            {"XML_CATALOG_FILES=" + schemas() + "/catalog.xml", "xmllint", "--nonet", "--noout",
                "--schema", "https://ptb.de/dcc/v3.3.0/dcc.xsd", file});
        if (!lint.ran)
            return lint.out + lint.err;
    }
    QStringList check{"dcc", "check", file, "--json"};
    if (!schemas().isEmpty())
        check << "--schemas" << schemas();
    const Answer own = runDyncal(check);
    for (const QJsonValue finding : QJsonDocument::fromJson(own.out)["findings"].toArray())
        if (finding["rule"] != "country") // nobody has typed one
            return own.out + own.err;
    return own.exitCode == 0 || own.exitCode == 2 ? QByteArray() : own.out + own.err;
}

} // namespace

class TestDcc : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    QString path(const QString &name) const { return m_folder.filePath(name); }

    Answer run(const QString &capture, const QString &name, const QStringList &more = {})
    {
        return runDyncal(QStringList{"run", path(capture), "-o", path(name)} + more,
            {"SOURCE_DATE_EPOCH=1767225600"});
    }

    QString recipe(const QString &name, const QJsonObject &content)
    {
        QFile file(path(name + ".recipe.json"));
        if (file.open(QIODevice::WriteOnly))
            file.write(QJsonDocument(content).toJson());
        return file.fileName();
    }

    /// Recordings and recipes of tests/audit/cases.py.
    bool makeCases()
    {
        const auto simulate = [this](const char *preset, const char *noise, const char *file) {
            return runDyncal({"simulate", "-o", path(file), "--preset", preset, "--noise", noise,
                                 "--seed", "3", "--duration-s", "0.006"})
                       .exitCode
                == 0;
        };
        return QFile::exists(path("both.h5"))
            || (simulate("optic3", "0.01", "dut.h5") && simulate("optic1", "0.002", "ref.h5")
                && python({sourcePath("/tests/audit/cases.py"), path("dut.h5"), path("ref.h5"),
                              m_folder.path()})
                       .ran);
    }

private slots:
    void initTestCase()
    {
        if (!python({"-c", "import lxml, h5py"}).ran)
            QSKIP("python3 with lxml and h5py is not installed: nothing was read.");
        QVERIFY(simulateShortCapture(path("shot.h5"), 7));
    }

    void everyTemplateAndLanguage_isValid_andHasEveryNumber_data()
    {
        QTest::addColumn<QString>("layout");
        QTest::addColumn<QStringList>("languages");
        for (const char *layout : {"accredited", "full", "short", "research"})
            QTest::newRow(layout) << layout << QStringList("en");
        QTest::newRow("sv") << "accredited" << QStringList("sv");
        QTest::newRow("de") << "accredited" << QStringList("de");
        QTest::newRow("en-sv") << "accredited" << QStringList({"en", "sv"});
        QTest::newRow("sv-de") << "short" << QStringList({"sv", "de"});
    }
    void everyTemplateAndLanguage_isValid_andHasEveryNumber()
    {
        QFETCH(QString, layout);
        QFETCH(QStringList, languages);
        const QString name = QTest::currentDataTag();
        const QJsonObject certificate{{"languages", QJsonArray::fromStringList(languages)}};
        const Answer answer = run("shot.h5", name,
            {"--template", layout, "--recipe", recipe(name, {{"certificate", certificate}})});
        QVERIFY2(answer.exitCode <= 1, answer.err);
        QVERIFY2(faultsOf(path(name)).isEmpty(), faultsOf(path(name)));
        if (languages.size() == 1) // side by side the pages are no table of lines any more
            QCOMPARE(missingDccNumbers(path(name), languages.front()), QByteArray());
    }

    /// Comparisons by table, model and chain, CMC, each decision rule, free decay; no step at all.
    void everyKind_isValid_andHasEveryNumber_data()
    {
        QTest::addColumn<QString>("capture");
        for (const char *name : {"table", "model", "chain", "chain_transducer", "cmc"})
            QTest::newRow(name) << "both.h5";
        QTest::newRow("decay") << "decay.h5";
        QTest::newRow("decay_compared") << "decay.h5";
    }
    void everyKind_isValid_andHasEveryNumber()
    {
        QFETCH(QString, capture);
        const QString name = QTest::currentDataTag();
        QVERIFY(makeCases());
        const Answer answer = run(capture, name, {"--recipe", path(name + ".json")});
        if (name == "decay_compared") { // refused: nothing is published, and so no DCC
            QVERIFY(!QFile::exists(path(name + "/dcc.xml")) || answer.exitCode <= 1);
            return;
        }
        QVERIFY2(answer.exitCode <= 1, answer.err);
        QVERIFY2(faultsOf(path(name)).isEmpty(), faultsOf(path(name)));
        QCOMPARE(missingDccNumbers(path(name)), QByteArray());
    }

    void withoutShockData_isValid()
    {
        const Answer answer = run("shot.h5", "unknown",
            {"--recipe", recipe("unknown", {{"shock", QJsonObject{{"enabled", false}}}})});
        QVERIFY2(answer.exitCode <= 1, answer.err);
        QVERIFY2(faultsOf(path("unknown")).isEmpty(), faultsOf(path("unknown")));
        QCOMPARE(missingDccNumbers(path("unknown")), QByteArray());
    }

    void oneToTenShots_areValid_data()
    {
        QTest::addColumn<int>("shots");
        for (const int shots : {1, 2, 5, 10})
            QTest::addRow("%d", shots) << shots;
    }
    void oneToTenShots_areValid()
    {
        QFETCH(int, shots);
        QStringList levels;
        for (int i = 0; i < shots; ++i)
            levels << QStringList({"low", "medium", "high"})[i % 3];
        const QString name = QString("shots%1").arg(shots);
        QCOMPARE(runDyncal({"simulate", "-o", path(name + ".h5"), "--preset", "piezo", "--shots",
                               levels.join(','), "--duration-s", "0.003", "--sample-rate-hz", "1e7",
                               "--seed", "5"})
                     .exitCode,
            0);
        QVERIFY(run(name + ".h5", name).exitCode <= 1);
        QVERIFY2(faultsOf(path(name)).isEmpty(), faultsOf(path(name)));
        QCOMPARE(missingDccNumbers(path(name)), QByteArray());
    }

    void runTwice_givesTheSameBytes()
    {
        QVERIFY(run("shot.h5", "first").exitCode <= 1);
        QVERIFY(run("shot.h5", "second").exitCode <= 1);
        QVERIFY(fileBytes(path("first/dcc.xml")) == fileBytes(path("second/dcc.xml")));
        QVERIFY(!fileBytes(path("first/dcc.xml")).contains(m_folder.path().toUtf8()));
    }

    /// A number that is moved in any of the three files is found.
    void movedNumber_isFound_data()
    {
        QTest::addColumn<QByteArray>("element");
        for (const char *element :
            {"si:valueExpandedMU", "si:coverageFactor", "si:value", "si:unit",
                "si:valueRealXMLList", "si:valueStandardMUXMLList", "si:intervalMinXMLList"})
            QTest::newRow(element) << QByteArray(element);
    }
    void movedNumber_isFound()
    {
        QFETCH(QByteArray, element);
        QVERIFY(QFile::exists(path("first/dcc.xml")));
        QByteArray xml = fileBytes(path("first/dcc.xml"));
        const QByteArray whole = xml;
        const QByteArray begin = '<' + element + '>';
        const qsizetype results = xml.indexOf("<dcc:results>");
        const qsizetype at = xml.indexOf(begin, results) + begin.size();
        xml.replace(at, 1, element == "si:unit" ? "\\kilo\\" : xml[at] == '7' ? "8" : "7");
        QFile file(path("first/dcc.xml"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(xml) == xml.size());
        file.close();
        QVERIFY(!missingDccNumbers(path("first")).isEmpty());
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(whole) == whole.size());
    }

    void issued_hasNumberAndHead_andIsTheSameAgain()
    {
        QByteArray first;
        for (int time = 0; time < 2; ++time) {
            const IssuedJob job;
            QVERIFY(job.begin(path("shot.h5")));
            QCOMPARE(job.issue().exitCode, 0);
            const QString folder = job.output() + "/1";
            QVERIFY2(faultsOf(folder).isEmpty(), faultsOf(folder));
            QCOMPARE(missingDccNumbers(folder), QByteArray());
            const QByteArray xml = fileBytes(folder + "/dcc.xml");
            QVERIFY(xml.contains("<dcc:uniqueIdentifier>1</dcc:uniqueIdentifier>"));
            const QJsonDocument manifest
                = QJsonDocument::fromJson(fileBytes(folder + "/manifest.json"));
            QVERIFY(xml.contains(manifest["head"].toString().toUtf8()));
            QVERIFY(!xml.contains("dyncal_draft\""));
            QVERIFY(manifest["files"].toObject().contains("dcc.xml"));
            QVERIFY(first.isEmpty() || first == xml);
            first = xml;
            QCOMPARE(job.verify({folder}).exitCode, 1); // not signed
        }
    }

    /// A country that nobody has typed is said, and is no obstacle.
    void issued_saysWhichCountryIsMissing()
    {
        const IssuedJob job;
        QVERIFY(job.begin(path("shot.h5")));
        const Answer without = job.issue({"--json"});
        QCOMPARE(without.exitCode, 0);
        QVERIFY2(without.err.contains("CER-010"), without.err);
        const QJsonArray said = QJsonDocument::fromJson(without.out)["findings"].toArray();
        QCOMPARE(said.size(), 2);
        QCOMPARE(said[0]["id"].toString(), QString("CER-010"));
        QCOMPARE(said[0]["severity"].toString(), QString("caution"));
        QJsonObject recipe = completeRecipe();
        QJsonObject fields = completeFields();
        fields["laboratory_country"] = "SE";
        fields["customer_address"] = "2 Test Street, NO-0010 Oslo";
        recipe["certificate"] = QJsonObject{{"fields", fields}};
        const IssuedJob stated;
        QVERIFY(stated.begin(path("shot.h5"), recipe));
        const Answer with = stated.issue();
        QCOMPARE(with.exitCode, 0);
        QVERIFY2(!with.err.contains("CER-010"), with.err);
        const QByteArray xml = fileBytes(stated.output() + "/1/dcc.xml");
        QVERIFY(xml.contains("<dcc:countryCodeISO3166_1>SE<"));
        QVERIFY(xml.contains("<dcc:countryCode>NO<"));
        QCOMPARE(runDyncal({"dcc", "check", stated.output() + "/1/dcc.xml"}).exitCode, 0);
    }

    void check_answersAsTheOtherCommands()
    {
        QCOMPARE(runDyncal({"dcc", "check", path("nothing.xml")}).exitCode, 3);
        QCOMPARE(runDyncal({"dcc", "check", path("shot.h5")}).exitCode, 3);
        QCOMPARE(runDyncal({"dcc", "check"}).exitCode, 4);
        QCOMPARE(runDyncal({"dcc"}).exitCode, 4);
        QCOMPARE(runDyncal({"dcc", "check", path("first/dcc.xml"), "--schemas", m_folder.path()})
                     .exitCode,
            4);
        const Answer said = runDyncal({"dcc", "check", path("first/dcc.xml")});
        QCOMPARE(said.exitCode, 2); // no country was typed
        QVERIFY2(said.out.contains("laboratory_country"), said.out);
        const QJsonDocument json = QJsonDocument::fromJson(
            runDyncal({"dcc", "check", path("first/dcc.xml"), "--json"}).out);
        QCOMPARE(json["schema"].toString(), QString("dyncal-dcc-check/1"));
        QCOMPARE(json["version"].toString(), QString("3.3.0"));
        QCOMPARE(json["number"].toString(), QString("draft"));
        QVERIFY(!json["findings"].toArray().isEmpty());
    }
};

DYNCAL_TEST(TestDcc)
#include "tst_dcc.moc"
