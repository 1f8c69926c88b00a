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

    void signerThatMayNotCertify_standsBehindNobody()
    {
        const SignatureCheck found = cmsCheck(key("child.all.pem"), m_keys.content("root.pem"));
        QCOMPARE(found.status, Status::UnknownSigner);
        QCOMPARE(found.signer, std::string("Child of none that may certify"));
    }
};

DYNCAL_TEST(TestSignerStanding)
#include "tst_signer_standing.moc"
