// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// PDFs of anybody's: cut off, flipped, in circles, with counts and streams of any size. Each is
// read or refused, in a time and memory that its size bounds.

#include "core/pdf/pdf_lint.h"
#include "core/pdf/pdf_streams.h"
#include "tests/support/made_pdf.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QtTest>

#include <ctime>
#include <random>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

const std::string &sound()
{
    static const std::string pdf = *withArchiveStructure(madePages(), madeArchive());
    return pdf;
}

constexpr double kLongest_s = 10.0; // of the processor; some two are needed

/// Whether it was read; a refusal is a sentence.
bool isRead(const std::string &pdf)
{
    const std::clock_t begin = std::clock();
    const auto faults = lintPdf(pdf);
    const auto files = attachmentsOf(pdf);
    const double used_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    if (used_s > kLongest_s)
        qFatal("%g s", used_s);
    if (!faults && (faults.error().kind != ErrorKind::FileUnreadable || files.has_value()))
        qFatal("refused in another way");
    return faults.has_value();
}

std::string replaced(std::string text, const std::string &from, const std::string &to)
{
    return text.replace(text.find(from), from.size(), to);
}

/// A catalog with these keys, and these objects behind it (the first is 2).
std::string pdfWith(const std::string &keys, const std::vector<std::string> &objects)
{
    std::vector<std::string> all{"<< /Type /Catalog " + keys + " >>"};
    all.insert(all.end(), objects.begin(), objects.end());
    return pdfOfObjects(all);
}

} // namespace

class TestHostilePdf : public QObject
{
    Q_OBJECT

private slots:
    void cutOff_anywhere_isRefusedOrRead()
    {
        const std::size_t step = static_cast<std::size_t>(trials::count(97, 1));
        for (std::size_t size = 0; size + 8 < sound().size(); size += step)
            QVERIFY2(!isRead(sound().substr(0, size)), std::to_string(size).c_str());
    }

    void flipped_anywhere_isRefusedOrRead()
    {
        std::mt19937 random(1);
        int read = 0;
        const int count = trials::count(400, 20000);
        for (int i = 0; i < count; ++i) {
            std::string pdf = sound();
            for (unsigned flips = 1 + random() % 4; flips > 0; --flips)
                pdf[random() % pdf.size()] = static_cast<char>(random() & 255U);
            read += isRead(pdf) ? 1 : 0;
        }
        QVERIFY(read > count / 4 && read < count); // both happen
    }

    void pieces_putTogetherAnew_areRefusedOrRead()
    {
        std::mt19937 random(2);
        for (int i = 0; i < trials::count(100, 5000); ++i) {
            std::string pdf = sound();
            const std::size_t from = random() % pdf.size(), length = random() % 400;
            pdf.insert(random() % pdf.size(), pdf.substr(from, length));
            isRead(pdf);
            pdf.erase(random() % pdf.size(), random() % 400);
            isRead(pdf);
        }
    }

    void circles_end()
    {
        // the tree of embedded files, the list of bookmarks, a font's descendants
        QVERIFY(
            isRead(pdfWith("/Names << /EmbeddedFiles 2 0 R >>", {"<< /Kids [ 2 0 R 2 0 R ] >>"})));
        QVERIFY(isRead(pdfWith("/Names << /EmbeddedFiles 2 0 R >>",
            {"<< /Kids [ 3 0 R 3 0 R ] >>", "<< /Kids [ 2 0 R ] /Names [ (a) 3 0 R ] >>"})));
        QVERIFY(isRead(pdfWith("/Outlines << /First 2 0 R >>", {"<< /Title (a) /Next 2 0 R >>"})));
        QVERIFY(isRead(pdfWith(
            "/Own 2 0 R", {"<< /Type /Font /Subtype /Type0 /DescendantFonts [ 2 0 R ] >>"})));
        QVERIFY(isRead(pdfWith("/AF [ 2 0 R 2 0 R ]", {"<< /EF << /F 2 0 R >> >>"})));
        isRead(pdfWith("/Own 2 0 R", {"2 0 R"}));
        isRead(pdfWith("/Metadata 2 0 R", {"<< /Length 2 0 R >>\nstream\nx\nendstream"}));
        // the table that names itself as the one before it
        const std::string pdf = pdfWith("", {});
        const std::string table = std::to_string(pdf.find("xref\n"));
        QVERIFY(!isRead(replaced(pdf, "/Root 1 0 R", "/Root 1 0 R /Prev " + table)));
    }

