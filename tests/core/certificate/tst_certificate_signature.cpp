// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_issue.h"
#include "core/certificate/certificate_signature.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;

namespace {

CertificateData issued(bool isSigned, const CertificateSigner &signer, bool hasSection = true)
{
    Recipe recipe;
    recipe.certificate.fields = example::certificateFields();
    ChosenTemplate chosen;
    if (hasSection)
        chosen.layout.sections.emplace_back(kSignatureSection);
    CertificateIssue issue{"17", {}, {}, "headhash", "resultshash"};
    if (isSigned)
        issue.signer = signer;
    return certificateOf(example::calibration(), recipe, "2026-11-21T12:00:00Z", chosen, issue);
}

QString saidOf(const CertificateSection &section)
{
    QStringList lines;
    for (const Message &paragraph : section.paragraphs)
        lines << QString::fromStdString(english(paragraph));
    for (const CertificateField &field : section.fields)
        lines << QString::fromStdString(english(field.label) + "=" + english(field.value));
    return lines.join('|');
}

const CertificateSigner kSigner{"Example Laboratory", "2026-11-21T12:34:56Z"};

} // namespace

/// The section over which a signature is to be seen.
class TestCertificateSignature : public QObject
{
    Q_OBJECT

private slots:
    void signed_statesWhoWhenAndNumber()
    {
        const CertificateData data = issued(true, kSigner);
        QVERIFY(data.section(kSignatureSection));
        QCOMPARE(saidOf(*data.section(kSignatureSection)),
            "Signed by=Example Laboratory|Signed at (UTC)=2026-11-21T12:34:56Z|"
            "Number of the certificate=17");
    }

    void service_saysItsNameLater()
    {
        const QString said = saidOf(*issued(true, {{}, kSigner.utc}).section(kSignatureSection));
        QVERIFY2(
            said.startsWith("Signed by=a service that signs for the laboratory"), qPrintable(said));
    }

    void unsigned_saysSo_withoutFields()
    {
        const CertificateData data = issued(false, {});
        const CertificateSection *section = data.section(kSignatureSection);
        QVERIFY(section && section->fields.empty());
        QVERIFY(saidOf(*section).contains("without an electronic signature"));
    }

    void draft_saysWhatWillBeThere()
    {
        const CertificateSection section = signatureToCome();
        QCOMPARE(section.id, std::string(kSignatureSection));
        QVERIFY(section.fields.empty() && section.paragraphs.size() == 1);
    }

    void templateWithout_hasNone()
    {
        QVERIFY(!issued(true, kSigner, false).section(kSignatureSection));
        QVERIFY(!issued(false, {}, false).section(kSignatureSection));
    }

    void hostileName_staysText()
    {
        const QString said
            = saidOf(*issued(true, {"%1 <b>\n%M1", kSigner.utc}).section(kSignatureSection));
        QVERIFY2(said.contains("%1 <b>"), qPrintable(said));
    }
};

DYNCAL_TEST(TestCertificateSignature)
#include "tst_certificate_signature.moc"
