// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/xml_signing.h"
#include "core/signing/xml_verifying.h"
#include "tests/support/made_keys.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QtTest>

#include <random>

using namespace dyncal;
using namespace dyncal::testing;
using Status = SignatureCheck::Status;

/// XML signatures, with xmlsec1 as the other judge, and forged ones.
class TestXmlSignature : public QObject
{
    Q_OBJECT

private:
    MadeKeys m_keys;
    const std::string m_document
        = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<dcc:certificate xmlns:dcc=\"urn:d\" "
          "xmlns:si=\"urn:s\" schemaVersion=\"3.3.0\">\n <!-- a remark -->\n"
          " <dcc:value unit=\"\\pascal\">1.5 &amp; \xC3\xA5</dcc:value>\n <si:list/>\n"
          "</dcc:certificate>\n";

    std::string signedBy(const std::string &name, const std::string &xml) const
    {
        const auto made = signedXml(xml, *SigningKey::open(m_keys.file(name + ".all.pem"), {}));
        return made ? *made : english(made.error().message);
    }
    SignatureCheck check(std::string_view xml) const
    {
        return checkXmlSignature(xml, {m_keys.content("root.pem"), MadeKeys::kNow});
    }
    bool xmlsecVerifies(const std::string &xml) const
    {
        m_keys.write("judged.xml", xml);
        return answerOf("xmlsec1",
            {"--verify", "--enabled-reference-uris", "empty", "--trusted-pem",
                m_keys.path("root.pem"), m_keys.path("judged.xml")})
            .ran;
    }
    static std::string replaced(std::string text, const std::string &from, const std::string &to)
    {
        const std::size_t place = text.find(from);
        return place == text.npos ? "(not there: " + from + ")"
                                  : text.replace(place, from.size(), to);
    }
    static std::string partOf(const std::string &xml)
    {
        const std::size_t begin = xml.find("<ds:Signature xmlns"),
                          end = xml.find("</ds:Signature>");
        return xml.substr(begin, end - begin + std::string("</ds:Signature>").size());
    }

private slots:
    void initTestCase()
    {
        QVERIFY(m_keys.isMade);
        QVERIFY(m_keys.make("lab", "Lab"));
        QVERIFY(m_keys.make("other", "Other"));
        QVERIFY(m_keys.make(
            "curve", "Curve", "signer", {"-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256"}));
    }

    void signedDocument_isValidForOthers_data()
    {
        QTest::addColumn<QString>("key");
        QTest::newRow("rsa") << "lab";
        QTest::newRow("curve") << "curve";
    }
    void signedDocument_isValidForOthers()
    {
        QFETCH(QString, key);
        const std::string made = signedBy(key.toStdString(), m_document);
        QVERIFY2(xmlsecVerifies(made), made.c_str());
        const SignatureCheck found = check(made);
        QVERIFY2(found.status == Status::Valid,
            found.difference ? english(*found.difference).c_str() : "");
        QCOMPARE(found.signer, key == "lab" ? std::string("Lab") : std::string("Curve"));
        QVERIFY(found.signedUtc.empty());
        QCOMPARE(found.remarks.size(), std::size_t(1));
        QVERIFY(english(found.remarks[0]).find("has a comment or") != std::string::npos);
        const std::string bare = replaced(m_document, "<!-- a remark -->", "");
        QVERIFY(check(signedBy(key.toStdString(), bare)).remarks.empty());
        QCOMPARE(withoutXmlSignature(made), m_document);
        QCOMPARE(checkXmlSignature(made, {"", MadeKeys::kNow}).status, Status::UnknownSigner);
        QCOMPARE(
            checkXmlSignature(made, {m_keys.content("root.pem"), "2036-06-01T00:00:00Z"}).status,
            Status::Expired);
    }

    void sampleOfDcc_isSignedAndStaysValid()
    {
        const QString folder = qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/../shared/dcc";
        if (!QFile::exists(folder + "/catalog.xml"))
            QSKIP("the schemas of ../shared/dcc are not here");
        const std::string sample
            = contentOf((folder + "/samples/own_shocktube_dcc.xml").toStdString());
        const std::string made = signedBy("lab", sample);
        QVERIFY(xmlsecVerifies(made));
        QCOMPARE(check(made).status, Status::Valid);
        qputenv("XML_CATALOG_FILES", (folder + "/catalog.xml").toUtf8());
        const ProgramAnswer schema = answerOf("xmllint",
            {"--nonet", "--noout", "--schema", folder + "/ptb.de/dcc/v3.3.0/dcc.xsd",
                m_keys.path("judged.xml")});
        qunsetenv("XML_CATALOG_FILES");
        QVERIFY2(schema.ran, schema.err);
    }

