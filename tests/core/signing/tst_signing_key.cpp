// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/signing_key.h"
#include "tests/support/known_secret.h"
#include "tests/support/made_keys.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

/// Keys from files: which open, and why others do not.
class TestSigningKey : public QObject
{
    Q_OBJECT

private:
    MadeKeys m_keys;

    /// The sentence; "" where the key opened.
    std::string refusal(const std::string &name, std::string_view secret = {}) const
    {
        const auto key = SigningKey::open(m_keys.file(name), secretOf(secret));
        return key ? std::string() : english(key.error().message);
    }

private slots:
    void initTestCase()
    {
        QVERIFY(m_keys.isMade);
        QVERIFY(m_keys.make("lab", "Kalibrerlaboratoriet Åsö"));
        QVERIFY(m_keys.make(
            "curve", "Curve", "signer", {"-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256"}));
        QVERIFY(m_keys.make("cipher", "Cipher", "cipher"));
        QVERIFY(m_keys.make("weak", "Weak", "signer", {"-newkey", "rsa:1024"}));
        QVERIFY(m_keys.makePkcs12("lab", "hemligt ord"));
        QVERIFY(m_keys.makePkcs12("curve", ""));
        QVERIFY(m_keys.openssl({"pkey", "-in", m_keys.path("lab.key"), "-aes256", "-passout",
            "pass:hemligt ord", "-out", m_keys.path("locked.key")}));
        m_keys.write("locked.pem", m_keys.content("locked.key") + m_keys.content("lab.pem"));
        m_keys.write("certificates first.pem",
            m_keys.content("root.pem") + m_keys.content("lab.pem") + m_keys.content("lab.key"));
        m_keys.write("mixed.pem", m_keys.content("curve.key") + m_keys.content("lab.pem"));
        const auto curve = [](const char *name) {
            return QStringList{"-newkey", "ec", "-pkeyopt", QString("ec_paramgen_curve:") + name};
        };
        for (const char *name :
            {"secp384r1", "secp521r1", "secp256k1", "brainpoolP256r1", "secp224r1", "secp112r1"})
            QVERIFY2(m_keys.make(name, name, "signer", curve(name)), name);
        QVERIFY(m_keys.make("ed25519", "Ed", "signer", {"-newkey", "ed25519"}));
        QVERIFY(m_keys.make(
            "pss", "Pss", "signer", {"-newkey", "rsa-pss", "-pkeyopt", "rsa_keygen_bits:2048"}));
        QVERIFY(m_keys.openssl({"pkcs12", "-export", "-legacy", "-inkey", m_keys.path("lab.key"),
            "-in", m_keys.path("lab.pem"), "-passout", "pass:hemligt ord", "-out",
            m_keys.path("legacy.p12")}));
        m_keys.write("two keys.pem",
            m_keys.content("curve.key") + m_keys.content("lab.key") + m_keys.content("root.pem")
                + m_keys.content("lab.pem"));
        m_keys.write("empty.pem", "");
        m_keys.write("text.p12", "no key at all");
        m_keys.write("large.pem", std::string(1U << 20U, 'x'));
    }

