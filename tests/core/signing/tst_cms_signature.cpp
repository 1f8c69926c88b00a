// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/content_hash.h"
#include "core/signing/cms_signature.h"
#include "tests/support/made_keys.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;
using Status = SignatureCheck::Status;

/// Detached signatures, with openssl as the other judge.
class TestCmsSignature : public QObject
{
    Q_OBJECT

private:
    MadeKeys m_keys;
    const std::string m_content = "What the laboratory states.\n";

    SigningKey key(const std::string &name) const
    {
        return *SigningKey::open(m_keys.file(name + ".all.pem"), {});
    }
    std::string cmsBy(const std::string &name) const
    {
        return cmsOfHash(sha256Hex(std::string_view(m_content)), key(name)).value_or("");
    }
    SignatureCheck check(const std::string &cms, const std::string &utc = MadeKeys::kNow,
        const std::string &stated = MadeKeys::kNow) const
    {
        return checkCms(cms, {std::string_view(m_content).substr(0, 5), m_content.substr(5)},
            stated, {m_keys.content("root.pem"), utc});
    }
    /// What openssl says of it.
    bool opensslVerifies(const std::string &cms) const
    {
        m_keys.write("content", m_content);
        m_keys.write("cms.der", cms);
        return answerOf("openssl",
            {"cms", "-verify", "-cades", "-binary", "-inform", "DER", "-in", m_keys.path("cms.der"),
                "-content", m_keys.path("content"), "-CAfile", m_keys.path("root.pem"), "-purpose",
                "any", "-out", "/dev/null"})
            .ran;
    }
    std::string foreignCms(const QStringList &more) const
    {
        m_keys.write("content", m_content);
        m_keys.openssl(QStringList{"cms", "-sign", "-binary", "-in", m_keys.path("content"),
                           "-signer", m_keys.path("lab.pem"), "-inkey", m_keys.path("lab.key"),
                           "-outform", "DER", "-out", m_keys.path("foreign.der")}
            + more);
        return m_keys.content("foreign.der");
    }

private slots:
    void initTestCase()
    {
        QVERIFY(m_keys.isMade);
        QVERIFY(m_keys.make("lab", "Lab"));
        QVERIFY(m_keys.make(
            "curve", "Curve", "signer", {"-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256"}));
        QVERIFY(m_keys.make("past", "Past", "signer", {"-newkey", "rsa:2048"}, "20250101000000Z",
            "20260101000000Z"));
    }