    void rsa_isReproducible()
    {
        QCOMPARE(signedBy("lab", m_document), signedBy("lab", m_document));
    }

    void changes_areFound()
    {
        const std::string made = signedBy("lab", m_document);
        const SignatureCheck value = check(replaced(made, "1.5", "1.6"));
        QCOMPARE(value.status, Status::Changed);
        QVERIFY(english(*value.difference).find("element certificate") != std::string::npos);
        QCOMPARE(check(replaced(made, "\\pascal", "\\bar")).status, Status::Changed);
        QCOMPARE(check(replaced(made, "<si:list/>", "")).status, Status::Changed);
        const std::string other = signedBy("other", m_document);
        const auto valueOf = [](const std::string &xml) {
            const std::size_t begin = xml.find("<ds:SignatureValue>");
            return xml.substr(begin, xml.find("</ds:SignatureValue>") - begin);
        };
        const SignatureCheck swapped = check(replaced(made, valueOf(made), valueOf(other)));
        QCOMPARE(swapped.status, Status::Changed);
        QVERIFY(english(*swapped.difference).find("not made by the key") != std::string::npos);
        // Comments are no content: the document says the same.
        QCOMPARE(check(replaced(made, "a remark", "b remark")).status, Status::Valid);
    }

    void commentInAText_isAChange()
    {
        const std::string made = signedBy("lab", replaced(m_document, "<!-- a remark -->", ""));
        for (const std::string &split :
            {std::string("1<!---->.5"), std::string("<!-- -->1.5"), std::string("1.5<!--x-->")}) {
            const SignatureCheck found = check(replaced(made, "1.5", split));
            QVERIFY2(found.status == Status::Changed && found.difference, split.c_str());
            QVERIFY(
                english(*found.difference).find("A comment or processing") != std::string::npos);
        }
        QCOMPARE(check(replaced(made, "1.5", "1<?x y?>.5")).status, Status::Changed);
        QCOMPARE(check(replaced(made, "<ds:DigestValue>", "<ds:DigestValue><!---->")).status,
            Status::Changed);
        for (const SignatureCheck &beside :
            {check(replaced(made, "<si:list/>", "<si:list><!-- 5 --></si:list>")),
                check(replaced(made, "<si:list/>", "<!-- 5 --><si:list/>")),
                check(made + "<!-- 5 -->")}) {
            QCOMPARE(beside.status, Status::Valid);
            QCOMPARE(beside.remarks.size(), std::size_t(1));
        }
        QVERIFY(signedBy("lab", "<a>1<!---->2</a>").find("cannot be signed") != std::string::npos);
    }

    /// However many bytes: the names of one element are counted before anything compares them.
    void manyNames_areRefusedUnread()
    {
        const std::string made = signedBy("lab", m_document);
        std::string names;
        while (names.size() < kMostXmlBytes / 2)
            names += " xmlns:a" + std::to_string(names.size()) + "='u:" + "'";
        for (const std::string &bad :
            {replaced(made, "<si:list/>", "<si:list" + names + "/>"), "<a" + names + "/>"}) {
            const SignatureCheck found = check(bad);
            QCOMPARE(found.status, Status::Changed);
            QVERIFY(english(*found.difference).find("at most 200 attributes and namespaces")
                != std::string::npos);
        }
    }

    /// Whatever is valid after a flip has the same content (XML-DSig signs content, not bytes).
    void flips_leaveTheContentOrAreFound()
    {
        const std::string made = signedBy("lab", m_document);
        const std::size_t end = m_document.size();
        std::mt19937_64 random(20261127);
        for (int i = 0; i < trials::count(500, 20000); ++i) {
            std::string bad = made;
            const std::size_t place = random() % bad.size();
            bad[place] = static_cast<char>(bad[place] ^ (1 << (random() % 8)));
            const SignatureCheck found = check(bad);
            if (found.status == Status::Valid)
                QVERIFY2(place > end || place < m_document.find("<dcc:certificate")
                        || (place > m_document.find("<!--") && place < m_document.find("-->"))
                        || std::isspace(static_cast<unsigned char>(made[place])) != 0
                        || made[place] == '"',
                    qPrintable(QString("%1: %2").arg(place).arg(made[place])));
            if (found.status == Status::Valid)
                QCOMPARE(found.signer, std::string("Lab"));
        }
    }

