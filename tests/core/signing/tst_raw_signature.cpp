// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/key_material.h"
#include "core/signing/raw_signature.h"
#include "core/signing/signing_key.h"
#include "tests/support/made_keys.h"
#include "tests/support/test_program.h"

#include <openssl/pem.h>

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

std::string ofHex(const QByteArray &digits)
{
    return QByteArray::fromHex(digits).toStdString();
}

/// A non-negative INTEGER (X.690, 8.3): no needless zeros in front, one where the first bit is set.
std::string derInteger(std::string bytes)
{
    bytes.erase(0, std::min(bytes.find_first_not_of('\0'), bytes.size() - 1));
    if ((static_cast<unsigned char>(bytes.front()) & 0x80) != 0)
        bytes.insert(0, 1, '\0');
    return std::string("\x02").append(1, static_cast<char>(bytes.size())).append(bytes);
}

/// Both halves as a SEQUENCE of two numbers, encoded here.
std::string derOfRaw(const std::string &raw)
{
    const std::string both
        = derInteger(raw.substr(0, raw.size() / 2)) + derInteger(raw.substr(raw.size() / 2));
    std::string der("\x30");
    if (both.size() >= 0x80)
        der += '\x81';
    return der.append(1, static_cast<char>(both.size())).append(both);
}

} // namespace

/// What keys sign, with `openssl dgst` as the other judge, and closed encodings.
class TestRawSignature : public QObject
{
    Q_OBJECT

private:
    MadeKeys m_keys;

    SigningKey key(const std::string &name) const
    {
        return *SigningKey::open(m_keys.file(name + ".all.pem"), {});
    }
    std::string signedBy(const std::string &name, const std::string &what) const
    {
        return openssl::signatureBy(key(name).material().key.get(), what);
    }
    bool opensslVerifies(
        const QString &name, const std::string &what, const std::string &signature) const
    {
        m_keys.write("what", what);
        m_keys.write("signature", signature);
        return m_keys.openssl({"x509", "-in", m_keys.path(name + ".pem"), "-pubkey", "-noout",
                   "-out", m_keys.path("public.pem")})
            && answerOf("openssl",
                {"dgst", "-sha256", "-verify", m_keys.path("public.pem"), "-signature",
                    m_keys.path("signature"), m_keys.path("what")})
                   .ran;
    }

private slots:
    void initTestCase()
    {
        QVERIFY(m_keys.isMade);
        QVERIFY(m_keys.make("lab", "Lab"));
        for (const char *curve : {"P-256", "P-384", "P-521"})
            QVERIFY(m_keys.make(curve, curve, "signer",
                {"-newkey", "ec", "-pkeyopt", QString("ec_paramgen_curve:") + curve}));
    }

    /// PKCS#1 v1.5 has no random part: two implementations must agree in every byte.
    void rsa_isThatOfOpenssl()
    {
        for (const std::size_t size : {0, 1, 55, 56, 63, 64, 65, 1000000}) {
            const std::string what(size, 'x');
            m_keys.write("what", what);
            QVERIFY(m_keys.openssl({"dgst", "-sha256", "-sign", m_keys.path("lab.key"), "-out",
                m_keys.path("signature"), m_keys.path("what")}));
            QCOMPARE(signedBy("lab", what), m_keys.content("signature"));
        }
    }

    void curves_areVerifiedByOpenssl_data()
    {
        QTest::addColumn<QString>("curve");
        QTest::addColumn<int>("bytes");
        QTest::newRow("P-256") << "P-256" << 64;
        QTest::newRow("P-384") << "P-384" << 96;
        QTest::newRow("P-521") << "P-521" << 132;
    }
    void curves_areVerifiedByOpenssl()
    {
        QFETCH(QString, curve);
        QFETCH(int, bytes);
        const SigningKey signer = key(curve.toStdString());
        EVP_PKEY *handle = signer.material().key.get();
        const std::string what("what is signed\0 with a zero", 27);
        for (int i = 0; i < 20; ++i) { // short numbers come up now and then
            const std::string der = openssl::signatureBy(handle, what);
            const std::string raw = openssl::rawCurveSignature(der, handle);
            QCOMPARE(raw.size(), static_cast<std::size_t>(bytes));
            QCOMPARE(derOfRaw(raw), der);
            if (i == 0)
                QVERIFY(opensslVerifies(curve, what, derOfRaw(raw)));
        }
        QVERIFY(!opensslVerifies(curve, what + "x", openssl::signatureBy(handle, what)));
    }

    void rawNumbers_areOfFixedLength_data()
    {
        QTest::addColumn<QByteArray>("der");
        QTest::addColumn<QByteArray>("raw");
        const QByteArray zeros(62, '0'), fs(64, 'f');
        QTest::newRow("ones") << QByteArray("3006020101020101") << zeros + "01" + zeros + "01";
        QTest::newRow("first bit")
            << QByteArray("3008020200800202 00ff") << zeros + "80" + zeros + "ff";
        QTest::newRow("two bytes")
            << QByteArray("3007020201000201 7f") << zeros.chopped(2) + "0100" + zeros + "7f";
        QTest::newRow("zero") << QByteArray("3006020100020101") << zeros + "00" + zeros + "01";
        QTest::newRow("full") << "3026022100" + fs + "020101" << fs + zeros + "01";
        QTest::newRow("too long") << "3027022201" + QByteArray(66, '0') + "020101" << QByteArray();
        QTest::newRow("negative") << QByteArray("30060201ff020101") << QByteArray();
        QTest::newRow("one number") << QByteArray("3003020101") << QByteArray();
        QTest::newRow("no sequence") << QByteArray("0201010201") << QByteArray();
        QTest::newRow("cut off") << QByteArray("30060201010201") << QByteArray();
        QTest::newRow("longer than there is") << QByteArray("30847fffffff020101") << QByteArray();
        QTest::newRow("nothing") << QByteArray() << QByteArray();
    }
    void rawNumbers_areOfFixedLength()
    {
        QFETCH(QByteArray, der);
        QFETCH(QByteArray, raw);
        const SigningKey signer = key("P-256");
        QCOMPARE(openssl::rawCurveSignature(ofHex(der), signer.material().key.get()), ofHex(raw));
    }

    void otherKeys_refuse()
    {
        QVERIFY(m_keys.openssl(
            {"genpkey", "-algorithm", "X25519", "-out", m_keys.path("agreement.key")}));
        const std::string pem = m_keys.content("agreement.key");
        const openssl::Bio in = openssl::bioOn(pem);
        const openssl::PrivateKey agreement(
            PEM_read_bio_PrivateKey(in.get(), nullptr, nullptr, nullptr));
        QVERIFY(agreement);
        QCOMPARE(openssl::signatureBy(agreement.get(), "what"), std::string());
    }
};

DYNCAL_TEST(TestRawSignature)
#include "tst_raw_signature.moc"
