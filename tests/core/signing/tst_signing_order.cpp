// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/pdf_signature.h"
#include "core/signing/signing_order.h"
#include "core/signing/xml_signing.h"
#include "core/signing/xml_verifying.h"
#include "tests/support/answering_server.h"
#include "tests/support/made_stamps.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;
using Status = SignatureCheck::Status;

/// A certificate's files signed as they are issued.
class TestSigningOrder : public QObject
{
    Q_OBJECT

private:
    MadeKeys m_keys;
    std::string m_pdf;

    SigningOrder byKey() const
    {
        return {.key = *SigningKey::open(m_keys.file("lab.all.pem"), {})};
    }
    SignatureCheck check(const std::string &pdf) const
    {
        return checkPdfSignature(pdf, {m_keys.content("root.pem"), MadeKeys::kNow});
    }
    Result<std::string> signedPdfBy(
        const SigningOrder &order, const std::string &utc = MadeKeys::kNow) const
    {
        return signedCertificate(m_pdf, order, utc, {});
    }

private slots:
    void initTestCase()
    {
        QVERIFY(m_keys.isMade);
        QVERIFY(m_keys.make("lab", "Lab"));
        QVERIFY(m_keys.make("stamps", "Stamps", "stamps"));
        m_pdf = contentOf(qEnvironmentVariable("DYNCAL_SOURCE_DIR").toStdString()
            + "/tests/data/kept_projects/2026-11-27-version-2/certificates/1/certificate.pdf");
    }

    void nobody_leavesThemAsTheyAre()
    {
        QVERIFY(!SigningOrder{}.isSigned());
        QCOMPARE(*signedPdfBy({}), m_pdf);
        QCOMPARE(*signedDcc("<a>x</a>", {}), std::string("<a>x</a>"));
    }

    void key_signsBoth()
    {
        QVERIFY(byKey().isSigned());
        const SignatureCheck found = check(*signedPdfBy(byKey()));
        QCOMPARE(found.status, Status::Valid);
        QCOMPARE(found.signedUtc, std::string(MadeKeys::kNow));
        QVERIFY(found.stampedUtc.empty());
        const auto dcc = signedDcc("<a>x</a>", byKey());
        QCOMPARE(checkXmlSignature(*dcc, {m_keys.content("root.pem"), MadeKeys::kNow}).status,
            Status::Valid);
        const auto late = signedPdfBy(byKey(), "2040-01-01T00:00:00Z");
        QVERIFY(!late);
        QCOMPARE(late.error().kind, ErrorKind::Usage);
    }

    void authority_stampsIt()
    {
        const MadeStamps stamps(m_keys);
        std::string asked;
        const AnsweringServer server([&](const std::string &head, const std::string &body) {
            asked = head;
            return httpAnswer(stamps.reply(body));
        });
        SigningOrder order = byKey();
        order.authority = server.url();
        const auto pdf = signedPdfBy(order);
        QVERIFY2(pdf, pdf ? "" : english(pdf.error().message).c_str());
        QVERIFY(asked.find("Content-Type: application/timestamp-query") != std::string::npos);
        const SignatureCheck found = check(*pdf);
        QCOMPARE(found.status, Status::Valid);
        QVERIFY(!found.stampedUtc.empty());
        QCOMPARE(std::string(unsignedRevision(*pdf)), m_pdf);
        m_keys.write("stamped.pdf", *pdf);
        const QByteArray judged = answerOf("pdfsig", {m_keys.path("stamped.pdf")}).out;
        QVERIFY2(judged.contains("Signature is Valid"), judged);
        order.authority = "http://127.0.0.1:1/";
        QCOMPARE(signedPdfBy(order).error().kind, ErrorKind::FileUnreadable);
    }

    void service_sealsThePdfOnly()
    {
        const std::string script = qEnvironmentVariable("DYNCAL_SOURCE_DIR").toStdString()
            + "/tests/support/seal_service.py";
        const SigningOrder order{.sealCommand = "python3 '" + script + "' '"
                + m_keys.file("lab.key") + "' '" + m_keys.file("lab.pem") + "'"};
        QVERIFY(order.isSigned());
        const auto pdf = signedPdfBy(order);
        QVERIFY2(pdf, pdf ? "" : english(pdf.error().message).c_str());
        const SignatureCheck found = check(*pdf);
        QCOMPARE(found.status, Status::Valid);
        QCOMPARE(found.signer, std::string("Lab"));
        m_keys.write("sealed.pdf", *pdf);
        const QByteArray judged = answerOf("pdfsig", {m_keys.path("sealed.pdf")}).out;
        QVERIFY2(judged.contains("Signature is Valid"), judged);
        QVERIFY2(judged.contains("Total document signed"), judged);
        QCOMPARE(*signedDcc("<a>x</a>", order), std::string("<a>x</a>"));
    }

    /// As a key that is none to sign with is refused.
    void serviceOfAnUnfitCertificate_isRefused_data()
    {
        QTest::addColumn<QStringList>("key");
        QTest::addColumn<QString>("section");
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("until");
        QTest::addColumn<QString>("words");
        const QStringList rsa{"-newkey", "rsa:2048"};
        const QString from = MadeKeys::kFrom, until = MadeKeys::kUntil;
        QTest::newRow("expired") << rsa << "signer" << from << "20260101000000Z"
                                 << "is valid from 2025-01-01";
        QTest::newRow("not yet") << rsa << "signer"
                                 << "20270101000000Z" << until << "is valid from 2027-01-01";
        QTest::newRow("cipher") << rsa << "cipher" << from << until << "is not for signatures";
        QTest::newRow("short") << QStringList{"-newkey", "rsa:1024"} << "signer" << from << until
                               << "The key in python3 (RSA, 1024 bits) is none";
    }
    void serviceOfAnUnfitCertificate_isRefused()
    {
        QFETCH(QStringList, key);
        QFETCH(QString, section);
        QFETCH(QString, from);
        QFETCH(QString, until);
        QFETCH(QString, words);
        QVERIFY(m_keys.make("unfit", "Unfit", section, key, from, until));
        const std::string script = qEnvironmentVariable("DYNCAL_SOURCE_DIR").toStdString()
            + "/tests/support/seal_service.py";
        const auto pdf = signedPdfBy({.sealCommand = "python3 '" + script + "' '"
                + m_keys.file("unfit.key") + "' '" + m_keys.file("unfit.pem") + "'"});
        QVERIFY(!pdf);
        QCOMPARE(pdf.error().kind, ErrorKind::Usage);
        const QString said = QString::fromStdString(english(pdf.error().message));
        QVERIFY2(said.contains(words), qPrintable(said));
    }
};

DYNCAL_TEST(TestSigningOrder)
#include "tst_signing_order.moc"
