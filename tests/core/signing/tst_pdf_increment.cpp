// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/cms_signature.h"
#include "core/signing/pdf_outline.h"
#include "core/signing/pdf_signature.h"
#include "tests/support/made_keys.h"
#include "tests/support/revised_pdf.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QtTest>

#include <random>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

const PdfSignatureWords kWords{"Lab", MadeKeys::kNow};

std::string repeated(const std::string &text, int times)
{
    std::string all;
    for (int i = 0; i < times; ++i)
        all += text;
    return all;
}

std::string nestedPages(int levels)
{
    MadePdf pdf;
    pdf.object(1, "<</Type/Catalog/Pages 2 0 R>>");
    for (int i = 0; i < levels; ++i)
        pdf.object(2 + i,
            "<</Type/Pages/Count 1/Kids[" + std::to_string(3 + i) + " 0 R]"
                + (i > 0 ? "/Parent " + std::to_string(1 + i) + " 0 R" : "") + ">>");
    pdf.object(2 + levels,
        "<</Type/Page/MediaBox[0 0 9 9]/Parent " + std::to_string(1 + levels) + " 0 R>>");
    return pdf.table("/Size " + std::to_string(3 + levels) + "/Root 1 0 R").bytes;
}

/// The same file with a revision behind it, in which an object has another content.
std::string revised(MadePdf pdf, int number, const std::string &content, int generation = 0)
{
    return pdf.object(number, content, generation).table("/Size 4/Root 1 0 R").bytes;
}

} // namespace

/// Incremental updates of PDFs as others may have written them, judged by poppler and qpdf.
class TestPdfIncrement : public QObject
{
    Q_OBJECT

private:
    MadeKeys m_keys;

    std::string signedPdfOf(const std::string &pdf) const
    {
        const auto made = signedPdf(pdf, kWords, [this](const std::string &sha256) {
            return cmsOfHash(sha256, *SigningKey::open(m_keys.file("lab.all.pem"), {}));
        });
        return made ? *made : english(made.error().message);
    }

    /// For poppler and qpdf.
    void isSoundAndSigned(const std::string &made) const
    {
        m_keys.write("judged.pdf", made);
        const QByteArray judged = answerOf("pdfsig", {m_keys.path("judged.pdf")}).out;
        QVERIFY2(judged.contains("Signature is Valid"), judged);
        QVERIFY2(judged.contains("Total document signed"), judged);
        const ProgramAnswer qpdf = answerOf("qpdf", {"--check", m_keys.path("judged.pdf")});
        QVERIFY2(qpdf.ran && qpdf.err.isEmpty(), qpdf.err + qpdf.out);
    }

private slots:
    void initTestCase()
    {
        QVERIFY(m_keys.isMade);
        QVERIFY(m_keys.make("lab", "Lab"));
    }

    /// Each number of the update is held against the bytes that it speaks of.
    void numbers_nameTheirPlaces()
    {
        const std::string base = MadePdf::small().bytes;
        const auto update = withSignatureField(base, kWords);
        QVERIFY(update && update->bytes.starts_with(base));
        const QString text = QString::fromLatin1(update->bytes.data(), update->bytes.size());
        const auto table = text.mid(text.lastIndexOf("startxref") + 9).split('\n').at(1).toLong();
        QVERIFY(text.mid(table).startsWith("xref\n"));
        QRegularExpression entry("(\\d+) 1\n(\\d{10}) (\\d{5}) n \n");
        QStringList numbers;
        for (auto all = entry.globalMatch(text, table); all.hasNext();) {
            const QRegularExpressionMatch one = all.next();
            numbers << one.captured(1);
            QVERIFY(one.captured(2).toLong() >= long(base.size()));
            QVERIFY(text.mid(one.captured(2).toLong()).startsWith(one.captured(1) + " 0 obj\n"));
        }
        QCOMPARE(numbers, (QStringList{"1", "3", "4", "5"}));
        QVERIFY(text.mid(table).contains("/Size 6/Root 1 0 R"));
        QVERIFY(text.mid(table).contains(QString("/Prev %1>>").arg(base.find("xref\n0"))));
        const QStringList range = text.mid(text.lastIndexOf("/ByteRange[") + 11)
                                      .section(']', 0, 0)
                                      .split(' ', Qt::SkipEmptyParts);
        QCOMPARE(range,
            (QStringList{"0", QString::number(update->holeBegin), QString::number(update->holeEnd),
                QString::number(update->bytes.size() - update->holeEnd)}));
        QVERIFY(text.contains("/M(D:20260601120000Z)"));
    }

