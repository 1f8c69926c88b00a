// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/content_hash.h"
#include "core/signing/cms_signature.h"
#include "core/signing/pdf_signature.h"
#include "tests/support/made_keys.h"
#include "tests/support/revised_pdf.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QtTest>

#include <map>
#include <random>

using namespace dyncal;
using namespace dyncal::testing;
using Status = SignatureCheck::Status;

namespace {

std::string smallPdf(
    const std::string &catalog = "", const std::string &page = "", const std::string &trailer = "")
{
    return MadePdf::small(catalog, page, trailer).bytes;
}

} // namespace

/// Signatures in PDF, with poppler and qpdf as the other judges.
class TestPdfSignature : public QObject
{
    Q_OBJECT

private:
    MadeKeys m_keys;
    std::string m_certificate; ///< as an earlier version issued it
    const PdfSignatureWords m_words{"Kalibrerlaboratoriet Åsö (1)", MadeKeys::kNow};

    CmsOfHash byKey(const std::string &name) const
    {
        return [this, name](const std::string &sha256) {
            return cmsOfHash(sha256, *SigningKey::open(m_keys.file(name + ".all.pem"), {}));
        };
    }
    std::string signedBy(const std::string &name, const std::string &pdf) const
    {
        return signedPdf(pdf, m_words, byKey(name)).value_or("");
    }
    /// The PDF with an update behind it that replaces the page, and whose signature, object 6,
    /// covers all of it: as somebody with another key of the authority would hide a change.
    std::string signedAgain(std::string pdf, const std::map<int, std::string> &objects,
        const std::string &before = "") const
    {
        constexpr std::size_t kRoom = 8192;
        const std::string table = pdf.substr(pdf.rfind("startxref") + 10);
        std::map<int, std::size_t> places;
        const auto add = [&](int number, const std::string &content) {
            places[number] = pdf.size();
            pdf += std::to_string(number) + " 0 obj\n" + content + "\nendobj\n";
        };
        for (const auto &[number, content] : objects)
            add(number, content);
        const std::string blank(30, ' ');
        add(6,
            "<</Type/Sig/SubFilter/ETSI.CAdES.detached/ByteRange[0" + blank + "]" + before
                + "/Contents<" + std::string(kRoom, '0') + ">>>");
        const std::size_t begin = pdf.size(), hole = pdf.rfind('<' + std::string(kRoom, '0')),
                          end = hole + kRoom + 2;
        pdf += "xref\n";
        for (const auto &[number, place] : places)
            pdf += QString::asprintf("%d 1\n%010zu 00000 n \n", number, place).toStdString();
        pdf += "trailer\n<</Size 9/Root 1 0 R/Prev " + std::to_string(std::stoul(table))
            + ">>\nstartxref\n" + std::to_string(begin) + "\n%%EOF\n";
        pdf.replace(pdf.rfind(blank), blank.size(),
            QString::asprintf(" %-9zu %-9zu %-9zu", hole, end, pdf.size() - end).toStdString());
        const std::string cms
            = *byKey("other")(sha256Hex(std::string_view(pdf.substr(0, hole) + pdf.substr(end))));
        const QByteArray digits = QByteArray::fromStdString(cms).toHex();
        return pdf.replace(hole + 1, std::size_t(digits.size()), digits.toStdString());
    }
    SignatureCheck check(std::string_view pdf) const
    {
        return checkPdfSignature(pdf, {m_keys.content("root.pem"), MadeKeys::kNow});
    }
    QByteArray pdfsig(const std::string &pdf) const
    {
        m_keys.write("judged.pdf", pdf);
        return answerOf("pdfsig", {m_keys.path("judged.pdf")}).out;
    }

private slots:
    void initTestCase()
    {
        QVERIFY(m_keys.isMade);
        QVERIFY(m_keys.make("lab", "Kalibrerlaboratoriet Åsö (1)"));
        QVERIFY(m_keys.make("other", "Other"));
        QVERIFY(m_keys.make(
            "curve", "Curve", "signer", {"-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256"}));
        m_certificate = contentOf(qEnvironmentVariable("DYNCAL_SOURCE_DIR").toStdString()
            + "/tests/data/kept_projects/2026-11-27-version-2/certificates/1/certificate.pdf");
        QVERIFY(m_certificate.size() > 10000);
    }

