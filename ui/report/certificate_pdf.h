// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/certificate/certificate_data.h"
#include "ui/report/report_figures.h"

#include <QtGlobal>

#include <memory>
#include <string>

namespace dyncal {

/// Why nothing is drawn without a QApplication, or where Qt gets no memory for a page.
Error nothingToDrawOn();

/// The certificate as a PDF: A4, vectors, fonts embedded, opaque colours, "DRAFT" behind every page
/// while it is one, with the structure of PDF/A-3 (core/pdf/pdf_archive.h) and the files that
/// `data.attachments` names inside. The same input gives the same bytes: dates come from
/// `data.createdUtc`, the document id from the content. All texts are fixed when this is made, in
/// the language of the installed translator. Needs a QApplication.
///
/// Painted block by block, so that the window can answer in between; `drawNext` needs
/// ReproducibleOutput.
class CertificatePdf
{
public:
    CertificatePdf(const CertificateData &data, const std::vector<ReportFigure> &figures);
    ~CertificatePdf();
    Q_DISABLE_COPY(CertificatePdf)

    std::size_t blockCount() const;
    bool isDrawn() const;
    void drawNext(); ///< the next block

    /// The document, once it is drawn. Fails (Internal) if it could not be painted.
    Result<std::string> take();

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace dyncal
