// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/certificate_pdf.h"

#include "ui/report/certificate_blocks.h"
#include "ui/report/pdf_bytes.h"
#include "ui/report/reproducible_output.h"
#include "ui/text/core_text.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QPdfWriter>

namespace dyncal {

namespace {

constexpr int kPageDpi = 96; ///< vectors: says how big a pixel is, not how fine the print
constexpr double kMargin = 57.0; ///< 15 mm
constexpr double kHeaderHeight = 30.0;
constexpr double kFooterHeight = 26.0;

class PagePainter
{
public:
    PagePainter(QPdfWriter &writer, const CertificateData &data)
        : m_writer(writer)
        , m_data(data)
        , m_page(0.0, 0.0, writer.width(), writer.height())
    {
    }

    const CertificateStyle &style() const { return m_style; }
    QRectF textArea() const
    {
        return m_page.adjusted(
            kMargin, kMargin + kHeaderHeight, -kMargin, -kMargin - kFooterHeight);
    }

    bool paint(const std::vector<FlowBlock> &blocks)
    {
        const QRectF area = textArea();
        const std::vector<PlacedBlock> placed = placeBlocks(blocks, area.height());
        const int pages = pageCount(placed);
        QPainter painter;
        if (!painter.begin(&m_writer))
            return false;
        painter.setRenderHint(QPainter::Antialiasing);
        int page = -1;
        for (const PlacedBlock &place : placed) {
            while (page < place.page) {
                if (page >= 0)
                    m_writer.newPage();
                paintFrame(painter, ++page, pages);
            }
            const FlowBlock &block = blocks[place.block];
            const QRectF where(area.left(), area.top() + place.top, area.width(), block.height);
            if (place.withHeader) {
                const FlowBlock &header = *block.repeatedHeader;
                header.paint(painter,
                    QRectF(area.left(), where.top() - header.height, area.width(), header.height));
            }
            block.paint(painter, where);
        }
        return painter.end();
    }

private:
    void paintFrame(QPainter &painter, int page, int pages)
    {
        if (m_data.draft)
            paintDraftMark(painter);
        const QRectF area = textArea();
        const QString number = m_data.number.empty()
            ? QCoreApplication::translate("Report", "no number yet")
            : QString::fromStdString(m_data.number);
        const QString left = translated(m_data.title) + QStringLiteral("  ")
            + QCoreApplication::translate("Report", "No. %1").arg(number);
        const QString right
            = QCoreApplication::translate("Report", "page %1 of %2").arg(page + 1).arg(pages);
        const double top = area.top() - kHeaderHeight;
        paintLine(painter, top, left, right);
        painter.setPen(QPen(m_style.rule, 0.7));
        painter.drawLine(QPointF(area.left(), top + 16.0), QPointF(area.right(), top + 16.0));
        const QString state = m_data.draft
            ? QCoreApplication::translate("Report", "Draft, not valid as a certificate")
            : QString();
        paintLine(painter, area.bottom() + 12.0, state,
            QCoreApplication::translate("Report", "Computed %1")
                .arg(QString::fromStdString(m_data.createdUtc)));
    }

    void paintLine(QPainter &painter, double top, const QString &left, const QString &right)
    {
        const QRectF area = textArea();
        const FlowText leftText(left, m_style.small, 0.75 * area.width(), &m_writer);
        const FlowText rightText(
            right, m_style.small, 0.4 * area.width(), &m_writer, Qt::AlignRight);
        leftText.draw(painter, QPointF(area.left(), top), m_style.quiet);
        rightText.draw(painter, QPointF(area.left() + 0.6 * area.width(), top), m_style.quiet);
    }

    void paintDraftMark(QPainter &painter)
    {
        painter.save();
        painter.translate(m_page.center());
        painter.rotate(-55.0);
        painter.setFont(m_style.mark);
        painter.setPen(m_style.draftMark);
        painter.drawText(QRectF(-600.0, -200.0, 1200.0, 400.0), Qt::AlignCenter,
            QCoreApplication::translate("Report", "DRAFT"));
        painter.restore();
    }

    QPdfWriter &m_writer;
    const CertificateData &m_data;
    QRectF m_page;
    CertificateStyle m_style;
};

} // namespace

QByteArray certificatePdf(const CertificateData &data, const std::vector<ReportFigure> &figures)
{
    const ReproducibleOutput reproducible;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setResolution(kPageDpi);
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setPageMargins(QMarginsF(0.0, 0.0, 0.0, 0.0));
        writer.setTitle(
            translated(data.title) + QLatin1Char(' ') + QString::fromStdString(data.number));
        writer.setCreator(QStringLiteral("Dyncal"));
        PagePainter pages(writer, data);
        const std::vector<FlowBlock> blocks
            = certificateBlocks(data, figures, pages.style(), pages.textArea().width(), &writer);
        if (!pages.paint(blocks))
            return {};
    }
    return withFixedDates(bytes, QString::fromStdString(data.createdUtc));
}

} // namespace dyncal