    void hugeCounts_areNotBelieved()
    {
        const std::string pdf = pdfWith("", {});
        for (const char *count : {"0 1000000000\n", "0 99999999999999999999\n", "1999999999 2\n"})
            QVERIFY(!isRead(replaced(pdf, "0 2\n", count)));
        isRead(replaced(pdf, "/Size 2", "/Size 2147483647"));
        isRead(replaced(pdf, "/Size 2", "/Size -5"));
        isRead(pdfWith("/Metadata 2 0 R", {"<< /Length 99999999999 >>\nstream\nx\nendstream"}));
        isRead(pdfWith("/Own 999999999 0 R /AF 999999999 65535 R", {}));
        QVERIFY(!isRead(std::string(kLargestPdf + 1, ' ')));
    }

    void deeplyNested_isRefusedOrRead()
    {
        for (const std::size_t depth : {100U, 10000U, 1000000U})
            for (const char *open : {"[", "<</A"}) {
                std::string nested;
                for (std::size_t i = 0; i < depth; ++i)
                    nested += open;
                isRead(pdfWith("/Own " + nested, {}));
                isRead(pdfWith("/Own 2 0 R", {nested}));
            }
        std::vector<std::string> chain; // pages below pages, each a /Kids of the one before
        for (int i = 0; i < 20000; ++i)
            chain.push_back("<< /Type /Pages /Kids [ " + std::to_string(i + 3) + " 0 R ] >>");
        isRead(pdfWith("/Pages 2 0 R", chain));
        QVERIFY(!isRead(pdfWith("", std::vector<std::string>(100001, "null"))));
    }

    void longLists_areReadInTheirTime()
    {
        std::string names = "<< /Names [ ", files = "[ ";
        for (int i = 0; i < 20000; ++i) {
            names += "(a) 3 0 R ";
            files += "3 0 R ";
        }
        QVERIFY(isRead(pdfWith("/Names << /EmbeddedFiles 2 0 R >> /AF " + files + "]",
            {names + "] >>", "<< /Type /Filespec >>"})));
    }

    /// What unpacks to more than the budget is left.
    void bomb_isNotUnpacked()
    {
        PdfArchive archive = madeArchive(std::string(std::size_t(100) << 20U, '\0'));
        const auto bomb = withArchiveStructure(madePages(), archive);
        archive = {};
        QVERIFY(bomb.has_value() && bomb->size() < 1000000);
        QVERIFY(!attachmentsOf(*bomb));
        const auto faults = lintPdf(*bomb);
        QCOMPARE(faults->size(), std::size_t(1));
        QCOMPARE(faults->front().rule, std::string("file"));
    }

    void chainOfFilters_isNotFollowed()
    {
        const auto file = [](const std::string &filter) {
            return pdfWith("/AF [ 2 0 R ]",
                {"<< /Type /Filespec /UF (a) /EF << /F 3 0 R >> >>",
                    streamObject("garbage", "/Filter " + filter)});
        };
        QVERIFY(!attachmentsOf(file("[ /FlateDecode /FlateDecode ]")));
        QVERIFY(!attachmentsOf(
            file("/FlateDecode /DecodeParms << /Predictor 12 /Columns 2147483647 >>")));
        QVERIFY(!attachmentsOf(file("/RunLengthDecode")));
        QVERIFY(!attachmentsOf(file("/FlateDecode"))); // garbage is none
        QCOMPARE(attachmentsOf(file("null"))->front().bytes, std::string("garbage"));
    }

    void tablesInStreams_areRefused()
    {
        const std::string pdf = pdfWith("", {});
        QVERIFY(
            !isRead(replaced(pdf, "xref\n0 2", "1 0 obj\n<< /Type /XRef /Size 2 /W [ 1 1 1 ] >>")));
        QVERIFY(
            !isRead(replaced(pdf, "/Root 1 0 R", "/Root 1 0 R /Encrypt << /Filter /Standard >>")));
    }

    void md5_ofTheStandard() // RFC 1321, A.5
    {
        const auto hex = [](const std::string &text) {
            return QByteArray::fromStdString(md5Of(text)).toHex();
        };
        QCOMPARE(hex(""), QByteArray("d41d8cd98f00b204e9800998ecf8427e"));
        QCOMPARE(hex("message digest"), QByteArray("f96b697d7cb7938d525a2f31aaf161d0"));
    }
};

DYNCAL_TEST(TestHostilePdf)
#include "tst_hostile_pdf.moc"