    void whatOpens_hasItsSigner_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("secret");
        QTest::addColumn<QString>("signer");
        const QString lab = "Kalibrerlaboratoriet Åsö";
        QTest::newRow("pem") << "lab.all.pem"
                             << "" << lab;
        QTest::newRow("pem, order") << "certificates first.pem"
                                    << "" << lab;
        QTest::newRow("pem, two keys") << "two keys.pem"
                                       << "" << lab;
        for (const char *name : {"secp384r1", "secp521r1"})
            QTest::newRow(name) << QString(name) + ".all.pem"
                                << "" << name;
        QTest::newRow("pem, passphrase") << "locked.pem"
                                         << "hemligt ord" << lab;
        QTest::newRow("pkcs12") << "lab.p12"
                                << "hemligt ord" << lab;
        QTest::newRow("pkcs12, line") << "lab.p12"
                                      << "hemligt ord\nmore" << lab;
        QTest::newRow("pkcs12, none") << "curve.p12"
                                      << ""
                                      << "Curve";
        QTest::newRow("curve") << "curve.all.pem"
                               << ""
                               << "Curve";
    }
    void whatOpens_hasItsSigner()
    {
        QFETCH(QString, name);
        QFETCH(QString, secret);
        QFETCH(QString, signer);
        const auto key
            = SigningKey::open(m_keys.file(name.toStdString()), secretOf(secret.toStdString()));
        QVERIFY2(key, key ? "" : english(key.error().message).c_str());
        QCOMPARE(QString::fromStdString(key->signer()), signer);
        QVERIFY(key->checkValidAt(MadeKeys::kNow));
    }

    void otherwise_oneSentence_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("secret");
        QTest::addColumn<QString>("words");
        QTest::newRow("no passphrase") << "lab.p12"
                                       << ""
                                       << "none was given; give it by --pin-fd N";
        QTest::newRow("wrong") << "lab.p12"
                               << "annat"
                               << "The passphrase does not open the key";
        QTest::newRow("pem, none") << "locked.pem"
                                   << ""
                                   << "none was given";
        QTest::newRow("pem, wrong") << "locked.pem"
                                    << "annat"
                                    << "does not open the key";
        QTest::newRow("mixed") << "mixed.pem"
                               << ""
                               << "does not belong to the private key";
        QTest::newRow("usage") << "cipher.all.pem"
                               << ""
                               << "neither digitalSignature nor";
        QTest::newRow("weak") << "weak.all.pem"
                              << ""
                              << "RSA key of 2048 bits or more";
        for (const char *name :
            {"secp256k1", "brainpoolP256r1", "secp224r1", "secp112r1", "ed25519"})
            QTest::newRow(name) << QString(name) + ".all.pem"
                                << "" << QString("(%1) is none to sign").arg(name);
        QTest::newRow("pss") << "pss.all.pem"
                             << ""
                             << "(RSA-PSS) is none to sign";
        QTest::newRow("old") << "legacy.p12"
                             << "hemligt ord"
                             << "encrypted in an old way";
        QTest::newRow("old, wrong") << "legacy.p12"
                                    << "annat"
                                    << "does not open the key";
        QTest::newRow("key only") << "lab.key"
                                  << ""
                                  << "together with its certificate";
        QTest::newRow("certificate only") << "lab.pem"
                                          << ""
                                          << "together with its certificate";
        QTest::newRow("text") << "text.p12"
                              << ""
                              << "together with its certificate";
        QTest::newRow("empty") << "empty.pem"
                               << ""
                               << "cannot be read, is empty or has more than";
        QTest::newRow("large") << "large.pem"
                               << ""
                               << "cannot be read, is empty or has more than";
        QTest::newRow("missing") << "nothing.pem"
                                 << ""
                                 << "cannot be read";
    }
    void otherwise_oneSentence()
    {
        QFETCH(QString, name);
        QFETCH(QString, secret);
        QFETCH(QString, words);
        const QString said
            = QString::fromStdString(refusal(name.toStdString(), secret.toStdString()));
        QVERIFY2(said.contains(words, Qt::CaseInsensitive), qPrintable(said));
        QVERIFY(secret.isEmpty() || !said.contains(secret));
    }

    void validity_isHeldAgainstTheMoment()
    {
        const auto key = SigningKey::open(m_keys.file("lab.all.pem"), {});
        QVERIFY(key);
        QVERIFY(key->checkValidAt("2025-01-01T00:00:00Z"));
        QVERIFY(key->checkValidAt("2035-12-31T23:59:59Z"));
        QVERIFY(!key->checkValidAt("2024-12-31T23:59:59Z"));
        const auto late = key->checkValidAt("2036-01-01T00:00:00Z");
        QVERIFY(!late);
        const std::string said = english(late.error().message);
        QVERIFY2(said.find("valid from 2025-01-01T00:00:00Z to 2035-12-31T23:59:59Z")
                != std::string::npos,
            said.c_str());
    }

    void secrets_areOneLine()
    {
        QCOMPARE(std::string(secretOf("1234").text()), std::string("1234"));
        QCOMPARE(secretOf("1234\n5678\n").size(), std::size_t(4));
        QCOMPARE(secretOf("å ä").size(), std::size_t(5));
        QCOMPARE(secretOf(std::string(SecretBytes::kMost, 'x')).size(), SecretBytes::kMost);
        QVERIFY(!secretOf(std::string(SecretBytes::kMost + 1, 'x')).isGiven());
        QVERIFY(!secretOf("\n1234").isGiven());
        QVERIFY(!secretOf(std::string_view("12\0 34", 6)).isGiven());
        const auto closed = SecretBytes::readFrom(999);
        QVERIFY(!closed);
        QVERIFY(english(closed.error().message).find("file descriptor 999") != std::string::npos);
        SecretBytes one = secretOf("first");
        one = secretOf("second");
        const SecretBytes moved = std::move(one);
        QCOMPARE(std::string(moved.text()), std::string("second"));
    }
};

DYNCAL_TEST(TestSigningKey)
#include "tst_signing_key.moc"
