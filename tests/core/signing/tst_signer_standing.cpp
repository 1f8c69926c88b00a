// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/content_hash.h"
#include "core/signing/cms_signature.h"
#include "core/signing/xml_signing.h"
#include "core/signing/xml_verifying.h"
#include "tests/support/made_keys.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;
using Status = SignatureCheck::Status;

/// Who stands behind a signer: certificates between it and the trusted one, of others, of no use.
class TestSignerStanding : public QObject
{
    Q_OBJECT

private:
    MadeKeys m_keys;

    SigningKey key(const std::string &file) const
    {
        return *SigningKey::open(m_keys.file(file), {});
    }
    /// A CMS over "content" by a service of the test's own, which signs with any key; "" if it
    /// failed.
    std::string sealedBy(const QString &name) const
    {
        m_keys.write("hash", sha256Hex(std::string_view("content")) + "\n");
        m_keys.write("service.sh", "python3 \"$1\" \"$2\" \"$3\" < \"$4\" > \"$5\"\n");
        const QString service
            = qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/tests/support/seal_service.py";
        const bool ran = answerOf("sh",
            {m_keys.path("service.sh"), service, m_keys.path(name + ".key"),
                m_keys.path(name + ".pem"), m_keys.path("hash"), m_keys.path("made.cms")})
                             .ran;
        return ran ? m_keys.content("made.cms") : std::string();
    }
    static SignatureCheck cmsCheck(
        const SigningKey &key, const std::string &anchors, const std::string &now = MadeKeys::kNow)
    {
        return checkCms(cmsOfHash(sha256Hex(std::string_view("content")), key).value_or(""),
            {"content"}, now, {anchors, now});
    }
    static SignatureCheck xmlCheck(
        const SigningKey &key, const std::string &anchors, const std::string &now = MadeKeys::kNow)
    {
        return checkXmlSignature(signedXml("<a>x</a>", key).value_or(""), {anchors, now});
    }

private slots:
    void initTestCase()
    {
        QVERIFY(m_keys.isMade);
        QVERIFY(m_keys.make("middle", "Middle", "root"));
        QVERIFY(m_keys.makeUnder("middle", "lab", "Lab"));
        QVERIFY(m_keys.make("ending", "Ending", "root", {"-newkey", "rsa:2048"}, "20250101000000Z",
            "20260101000000Z"));
        QVERIFY(m_keys.makeUnder("ending", "late", "Late"));
        QVERIFY(m_keys.make("plain", "Plain"));
        QVERIFY(m_keys.makeUnder("plain", "child", "Child of none that may certify"));
        QVERIFY(m_keys.make("short", "Short", "signer", {"-newkey", "rsa:1024"}));
        QVERIFY(m_keys.make("koblitz", "Koblitz", "signer",
            {"-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:secp256k1"}));
        m_keys.write("ca.cnf",
            m_keys.content("ca.cnf")
                + "[server]\nkeyUsage=critical,digitalSignature\nextendedKeyUsage=serverAuth\n"
                  "[mail]\nextendedKeyUsage=serverAuth,emailProtection\n");
        QVERIFY(m_keys.make("server", "Server", "server") && m_keys.make("mail", "Mail", "mail"));
        QVERIFY(m_keys.make("stamps", "Stamps", "stamps"));
        for (const char *hash : {"md5", "sha1"}) {
            QVERIFY(m_keys.make(hash, hash));
            QVERIFY(m_keys.openssl({"ca", "-batch", "-notext", "-config", m_keys.path("ca.cnf"),
                "-in", m_keys.path(QString(hash) + ".csr"), "-out",
                m_keys.path(QString(hash) + ".pem"), "-extensions", "signer", "-startdate",
                MadeKeys::kFrom, "-enddate", MadeKeys::kUntil, "-cert", m_keys.path("root.pem"),
                "-keyfile", m_keys.path("root.key"), "-md", hash}));
            m_keys.write(std::string(hash) + ".all.pem",
                m_keys.content(std::string(hash) + ".key")
                    + m_keys.content(std::string(hash) + ".pem"));
        }
        m_keys.write("alone.pem", m_keys.content("lab.key") + m_keys.content("lab.pem"));
    }

    void certificatesBetween_comeWithTheSignature()
    {
        const std::string root = m_keys.content("root.pem");
        for (const SignatureCheck &found :
            {cmsCheck(key("lab.all.pem"), root), xmlCheck(key("lab.all.pem"), root)}) {
            QCOMPARE(found.status, Status::Valid);
            QCOMPARE(found.signer, std::string("Lab"));
            QVERIFY(found.remarks.empty());
        }
        // Without them nobody knows who stands between.
        QCOMPARE(cmsCheck(key("alone.pem"), root).status, Status::UnknownSigner);
        QCOMPARE(xmlCheck(key("alone.pem"), root).status, Status::UnknownSigner);
    }