    void wrappedSignatures_areRefused_data()
    {
        QTest::addColumn<QByteArray>("xml");
        const std::string made = signedBy("lab", m_document);
        const std::string signature = partOf(made), bare = withoutXmlSignature(made);
        const std::string root = bare.substr(bare.find("<dcc:certificate"));
        const auto row = [](const char *name, const std::string &xml) {
            QTest::newRow(name) << QByteArray::fromStdString(xml);
        };
        row("signed document inside another",
            "<dcc:fake xmlns:dcc=\"urn:d\">" + made.substr(made.find("<dcc:certificate"))
                + "</dcc:fake>");
        row("signature moved in front", replaced(bare, "<dcc:value", signature + "<dcc:value"));
        row("signature one level down",
            replaced(bare, "<si:list/>", "<si:list>" + signature + "</si:list>"));
        row("two signatures", replaced(made, signature, signature + signature));
        row("element behind it", replaced(made, "</ds:Signature>", "</ds:Signature><si:more/>"));
        row("reference by id",
            replaced(replaced(made, "URI=\"\"", "URI=\"#a\""), "schemaVersion",
                "id=\"a\" schemaVersion"));
        row("reference to a file", replaced(made, "URI=\"\"", "URI=\"file:///etc/passwd\""));
        row("second reference",
            replaced(made, "</ds:Reference>", "</ds:Reference><ds:Reference URI=\"\"/>"));
        row("other transform",
            replaced(made, "<ds:Transforms>",
                "<ds:Transforms><ds:Transform Algorithm=\"http://www.w3.org/TR/1999/REC-xpath-19991116\">"
                "<ds:XPath>false()</ds:XPath></ds:Transform>"));
        row("no enveloped transform",
            replaced(made,
                "<ds:Transform Algorithm=\"http://www.w3.org/2000/09/xmldsig#enveloped-signature\">"
                "</ds:Transform>",
                ""));
        row("object", replaced(made, "</ds:KeyInfo>", "</ds:KeyInfo><ds:Object>x</ds:Object>"));
        row("hmac", replaced(made, "2001/04/xmldsig-more#rsa-sha256", "2000/09/xmldsig#hmac-sha1"));
        row("sha1", replaced(made, "2001/04/xmlenc#sha256", "2000/09/xmldsig#sha1"));
        row("key value", replaced(made, "<ds:X509Data>", "<ds:KeyValue/><ds:X509Data>"));
        row("no certificate", replaced(made, "<ds:X509Certificate>", "<ds:X509Certificate>AA"));
        row("other namespace",
            replaced(
                made, "xmlns:ds=\"http://www.w3.org/2000/09/xmldsig#\"", "xmlns:ds=\"urn:x\""));
        row("document type", "<!DOCTYPE a>" + root);
        row("entities",
            "<!DOCTYPE a [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]><a>&b;</a>");
        row("external entity",
            "<!DOCTYPE a [<!ENTITY a SYSTEM \"file:///etc/passwd\">]><a>&a;</a>");
        row("utf-16", std::string("\xff\xfe<\0a\0/\0>\0", 10));
        row("deep", [] {
            std::string deep;
            for (int i = 0; i < 5000; ++i)
                deep += "<a>";
            return deep;
        }());
        row("no XML", "text");
        row("nothing", "");
        row("large", std::string(kMostXmlBytes + 1, ' '));
    }
    void wrappedSignatures_areRefused()
    {
        QFETCH(QByteArray, xml);
        QVERIFY(!xml.startsWith("(not there"));
        const SignatureCheck found = check(xml.toStdString());
        QCOMPARE(found.status, Status::Changed);
        QVERIFY(found.difference && found.signer.empty());
    }

    void unsignedDocument_isUnsigned()
    {
        QCOMPARE(check(m_document).status, Status::Unsigned);
        QCOMPARE(check("<a/>").status, Status::Unsigned);
        QCOMPARE(withoutXmlSignature(m_document), m_document);
    }

    void whatCannotBeSigned_isRefused()
    {
        const std::string made = signedBy("lab", m_document);
        for (const std::string &bad : {made, std::string("<a/>"), std::string("text"),
                 std::string(), "<!DOCTYPE a><a></a>" + std::string()})
            QVERIFY2(
                signedBy("lab", bad).find("cannot be signed") != std::string::npos, bad.c_str());
        QCOMPARE(check(signedBy("lab", "<a></a>")).status, Status::Valid);
        QCOMPARE(check(signedBy("lab", "<a>x</a><!-- </b> -->")).status, Status::Valid);
    }
};

DYNCAL_TEST(TestXmlSignature)
#include "tst_xml_signature.moc"
