// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pdf/pdf_structure.h"

#include "tests/support/made_pdf.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// A catalog with these keys, and these objects behind it (the first is 2).
PdfStructure structureOf(const std::string &keys, const std::vector<std::string> &objects = {})
{
    std::vector<std::string> all{"<< /Type /Catalog " + keys + " >>"};
    all.insert(all.end(), objects.begin(), objects.end());
    const auto read = readPdfStructure(pdfOfObjects(all));
    if (!read)
        qFatal("%s", english(read.error().message).c_str());
    return *read;
}

std::string fileNamed(const std::string &name, int stream)
{
    return "<< /Type /Filespec /F (" + name + ") /UF (" + name + ") /EF << /F "
        + std::to_string(stream) + " 0 R >> >>";
}

std::string namesOf(const PdfStructure &structure)
{
    std::string names;
    for (const PdfFile &file : structure.files)
        names += file.attachment.name + (file.isAssociated ? "+a" : "") + (file.isNamed ? "+n" : "")
            + ' ';
    return names;
}

} // namespace

/// What a PDF's structure says, read from PDFs written by hand.
class TestPdfStructure : public QObject
{
    Q_OBJECT

private slots:
    void bareOne_saysNothing()
    {
        const PdfStructure read = structureOf("");
        QCOMPARE(read.header, std::string("%PDF-1.4"));
        QVERIFY(!read.isMarkedBinary && !read.hasIdentifier && !read.showsTitle);
        QVERIFY(read.language.empty() && read.xmp.empty() && read.information.empty());
        QVERIFY(read.files.empty() && read.bookmarks.empty() && read.outputIntents.empty());
        QVERIFY(read.fontsNotEmbedded.empty() && read.forbidden.empty());
    }

    void catalog_isRead()
    {
        const PdfStructure read = structureOf(
            "/Lang (sv-SE) /ViewerPreferences << /DisplayDocTitle true >> /Metadata 2 0 R"
            " /OutputIntents [ << /S /GTS_PDFX /DestOutputProfile 3 0 R >>"
            " << /S /GTS_PDFA1 /DestOutputProfile 3 0 R >> << /S /GTS_PDFA1 >> ]",
            {streamObject("<x/>"), streamObject("profile")});
        QCOMPARE(read.language, std::string("sv-SE"));
        QVERIFY(read.showsTitle && read.isXmpPlain);
        QCOMPARE(read.xmp, std::string("<x/>"));
        QCOMPARE(read.outputIntents, (std::vector<std::string>{"profile", ""}));
    }

    void otherKindsOfValue_countAsNone()
    {
        const PdfStructure read
            = structureOf("/Lang /sv /ViewerPreferences [ ] /Metadata (x) /OutputIntents << >>"
                          " /Outlines 7 /AF (x) /Names [ ]");
        QVERIFY(read.language.empty() && !read.showsTitle && read.xmp.empty());
        QVERIFY(read.outputIntents.empty() && read.files.empty() && read.bookmarks.empty());
    }

    void texts_ofBothEncodings_areUtf8()
    {
        const PdfStructure read = structureOf("/Outlines << /First 2 0 R >>",
            {"<< /Title (B\345t) /Next 3 0 R >>", "<< /Title <feff03a9> >>"});
        QCOMPARE(read.bookmarks, (std::vector<std::string>{"Båt", "Ω"}));
    }

    void fileSpecification_isReadWhole()
    {
        const PdfStructure read = structureOf("/AF [ 2 0 R ]",
            {"<< /Type /Filespec /F (plain) /UF <feff03a9> /Desc (said) /AFRelationship /Data"
             " /EF << /F 3 0 R >> >>",
                streamObject("abc",
                    "/Type /EmbeddedFile /Subtype /text#2fcsv /Params << /Size 3 /ModDate"
                    " (D:20260131120000Z) /CheckSum <900150983cd24fb0d6963f7d28e17f72> >>")});
        QCOMPARE(read.files.size(), std::size_t(1));
        const PdfFile &file = read.files.front();
        QVERIFY((file.attachment == PdfAttachment{"Ω", "text/csv", "Data", "said", "abc"}));
        QCOMPARE(file.plainName, std::string("plain"));
        QCOMPARE(file.modified, std::string("D:20260131120000Z"));
        QCOMPARE(file.statedSize, 3);
        QVERIFY(file.isUnpacked && file.isAssociated && !file.isNamed);
        QCOMPARE(file.statedChecksum, file.checksum); // MD5 of "abc" by RFC 1321
    }