    void anyNamedCertificate_isTrusted()
    {
        for (const char *anchor : {"middle.pem", "lab.pem"}) {
            QCOMPARE(cmsCheck(key("alone.pem"), m_keys.content(anchor)).status, Status::Valid);
            QCOMPARE(xmlCheck(key("alone.pem"), m_keys.content(anchor)).status, Status::Valid);
        }
        const std::string several = m_keys.content("plain.pem") + m_keys.content("middle.pem");
        QCOMPARE(cmsCheck(key("alone.pem"), several).status, Status::Valid);
        QCOMPARE(
            cmsCheck(key("alone.pem"), m_keys.content("plain.pem")).status, Status::UnknownSigner);
        QCOMPARE(cmsCheck(key("alone.pem"), "no certificates").status, Status::UnknownSigner);
    }

    void endedCertificateBetween_isNamed()
    {
        const SignatureCheck found = cmsCheck(key("late.all.pem"), m_keys.content("root.pem"));
        QCOMPARE(found.status, Status::Expired);
        QVERIFY(english(found.remarks.at(0))
                    .find("“Ending” is valid from 2025-01-01T00:00:00Z to "
                          "2026-01-01T00:00:00Z")
            != std::string::npos);
        QCOMPARE(cmsCheck(key("late.all.pem"), m_keys.content("root.pem"), "2025-06-01T00:00:00Z")
                     .status,
            Status::Valid);
    }

    /// By a service: such keys do not open.
    void weakCertificates_areOfNobody_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("words");
        QTest::newRow("short") << "short"
                               << "rests on RSA, 1024 bits, which is too weak";
        QTest::newRow("md5") << "md5"
                             << "rests on md5, which is too weak";
        QTest::newRow("sha1") << "sha1"
                              << "rests on sha1, which is too weak";
    }
    void weakCertificates_areOfNobody()
    {
        QFETCH(QString, name);
        QFETCH(QString, words);
        const std::string cms = sealedBy(name);
        QVERIFY(!faultOfCms(cms, sha256Hex(std::string_view("content"))));
        for (const std::string &anchors : {m_keys.content("root.pem"), std::string()}) {
            const SignatureCheck found
                = checkCms(cms, {"content"}, MadeKeys::kNow, {anchors, MadeKeys::kNow});
            QCOMPARE(found.status, Status::UnknownSigner);
            const QString said = QString::fromStdString(english(found.remarks.back()));
            if (!anchors.empty())
                QVERIFY2(said.toLower().contains(words.toLower()), qPrintable(said));
        }
        const auto fit = checkSignerOfCms(cms, "seal-client", MadeKeys::kNow);
        QCOMPARE(fit.has_value(), name != "short");
    }

    /// Signed by a service: such a key opens only where documents are among its uses.
    void certificateForOtherUse_isRemarked_andSignsNothing()
    {
        const TrustSettings trust{m_keys.content("root.pem"), MadeKeys::kNow};
        for (const std::string name : {"server", "stamps", "mail"}) {
            const std::string cms = sealedBy(QString::fromStdString(name));
            const SignatureCheck found = checkCms(cms, {"content"}, MadeKeys::kNow, trust);
            QCOMPARE(found.status, Status::Valid);
            QCOMPARE(found.remarks.empty(), name == "mail");
            QVERIFY(found.remarks.empty()
                || english(found.remarks[0]).find("(extended key usage)") != std::string::npos);
            const auto opened = SigningKey::open(m_keys.file(name + ".all.pem"), {});
            QCOMPARE(opened.has_value(), name == "mail");
            QVERIFY(opened
                || english(opened.error().message).find("one of a server") != std::string::npos);
            QCOMPARE(checkSignerOfCms(cms, "seal", MadeKeys::kNow).has_value(), name == "mail");
        }
    }

    void signerThatMayNotCertify_standsBehindNobody()
    {
        const SignatureCheck found = cmsCheck(key("child.all.pem"), m_keys.content("root.pem"));
        QCOMPARE(found.status, Status::UnknownSigner);
        QCOMPARE(found.signer, std::string("Child of none that may certify"));
    }
};

DYNCAL_TEST(TestSignerStanding)
#include "tst_signer_standing.moc"