    void signedPdf_isValidForOthers_data()
    {
        QTest::addColumn<QByteArray>("pdf");
        QTest::addColumn<QString>("key");
        const auto row = [](const char *name, const std::string &pdf, const char *key) {
            QTest::newRow(name) << QByteArray::fromStdString(pdf) << key;
        };
        row("issued", m_certificate, "lab");
        row("small", smallPdf(), "lab");
        row("curve", smallPdf(), "curve");
        row("annotations", smallPdf("/AcroForm<</Fields[]/DA(/F 1 Tf)>>/Lang(sv)", "/Annots[]"),
            "lab");
        row("id", smallPdf("", "", "/ID[<00><00>]"), "lab");
        row("no line break", smallPdf().substr(0, smallPdf().size() - 1), "lab");
    }
    void signedPdf_isValidForOthers()
    {
        QFETCH(QByteArray, pdf);
        QFETCH(QString, key);
        const std::string base = pdf.toStdString();
        const std::string made = signedBy(key.toStdString(), base);
        QVERIFY(made.starts_with(base)); // an update: no byte before it is touched
        const SignatureCheck found = check(made);
        QCOMPARE(found.status, Status::Valid);
        QVERIFY(found.remarks.empty());
        QCOMPARE(found.signer,
            m_keys.content(key.toStdString() + ".pem").empty() ? std::string()
                : key == "lab"                                 ? m_words.signer
                                                               : "Curve");
        QCOMPARE(found.signedUtc, m_words.utc);
        const QByteArray judged = pdfsig(made);
        QVERIFY2(judged.contains("Signature is Valid"), judged);
        QVERIFY2(judged.contains("Total document signed"), judged);
        QVERIFY2(judged.contains("ETSI.CAdES.detached"), judged);
        const ProgramAnswer qpdf = answerOf("qpdf", {"--check", m_keys.path("judged.pdf")});
        QVERIFY2(qpdf.ran && qpdf.err.isEmpty(), qpdf.err + qpdf.out);
    }

    void onlyTheHole_isUnsigned()
    {
        const Result<UnsignedIncrement> update = withSignatureField(smallPdf(), m_words);
        QVERIFY(update);
        QCOMPARE(update->bytes[update->holeBegin], '<');
        QCOMPARE(update->bytes[update->holeEnd - 1], '>');
        QCOMPARE(update->holeEnd - update->holeBegin, 2 * kCmsRoom + 2);
        std::string asked;
        const auto made = signedPdf(smallPdf(), m_words, [&](const std::string &sha256) {
            asked = sha256;
            return byKey("lab")(sha256);
        });
        QVERIFY(made);
        const std::string all = *made;
        QCOMPARE(asked,
            sha256Hex(
                std::string_view(all.substr(0, update->holeBegin) + all.substr(update->holeEnd))));
        // openssl over the signed bytes, as the range in the file states them.
        m_keys.write("content", all.substr(0, update->holeBegin) + all.substr(update->holeEnd));
        const QByteArray hole = QByteArray::fromHex(
            QByteArray::fromStdString(all.substr(update->holeBegin + 1, 2 * kCmsRoom)));
        m_keys.write("cms.der", hole.toStdString());
        QVERIFY(m_keys.openssl({"cms", "-verify", "-cades", "-binary", "-inform", "DER", "-in",
            m_keys.path("cms.der"), "-content", m_keys.path("content"), "-CAfile",
            m_keys.path("root.pem"), "-purpose", "any", "-out", "/dev/null"}));
    }

    void rsa_isReproducible()
    {
        const std::string made = signedBy("lab", m_certificate);
        QCOMPARE(made, signedBy("lab", m_certificate));
        QCOMPARE(std::string(unsignedRevision(made)), m_certificate);
        QCOMPARE(std::string(unsignedRevision(signedBy("curve", m_certificate))), m_certificate);
        QCOMPARE(std::string(unsignedRevision(m_certificate)), m_certificate);
    }