    /// Over the named place, on its page; what is no such place leaves it unseen on the first.
    void signature_isSeenWhereThePdfSays_data()
    {
        QTest::addColumn<QByteArray>("place");
        QTest::addColumn<bool>("isSeen");
        QTest::newRow("place") << QByteArray("(signature)[4 0 R/FitR 57.25 90 538 140.5]") << true;
        QTest::newRow("another name")
            << QByteArray("(other)[4 0 R/FitR 57.25 90 538 140]") << false;
        QTest::newRow("no rectangle") << QByteArray("(signature)[4 0 R/XYZ null 90 null]") << false;
        QTest::newRow("no page") << QByteArray("(signature)[2 0 R/FitR 57 90 538 140]") << false;
        QTest::newRow("words") << QByteArray("(signature)[4 0 R/FitR(a)(b)(c)(d)]") << false;
        QTest::newRow("nothing") << QByteArray("(signature)null") << false;
    }
    void signature_isSeenWhereThePdfSays()
    {
        QFETCH(QByteArray, place);
        QFETCH(bool, isSeen);
        const std::string page = "<</Type/Page/Parent 2 0 R/MediaBox[0 0 595 842]>>";
        const std::string pdf = MadePdf()
                                    .object(1,
                                        "<</Type/Catalog/Pages 2 0 R/Names<</Dests<</Names["
                                            + place.toStdString() + "]>>>>>>")
                                    .object(2, "<</Type/Pages/Kids[3 0 R 4 0 R]/Count 2>>")
                                    .object(3, page)
                                    .object(4, page)
                                    .table("/Size 5/Root 1 0 R")
                                    .bytes;
        const std::string made = signedPdfOf(pdf);
        QVERIFY2(made.starts_with(pdf), made.c_str());
        const std::string added = made.substr(pdf.size());
        QCOMPARE(
            added.find("/Rect[57.25 90 538 140.5]/AP<</N 7 0 R>>/P 4 0 R") != added.npos, isSeen);
        QCOMPARE(added.find("/Rect[0 0 0 0]/P 3 0 R") != added.npos, !isSeen);
        QCOMPARE(added.find("7 0 obj\n<</Type/XObject/Subtype/Form/BBox[57.25 90 538 140.5]")
                != added.npos,
            isSeen);
        isSoundAndSigned(made);
    }

