// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pdf/pdf_archive.h"

#include "core/base/content_hash.h"
#include "core/pdf/pdf_lint.h"
#include "tests/support/made_pdf.h"
#include "tests/support/test_program.h"
#include "tests/support/tool_answer.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include <random>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

std::string archived(
    const PdfArchive &archive = madeArchive(), const std::string &pdf = madePages())
{
    const auto bytes = withArchiveStructure(pdf, archive);
    return bytes ? *bytes : "failed: " + english(bytes.error().message);
}

std::string randomBytes(std::size_t count, unsigned seed)
{
    std::mt19937 random(seed);
    std::string bytes;
    while (bytes.size() < count)
        bytes += static_cast<char>(random() & 255U);
    return bytes;
}

} // namespace

/// The structure around the pages, judged by qpdf and poppler.
class TestPdfArchive : public QObject
{
    Q_OBJECT

private slots:
    void whatWasAttached_comesBack_byOtherProgramsToo()
    {
        PdfArchive archive = madeArchive(randomBytes(70000, 1));
        archive.attachments.push_back(
            {"räknat.bin", "application/octet-stream", "Unspecified", "Ω", std::string()});
        const std::string pdf = archived(archive);
        const auto back = attachmentsOf(pdf);
        QVERIFY2(back.has_value(), pdf.c_str());
        QVERIFY(*back == archive.attachments);
        for (const PdfAttachment &one : archive.attachments) {
            const QString name = QString::fromStdString(one.name);
            const QByteArray bytes = QByteArray::fromStdString(one.bytes);
            QCOMPARE(askTool("qpdf", {"--show-attachment=" + name, "FILE"}, pdf).out, bytes);
        }
        QCOMPARE(
            askTool("pdfdetach", {"-savefile", "results.json", "-o", "got", "FILE"}, pdf, "got")
                .out,
            QByteArray::fromStdString(archive.attachments.front().bytes));
        QVERIFY(askTool("pdfdetach", {"-list", "FILE"}, pdf).out.startsWith("3 embedded files"));
    }

    /// As a named destination, beside the attachments, for poppler too.
    void placeOfASignature_isNamed()
    {
        PdfArchive archive = madeArchive();
        archive.signature = PdfPlace{1, 57.25, 90.0, 538.0, 140.5};
        for (const bool hasFiles : {true, false}) {
            if (!hasFiles)
                archive.attachments.clear();
            const std::string pdf = archived(archive);
            const QByteArray said = askTool("pdfinfo", {"-dests", "FILE"}, pdf).out;
            QVERIFY2(said.contains("\"signature\""), said);
            QVERIFY2(said.contains("   2 [") && said.contains("57"), said);
            QCOMPARE(askTool("qpdf", {"--check", "FILE"}, pdf).exitCode, 0);
            QCOMPARE(attachmentsOf(pdf)->size(), archive.attachments.size());
        }
        QVERIFY(!askTool("pdfinfo", {"-dests", "FILE"}, archived()).out.contains("signature"));
        archive.signature->page = 2;
        QVERIFY(archived(archive).starts_with("failed"));
    }

    void otherPrograms_findNoFault_andWhatWasSaid()
    {
        const std::string pdf = archived();
        const ToolAnswer check = askTool("qpdf", {"--check", "FILE"}, pdf);
        QVERIFY2(check.exitCode == 0 && check.error.isEmpty(), check.error + check.out);
        const QByteArray said = askTool("pdfinfo", {"FILE"}, pdf).out;
        for (const char *line : {"Title:           Bevis över 17\n", "Author:          Lab <&> Å\n",
                 "Creator:         Dyncal\n", "Metadata Stream: yes", "Pages:           2\n",
                 "PDF version:     1.7", "Encrypted:       no", "Form:            none"})
            QVERIFY2(said.contains(line), said);
        QCOMPARE(askTool("pdfinfo", {"-meta", "FILE"}, pdf).out.trimmed(),
            QByteArray::fromStdString(xmpOf(madeArchive().metadata)).trimmed());
        const QByteArray fonts = askTool("pdffonts", {"FILE"}, pdf).out;
        QVERIFY2(fonts.contains("ABCDEF+Made"), fonts);
        const auto faults = lintPdf(pdf);
        QVERIFY(faults.has_value());
        QVERIFY2(faults->empty(), faults->empty() ? "" : faults->front().rule.c_str());
    }

