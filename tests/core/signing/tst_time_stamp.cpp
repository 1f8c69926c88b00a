// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/content_hash.h"
#include "core/signing/cms_signature.h"
#include "core/signing/time_stamp.h"
#include "tests/support/made_stamps.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;
using Status = SignatureCheck::Status;

/// Time stamps of an authority that openssl is.
class TestTimeStamp : public QObject
{
    Q_OBJECT

private:
    MadeKeys m_keys;
    std::unique_ptr<MadeStamps> m_stamps;
    const std::string m_content = "content";

    std::string cmsBy(const std::string &name) const
    {
        return cmsOfHash(sha256Hex(std::string_view(m_content)),
            *SigningKey::open(m_keys.file(name + ".all.pem"), {}))
            .value_or("");
    }
    AskAuthority authority() const
    {
        return [this](const std::string &request) {
            return Result<std::string>(m_stamps->reply(request));
        };
    }
    SignatureCheck check(const std::string &cms, const std::string &trust,
        const std::string &now = "2030-01-01T00:00:00Z",
        const std::string &stated = "2025-06-01T00:00:00Z") const
    {
        return checkCms(cms, {m_content}, stated, {trust, now});
    }

private slots:
    void initTestCase()
    {
        QVERIFY(m_keys.isMade);
        QVERIFY(m_keys.make("lab", "Lab"));
        QVERIFY(m_keys.make("short", "Short", "signer", {"-newkey", "rsa:2048"}, "20250101000000Z",
            "20271231000000Z"));
        QVERIFY(m_keys.make("past", "Past", "signer", {"-newkey", "rsa:2048"}, "20250101000000Z",
            "20250701000000Z"));
        QVERIFY(m_keys.make("stamps", "Stamps", "stamps"));
        m_stamps = std::make_unique<MadeStamps>(m_keys);
    }

    void stamp_isReadAndAcceptedByOpenssl()
    {
        const std::string bare = cmsBy("lab");
        const auto stamped = withTimeStamp(bare, authority());
        QVERIFY2(stamped, stamped ? "" : english(stamped.error().message).c_str());
        const std::string justNow
            = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
        const SignatureCheck found
            = check(*stamped, m_keys.content("root.pem"), "2030-01-01T00:00:00Z", justNow);
        QCOMPARE(found.status, Status::Valid);
        QVERIFY(found.remarks.empty());
        const QDateTime moment
            = QDateTime::fromString(QString::fromStdString(found.stampedUtc), Qt::ISODate);
        QVERIFY(qAbs(moment.secsTo(QDateTime::currentDateTimeUtc())) < 600);
        QVERIFY(m_keys.openssl({"ts", "-verify", "-queryfile", m_keys.path("stamps.tsq"), "-in",
            m_keys.path("stamps.tsr"), "-CAfile", m_keys.path("root.pem")}));
        m_keys.write("content", m_content);
        m_keys.write("stamped.der", *stamped);
        QVERIFY(m_keys.openssl({"cms", "-verify", "-cades", "-binary", "-inform", "DER", "-in",
            m_keys.path("stamped.der"), "-content", m_keys.path("content"), "-CAfile",
            m_keys.path("root.pem"), "-purpose", "any", "-out", "/dev/null"}));
        const ProgramAnswer request
            = answerOf("openssl", {"ts", "-query", "-in", m_keys.path("stamps.tsq"), "-text"});
        QVERIFY2(request.out.contains("Hash Algorithm: sha256")
                && request.out.contains("Certificate required: yes")
                && !request.out.contains("Nonce: unspecified"),
            request.out);
    }

    void momentsFarApart_areRemarked()
    {
        const std::string stamped = *withTimeStamp(cmsBy("lab"), authority());
        const std::string trust = m_keys.content("root.pem"), now = "2030-01-01T00:00:00Z";
        const auto remarks = [&](qint64 hours) {
            const QDateTime stated = QDateTime::currentDateTimeUtc().addSecs(3600 * hours);
            return check(stamped, trust, now, stated.toString(Qt::ISODate).toStdString()).remarks;
        };
        for (const qint64 near : {-23, 0, 23})
            QVERIFY(remarks(near).empty());
        for (const qint64 far : {-25, 25, -8000})
            QVERIFY(remarks(far).size() == 1
                && english(remarks(far)[0]).find("more than a day") != std::string::npos);
        QVERIFY(check(stamped, trust, now, "").remarks.empty());
    }

