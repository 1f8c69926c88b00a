// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/certificate_facts.h"
#include "tests/support/test_program.h"

#include <openssl/ec.h>
#include <openssl/x509v3.h>

#include <QtTest>

using namespace dyncal;

namespace {

using Time = std::unique_ptr<ASN1_STRING, openssl::Freed<&ASN1_STRING_free>>;

Time timeOf(int type, std::string_view digits)
{
    Time time(ASN1_STRING_type_new(type));
    ASN1_STRING_set(time.get(), digits.data(), static_cast<int>(digits.size()));
    return time;
}

/// A certificate put together here; nothing of it is signed.
openssl::Certificate blank()
{
    openssl::Certificate made(X509_new());
    X509_set1_notBefore(made.get(), timeOf(V_ASN1_UTCTIME, "250131042311Z").get());
    X509_set1_notAfter(made.get(), timeOf(V_ASN1_GENERALIZEDTIME, "20510228235959Z").get());
    return made;
}

void addName(X509 *certificate, const char *kind, int encoding, std::string_view text)
{
    X509_NAME_add_entry_by_txt(X509_get_subject_name(certificate), kind, encoding,
        openssl::bytesOf(text), static_cast<int>(text.size()), -1, 0);
}

} // namespace

/// Names, moments and usages of certificates, in every encoding that X.509 has for them.
class TestCertificateFacts : public QObject
{
    Q_OBJECT

private slots:
    void names_areUtf8_data()
    {
        QTest::addColumn<int>("encoding");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("name");
        QTest::newRow("utf8") << V_ASN1_UTF8STRING
                              << QByteArray("L\xc3\xa5"
                                            "b")
                              << u"Låb"_qs;
        QTest::newRow("printable") << V_ASN1_PRINTABLESTRING << QByteArray("Lab 1") << "Lab 1";
        QTest::newRow("bmp") << V_ASN1_BMPSTRING << QByteArray("\0L\0\xe5\0b", 6) << u"Låb"_qs;
        QTest::newRow("universal")
            << V_ASN1_UNIVERSALSTRING << QByteArray("\0\0\0L\0\0\0\xe5", 8) << u"Lå"_qs;
        QTest::newRow("latin") << V_ASN1_T61STRING
                               << QByteArray("L\xe5"
                                             "b")
                               << u"Låb"_qs;
    }
    void names_areUtf8()
    {
        QFETCH(int, encoding);
        QFETCH(QByteArray, bytes);
        QFETCH(QString, name);
        const openssl::Certificate made = blank();
        addName(made.get(), "CN", encoding, bytes.toStdString());
        QCOMPARE(QString::fromStdString(subjectName(made.get())), name);
    }

    void name_isTheMostTelling()
    {
        const openssl::Certificate made = blank();
        QCOMPARE(subjectName(made.get()), std::string());
        addName(made.get(), "C", V_ASN1_PRINTABLESTRING, "SE");
        addName(made.get(), "OU", V_ASN1_UTF8STRING, "Tryck å vakuum");
        QCOMPARE(subjectName(made.get()), std::string("C = SE, OU = Tryck å vakuum"));
        addName(made.get(), "O", V_ASN1_UTF8STRING, "Institutet");
        QCOMPARE(subjectName(made.get()), std::string("Institutet"));
        addName(made.get(), "CN", V_ASN1_UTF8STRING, "Laboratoriet");
        QCOMPARE(subjectName(made.get()), std::string("Laboratoriet"));
        addName(made.get(), "CN", V_ASN1_UTF8STRING, "Another");
        QCOMPARE(subjectName(made.get()), std::string("Laboratoriet")); // the first
    }

