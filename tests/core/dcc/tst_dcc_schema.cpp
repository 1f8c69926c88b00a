// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// By PTB's schemas, where they lie beside the checkout, and by made folders without them.

#include "core/dcc/dcc_check.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace dyncal;
using testing::replacedOnce;

namespace {

/// "" where they are not there.
QString schemas()
{
    const QDir folder(qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/../shared/dcc");
    return folder.exists("ptb.de/dcc/v3.3.0/dcc.xsd") ? folder.absolutePath() : QString();
}

bool write(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    return QDir().mkpath(QFileInfo(path).path()) && file.open(QIODevice::WriteOnly)
        && file.write(bytes) == bytes.size();
}

} // namespace

class TestDccSchema : public QObject
{
    Q_OBJECT

private slots:
    void ownDocument_isValid()
    {
        if (schemas().isEmpty())
            QSKIP("PTB's schemas are not there: ../shared/dcc");
        const Result<DccCheck> check = checkDcc(testing::exampleDcc(), schemas().toStdString());
        QVERIFY(check.has_value());
        for (const DccFinding &finding : check->findings)
            qWarning("%s %s", finding.where.c_str(), finding.found.c_str());
        QVERIFY(check->findings.empty());
        QVERIFY(check->isSchemaChecked);
    }

    void brokenDocument_isSaidWithItsLine()
    {
        if (schemas().isEmpty())
            QSKIP("PTB's schemas are not there: ../shared/dcc");
        const std::string broken
            = replacedOnce(testing::exampleDcc(), "<dcc:type>application", "<dcc:type>spreadsheet");
        const Result<DccCheck> check = checkDcc(broken, schemas().toStdString());
        QVERIFY(check.has_value());
        QVERIFY(!check->findings.empty());
        const DccFinding &finding = check->findings.front();
        QCOMPARE(finding.rule, std::string("schema"));
        QVERIFY(finding.where.starts_with("line "));
        QVERIFY(finding.found.find("spreadsheet") != std::string::npos);
    }

    void ownSample_isValid()
    {
        QFile sample(schemas() + "/samples/own_shocktube_dcc.xml");
        if (schemas().isEmpty() || !sample.open(QIODevice::ReadOnly))
            QSKIP("PTB's schemas are not there: ../shared/dcc");
        const Result<DccCheck> check
            = checkDcc(sample.readAll().toStdString(), schemas().toStdString());
        QVERIFY(check.has_value());
        QVERIFY(check->findings.empty());
    }

    void folderWithoutTheVersion_isWrongUsage()
    {
        const QTemporaryDir folder;
        const Result<DccCheck> none = checkDcc(testing::exampleDcc(), folder.path().toStdString());
        QVERIFY(!none.has_value());
        QCOMPARE(none.error().kind, ErrorKind::Usage);
        QVERIFY(english(none.error().message).find("v3.3.0") != std::string::npos);
        const Result<DccCheck> odd
            = checkDcc(replacedOnce(testing::exampleDcc(), "schemaVersion=\"3.3.0\"",
                           "schemaVersion=\"../..\""),
                folder.path().toStdString());
        QVERIFY(!odd.has_value());
    }

    void schemaThatIsNone_isWrongUsage()
    {
        const QTemporaryDir folder;
        QVERIFY(write(folder.filePath("ptb.de/dcc/v3.3.0/dcc.xsd"), "no schema"));
        const Result<DccCheck> none = checkDcc(testing::exampleDcc(), folder.path().toStdString());
        QVERIFY(!none.has_value());
        QCOMPARE(none.error().kind, ErrorKind::Usage);
    }

    /// What it imports from outside the folder is not opened, so that it is no whole schema.
    void schemaThatLeavesItsFolder_isNotFollowed()
    {
        const QTemporaryDir folder;
        const char *schema
            = "<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\" xmlns:o=\"urn:o\">"
              "<xs:import namespace=\"urn:o\" schemaLocation=\"%1\"/>"
              "<xs:element name=\"digitalCalibrationCertificate\" type=\"o:t\"/></xs:schema>";
        QVERIFY(write(folder.filePath("outside.xsd"),
            "<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\" targetNamespace=\"urn:o\">"
            "<xs:simpleType name=\"t\"><xs:restriction base=\"xs:string\"/></xs:simpleType>"
            "</xs:schema>"));
        for (const QString &place : {folder.filePath("outside.xsd"), QString("file:///etc/passwd"),
                 QString("https://ptb.de/../../outside.xsd"),
                 QString("https://example.org/x.xsd")}) {
            QVERIFY(write(folder.filePath("in/ptb.de/dcc/v3.3.0/dcc.xsd"),
                QString(schema).arg(place).toUtf8()));
            const Result<DccCheck> none
                = checkDcc(testing::exampleDcc(), folder.filePath("in").toStdString());
            QVERIFY2(!none.has_value(), qPrintable(place));
        }
    }
};

DYNCAL_TEST(TestDccSchema)
#include "tst_dcc_schema.moc"
