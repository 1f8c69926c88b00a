// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/document_archive.h"

#include "ui/report/document_words.h"
#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <QColorSpace>
#include <QFile>

namespace dyncal {
namespace {

constexpr double kPointsPerInch = 72.0;

/// As a viewer's list shows it, which breaks no words.
std::string oneLine(QString words)
{
    return words.remove(QChar(QChar::SoftHyphen)).simplified().toStdString();
}

/// What is printed as the laboratory; empty where nobody stated one.
std::string laboratoryOf(const CertificateData &data)
{
    for (const CertificateSection &section : data.sections)
        for (const CertificateField &field : section.fields)
            if (field.id == "laboratory" && !field.missing)
                return oneLine(printed(field.value));
    return {};
}

} // namespace

QString documentTitle(const CertificateData &data)
{
    return (printed(data.title) + QLatin1Char(' ') + shownText(data.number)).simplified();
}

PdfArchive documentArchive(const CertificateData &data)
{
    PdfArchive archive;
    archive.metadata.title = oneLine(documentTitle(data));
    archive.metadata.author = laboratoryOf(data);
    archive.metadata.creator = "Dyncal";
    archive.metadata.producer = oneLine(QLatin1String("Qt ") + QLatin1String(qVersion()));
    archive.metadata.language = data.language.empty() ? "en" : data.language;
    archive.metadata.secondLanguage = data.secondLanguage;
    archive.metadata.createdUtc = data.createdUtc;
    for (const auto &[name, value] : data.marks)
        archive.metadata.marks.emplace_back(name, shownText(value).toStdString());
    archive.colorProfile = sRgbProfile();
    for (const CertificateAttachment &file : data.attachments)
        archive.attachments.push_back({file.name, file.mime, file.relationship,
            oneLine(printed(file.description)), file.bytes});
    return archive;
}

std::vector<PdfBookmark> documentBookmarks(const std::vector<FlowBlock> &blocks,
    const std::vector<PlacedBlock> &placed, const QRectF &page, const QRectF &textArea,
    double page_dpi)
{
    std::vector<PdfBookmark> bookmarks;
    for (const PlacedBlock &place : placed)
        if (const QString &title = blocks[place.block].bookmark; !title.isEmpty()) {
            const double height = page.bottom() - textArea.top() - place.top;
            bookmarks.push_back({oneLine(title), place.page, height * kPointsPerInch / page_dpi});
        }
    return bookmarks;
}

std::optional<PdfPlace> documentSignaturePlace(const std::vector<FlowBlock> &blocks,
    const std::vector<PlacedBlock> &placed, const QRectF &page, const QRectF &textArea,
    double page_dpi)
{
    constexpr double kAround = 3.0; // of the words, in pixels
    std::optional<PlacedBlock> first;
    double bottom = 0.0;
    for (const PlacedBlock &place : placed) {
        const FlowBlock &block = blocks[place.block];
        if (!block.isSignature || (first && place.page != first->page))
            continue;
        if (!first)
            first = place;
        bottom = place.top + block.height;
    }
    if (!first)
        return {};
    const QRectF around(QPointF(textArea.left() - kAround, textArea.top() + first->top - kAround),
        QPointF(textArea.right() + kAround, textArea.top() + bottom + kAround));
    const double points = kPointsPerInch / page_dpi;
    return PdfPlace{first->page, points * around.left(), points * (page.bottom() - around.bottom()),
        points * around.right(), points * (page.bottom() - around.top())};
}

std::string sRgbProfile()
{
    QFile file(QStringLiteral(":/qpdf/sRGB2014.icc")); // the ICC's own, which Qt's PDFs carry
    if (file.open(QIODevice::ReadOnly))
        return file.readAll().toStdString();
    return QColorSpace(QColorSpace::SRgb).iccProfile().toStdString();
}

} // namespace dyncal
