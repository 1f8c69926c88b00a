// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The DCC of runs and issued certificates, by the built program: made again it is the same, and
// what judges it sees a moved number. system_dcc_matrix has every template, language, kind and
// number of shots.

#include "tests/support/test_program.h"
#include "tests/system/dcc_judges.h"
#include "tests/system/issued_job.h"

#include <QtTest>

using dyncal::testing::python;

class TestDcc : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    QString path(const QString &name) const { return m_folder.filePath(name); }

    Answer run(const QString &capture, const QString &name)
    {
        return runDyncal({"run", path(capture), "--recipe", path("quick.json"), "-o", path(name)},
            {"SOURCE_DATE_EPOCH=1767225600"});
    }

private slots:
    void initTestCase()
    {
        if (!python({"-c", "import lxml, h5py"}).ran)
            QSKIP("python3 with lxml and h5py is not installed: nothing was read.");
        QVERIFY(simulateShortCapture(path("shot.h5"), 7));
        QVERIFY(writeBytes(path("quick.json"), R"({"uncertainty": {"monte_carlo_trials": 1000}})"));
    }

    void runTwice_givesTheSameBytes()
    {
        QVERIFY(run("shot.h5", "first").exitCode <= 1);
        QVERIFY(run("shot.h5", "second").exitCode <= 1);
        QVERIFY(bytesOf(path("first/dcc.xml")) == bytesOf(path("second/dcc.xml")));
        QVERIFY(!bytesOf(path("first/dcc.xml")).contains(m_folder.path().toUtf8()));
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
        QByteArray xml = bytesOf(path("first/dcc.xml"));
        const QByteArray whole = xml;
        const QByteArray begin = '<' + element + '>';
        const qsizetype results = xml.indexOf("<dcc:results>");
        const qsizetype at = xml.indexOf(begin, results) + begin.size();
        xml.replace(at, 1, element == "si:unit" ? "\\kilo\\" : xml[at] == '7' ? "8" : "7");
        QFile file(path("first/dcc.xml"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(xml) == xml.size());
        file.close();
        QVERIFY(!missingNumbers(path("first"), "en").isEmpty());
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
            QCOMPARE(faultsOf(folder), QByteArray());
            QCOMPARE(missingNumbers(folder, "en"), QByteArray());
            const QByteArray xml = bytesOf(folder + "/dcc.xml");
            QVERIFY(xml.contains("<dcc:uniqueIdentifier>1</dcc:uniqueIdentifier>"));
            const QJsonDocument manifest
                = QJsonDocument::fromJson(bytesOf(folder + "/manifest.json"));
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
        const QByteArray xml = bytesOf(stated.output() + "/1/dcc.xml");
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
        QVERIFY2(said.out.contains("countries of laboratory and customer"), said.out);
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
