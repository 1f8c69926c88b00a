// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/content_hash.h"
#include "core/signing/cms_opened.h"
#include "core/signing/cms_signature.h"
#include "tests/support/made_keys.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// Tag, length and content of a value (X.690, 8.1), encoded here.
std::string der(int tag, const std::string &content)
{
    std::string value(1, static_cast<char>(tag)), length;
    for (std::size_t rest = content.size(); rest > 0; rest /= 256)
        length.insert(0, 1, static_cast<char>(rest % 256));
    if (content.size() < 0x80)
        value += static_cast<char>(content.size());
    else
        value.append(1, static_cast<char>(0x80 | length.size())).append(length);
    return value + content;
}

/// The values one after the other in the content of another, each whole.
std::vector<std::string> partsOf(const std::string &content)
{
    std::vector<std::string> parts;
    for (std::size_t place = 0; place + 2 <= content.size();) {
        std::size_t size = static_cast<unsigned char>(content[place + 1]), head = 2;
        if (size >= 0x80) {
            head += size - 0x80;
            size = 0;
            for (std::size_t i = 2; i < head; ++i)
                size = size * 256 + static_cast<unsigned char>(content.at(place + i));
        }
        parts.push_back(content.substr(place, head + size));
        place += head + size;
    }
    return parts;
}

std::string contentOfDer(const std::string &value)
{
    const auto first = static_cast<unsigned char>(value.at(1));
    return value.substr(first < 0x80 ? 2 : 2 + (first - 0x80));
}

/// Down through the values: the part of that number, of that the next, and so on.
std::string partAt(std::string value, std::initializer_list<std::size_t> path)
{
    for (const std::size_t number : path)
        value = partsOf(contentOfDer(value)).at(number);
    return value;
}

const std::string kContent = "content";

} // namespace

/// CMS byte by byte: read by a reader of DER written here, hashed and verified by `openssl dgst`.
class TestCmsOpened : public QObject
{
    Q_OBJECT

private:
    MadeKeys m_keys;
    std::string m_cms;

    bool isAccepted(const std::string &cms) const
    {
        return !faultOfCms(cms, sha256Hex(std::string_view(kContent)));
    }
    /// The parts of its one SignerInfo.
    std::vector<std::string> signer() const
    {
        return partsOf(contentOfDer(partAt(m_cms, {1, 0, 4, 0})));
    }
    /// The same CMS with another SignerInfo, or several.
    std::string withSigners(const std::string &signers) const
    {
        std::vector<std::string> parts = partsOf(contentOfDer(partAt(m_cms, {1, 0})));
        return der(0x30,
            partAt(m_cms, {0})
                + der(0xA0,
                    der(0x30, parts[0] + parts[1] + parts[2] + parts[3] + der(0x31, signers))));
    }
    static std::string joined(const std::vector<std::string> &parts)
    {
        std::string all;
        for (const std::string &one : parts)
            all += one;
        return all;
    }

private slots:
    void initTestCase()
    {
        QVERIFY(m_keys.isMade);
        QVERIFY(m_keys.make("lab", "Lab"));
        m_cms = cmsOfHash(sha256Hex(std::string_view(kContent)),
            *SigningKey::open(m_keys.file("lab.all.pem"), {}))
                    .value_or("");
        QVERIFY(isAccepted(m_cms));
    }

    void hexadecimalDigits_areBytes()
    {
        using Bytes = openssl::Bytes;
        QCOMPARE(openssl::bytesOfHex("00ff7F80"), (Bytes{0, 255, 127, 128}));
        QCOMPARE(openssl::bytesOfHex(""), Bytes{});
        QCOMPARE(openssl::bytesOfHex("0"), Bytes{});
        QCOMPARE(openssl::bytesOfHex("010"), Bytes{1});
        QCOMPARE(openssl::bytesOfHex("01g2"), Bytes{1});
        QCOMPARE(openssl::bytesOfHex("g1"), Bytes{});
        QCOMPARE(openssl::bytesOfHex(std::string_view("0\0", 2)), Bytes{});
    }