    void filesOfBothLists_areReadOnce_associatedFirst()
    {
        const std::vector<std::string> objects{fileNamed("a", 6), fileNamed("b", 6),
            fileNamed("c", 6), "<< /Kids [ 7 0 R ] /Names [ (a) 2 0 R ] >>", streamObject("x"),
            "<< /Names [ (b) 3 0 R ] >>"};
        QCOMPARE(
            namesOf(structureOf("/AF [ 4 0 R 3 0 R ] /Names << /EmbeddedFiles 5 0 R >>", objects)),
            std::string("c+a b+a+n a+n "));
    }

    void attachments_areThoseOfTheFile()
    {
        const std::string pdf = pdfOfObjects({"<< /Type /Catalog /AF [ 2 0 R 3 0 R ] >>",
            fileNamed("a", 4), fileNamed("b", 5), streamObject("x"), streamObject("y")});
        const auto read = attachmentsOf(pdf);
        QCOMPARE(read->size(), std::size_t(2));
        QCOMPARE(read->front().bytes + read->back().bytes, std::string("xy"));
        const std::string lost
            = pdfOfObjects({"<< /Type /Catalog /AF [ 2 0 R ] >>", fileNamed("a", 9)});
        const auto refused = attachmentsOf(lost);
        QVERIFY(!refused && refused.error().kind == ErrorKind::FileUnreadable);
        QVERIFY(english(refused.error().message).find("(a)") != std::string::npos);
    }

    void fonts_everywhere_areLookedAt_data()
    {
        QTest::addColumn<QString>("font");
        QTest::addColumn<bool>("isEmbedded");
        const auto add = [](const char *font, bool isEmbedded) {
            QTest::newRow(font) << QString(font) << isEmbedded;
        };
        add("/Subtype /Type1 /BaseFont /Helvetica", false);
        add("/Subtype /TrueType /FontDescriptor << /FontFile2 3 0 R >>", true);
        add("/Subtype /Type1 /FontDescriptor << /FontFile 3 0 R >>", true);
        add("/Subtype /Type1 /FontDescriptor << /FontFile3 3 0 R >>", true);
        add("/Subtype /Type1 /FontDescriptor << /FontFile (x) >>", false);
        add("/Subtype /Type3", true);
        add("/Subtype /Type0 /DescendantFonts [ ]", false);
    }
    void fonts_everywhere_areLookedAt()
    {
        QFETCH(QString, font);
        QFETCH(bool, isEmbedded);
        const std::string one = "<< /Type /Font " + font.toStdString() + " >>";
        // as an object of its own, and inside of others
        QCOMPARE(structureOf("", {one, streamObject("x")}).fontsNotEmbedded.empty(), isEmbedded);
        const PdfStructure inside
            = structureOf("/Own [ << /Own " + one + " >> ]", {"null", streamObject("x")});
        QCOMPARE(inside.fontsNotEmbedded.empty(), isEmbedded);
    }

    void streams_thatLieElsewhereOrHaveForbiddenFilters_areNamed()
    {
        const PdfStructure read = structureOf("",
            {streamObject("x", "/Filter [ /ASCIIHexDecode /LZWDecode ]"),
                streamObject("x", "/F (other) /FFilter /FlateDecode")});
        QVERIFY((read.forbidden
            == std::set<std::string>{"/LZWDecode", "stream with /F", "stream with /FFilter"}));
    }

    void binaryMark_isFourBytesInTheNextLine()
    {
        const auto read = readPdfStructure(*withArchiveStructure(madePages(), madeArchive()));
        QVERIFY(read->isMarkedBinary);
        QCOMPARE(read->header, std::string("%PDF-1.7"));
    }

    void budget_isOfAllStreamsTogether()
    {
        QCOMPARE(unpackedLimit(0), std::size_t(64) << 20U);
        QCOMPARE(unpackedLimit(1000) - unpackedLimit(0), std::size_t(20000));
        PdfArchive archive = madeArchive(std::string(std::size_t(40) << 20U, 'a'));
        archive.attachments.back().bytes = std::string(std::size_t(40) << 20U, 'b');
        const auto read = readPdfStructure(*withArchiveStructure(madePages(), archive));
        QVERIFY(read->files.front().isUnpacked && !read->files.back().isUnpacked);
    }
};

DYNCAL_TEST(TestPdfStructure)
#include "tst_pdf_structure.moc"
