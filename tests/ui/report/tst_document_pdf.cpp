// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Documents of words and tables that are no certificate: what stands around them, their language,
// the same bytes each time.

#include "core/selftest/selftest_files.h"
#include "tests/support/test_program.h"
#include "ui/report/document_pdf.h"

#include <QProcess>
#include <QtTest>

using namespace dyncal;

namespace {

CertificateData madeDocument(const char *language = "en")
{
    SelfTestReport report;
    report.checks = {{"window", {"first", {}}, {"by hand", {}}, 1.0, 1.25, 0.5, 2e-12},
        {"model", {"second", {}}, {"by hand", {}}, 2.0, 3.0, 0.5, 0.0}};
    report.installation = {"1.0", "abc", "a compiler", "a processor", "a system", {{"Qt", "6.4"}}};
    return selfTestDocument(report, "2026-01-31T12:00:00Z", language);
}

/// The words of a PDF, by another program.
QString wordsOf(const std::string &pdf)
{
    QProcess reader;
    reader.start("pdftotext", {"-layout", "-", "-"});
    reader.write(pdf.data(), static_cast<qint64>(pdf.size()));
    reader.closeWriteChannel();
    return reader.waitForFinished() ? QString::fromUtf8(reader.readAllStandardOutput()) : QString();
}

} // namespace

class TestDocumentPdf : public QObject
{
    Q_OBJECT

private slots:
    void report_hasItsWords_andNothingOfACertificate()
    {
        const auto pdf = documentPdf(madeDocument());
        QVERIFY(pdf.has_value());
        const QString words = wordsOf(*pdf);
        for (const char *there : {"Self-test of the installation", "a processor", "page 1 of 1",
                 "Computed 2026-01-31T12:00:00Z", "1.25", "deviates", "End of the report"})
            QVERIFY2(words.contains(there), there);
        for (const char *absent : {"No. ", "no number yet", "DRAFT", "certificate"})
            QVERIFY2(!words.contains(absent), absent);
    }

    void certificate_keepsItsNumberAndItsEnd()
    {
        CertificateData data = madeDocument();
        data.isCertificate = true;
        data.number = "17";
        const QString words = wordsOf(*documentPdf(data));
        QVERIFY(words.contains("No. 17") && words.contains("End of the certificate"));
    }

    void swedish_isWhole()
    {
        const QString words = wordsOf(*documentPdf(madeDocument("sv")));
        for (const char *there :
            {"Självtest av installationen", "avviker", "stämmer", "Slut på rapporten"})
            QVERIFY2(words.contains(there), there);
        for (const char *absent : {"Expected", "deviates", "Coverage study", "Library"})
            QVERIFY2(!words.contains(absent), absent);
    }

    void again_sameBytes()
    {
        QCOMPARE(*documentPdf(madeDocument()), *documentPdf(madeDocument()));
        QVERIFY(*documentPdf(madeDocument()) != *documentPdf(madeDocument("sv")));
    }
};

DYNCAL_TEST(TestDocumentPdf)
#include "tst_document_pdf.moc"