    void signature_isAcceptedByOpenssl_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("rsa") << "lab";
        QTest::newRow("curve") << "curve";
    }
    void signature_isAcceptedByOpenssl()
    {
        QFETCH(QString, name);
        const std::string cms = cmsBy(name.toStdString());
        QVERIFY(opensslVerifies(cms));
        const SignatureCheck found = check(cms);
        QCOMPARE(found.status, Status::Valid);
        QVERIFY(found.remarks.empty() && !found.difference && found.stampedUtc.empty());
        QCOMPARE(found.signer, name == "lab" ? std::string("Lab") : std::string("Curve"));
        QCOMPARE(found.signedUtc, std::string(MadeKeys::kNow));
    }

    void attributes_areThoseOfPades()
    {
        m_keys.write("cms.der", cmsBy("lab"));
        const ProgramAnswer printed = answerOf("openssl",
            {"cms", "-cmsout", "-print", "-noout", "-inform", "DER", "-in",
                m_keys.path("cms.der")});
        QVERIFY(printed.ran);
        for (const char *there :
            {"id-smime-aa-signingCertificateV2", "messageDigest", "contentType", "sha256"})
            QVERIFY2(printed.out.contains(there), there);
        for (const char *absent : {"signingTime", "S/MIME Capabilities"})
            QVERIFY2(!printed.out.contains(absent), absent);
        QVERIFY(printed.out.contains("eContent: <ABSENT>"));
    }

    void rsa_isReproducible()
    {
        QCOMPARE(cmsBy("lab"), cmsBy("lab"));
        QVERIFY(cmsBy("curve") != cmsBy("curve"));
    }

    void anyChange_isFound()
    {
        const std::string cms = cmsBy("lab");
        const SignatureCheck other = checkCms(
            cms, {"What the laboratory states!\n"}, "", {m_keys.content("root.pem"), ""});
        QCOMPARE(other.status, Status::Changed);
        QVERIFY(other.difference && other.signer.empty());
        // Of the CMS itself certificates above the signer's and the like are not signed; the
        // verdict must never be about another signer.
        for (std::size_t i = 0; i < cms.size(); i += 7) {
            std::string bad = cms;
            bad[i] = static_cast<char>(bad[i] ^ 4);
            const SignatureCheck found = check(bad);
            QVERIFY2(
                found.status != Status::Valid || found.signer == "Lab", std::to_string(i).c_str());
        }
        for (std::size_t size = 0; size < cms.size(); size += 101)
            QCOMPARE(check(cms.substr(0, size)).status, Status::Changed);
        QCOMPARE(check(cms + "x").status, Status::Changed);
        QVERIFY(!faultOfCms(cms, sha256Hex(std::string_view(m_content))));
        QVERIFY(faultOfCms(cms, std::string(64, '0')));
        QVERIFY(faultOfCms(cms, "no hash"));
        QVERIFY(faultOfCms("no CMS", std::string(64, '0')));
    }

    void signerAndTimes_areJudged()
    {
        const std::string cms = cmsBy("lab");
        const SignatureCheck unknown
            = checkCms(cms, {m_content}, MadeKeys::kNow, {"", MadeKeys::kNow});
        QCOMPARE(unknown.status, Status::UnknownSigner);
        QCOMPARE(unknown.signer, std::string("Lab"));
        QVERIFY(english(unknown.remarks[0]).find("--trust CA.pem") != std::string::npos);
        const SignatureCheck stranger = checkCms(
            cms, {m_content}, MadeKeys::kNow, {m_keys.content("curve.pem"), MadeKeys::kNow});
        QCOMPARE(stranger.status, Status::UnknownSigner);
        const SignatureCheck named = checkCms(
            cms, {m_content}, MadeKeys::kNow, {m_keys.content("lab.pem"), MadeKeys::kNow});
        QCOMPARE(named.status, Status::Valid); // itself is trusted

        const std::string past = cmsBy("past");
        QCOMPARE(check(past, "2025-06-01T00:00:00Z", "2025-05-01T00:00:00Z").status, Status::Valid);
        const SignatureCheck ended = check(past, MadeKeys::kNow, "2025-05-01T00:00:00Z");
        QCOMPARE(ended.status, Status::Expired);
        QVERIFY(english(ended.remarks[0]).find("no time stamp") != std::string::npos);
        const SignatureCheck late = check(past, MadeKeys::kNow, "2026-02-01T00:00:00Z");
        QCOMPARE(late.status, Status::Expired);
        QVERIFY(english(late.remarks[0]).find("not valid when it signed") != std::string::npos);
        QCOMPARE(check(cms, "2036-02-01T00:00:00Z").status, Status::Expired);
        QCOMPARE(check(cms, "2024-02-01T00:00:00Z", "").status, Status::Expired);
    }

    void foreignSignatures_areRead()
    {
        const SignatureCheck signedNow = check(foreignCms({"-cades"}), "2027-01-01T00:00:00Z");
        QCOMPARE(signedNow.status, Status::Valid);
        QVERIFY(signedNow.signedUtc.starts_with("20") && signedNow.signedUtc != MadeKeys::kNow);
        QCOMPARE(
            check(foreignCms({"-md", "sha512"}), "2027-01-01T00:00:00Z").status, Status::Valid);
        QCOMPARE(
            check(foreignCms({"-md", "sha1"}), "2027-01-01T00:00:00Z").status, Status::Changed);
        QCOMPARE(check(foreignCms({"-noattr"})).status, Status::Changed);
        QCOMPARE(check(foreignCms({"-nocerts"})).status, Status::Changed);
        QCOMPARE(check(foreignCms({"-nodetach"})).status, Status::Changed);
        QCOMPARE(check(foreignCms(
                           {"-signer", m_keys.path("past.pem"), "-inkey", m_keys.path("past.key")}))
                     .status,
            Status::Changed); // two signers
    }

    void anchors_areRead()
    {
        QVERIFY(readAnchors(m_keys.file("root.pem")));
        const auto none = readAnchors(m_keys.file("ca.cnf"));
        QVERIFY(!none);
        QCOMPARE(none.error().kind, ErrorKind::FileUnreadable);
        QVERIFY(!readAnchors(m_keys.file("nothing")));
        QCOMPARE(std::string(signatureStatusName(Status::UnknownSigner)), "unknown-signer");
        QCOMPARE(std::string(signatureStatusName(Status::Expired)), "expired");
    }
};

DYNCAL_TEST(TestCmsSignature)
#include "tst_cms_signature.moc"
