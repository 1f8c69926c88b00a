// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/signing_order.h"
#include "registry/issued/file_signatures.h"
#include "tests/support/made_keys.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;
using Status = SignatureCheck::Status;

/// Signatures of an issued folder: PDF and DCC together.
class TestFileSignatures : public QObject
{
    Q_OBJECT

private:
    MadeKeys m_keys;
    std::string m_pdf;
    const std::string m_dcc = "<a>x</a>";

    SigningOrder by(const std::string &name) const
    {
        return {.key = *SigningKey::open(m_keys.file(name + ".all.pem"), {})};
    }
    SignatureCheck checked(const std::string &pdf, const std::string &dcc) const
    {
        const ScratchFolder folder;
        folder.write("certificate.pdf", pdf.data(), pdf.size());
        if (!dcc.empty())
            folder.write("dcc.xml", dcc.data(), dcc.size());
        return checkFolderSignatures(folder.file(""), {m_keys.content("root.pem"), MadeKeys::kNow});
    }

private slots:
    void initTestCase()
    {
        QVERIFY(m_keys.isMade);
        QVERIFY(m_keys.make("lab", "Lab") && m_keys.make("other", "Other"));
        QVERIFY(m_keys.make("again", "Lab"));
        m_pdf = contentOf(qEnvironmentVariable("DYNCAL_SOURCE_DIR").toStdString()
            + "/tests/data/kept_projects/2026-11-27-version-2/certificates/1/certificate.pdf");
    }

    void bothAreHeldTogether()
    {
        const std::string pdf = *signedCertificate(m_pdf, by("lab"), MadeKeys::kNow, {});
        const std::string dcc = *signedDcc(m_dcc, by("lab"));
        const SignatureCheck both = checked(pdf, dcc);
        QVERIFY(both.status == Status::Valid && both.remarks.empty());
        QCOMPARE(both.signer, std::string("Lab"));
        QVERIFY(checked(pdf, "").status == Status::Valid && checked(pdf, "").remarks.empty());
        const SignatureCheck sealed = checked(pdf, m_dcc);
        QCOMPARE(sealed.status, Status::Valid);
        QCOMPARE(
            english(sealed.remarks.at(0)), std::string("dcc.xml has no signature of its own."));
        const SignatureCheck half = checked(m_pdf, dcc);
        QCOMPARE(half.status, Status::Unsigned);
        QVERIFY(english(half.remarks.at(0)).starts_with("Only dcc.xml is signed"));
        const SignatureCheck mixed = checked(pdf, *signedDcc(m_dcc, by("other")));
        QCOMPARE(mixed.status, Status::Changed);
        QVERIFY(english(*mixed.difference).find("by “Other”") != std::string::npos);
        QVERIFY(english(*mixed.difference).find("not issued together") != std::string::npos);
        const SignatureCheck namesake = checked(pdf, *signedDcc(m_dcc, by("again")));
        QCOMPARE(namesake.status, Status::Changed);
        QVERIFY(checked(m_pdf, m_dcc).status == Status::Unsigned);
    }

    void changes_areFound()
    {
        std::string pdf = *signedCertificate(m_pdf, by("lab"), MadeKeys::kNow, {});
        std::string dcc = *signedDcc(m_dcc, by("lab"));
        std::string badDcc = dcc;
        badDcc[3] = 'y';
        const SignatureCheck changed = checked(pdf, badDcc);
        QCOMPARE(changed.status, Status::Changed);
        QVERIFY(english(*changed.difference).find("signature of dcc.xml does not hold")
            != std::string::npos);
        pdf[1000] = static_cast<char>(pdf[1000] ^ 1);
        QCOMPARE(checked(pdf, dcc).status, Status::Changed);
        QVERIFY(!checkFileSignature("/nowhere/a.pdf", {}));
        QVERIFY(checkFileSignature("/nowhere/a.json", {})->status == Status::Unsigned);
    }

    void files_areKnownByTheirContent()
    {
        const ScratchFolder folder;
        const auto write = [&](const std::string &name, const std::string &bytes) {
            return folder.write(name, bytes.data(), bytes.size());
        };
        const std::string dcc = *signedDcc(
            "<?xml version=\"1.0\"?><digitalCalibrationCertificate>x</digitalCalibrationCertificate>",
            by("lab"));
        const std::string pdf = *signedCertificate(m_pdf, by("lab"), MadeKeys::kNow, {});
        const TrustSettings trust{m_keys.content("root.pem"), MadeKeys::kNow};
        for (const char *name : {"a", "a.txt", "a.PDF", "a.xml", "a.Pdf"}) {
            QCOMPARE(signedKindOf(write(name, pdf)), SignedKind::Pdf);
            QCOMPARE(checkFileSignature(folder.file(name), trust)->status, Status::Valid);
            QCOMPARE(signedKindOf(write(name, " \n" + dcc)), SignedKind::Xml);
            QCOMPARE(signedKindOf(write(name, dcc)), SignedKind::Xml);
            QCOMPARE(checkFileSignature(folder.file(name), trust)->status, Status::Valid);
        }
        QCOMPARE(signedKindOf(write("b.XML", "text")), SignedKind::Xml);
        QCOMPARE(signedKindOf(write("b.PDF", "text")), SignedKind::Pdf);
        for (const std::string &other : {std::string("text"), std::string("<recording/>"),
                 std::string(2000, ' ') + "%PDF-1.7", std::string()})
            QCOMPARE(signedKindOf(write("b", other)), SignedKind::None);
    }
};

DYNCAL_TEST(TestFileSignatures)
#include "tst_file_signatures.moc"
