// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/document_pdf.h"

#include "ui/report/certificate_pdf.h"
#include "ui/report/report_language.h"
#include "ui/report/reproducible_output.h"

#include <QApplication>

namespace dyncal {
namespace {

QByteArray drawnPages(const CertificateData &data)
{
    ReportLanguage language(data.language);
    const ReproducibleOutput reproducible(language.numbers());
    const ReportLanguage::Scope scope(language);
    CertificatePdf pdf(data, {});
    while (!pdf.isDrawn())
        pdf.drawNext();
    return pdf.take();
}

} // namespace

Result<std::string> documentPdf(const CertificateData &data)
{
    QByteArray bytes;
    if (qobject_cast<QApplication *>(QCoreApplication::instance()))
        bytes = drawnPages(data);
    if (bytes.isEmpty())
        return fail(ErrorKind::Internal,
            {DYNCAL_TEXT("core",
                 "The document cannot be drawn: the program found nothing to draw on; start it anew."),
                {}});
    return bytes.toStdString();
}

} // namespace dyncal
