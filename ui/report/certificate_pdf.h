// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "ui/report/report_figures.h"

#include <QByteArray>

namespace dyncal {

/// The certificate as a PDF: A4, vectors, fonts embedded, opaque colours, "DRAFT" behind every page
/// while it is one. The same input gives the same bytes: dates come from `data.createdUtc`, the
/// document id from the content. Texts in the language of the installed translator. Needs a
/// QApplication; empty if the page could not be painted.
QByteArray certificatePdf(const CertificateData &data, const std::vector<ReportFigure> &figures);

} // namespace dyncal
