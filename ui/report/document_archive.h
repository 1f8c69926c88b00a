// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pdf/pdf_archive.h"
#include "ui/report/page_flow.h"

#include <QRectF>

#include <optional>

namespace dyncal {

/// Title of a document as its file states it: with the number, where there is one.
QString documentTitle(const CertificateData &data);

/// What a document gets as an archive, in the language of the installed translator.
PdfArchive documentArchive(const CertificateData &data);

/// A bookmark for each block that has one. `page` and `textArea` are in pixels of `page_dpi` to the
/// inch, the same on every page.
std::vector<PdfBookmark> documentBookmarks(const std::vector<FlowBlock> &blocks,
    const std::vector<PlacedBlock> &placed, const QRectF &page, const QRectF &textArea,
    double page_dpi);

/// Where a signature is to be seen, with the same arguments; none where no block asks for it.
std::optional<PdfPlace> documentSignaturePlace(const std::vector<FlowBlock> &blocks,
    const std::vector<PlacedBlock> &placed, const QRectF &page, const QRectF &textArea,
    double page_dpi);

/// The ICC profile of sRGB, as which all colours on the pages are meant.
std::string sRgbProfile();

} // namespace dyncal
