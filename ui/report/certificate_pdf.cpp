// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/certificate_pdf.h"

#include "core/certificate/certificate_issue.h"
#include "ui/report/certificate_blocks.h"
#include "ui/report/document_archive.h"
#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QPdfWriter>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kPageDpi = 96; ///< vectors: says how big a pixel is, not how fine the print
constexpr double kMargin = 57.0; ///< 15 mm
constexpr double kHeaderHeight = 30.0;
constexpr double kFooterHeight = 26.0;

/// "No. 17"; nothing on what is no certificate.
QString numberOf(const CertificateData &data)
{
    if (!data.isCertificate)
        return {};
    return data.number.empty()
        ? QCoreApplication::translate("Report", "no number yet")
        : QCoreApplication::translate("Report", "No. %1").arg(shownText(data.number));
}

bool isSigned(const CertificateData &data)
{
    return std::ranges::any_of(
        data.marks, [](const auto &mark) { return mark.first == kSignedMark; });
}

/// What stands around the text of every page.
struct FrameTexts
{
    QString title, number, page, state, computed, mark;

    explicit FrameTexts(const CertificateData &data)
        : title(printed(data.title))
        , number(numberOf(data))
        , page(QCoreApplication::translate("Report", "page %1 of %2"))
        , computed(
              QCoreApplication::translate("Report", "Computed %1").arg(rawText(data.createdUtc)))
    {
        if (!data.isCertificate)
            return;
        if (!data.draft) {
            state = isSigned(data)
                ? QCoreApplication::translate("Report", "Issued, with an electronic signature")
                : QCoreApplication::translate("Report", "Issued, not signed");
            return;
        }
        state = QCoreApplication::translate("Report", "Draft, not valid as a certificate");
        mark = QCoreApplication::translate("Report", "DRAFT");
    }
};

class PagePainter
{
public:
    PagePainter(QPdfWriter &writer, const CertificateData &data)
        : m_writer(writer)
        , m_texts(data)
        , m_page(0.0, 0.0, writer.width(), writer.height())
    {
    }

    const CertificateStyle &style() const { return m_style; }
    const QRectF &page() const { return m_page; }
    QRectF textArea() const
    {
        return m_page.adjusted(
            kMargin, kMargin + kHeaderHeight, -kMargin, -kMargin - kFooterHeight);
    }

    void paintBlock(QPainter &painter, const FlowBlock &block, double top, bool withHeader) const
    {
        const QRectF area = textArea();
        const QRectF where(area.left(), area.top() + top, area.width(), block.height);
        if (withHeader) {
            const FlowBlock &header = *block.repeatedHeader;
            header.paint(painter,
                QRectF(area.left(), where.top() - header.height, area.width(), header.height));
        }
        block.paint(painter, where);
    }

    void paintFrame(QPainter &painter, int page, int pages) const
    {
        if (!m_texts.mark.isEmpty())
            paintDraftMark(painter);
        const QRectF area = textArea();
        const double top = area.top() - kHeaderHeight;
        paintLine(painter, top, m_texts.title + QStringLiteral("  ") + m_texts.number,
            m_texts.page.arg(page + 1).arg(pages));
        painter.setPen(QPen(m_style.rule, 0.7));
        painter.drawLine(QPointF(area.left(), top + 16.0), QPointF(area.right(), top + 16.0));
        paintLine(painter, area.bottom() + 12.0, m_texts.state, m_texts.computed);
    }

private:
    void paintLine(QPainter &painter, double top, const QString &left, const QString &right) const
    {
        const QRectF area = textArea();
        const FlowText leftText(left, m_style.small, 0.75 * area.width(), &m_writer);
        const FlowText rightText(
            right, m_style.small, 0.4 * area.width(), &m_writer, Qt::AlignRight);
        leftText.draw(painter, QPointF(area.left(), top), m_style.quiet);
        rightText.draw(painter, QPointF(area.left() + 0.6 * area.width(), top), m_style.quiet);
    }

    void paintDraftMark(QPainter &painter) const
    {
        painter.save();
        painter.translate(m_page.center());
        painter.rotate(-55.0);
        painter.setFont(m_style.mark);
        painter.setPen(m_style.draftMark);
        painter.drawText(QRectF(-600.0, -200.0, 1200.0, 400.0), Qt::AlignCenter, m_texts.mark);
        painter.restore();
    }

    QPdfWriter &m_writer;
    FrameTexts m_texts;
    QRectF m_page;
    CertificateStyle m_style;
};

void setUp(QPdfWriter &writer)
{
    writer.setResolution(kPageDpi);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(0.0, 0.0, 0.0, 0.0));
}

} // namespace

struct CertificatePdf::Private
{
    QByteArray bytes;
    QBuffer buffer{&bytes};
    std::unique_ptr<QPdfWriter> writer; ///< writes the end of the document when it goes
    std::unique_ptr<PagePainter> pages;
    std::vector<FlowBlock> blocks;
    std::vector<PlacedBlock> placed;
    QPainter painter;
    std::size_t next = 0;
    int page = -1;
    PdfArchive archive;

    ~Private()
    {
        if (painter.isActive())
            painter.end(); // before the writer is destroyed
    }
};

CertificatePdf::CertificatePdf(
    const CertificateData &data, const std::vector<ReportFigure> &figures)
    : d(std::make_unique<Private>())
{
    d->buffer.open(QIODevice::WriteOnly);
    d->writer = std::make_unique<QPdfWriter>(&d->buffer);
    setUp(*d->writer);
    d->pages = std::make_unique<PagePainter>(*d->writer, data);
    const QRectF area = d->pages->textArea();
    d->blocks = certificateBlocks(data, figures, d->pages->style(), area.width(), d->writer.get());
    d->placed = placeBlocks(d->blocks, area.height());
    d->archive = documentArchive(data);
    d->archive.bookmarks
        = documentBookmarks(d->blocks, d->placed, d->pages->page(), area, kPageDpi);
    d->archive.signature
        = documentSignaturePlace(d->blocks, d->placed, d->pages->page(), area, kPageDpi);
    if (d->painter.begin(d->writer.get()))
        d->painter.setRenderHint(QPainter::Antialiasing);
    else
        d->next = d->placed.size(); // nothing to draw on: take() gives nothing
}

CertificatePdf::~CertificatePdf() = default;

std::size_t CertificatePdf::blockCount() const
{
    return d->placed.size();
}

bool CertificatePdf::isDrawn() const
{
    return d->next >= d->placed.size();
}

void CertificatePdf::drawNext()
{
    const PlacedBlock &place = d->placed[d->next++];
    while (d->page < place.page) {
        if (d->page >= 0)
            d->writer->newPage();
        d->pages->paintFrame(d->painter, ++d->page, pageCount(d->placed));
    }
    d->pages->paintBlock(d->painter, d->blocks[place.block], place.top, place.withHeader);
}

Error nothingToDrawOn()
{
    return {ErrorKind::Internal,
        {DYNCAL_TEXT("core",
             "The document cannot be drawn: the program found nothing to draw on; start it anew."),
            {}},
        {}};
}

Result<std::string> CertificatePdf::take()
{
    if (!d->painter.isActive() || !d->painter.end())
        return tl::unexpected<Error>(nothingToDrawOn());
    d->writer.reset(); // writes the end of the document
    return withArchiveStructure(d->bytes.toStdString(), d->archive);
}

} // namespace dyncal
