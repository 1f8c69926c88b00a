// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pdf/pdf_lint.h"
#include "tests/support/test_program.h"
#include "tests/support/tool_answer.h"
#include "tests/system/issued_job.h"

#include <QCryptographicHash>
#include <QtTest>

using namespace dyncal;
using dyncal::testing::askTool;

/// The PDF of a certificate that the built program issued, as an archive.
class TestIssuedPdf : public QObject
{
    Q_OBJECT

    IssuedJob m_job;
    QString folder() const { return m_job.output() + "/1"; }
    QByteArray file(const QString &name) const { return bytesOf(folder() + '/' + name); }

    /// Puts another PDF into the folder, with every hash beside it, as a careful forger would.
    void forge(const QByteArray &pdf) const
    {
        const auto hash = [](const QByteArray &bytes) {
            return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex();
        };
        const QByteArray before = file("certificate.pdf");
        const QByteArray manifest = file("manifest.json");
        const QByteArray forged = QByteArray(manifest).replace(hash(before), hash(pdf));
        QVERIFY(writeBytes(folder() + "/certificate.pdf", pdf));
        QVERIFY(writeBytes(folder() + "/manifest.json", forged));
        QVERIFY(writeBytes(folder() + "/written.json",
            file("written.json")
                .replace(hash(before), hash(pdf))
                .replace(hash(manifest), hash(forged))));
    }

private slots:
    void initTestCase()
    {
        QTemporaryDir recordings;
        QVERIFY(simulateShortCapture(recordings.filePath("shot.h5"), 7));
        QVERIFY(m_job.begin(recordings.filePath("shot.h5")));
        QCOMPARE(m_job.issue().exitCode, 0);
    }

    void filesInside_areThoseBeside()
    {
        const std::string pdf = file("certificate.pdf").toStdString();
        const auto inside = attachmentsOf(pdf);
        QVERIFY(inside.has_value() && inside->size() >= 2);
        for (const PdfAttachment &one : *inside) {
            const QString name = QString::fromStdString(one.name);
            QCOMPARE(QByteArray::fromStdString(one.bytes), file(name));
            QCOMPARE(askTool("qpdf", {"--show-attachment=" + name, "FILE"}, pdf).out, file(name));
            QCOMPARE(askTool("pdfdetach", {"-savefile", name, "-o", "got", "FILE"}, pdf, "got").out,
                file(name));
        }
    }

    void structure_isWhole()
    {
        const std::string pdf = file("certificate.pdf").toStdString();
        const auto faults = lintPdf(pdf);
        QVERIFY(faults.has_value());
        QVERIFY2(faults->empty(), faults->empty() ? "" : faults->front().rule.c_str());
        QCOMPARE(askTool("qpdf", {"--check", "FILE"}, pdf).exitCode, 0);
        QVERIFY(askTool("pdfinfo", {"FILE"}, pdf).out.contains("dynamic calibration 1\n"));
    }

    /// A forger who knows of every hash outside of the PDF is found by what is inside of it.
    void fileInsideChanged_isFound_whateverTheHashesSay()
    {
        const QByteArray sound = file("certificate.pdf");
        QCOMPARE(runDyncal({"verify", folder()}).exitCode, 1);
        for (const auto &[from, to] : {std::pair{"/AFRelationship /Data", "/AFRelationship /Date"},
                 {"/Lang (en)", "/Lung (en)"}, {"/F (recipe.json)", "/F (recept.json)"}}) {
            forge(QByteArray(sound).replace(from, to));
            const Answer answer = runDyncal({"verify", folder()});
            QVERIFY2(answer.exitCode == 2, answer.out + answer.err);
        }
        forge(sound);
        QCOMPARE(runDyncal({"verify", folder()}).exitCode, 1);
    }
};

DYNCAL_TEST(TestIssuedPdf)
#include "tst_issued_pdf.moc"