    void anyFlip_isNeverValid()
    {
        const std::string made = signedBy("lab", m_certificate);
        const auto update = withSignatureField(m_certificate, m_words);
        std::mt19937_64 random(20261127);
        int judgedByPoppler = 0;
        const auto flip = [&](std::size_t place) {
            std::string bad = made;
            bad[place] = static_cast<char>(bad[place] ^ (1 << (random() % 8)));
            if (judgedByPoppler++ < trials::count(20, 2000))
                QVERIFY2(!pdfsig(bad).contains("Signature is Valid"),
                    qPrintable(QString::number(place)));
            const Status status = check(bad).status;
            QVERIFY2(status == Status::Changed, qPrintable(QString::number(place)));
        };
        for (int i = 0; i < trials::count(300, 20000); ++i) {
            std::size_t place = random() % made.size();
            while (place > update->holeBegin && place < update->holeEnd - 1)
                place = random() % made.size();
            flip(place);
        }
        // All of the update before and behind the hole, and the hole's ends.
        for (std::size_t place = m_certificate.size(); place < update->holeBegin + 1; place += 3)
            flip(place);
        for (std::size_t place = update->holeEnd - 1; place < made.size(); ++place)
            flip(place);
    }

    void whatIsAddedOrCut_isFound()
    {
        const std::string made = signedBy("lab", m_certificate);
        const SignatureCheck added = check(made + "\n% more\n");
        QCOMPARE(added.status, Status::Changed);
        QVERIFY(english(*added.difference).find("added behind it") != std::string::npos);
        const SignatureCheck cut = check(std::string_view(made).substr(0, made.size() - 2));
        QCOMPARE(cut.status, Status::Changed);
        QVERIFY(english(*cut.difference).find("cut off") != std::string::npos);
        QCOMPARE(check(made + "/ByteRange[0 10 20 " + std::to_string(made.size()) + "]").status,
            Status::Changed);
        std::string padded = made; // bytes hidden behind the CMS in its hole
        const auto update = withSignatureField(m_certificate, m_words);
        padded[update->holeEnd - 3] = 'a';
        QCOMPARE(check(padded).status, Status::Changed);
        for (const char *range :
            {"/ByteRange", "/ByteRange[", "/ByteRange[0 1 2",
                "/ByteRange[0 99999999999999999999 1 1]", "/ByteRange[0 4 2 1]",
                "/ByteRange[0 1 18446744073709551615 18446744073709551615]", "/ByteRange[1 2 3 4]"})
            QVERIFY2(check(m_certificate + range).status == Status::Changed, range);
        QCOMPARE(check(m_certificate).status, Status::Unsigned);
        QCOMPARE(check("").status, Status::Unsigned);
    }

