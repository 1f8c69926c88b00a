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

    void whatCannotBeSigned_isRefused_data()
    {
        QTest::addColumn<QByteArray>("pdf");
        QTest::addColumn<QString>("words");
        const auto row = [](const char *name, const std::string &pdf, const char *words) {
            QTest::newRow(name) << QByteArray::fromStdString(pdf) << words;
        };
        row("signed already", signedBy("lab", smallPdf()), "has a signature already");
        row("no PDF", "text", "classic kind");
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
