// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/content_hash.h"
#include "core/signing/cms_signature.h"
#include "core/signing/key_token.h"
#include "core/signing/xml_signing.h"
#include "core/signing/xml_verifying.h"
#include "tests/support/known_secret.h"
#include "tests/support/made_token.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

/// Keys that stay in a token (SoftHSM2).
class TestTokenKey : public QObject
{
    Q_OBJECT

private:
    MadeKeys m_keys;
    std::unique_ptr<MadeToken> m_token;

    static std::string refusal(const std::string &uri, std::string_view pin)
    {
        const auto key = SigningKey::open(uri, secretOf(pin));
        return key ? std::string() : english(key.error().message);
    }

private slots:
    void initTestCase()
    {
        QVERIFY(m_keys.isMade);
        QVERIFY(m_keys.make("lab", "Lab"));
        m_token = std::make_unique<MadeToken>(m_keys);
        QVERIFY(m_token->isMade);
    }

    void uriWithAPin_isRefusedBeforeItIsUsed()
    {
        for (const char *fine : {"pkcs11:token=lab;object=seal",
                 "pkcs11:", "pkcs11:object=pin-value?module-path=/usr/lib/pin-source.so"})
            QVERIFY2(checkTokenUri(fine).has_value(), fine);
        for (const char *bad :
            {"pkcs11:token=lab?pin-value=4815", "pkcs11:pin-source=/pin;token=lab",
                "pkcs11:token=lab?module-path=/a.so&pin-value=", "pkcs11:token=lab?PIN-VALUE=4815",
                "pkcs11:token=lab?pin%2Dvalue=4815", "pkcs11:token=lab?p%69n-Value=4815",
                "pkcs11:token=lab;Pin-Source=4815", "PKCS11:token=lab?pin_value=4815",
                "pkcs11:token=lab?pin-value%3D4815"}) {
            QVERIFY(isTokenUri(bad));
            const auto fit = checkTokenUri(bad);
            QVERIFY2(!fit && fit.error().kind == ErrorKind::Usage, bad);
            QVERIFY(english(fit.error().message).find("4815") == std::string::npos);
        }
    }

    void query_isNeverSaid()
    {
        QCOMPARE(shownSource("pkcs11:token=lab?x=4815"), std::string("pkcs11:token=lab"));
        QCOMPARE(shownSource("/a?b.pem"), std::string("/a?b.pem"));
        for (const char *uri : {"pkcs11:token=other?passwd=4815", "PKCS11:token=other?key=4815"}) {
            const std::string said = refusal(uri, MadeToken::kPin);
            QVERIFY2(said.find("4815") == std::string::npos
                    && said.find("no private key for pkcs11:token=other")
                            + said.find("no private key for PKCS11:token=other")
                        != 2 * std::string::npos,
                said.c_str());
        }
    }

    void otherwise_oneSentence()
    {
        const std::string uri = MadeToken::kUri;
        const auto says = [](const std::string &said, const char *words) {
            if (said.find(words) == std::string::npos)
                qWarning("%s", said.c_str());
            return said.find(words) != std::string::npos;
        };
        QVERIFY(says(refusal(uri, "11111111"), "the PIN is wrong, or there is no such token"));
        QVERIFY(says(refusal(uri, ""), "without a PIN; give it by --pin-fd N"));
        QVERIFY(
            says(refusal("pkcs11:token=lab;object=none", MadeToken::kPin), "no private key for"));
        QVERIFY(
            says(refusal("pkcs11:token=other;object=seal", MadeToken::kPin), "no private key for"));
        for (const char *part : {";pin-value=", "?pin-value=", "?pin-source=", ";pin-source="}) {
            const std::string said = refusal(uri + part + MadeToken::kPin, "");
            QVERIFY(says(said, "others could read in the list of processes"));
            QVERIFY(said.find(MadeToken::kPin) == std::string::npos);
        }
        QVERIFY(says(refusal(uri + "?module-path=/nowhere.so", MadeToken::kPin), "cannot be used"));
        const QByteArray module = qgetenv("PKCS11_MODULE_PATH");
        qunsetenv("PKCS11_MODULE_PATH");
        QVERIFY(says(refusal(uri, MadeToken::kPin), "install libengine-pkcs11-openssl"));
        qputenv("PKCS11_MODULE_PATH", module);
        // The right one still opens: nothing was locked or left behind.
        QCOMPARE(refusal(uri, MadeToken::kPin), std::string());
    }

    void token_signsAsTheSameKeyInAFile()
    {
        const auto ofFile = SigningKey::open(m_keys.file("lab.all.pem"), {});
        const std::string hash = sha256Hex(std::string_view("content"));
        const TrustSettings trust{m_keys.content("root.pem"), MadeKeys::kNow};
        for (const std::string &uri :
            {std::string(MadeToken::kUri), std::string("pkcs11:token=lab;id=%01;type=private"),
                std::string("pkcs11:object=seal?module-path=").append(MadeToken::kModule),
                std::string("pkcs11:object=se%61l;type=cert")}) {
            const auto key = SigningKey::open(uri, secretOf(MadeToken::kPin));
            QVERIFY2(key, key ? "" : english(key.error().message).c_str());
            QCOMPARE(key->signer(), std::string("Lab"));
            const auto cms = cmsOfHash(hash, *key);
            QVERIFY2(cms, cms ? "" : english(cms.error().message).c_str());
            const SignatureCheck found = checkCms(*cms, {"content"}, MadeKeys::kNow, trust);
            QVERIFY(found.status == SignatureCheck::Status::Valid);
            const auto xml = signedXml("<a>x</a>", *key);
            QVERIFY2(xml, xml ? "" : english(xml.error().message).c_str());
            QVERIFY(checkXmlSignature(*xml, trust).status == SignatureCheck::Status::Valid);
            // Certificates above the signer's are in the file only; the signature is the same.
            const auto valueOf = [](const std::string &text) {
                const std::size_t begin = text.find("<ds:SignedInfo ");
                return text.substr(begin, text.find("</ds:SignatureValue>") - begin);
            };
            QCOMPARE(valueOf(*xml), valueOf(*signedXml("<a>x</a>", *ofFile)));
        }
    }
};

DYNCAL_TEST(TestTokenKey)
#include "tst_token_key.moc"