    void moments_areIso8601_data()
    {
        QTest::addColumn<int>("type");
        QTest::addColumn<QByteArray>("digits");
        QTest::addColumn<QString>("utc");
        const int two = V_ASN1_UTCTIME, four = V_ASN1_GENERALIZEDTIME;
        // RFC 5280, 4.1.2.5.1: 50 to 99 are of the century before.
        QTest::newRow("2049") << two << QByteArray("491231235959Z") << "2049-12-31T23:59:59Z";
        QTest::newRow("1950") << two << QByteArray("500101000000Z") << "1950-01-01T00:00:00Z";
        QTest::newRow("2050") << four << QByteArray("20500101000000Z") << "2050-01-01T00:00:00Z";
        QTest::newRow("never") << four << QByteArray("99991231235959Z") << "9999-12-31T23:59:59Z";
        QTest::newRow("leap") << two << QByteArray("240229120000Z") << "2024-02-29T12:00:00Z";
        QTest::newRow("fraction") << four << QByteArray("20260131042311.5Z")
                                  << "2026-01-31T04:23:11Z";
        QTest::newRow("offset") << two << QByteArray("260101003000+0100") << "2025-12-31T23:30:00Z";
        QTest::newRow("no leap") << two << QByteArray("230229120000Z") << "";
        QTest::newRow("month 13") << two << QByteArray("261301000000Z") << "";
        QTest::newRow("letters") << two << QByteArray("26010100000xZ") << "";
        QTest::newRow("nothing") << two << QByteArray() << "";
        QTest::newRow("other type") << V_ASN1_OCTET_STRING << QByteArray("260101000000Z") << "";
    }
    void moments_areIso8601()
    {
        QFETCH(int, type);
        QFETCH(QByteArray, digits);
        QFETCH(QString, utc);
        QCOMPARE(QString::fromStdString(utcText(timeOf(type, digits.toStdString()).get())), utc);
        QCOMPARE(utcText(nullptr), std::string());
    }

    void validity_hasItsEnds()
    {
        const openssl::Certificate made = blank();
        QCOMPARE(validFrom(made.get()), std::string("2025-01-31T04:23:11Z"));
        QCOMPARE(validUntil(made.get()), std::string("2051-02-28T23:59:59Z"));
        for (const char *in : {"2025-01-31T04:23:11Z", "2025-01-31T04:23:12Z",
                 "2050-01-01T00:00:00Z", "2051-02-28T23:59:59Z"})
            QVERIFY2(isValidAt(made.get(), in), in);
        for (const char *out : {"2025-01-31T04:23:10Z", "2051-03-01T00:00:00Z",
                 "1999-06-01T00:00:00Z", "9999-01-01T00:00:00Z", ""})
            QVERIFY2(!isValidAt(made.get(), out), out);
        // A certificate whose times cannot be read is valid never, not always.
        X509_set1_notBefore(made.get(), timeOf(V_ASN1_UTCTIME, "broken").get());
        QVERIFY(!isValidAt(made.get(), "2026-01-01T00:00:00Z"));
        const openssl::Certificate endless = blank();
        X509_set1_notAfter(endless.get(), timeOf(V_ASN1_UTCTIME, "broken").get());
        QVERIFY(!isValidAt(endless.get(), "2026-01-01T00:00:00Z"));
    }

    void usage_decidesWhatMaySign_data()
    {
        QTest::addColumn<QString>("usage");
        QTest::addColumn<bool>("maySign");
        QTest::newRow("none stated") << "" << true;
        for (const char *good : {"digitalSignature", "nonRepudiation",
                 "critical,digitalSignature,keyEncipherment", "keyCertSign,nonRepudiation"})
            QTest::newRow(good) << good << true;
        for (const char *bad : {"keyEncipherment", "critical,keyCertSign,cRLSign",
                 "dataEncipherment,keyAgreement", "keyAgreement,decipherOnly"})
            QTest::newRow(bad) << bad << false;
    }
    void usage_decidesWhatMaySign()
    {
        QFETCH(QString, usage);
        QFETCH(bool, maySign);
        const openssl::Certificate made = blank();
        if (!usage.isEmpty()) {
            X509_EXTENSION *extension = X509V3_EXT_conf_nid(
                nullptr, nullptr, NID_key_usage, usage.toLatin1().constData());
            QVERIFY(extension != nullptr);
            X509_add_ext(made.get(), extension, -1);
            X509_EXTENSION_free(extension);
        }
        // Only of a whole certificate OpenSSL reads the usage.
        const openssl::PrivateKey key(EVP_EC_gen("P-256"));
        X509_set_version(made.get(), X509_VERSION_3);
        ASN1_INTEGER_set(X509_get_serialNumber(made.get()), 1);
        X509_set_pubkey(made.get(), key.get());
        QVERIFY(X509_sign(made.get(), key.get(), EVP_sha256()) > 0);
        QCOMPARE(dyncal::maySign(made.get()), maySign);
    }
};

DYNCAL_TEST(TestCertificateFacts)
#include "tst_certificate_facts.moc"