    /// RFC 5652, 5.1 to 5.4: each field, and what the signature is over.
    void fields_areThoseOfTheStandard()
    {
        QCOMPARE(partAt(m_cms, {0}), QByteArray::fromHex("06092a864886f70d010702").toStdString());
        QCOMPARE(partAt(m_cms, {1, 0, 2}), // detached: the type only
            QByteArray::fromHex("300b06092a864886f70d010701").toStdString());
        const std::vector<std::string> parts = signer();
        QCOMPARE(parts.size(), std::size_t(6)); // no unsigned attributes
        QCOMPARE(parts[0], QByteArray::fromHex("020101").toStdString());
        QCOMPARE(partAt(parts[2], {0}),
            QByteArray::fromHex("0609608648016503040201").toStdString()); // SHA-256
        std::string attributes = parts[3];
        QCOMPARE(attributes[0], '\xA0');
        std::vector<std::string> sorted = partsOf(contentOfDer(attributes));
        QCOMPARE(sorted.size(), std::size_t(3));
        QVERIFY(std::is_sorted(sorted.begin(), sorted.end()));
        m_keys.write("content", kContent);
        const QByteArray hash
            = answerOf("openssl", {"dgst", "-sha256", "-binary", m_keys.path("content")}).out;
        const std::string digest = der(0x04, hash.toStdString());
        QVERIFY(attributes.find(
                    QByteArray::fromHex("06092a864886f70d010904").toStdString() + der(0x31, digest))
            != std::string::npos);
        QVERIFY(m_keys.openssl({"x509", "-in", m_keys.path("lab.pem"), "-outform", "DER", "-out",
            m_keys.path("lab.der")}));
        const QByteArray certificate
            = answerOf("openssl", {"dgst", "-sha256", "-binary", m_keys.path("lab.der")}).out;
        QVERIFY(attributes.find(der(0x04, certificate.toStdString())) != std::string::npos);
        QVERIFY(m_cms.find(m_keys.content("lab.der")) != std::string::npos);
        // Signed are the attributes as a SET (5.4), which is not how they stand there.
        attributes[0] = '\x31';
        m_keys.write("attributes", attributes);
        m_keys.write("signature", contentOfDer(parts[5]));
        QVERIFY(m_keys.openssl({"x509", "-in", m_keys.path("lab.pem"), "-pubkey", "-noout", "-out",
            m_keys.path("public.pem")}));
        QVERIFY(m_keys.openssl({"dgst", "-sha256", "-verify", m_keys.path("public.pem"),
            "-signature", m_keys.path("signature"), m_keys.path("attributes")}));
    }

    void eachFlipOfTheSigner_isFound()
    {
        const std::size_t begin = m_cms.find(joined(signer()));
        QVERIFY(begin != std::string::npos);
        // Not signed: version, the name under which the certificate is looked for (which the
        // attributes state too), and what is named beside RSA.
        const std::string head = signer()[0] + signer()[1], algorithm = signer()[4];
        const std::size_t unsignedBegin = m_cms.find(algorithm, begin);
        for (std::size_t i = begin + head.size(); i < m_cms.size(); ++i) {
            if (i >= unsignedBegin && i < unsignedBegin + algorithm.size())
                continue;
            for (int bit = 0; bit < 8; ++bit) {
                std::string bad = m_cms;
                bad[i] = static_cast<char>(bad[i] ^ (1 << bit));
                const QByteArray around = QByteArray::fromStdString(bad.substr(i - 8, 24)).toHex();
                QVERIFY2(!isAccepted(bad),
                    qPrintable(
                        QString("%1, bit %2: %3").arg(i - begin).arg(bit).arg(QString(around))));
            }
        }
    }

    void otherForms_areRefused_data()
    {
        QTest::addColumn<QByteArray>("cms");
        const auto row = [](const char *name, const std::string &cms) {
            QTest::newRow(name) << QByteArray::fromStdString(cms);
        };
        std::vector<std::string> parts = signer();
        const std::string one = der(0x30, joined(parts));
        row("no signer", withSigners(""));
        row("two signers", withSigners(one + one));
        const std::vector<std::string> attributes = partsOf(contentOfDer(parts[3]));
        const auto withAttributes = [&](const std::string &made) {
            std::vector<std::string> changed = parts;
            changed[3] = made;
            return withSigners(der(0x30, joined(changed)));
        };
        row("no attributes", withAttributes(""));
        row("empty attributes", withAttributes(der(0xA0, "")));
        for (std::size_t i = 0; i < attributes.size(); ++i) {
            std::vector<std::string> less = attributes, twice = attributes;
            less.erase(less.begin() + static_cast<long>(i));
            twice.push_back(attributes[i]);
            row(qPrintable(QString("without %1").arg(i)), withAttributes(der(0xA0, joined(less))));
            row(qPrintable(QString("twice %1").arg(i)), withAttributes(der(0xA0, joined(twice))));
        }
        row("type of data", partAt(m_cms, {1, 0, 2}));
        row("nothing", "");
        row("zeros", std::string(1000, '\0'));
        row("more than there is", QByteArray::fromHex("3084ffffffff").toStdString() + m_cms);
        row("length of lengths", "\x30" + std::string(127, '\xff'));
        row("no end", "\x30\x80" + m_cms);
        std::string nested;
        for (int i = 0; i < 20000; ++i)
            nested += "\x30\x80";
        row("nested without end", nested);
        std::string deep = m_cms;
        for (int i = 0; i < 2000; ++i)
            deep = der(0x30, deep);
        row("nested", deep);
        row("large", m_cms + std::string(50000000, 'x'));
    }
    void otherForms_areRefused()
    {
        QFETCH(QByteArray, cms);
        QElapsedTimer timer;
        timer.start();
        const auto fault = faultOfCms(cms.toStdString(), sha256Hex(std::string_view(kContent)));
        QVERIFY(fault && english(*fault).ends_with('.'));
        QVERIFY(timer.elapsed() < 5000);
    }

    /// So the refusals above are of what was changed, not of how this test writes it.
    void sameFormWrittenHere_isAccepted()
    {
        QCOMPARE(withSigners(der(0x30, joined(signer()))), m_cms);
        for (std::size_t size = 0; size < m_cms.size(); size += 3)
            QVERIFY(!isAccepted(m_cms.substr(0, size)));
    }
};

DYNCAL_TEST(TestCmsOpened)
#include "tst_cms_opened.moc"