    void catalog_saysLanguageTitleAndContents()
    {
        const std::string pdf = archived();
        const QJsonObject all = QJsonDocument::fromJson(
            askTool("qpdf", {"--json=2", "--json-key=outlines", "FILE"}, pdf).out)
                                    .object();
        const QJsonArray lines = all["outlines"].toArray();
        QCOMPARE(lines.size(), 2);
        QCOMPARE(lines[0].toObject()["title"].toString(), QString("Resultat"));
        QCOMPARE(lines[1].toObject()["title"].toString(), QString("Ωmega"));
        QCOMPARE(lines[1].toObject()["destpageposfrom1"].toInt(), 2);
        QCOMPARE(lines[0].toObject()["dest"].toArray()[3].toDouble(), 700.25);
        const auto structure = readPdfStructure(pdf);
        QCOMPARE(structure->language, std::string("sv"));
        QVERIFY(structure->showsTitle && structure->hasIdentifier && structure->isMarkedBinary);
        QCOMPARE(structure->outputIntents, std::vector<std::string>{madeProfile()});
    }

    void pages_areNotTouched()
    {
        const QByteArray plain
            = askTool("qpdf", {"--qdf", "--object-streams=disable", "FILE", "-"}, archived()).out;
        for (const char *content :
            {"BT /F1 12 Tf 72 700 Td <0001> Tj ET", "BT /F1 12 Tf 72 600 Td <0002> Tj ET"})
            QCOMPARE(plain.count(content), 1);
    }

    void again_sameBytes_whateverTheDatesWere()
    {
        const std::string pdf = archived();
        QVERIFY(archived() == pdf);
        // A PDF that says the same pages are of another day, by another program.
        std::string dated = madePages();
        dated.replace(dated.find("/Root 1 0 R"), 11, "/Root 1 0 R /ID [ <00> <01> ]");
        QVERIFY(archived(madeArchive(), dated) == pdf);
        PdfArchive other = madeArchive();
        other.metadata.createdUtc = "2027-01-31T12:00:00Z";
        QVERIFY(archived(other) != pdf);
    }

    void oneTable_andNoObjectStreams()
    {
        const std::string pdf = archived();
        QCOMPARE(QByteArray::fromStdString(pdf).count("startxref"), 1);
        QVERIFY(pdf.find("/ObjStm") == std::string::npos && pdf.find("/XRef") == std::string::npos);
        const std::size_t stated = pdf.rfind("startxref\n") + 10;
        QCOMPARE(pdf.substr(std::stoul(pdf.substr(stated)), 5), std::string("xref\n"));
    }

    /// The revision before a signature's: what is appended later must leave it as it is.
    void incrementBehindIt_leavesTheStructureReadable()
    {
        std::string pdf = archived();
        const std::string before = pdf.substr(pdf.rfind("startxref\n") + 10);
        const std::string object = "1000 0 obj\n<< /Type /Sig >>\nendobj\n";
        const std::size_t at = pdf.size(), table = at + object.size();
        char entry[21];
        std::snprintf(entry, sizeof entry, "%010zu 00000 n \n", at);
        const std::size_t root = pdf.rfind("/Info ");
        pdf += object + "xref\n1000 1\n" + entry + "trailer\n<< /Size 1001 "
            + pdf.substr(root, pdf.find("/Size", root) - root) + " /Prev "
            + before.substr(0, before.find('\n')) + " /ID [ <00> <01> ] >>\nstartxref\n"
            + std::to_string(table) + "\n%%EOF\n";
        QCOMPARE(askTool("qpdf", {"--check", "FILE"}, pdf).exitCode, 0);
        QVERIFY(*attachmentsOf(pdf) == madeArchive().attachments);
        QVERIFY(lintPdf(pdf)->empty());
    }

    void withoutAttachmentsOrBookmarks_nothingStandsForThem()
    {
        PdfArchive archive = madeArchive();
        archive.attachments.clear();
        archive.bookmarks.clear();
        const std::string pdf = archived(archive);
        for (const char *key : {"/AF", "/EmbeddedFiles", "/Outlines"})
            QVERIFY2(pdf.find(key) == std::string::npos, key);
        QVERIFY(attachmentsOf(pdf)->empty());
    }

    void whatCannotBe_isRefused_data()
    {
        QTest::addColumn<QString>("fault");
        for (const char *fault : {"no name", "folder", "twice", "relationship", "page", "no PDF"})
            QTest::newRow(fault) << fault;
    }
    void whatCannotBe_isRefused()
    {
        QFETCH(QString, fault);
        PdfArchive archive = madeArchive();
        PdfAttachment &first = archive.attachments.front();
        if (fault == "no name")
            first.name = "";
        if (fault == "folder")
            first.name = "a/b";
        if (fault == "twice")
            first.name = "recipe.json";
        if (fault == "relationship")
            first.relationship = "Friend";
        if (fault == "page")
            archive.bookmarks.front().page = 2;
        const auto refused
            = withArchiveStructure(fault == "no PDF" ? "no PDF" : madePages(), archive);
        QVERIFY(!refused && refused.error().kind == ErrorKind::Internal);
    }
};

DYNCAL_TEST(TestPdfArchive)
#include "tst_pdf_archive.moc"
