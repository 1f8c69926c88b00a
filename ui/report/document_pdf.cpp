// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/document_pdf.h"

#include "ui/report/certificate_pdf.h"
#include "ui/report/report_language.h"
#include "ui/report/reproducible_output.h"

#include <QApplication>

namespace dyncal {
namespace {

Result<std::string> drawnPages(const CertificateData &data)
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
    if (!qobject_cast<QApplication *>(QCoreApplication::instance()))
        return tl::unexpected<Error>(nothingToDrawOn());
    return drawnPages(data);
}

} // namespace dyncal
