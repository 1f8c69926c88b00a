// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pdf/pdf_metadata.h"

#include "tests/support/made_pdf.h"
#include "tests/support/test_program.h"

#include <QXmlStreamReader>
#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

const char *const kOwn = "https://dyncal.example.org/ns/1.0/";

/// Name and text of every property of a namespace, by another XML parser; empty where it is none.
std::vector<std::pair<std::string, std::string>> propertiesOf(
    const std::string &xmp, const QString &space)
{
    std::vector<std::pair<std::string, std::string>> properties;
    QXmlStreamReader xml(QByteArray::fromStdString(xmp));
    while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.namespaceUri() == space) {
            const std::string name = xml.name().toString().toStdString();
            properties.emplace_back(name,
                xml.readElementText(QXmlStreamReader::IncludeChildElements)
                    .simplified()
                    .toStdString());
        }
    return xml.hasError() ? std::vector<std::pair<std::string, std::string>>() : properties;
}

} // namespace

/// The metadata of a document.
class TestPdfMetadata : public QObject
{
    Q_OBJECT

private slots:
    void dates_asAPdfWritesThem_andBack()
    {
        QCOMPARE(pdfDate("2026-01-31T12:34:56Z"), std::string("D:20260131123456Z"));
        QCOMPARE(utcOfPdfDate("D:20260131123456Z"), std::string("2026-01-31T12:34:56Z"));
        for (const char *none : {"", "yesterday", "2026-01-31T12:34:56", "2026-01-31T12:34:5xZ"})
            QCOMPARE(pdfDate(none), std::string("D:19700101000000Z"));
        for (const char *none : {"", "D:2026", "D:20260131123456+02'00'", "D:2026013112345xZ"})
            QVERIFY(utcOfPdfDate(none).empty());
    }

    void whatIsWritten_isReadBack()
    {
        const PdfMetadata given = madeArchive().metadata;
        const auto read = readXmp(xmpOf(given));
        QVERIFY(read.has_value());
        QCOMPARE(read->part + read->conformance, std::string("3B"));
        QCOMPARE(read->claims, 1);
        QCOMPARE(read->title, given.title);
        QCOMPARE(read->author, given.author);
        QCOMPARE(read->creator, given.creator);
        QCOMPARE(read->producer, given.producer);
        QCOMPARE(read->created, given.createdUtc);
        QCOMPARE(read->modified, given.createdUtc);
        QVERIFY((read->languages == std::vector<std::string>{"sv", "en"}));
        QVERIFY(read->marks == given.marks && read->describesMarks);
    }

    void anotherParser_findsTheSame()
    {
        const PdfMetadata given = madeArchive().metadata;
        const std::string xmp = xmpOf(given);
        QVERIFY(propertiesOf(xmp, kOwn) == given.marks);
        using Properties = std::vector<std::pair<std::string, std::string>>;
        QVERIFY((propertiesOf(xmp, "http://www.aiim.org/pdfa/ns/id/")
            == Properties{{"part", "3"}, {"conformance", "B"}}));
        QVERIFY((
            propertiesOf(xmp, "http://ns.adobe.com/pdf/1.3/") == Properties{{"Producer", "Qt 6"}}));
        QCOMPARE(propertiesOf(xmp, "http://purl.org/dc/elements/1.1/").size(), std::size_t(4));
    }

    /// Each property of Dyncal's own is described, or the file would not be PDF/A.
    void everyMark_isDescribed_andNothingIsWithoutMarks()
    {
        PdfMetadata metadata = madeArchive().metadata;
        const auto described
            = propertiesOf(xmpOf(metadata), "http://www.aiim.org/pdfa/ns/property#");
        std::size_t names = 0;
        for (const auto &[name, text] : described)
            names += name == "name" ? 1 : 0;
        QCOMPARE(names, metadata.marks.size());
        metadata.marks.clear();
        QVERIFY(!readXmp(xmpOf(metadata))->describesMarks);
        QVERIFY(xmpOf(metadata).find("dyncal:") == std::string::npos);
    }

    void marks_standAsText()
    {
        QVERIFY(xmpOf(madeArchive().metadata).find("<dyncal:number>17</dyncal:number>")
            != std::string::npos);
    }

    void withoutAuthorOrSecondLanguage_nothingStandsForThem()
    {
        PdfMetadata metadata = madeArchive().metadata;
        metadata.author = metadata.secondLanguage = "";
        const std::string xmp = xmpOf(metadata);
        QVERIFY(xmp.find("dc:creator") == std::string::npos);
        QVERIFY(readXmp(xmp)->languages == std::vector<std::string>{"sv"});
    }

    void twoClaims_areCounted_whereverTheyStand()
    {
        const std::string xmp = xmpOf(madeArchive().metadata);
        for (const char *second :
            {"<rdf:Description><pdfaid:part>2</pdfaid:part></rdf:Description>",
                "<rdf:Description pdfaid:part=\"1\"/>"}) {
            std::string twice = xmp;
            twice.insert(twice.find("</rdf:RDF>"), second);
            QCOMPARE(readXmp(twice)->claims, 2);
        }
    }

    void whatIsNoXml_isNotRead()
    {
        for (const char *none : {"", "<a", "<a></b>", "%PDF"})
            QVERIFY(!readXmp(none));
        QCOMPARE(readXmp("<a/>")->claims, 0);
        QCOMPARE(readXmp("<!DOCTYPE x [<!ENTITY a \"aaaa\">]><x>&a;</x>")->claims, 0);
    }
};

DYNCAL_TEST(TestPdfMetadata)
#include "tst_pdf_metadata.moc"