    void otherPdfs_areSigned_data()
    {
        QTest::addColumn<QByteArray>("pdf");
        const auto row = [](const char *name, const std::string &pdf) {
            QTest::newRow(name) << QByteArray::fromStdString(pdf);
        };
        const MadePdf small = MadePdf::small();
        const std::string page = "<</Type/Page/Parent 2 0 R/MediaBox[0 0 9 9]/Rotate 90>>";
        row("several sections", small.bytes);
        row("two revisions", revised(small, 3, page));
        row("three revisions", [&] {
            MadePdf pdf = small;
            pdf.object(3, page).table("/Size 4/Root 1 0 R");
            return revised(pdf, 1, "<</Type/Catalog/Pages 2 0 R/Lang(sv)>>");
        }());
        row("generation", [] {
            return MadePdf()
                .object(1, "<</Type/Catalog/Pages 2 0 R>>", 7)
                .object(2, "<</Type/Pages/Kids[3 12 R]/Count 1>>")
                .object(3, "<</Type/Page/Parent 2 0 R/MediaBox[0 0 9 9]>>", 12)
                .table("/Size 4/Root 1 7 R")
                .bytes;
        }());
        row("free numbers", [] {
            return MadePdf()
                .object(1, "<</Type/Catalog/Pages 20 0 R>>")
                .object(20, "<</Type/Pages/Kids[300 0 R]/Count 1>>")
                .object(300, "<</Type/Page/Parent 20 0 R/MediaBox[0 0 9 9]>>")
                .table("/Size 1000/Root 1 0 R")
                .bytes;
        }());
        row("lists elsewhere", [] {
            return MadePdf()
                .object(1, "<</Type/Catalog/Pages 2 0 R/AcroForm 4 0 R>>")
                .object(2, "<</Type/Pages/Kids[3 0 R]/Count 1>>")
                .object(3, "<</Type/Page/Parent 2 0 R/MediaBox[0 0 9 9]/Annots 5 0 R>>")
                .object(4, "<</Fields 6 0 R/DA(/F \\(1\\) Tf)>>")
                .object(5, "[]")
                .object(6, "[]")
                .table("/Size 7/Root 1 0 R")
                .bytes;
        }());
        row("nested pages", nestedPages(40));
        row("remark behind", small.bytes + "% a remark\n");
        row("strings", MadePdf::small("/Lang(\\(\\)\\\\ \\377\\000)/X<00ff>/Y(\r\n)").bytes);
    }
    void otherPdfs_areSigned()
    {
        QFETCH(QByteArray, pdf);
        const std::string base = pdf.toStdString(), made = signedPdfOf(base);
        QVERIFY2(made.starts_with(base), made.c_str());
        QVERIFY(std::string(unsignedRevision(made)).size() <= made.size());
        isSoundAndSigned(made);
        const ProgramAnswer pages = answerOf("qpdf", {"--show-npages", m_keys.path("judged.pdf")});
        QCOMPARE(pages.out.trimmed(), QByteArray("1"));
        const std::string twice = signedPdfOf(made);
        QVERIFY2(twice.find("has a signature already") != std::string::npos, twice.c_str());
    }

    void unsoundPdfs_endInASentence_data()
    {
        QTest::addColumn<QByteArray>("pdf");
        const auto row = [](const char *name, const std::string &pdf) {
            QTest::newRow(name) << QByteArray::fromStdString(pdf);
        };
        const auto withSize = [](const std::string &size) {
            std::string pdf = MadePdf::small().bytes;
            return pdf.replace(pdf.find("/Size 4"), 7, size);
        };
        // A new object would have the number of one that is there.
        row("size too small", withSize("/Size 3"));
        row("size 0", withSize("/Size 0"));
        row("size below 0", withSize("/Size -7"));
        row("size too large", withSize("/Size 2147483647"));
        row("size beyond all", withSize("/Size 99999999999999999999"));
        row("size no number", withSize("/Size (4)"));
        row("no size", withSize(""));
        const std::string pages = "<</Type/Pages/Kids[3 0 R]/Count 1>>";
        row("catalog in the trailer",
            MadePdf()
                .object(2, pages)
                .object(3, "<</Type/Page/Parent 2 0 R/MediaBox[0 0 9 9]>>")
                .table("/Size 4/Root<</Type/Catalog/Pages 2 0 R>>")
                .bytes);
        row("page in the list",
            revised(MadePdf::small(), 2,
                "<</Type/Pages/Count 1/Kids[<</Type/Page/MediaBox[0 0 9 9]>>]>>"));
        row("pages in a circle",
            revised(MadePdf::small(), 2, "<</Type/Pages/Kids[2 0 R]/Count 1>>"));
        row("pages of each other",
            revised(MadePdf::small(), 3, "<</Type/Pages/Kids[2 0 R]/Count 1>>"));
        row("no pages", revised(MadePdf::small(), 2, "<</Type/Pages/Kids[]/Count 0>>"));
        row("pages no dictionary", revised(MadePdf::small(), 2, "[1 2 3]"));
        row("page no dictionary", revised(MadePdf::small(), 3, "(page)"));
        row("tables in a circle", [] {
            std::string pdf = MadePdf::small().bytes;
            const std::string place = std::to_string(pdf.rfind("xref\n0"));
            return pdf.replace(pdf.find("/Size 4"), 7, "/Size 4/Prev " + place);
        }());
        row("nested lists",
            MadePdf::small("/X" + repeated("[", 100000) + repeated("]", 100000)).bytes);
        row("open lists", MadePdf::small("/X" + repeated("[", 100000)).bytes);
        row("table beyond", MadePdf::small().bytes + "startxref\n999999999\n%%EOF\n");
        row("table below 0", MadePdf::small().bytes + "startxref\n-5\n%%EOF\n");
        row("no table", MadePdf::small().bytes + "startxref\n%%EOF\n");
        row("large and nothing", std::string(20000000, '%'));
    }
    void unsoundPdfs_endInASentence()
    {
        QFETCH(QByteArray, pdf);
        QElapsedTimer timer;
        timer.start();
        const auto update = withSignatureField(pdf.toStdString(), kWords);
        QVERIFY2(!update, update ? update->bytes.substr(pdf.size(), 2000).c_str() : "");
        QVERIFY(update.error().kind == ErrorKind::FileUnreadable);
        QVERIFY(english(update.error().message).starts_with("The PDF cannot be signed: it "));
        QVERIFY2(timer.elapsed() < 5000, qPrintable(QString::number(timer.elapsed())));
    }