    void signatureBesideTheForm_isChanged_data()
    {
        QTest::addColumn<QByteArray>("pdf");
        QTest::addColumn<QString>("words"); ///< empty: as it should be, so that the others are
        const auto row = [](const char *name, const std::string &pdf, const char *words) {
            QTest::newRow(name) << QByteArray::fromStdString(pdf) << words;
        };
        const std::string page = "<</Type/Page/Parent 2 0 R/MediaBox[0 0 300 300]/Rotate 90>>";
        const std::string catalog = "<</Type/Catalog/Pages 2 0 R/AcroForm<</SigFlags 3/Fields[";
        const std::string field = "<</FT/Sig/T(A)/V 6 0 R>>";
        const std::map<int, std::string> shown{{1, catalog + "7 0 R]>>>>"}, {3, page}, {7, field}};
        row("as it should be", signedAgain(smallPdf(), shown), "");
        const std::string once = signedBy("lab", smallPdf());
        row("nobody's second", signedAgain(once, {{3, page}}), "more than one signature");
        row("second in the form", signedAgain(once, shown), "more than one signature");
        std::string hidden = once;
        hidden.replace(hidden.find("/ByteRange[0 "), 13, "/Byte#52ange[");
        row("first by another name", signedAgain(hidden, shown), "more than one signature");
        row("in no form", signedAgain(smallPdf(), {{3, page}}), "not that of the one");
        row("of no value",
            signedAgain(smallPdf(), {{1, shown.at(1)}, {7, "<</FT/Sig/T(A)/V 3 0 R>>"}}),
            "not that of the one");
        row("two fields",
            signedAgain(
                smallPdf(), {{1, catalog + "7 0 R 8 0 R]>>>>"}, {7, field}, {8, "<</FT/Sig>>"}}),
            "more than one signature");
        row("field in another form",
            signedAgain(smallPdf(), {{7, field}, {8, "<</Fields[7 0 R]>>"}}),
            "not that of the one");
        row("other contents", signedAgain(smallPdf(), shown, "/Contents<00>/Not"),
            "not that of the one");
        row("other range", signedAgain(smallPdf(), shown, "/Byte#52ange[0 1 2 3]"),
            "not that of the one");
    }
    void signatureBesideTheForm_isChanged()
    {
        QFETCH(QByteArray, pdf);
        QFETCH(QString, words);
        const SignatureCheck found = check(pdf.toStdString());
        const QString said
            = found.difference ? QString::fromStdString(english(*found.difference)) : QString();
        QVERIFY2(said.contains(words), qPrintable(said));
        QCOMPARE(found.status, words.isEmpty() ? Status::Valid : Status::Changed);
        QCOMPARE(found.signer, words.isEmpty() ? std::string("Other") : std::string());
    }

    void whatCannotBeSigned_isRefused_data()
    {
        QTest::addColumn<QByteArray>("pdf");
        QTest::addColumn<QString>("words");
        const auto row = [](const char *name, const std::string &pdf, const char *words) {
            QTest::newRow(name) << QByteArray::fromStdString(pdf) << words;
        };
        row("signed already", signedBy("lab", smallPdf()), "has a signature already");
        row("no PDF", "text", "classic kind");
        row("text like one", smallPdf("/Lang(/ByteRange)"), "a text in it has /ByteRange");
        row("no page", smallPdf("", "", "/Root 7 0 R"), "damaged");
        std::string streams = smallPdf();
        row("table elsewhere", streams.replace(streams.find("xref\n0"), 4, "xrof"), "classic kind");
        m_keys.write("plain.pdf", smallPdf());
        answerOf(
            "qpdf", {"--object-streams=generate", m_keys.path("plain.pdf"), m_keys.path("o.pdf")});
        row("cross-reference stream", m_keys.content("o.pdf"), "classic kind");
        answerOf("qpdf",
            {"--encrypt", "", "x", "256", "--", "--object-streams=disable",
                m_keys.path("plain.pdf"), m_keys.path("e.pdf")});
        row("encrypted", m_keys.content("e.pdf"), "encrypted");
    }
    void whatCannotBeSigned_isRefused()
    {
        QFETCH(QByteArray, pdf);
        QFETCH(QString, words);
        const auto made = signedPdf(pdf.toStdString(), m_words, byKey("lab"));
        QVERIFY(!made);
        const QString said = QString::fromStdString(english(made.error().message));
        QVERIFY2(said.contains(words), qPrintable(said));
    }

    void failures_arePassedOn()
    {
        const auto large = signedPdf(smallPdf(), m_words,
            [](const std::string &) { return std::string(kCmsRoom + 1, '\1'); });
        QVERIFY(!large);
        QVERIFY(english(large.error().message).find("room for 16384") != std::string::npos);
        const auto refused = signedPdf(smallPdf(), m_words, [](const std::string &) {
            return Result<std::string>(fail(ErrorKind::Cancelled, {"no", {}}));
        });
        QCOMPARE(refused.error().kind, ErrorKind::Cancelled);
    }
};

DYNCAL_TEST(TestPdfSignature)
#include "tst_pdf_signature.moc"