    void refusal_isSaid()
    {
        // TimeStampResp { PKIStatusInfo { rejection, { "no" } } }
        const std::string denied("\x30\x0b\x30\x09\x02\x01\x02\x30\x04\x0c\x02no", 13);
        const auto refused = withTimeStamp(
            cmsBy("lab"), [&](const std::string &) { return Result<std::string>(denied); });
        QVERIFY(!refused);
        const std::string said = english(refused.error().message);
        QVERIFY2(
            said.find("refused to stamp this signature (PKIStatus 2, no)") != std::string::npos,
            said.c_str());
    }

    void stamp_keepsASignatureAlive()
    {
        const std::string trust = m_keys.content("root.pem");
        const std::string bare = cmsBy("short");
        const std::string stamped = *withTimeStamp(bare, authority());
        QCOMPARE(check(bare, trust, "2030-01-01T00:00:00Z").status, Status::Expired);
        QCOMPARE(check(stamped, trust, "2030-01-01T00:00:00Z").status, Status::Valid);
        const std::string late = *withTimeStamp(cmsBy("past"), authority());
        const SignatureCheck found = check(late, trust, "2025-06-02T00:00:00Z");
        QCOMPARE(found.status, Status::Expired); // whatever the signature says of its time
        QVERIFY(!found.stampedUtc.empty());
    }

    void unknownAuthority_doesNotCount()
    {
        const std::string stamped = *withTimeStamp(cmsBy("lab"), authority());
        const SignatureCheck found = check(stamped, m_keys.content("lab.pem"));
        QCOMPARE(found.status, Status::Valid);
        QVERIFY(found.stampedUtc.empty());
        QVERIFY(
            english(found.remarks.at(0)).find("by an authority behind which") != std::string::npos);
        // A certificate that is not for time stamps.
        m_keys.write("stamps.pem.good", m_keys.content("stamps.pem"));
    }

    void changedStamp_doesNotCount()
    {
        const std::string trust = m_keys.content("root.pem");
        const std::string stamped = *withTimeStamp(cmsBy("lab"), authority());
        const std::size_t bare = cmsBy("lab").size();
        int refused = 0, tried = 0;
        for (std::size_t i = bare; i < stamped.size(); i += 23, ++tried) {
            std::string bad = stamped;
            bad[i] = static_cast<char>(bad[i] ^ 1);
            const SignatureCheck found = check(bad, trust);
            QVERIFY(found.status == Status::Valid || found.status == Status::Changed);
            refused += found.stampedUtc.empty() ? 1 : 0;
            if (found.status == Status::Valid && !found.stampedUtc.empty())
                QVERIFY(found.stampedUtc.starts_with(
                    QDateTime::currentDateTimeUtc().toString("yyyy-MM").toStdString()));
        }
        QVERIFY2(refused > tried / 2, qPrintable(QString("%1 of %2").arg(refused).arg(tried)));
    }

    void otherReplies_areRefused()
    {
        const std::string cms = cmsBy("lab");
        std::string earlier;
        const auto kept = withTimeStamp(cmsBy("short"), [&](const std::string &request) {
            earlier = m_stamps->reply(request);
            return Result<std::string>(earlier);
        });
        QVERIFY(kept && !earlier.empty());
        const std::string denied("\x30\x05\x30\x03\x02\x01\x02", 7); // rejection
        for (const std::string &reply : {earlier, denied, std::string("text"), std::string()}) {
            const auto stamped = withTimeStamp(
                cms, [&](const std::string &) { return Result<std::string>(reply); });
            QVERIFY(!stamped);
            QCOMPARE(stamped.error().kind, ErrorKind::DataBlocked);
        }
        const auto silent = withTimeStamp(cms, [](const std::string &) {
            return Result<std::string>(fail(ErrorKind::FileUnreadable, {"nobody", {}}));
        });
        QCOMPARE(silent.error().kind, ErrorKind::FileUnreadable);
        QVERIFY(!withTimeStamp("no CMS", authority()));
    }
};

DYNCAL_TEST(TestTimeStamp)
#include "tst_time_stamp.moc"