    /// What is cut or flipped is refused, or signed as it is; never anything else.
    void damage_isRefusedOrSigned()
    {
        const std::string base = MadePdf::small("/AcroForm<</Fields[]>>", "/Annots[]").bytes;
        for (std::size_t size = 0; size < base.size(); ++size)
            if (const auto update = withSignatureField(base.substr(0, size), kWords); update)
                QVERIFY(update->bytes.starts_with(base.substr(0, size)));
        std::mt19937_64 random(20261128);
        for (int i = 0; i < trials::count(1000, 50000); ++i) {
            std::string bad = base;
            const std::size_t place = random() % bad.size();
            bad[place] = static_cast<char>(bad[place] ^ (1 << (random() % 8)));
            const auto update = withSignatureField(bad, kWords);
            if (!update)
                continue;
            QVERIFY(update->bytes.starts_with(bad));
            QVERIFY(update->holeBegin > bad.size() && update->holeEnd < update->bytes.size());
            QCOMPARE(update->bytes[update->holeBegin], '<');
            QCOMPARE(update->bytes[update->holeEnd - 1], '>');
        }
    }

    void names_cannotLeaveTheirString_data()
    {
        QTest::addColumn<QString>("name");
        for (const char16_t *name :
            {u"", u"Lab (1)", u")>>/X(", u"\\", u"a\nb\r", u"Kalibrerlaboratoriet Åsö",
                u"\x4e2d\x6587", u"\xd83d\xde00", u"/ByteRange[0 1 2 3]"})
            QTest::addRow("%s", qPrintable(QString::fromUtf16(name))) << QString::fromUtf16(name);
        QTest::newRow("long") << QString(100000, 'x');
    }
    void names_cannotLeaveTheirString()
    {
        QFETCH(QString, name);
        QByteArray wanted("<feff");
        for (const QChar unit : name)
            wanted += QByteArray::number(unit.unicode(), 16).rightJustified(4, '0');
        QCOMPARE(QByteArray::fromStdString(pdfTextString(name.toStdString())), wanted + ">");
        const auto update
            = withSignatureField(MadePdf::small().bytes, {name.toStdString(), MadeKeys::kNow});
        QVERIFY(update && update->bytes.find(wanted.toStdString()) != std::string::npos);
    }
};

DYNCAL_TEST(TestPdfIncrement)
#include "tst_pdf_increment.moc"
