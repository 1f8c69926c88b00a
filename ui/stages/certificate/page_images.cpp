// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/certificate/page_images.h"

#include <poppler-qt6.h>

namespace dyncal {

namespace {

constexpr double kPointsPerInch = 72.0;

tl::unexpected<Error> noPages()
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "The document cannot be shown: its pages cannot be read; export it and open it in another program."),
            {}});
}

QImage imageOf(const Poppler::Document &document, int index, int width_px)
{
    const std::unique_ptr<Poppler::Page> page = document.page(index);
    if (!page || page->pageSizeF().width() <= 0.0)
        return {};
    const double dpi = kPointsPerInch * width_px / page->pageSizeF().width();
    return page->renderToImage(dpi, dpi);
}

} // namespace

Result<std::vector<QImage>> pageImages(
    const std::string &pdf, int width_px, const JobControl &control)
{
    const std::unique_ptr<Poppler::Document> document = Poppler::Document::loadFromData(
        QByteArray(pdf.data(), static_cast<qsizetype>(pdf.size())));
    if (!document || document->isLocked() || width_px < 1)
        return noPages();
    document->setRenderHint(Poppler::Document::Antialiasing);
    document->setRenderHint(Poppler::Document::TextAntialiasing);
    std::vector<QImage> images;
    for (int i = 0; i < document->numPages(); ++i) {
        if (control.stopRequested())
            return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Cancelled."), {}});
        images.push_back(imageOf(*document, i, width_px));
        if (images.back().isNull())
            return noPages();
    }
    return images;
}

} // namespace dyncal
