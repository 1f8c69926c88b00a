// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/certificate_blocks.h"

#include "ui/plot/widget/plot_widget.h"
#include "ui/report/document_words.h"
#include "ui/report/report_logo.h"
#include "ui/text/kept_together.h"

#include <QCoreApplication>

#include <algorithm>
#include <numeric>

namespace dyncal {

namespace {

constexpr double kLabelShare = 0.36; ///< of the width, for labels of fields
constexpr double kCellPadding = 4.0;
constexpr double kRowPadding = 2.0;
constexpr double kFigureHeight = 250.0;
constexpr double kPoleZeroHeight = 330.0;
constexpr double kPoleZeroWidth = 420.0;

QFont font(int pixels, bool bold = false)
{
    QFont made(QStringLiteral("DejaVu Sans"));
    made.setPixelSize(pixels);
    made.setBold(bold);
    // The same advance widths on every screen: a certificate must not depend on one.
    made.setHintingPreference(QFont::PreferNoHinting);
    // Any letter spacing turns ligatures off: "certificate" with one letter for "fi" would not be
    // found by a search of the document.
    made.setLetterSpacing(QFont::AbsoluteSpacing, 0.02);
    return made;
}

class BlockMaker
{
public:
    BlockMaker(const CertificateStyle &style, const DocumentWords &words, double width,
        QPaintDevice *device)
        : m_style(style)
        , m_words(words)
        , m_width(width)
        , m_device(device)
    {
    }

    FlowBlock text(
        const QString &words, const QFont &face, const QColor &color, double spaceBefore) const
    {
        const FlowText set(words, face, m_width, m_device);
        FlowBlock block;
        block.height = set.height();
        block.spaceBefore = spaceBefore;
        block.paint = [set, color](QPainter &painter, const QRectF &area) {
            set.draw(painter, area.topLeft(), color);
        };
        return block;
    }

    /// The logo takes the right end of the first line.
    FlowBlock titleWithLogo(const QString &words, const ReportLogo &logo) const
    {
        constexpr double kTitleShare = 0.68; // of the width; the rest is the logo's
        constexpr double kLogoHeight = 54.0;
        const FlowText title(words, m_style.title, kTitleShare * m_width, m_device);
        FlowBlock block;
        block.height = std::max(title.height(), kLogoHeight) + 2.0;
        block.paint = [title, logo, color = m_style.text](QPainter &painter, const QRectF &area) {
            title.draw(painter, area.topLeft(), color);
            const double left = area.left() + (kTitleShare + 0.02) * area.width();
            logo.draw(painter, QRectF(left, area.top(), area.right() - left, kLogoHeight));
        };
        return block;
    }

    FlowBlock heading(const QString &words) const
    {
        FlowBlock block = text(words, m_style.heading, m_style.text, 16.0);
        block.bookmark = words;
        const double textHeight = block.height;
        block.height += 4.0;
        block.keepWithNext = true;
        block.paint = [paint = block.paint, textHeight, rule = m_style.rule](
                          QPainter &painter, const QRectF &area) {
            paint(painter, area);
            painter.setPen(QPen(rule, 0.7));
            const double y = area.top() + textHeight + 1.5;
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        };
        return block;
    }

    FlowBlock field(const CertificateField &field) const
    {
        const double labelWidth = kLabelShare * m_width;
        const FlowText label(m_words(field.label), m_style.body, labelWidth - 8.0, m_device);
        const FlowText value(m_words(field.value), field.missing ? m_style.body : m_style.bold,
            m_width - labelWidth, m_device);
        FlowBlock block;
        block.height = std::max(label.height(), value.height()) + kRowPadding;
        block.paint = [label, value, labelWidth, style = m_style, missing = field.missing](
                          QPainter &painter, const QRectF &area) {
            label.draw(painter, area.topLeft(), style.quiet);
            value.draw(painter, area.topLeft() + QPointF(labelWidth, 0.0),
                missing ? style.missing : style.text);
        };
        return block;
    }

    void table(const CertificateTable &table, std::vector<FlowBlock> &blocks) const
    {
        const TableTexts texts = textsOf(table);
        const std::vector<double> widths = tableWidths(texts);
        if (!table.caption.arguments.empty() || *table.caption.text) {
            blocks.push_back(text(m_words(table.caption), m_style.body, m_style.text, 8.0));
            blocks.back().keepWithNext = true;
            blocks.back().height += 3.0;
        }
        const auto header
            = std::make_shared<const FlowBlock>(row(table, texts.headings, widths, true));
        blocks.push_back(*header);
        blocks.back().keepWithNext = true;
        for (std::size_t i = 0; i < table.rows.size(); ++i) {
            FlowBlock block = row(table, texts.rows[i], widths, false);
            block.repeatedHeader = header;
            // Neither the first nor the last row of a table stands alone on a page.
            block.keepWithNext = table.rows.size() > 2 && (i == 0 || i + 2 == table.rows.size());
            blocks.push_back(std::move(block));
        }
    }

    FlowBlock figure(const PlotContent &content, const QString &caption) const
    {
        PlotContent drawn = content;
        drawn.title.clear(); // the caption says it
        const bool square = content.equalAspect;
        const double width = square ? std::min(m_width, kPoleZeroWidth) : m_width;
        const double height = square ? kPoleZeroHeight : kFigureHeight;
        const FlowText words(caption, m_style.body, m_width, m_device);
        FlowBlock block;
        block.height = height + 4.0 + words.height();
        block.spaceBefore = 14.0;
        block.paint = [drawn, words, width, height, color = m_style.text](
                          QPainter &painter, const QRectF &area) {
            const double left = area.left() + 0.5 * (area.width() - width);
            PlotWidget::paint(painter, QRectF(left, area.top(), width, height), drawn);
            words.draw(painter, area.topLeft() + QPointF(0.0, height + 4.0), color);
        };
        return block;
    }

private:
    /// The words of a table, whose columns are narrow.
    struct TableTexts
    {
        QStringList headings;
        std::vector<QStringList> rows;
    };

    /// Numbers with their units where the columns have room for it, else broken where they must.
    TableTexts textsOf(const CertificateTable &table) const
    {
        const auto made = [&](const auto &shaped) {
            TableTexts texts;
            for (const CertificateColumn &column : table.columns)
                texts.headings << shaped(m_words.inTable(column.heading));
            for (const std::vector<Message> &cells : table.rows) {
                texts.rows.emplace_back();
                for (const Message &cell : cells)
                    texts.rows.back() << shaped(m_words.inTable(cell));
            }
            return texts;
        };
        TableTexts kept = made([](const QString &words) { return keptTogether(words); });
        const std::vector<double> least = columnsOf(kept).least;
        const bool fits = std::accumulate(least.begin(), least.end(), 0.0) <= m_width;
        return fits ? kept : made([](const QString &words) { return words; });
    }

    struct ColumnSizes
    {
        std::vector<double> natural;
        std::vector<double> least;
    };

    ColumnSizes columnsOf(const TableTexts &texts) const
    {
        constexpr double kPadding = 2.0 * kCellPadding;
        const auto count = static_cast<std::size_t>(texts.headings.size());
        ColumnSizes sizes{std::vector<double>(count, 1.0), std::vector<double>(count, 1.0)};
        for (std::size_t c = 0; c < count; ++c) {
            const auto at = static_cast<qsizetype>(c);
            // Headings may wrap: only their longest word counts as natural.
            const double word
                = FlowText::longestWord(texts.headings[at], m_style.tableBold, m_device) + kPadding;
            double &natural = sizes.natural[c], &least = sizes.least[c];
            natural = least = std::max(1.0, word);
            for (const QStringList &cells : texts.rows) {
                const QString &words = cells[at];
                natural = std::max(
                    natural, FlowText::naturalWidth(words, m_style.table, m_device) + kPadding);
                least = std::max(
                    least, FlowText::longestWord(words, m_style.table, m_device) + kPadding);
            }
        }
        return sizes;
    }

    std::vector<double> tableWidths(const TableTexts &texts) const
    {
        const ColumnSizes sizes = columnsOf(texts);
        return columnWidths(sizes.natural, sizes.least, m_width);
    }

    FlowBlock row(const CertificateTable &table, const QStringList &cells,
        const std::vector<double> &widths, bool isHeader) const
    {
        std::vector<FlowText> texts;
        double height = 0.0;
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            const Qt::Alignment side = table.columns[c].number ? Qt::AlignRight : Qt::AlignLeft;
            texts.emplace_back(cells[static_cast<qsizetype>(c)],
                isHeader ? m_style.tableBold : m_style.table, widths[c] - 2.0 * kCellPadding,
                m_device, side);
            height = std::max(height, texts.back().height());
        }
        FlowBlock block;
        block.height = height + 2.0 * kRowPadding;
        block.paint
            = [texts, widths, isHeader, style = m_style](QPainter &painter, const QRectF &area) {
                  if (isHeader)
                      painter.fillRect(area, style.tableHead);
                  painter.setPen(QPen(style.rule, isHeader ? 0.8 : 0.3));
                  painter.drawLine(area.bottomLeft(), area.bottomRight());
                  double left = area.left();
                  for (std::size_t c = 0; c < texts.size(); ++c) {
                      texts[c].draw(painter, QPointF(left + kCellPadding, area.top() + kRowPadding),
                          style.text);
                      left += widths[c];
                  }
              };
        return block;
    }

    const CertificateStyle &m_style;
    const DocumentWords &m_words;
    double m_width;
    QPaintDevice *m_device;
};

/// A column is as wide as the longest word of either language.
CertificateStyle forTwoLanguages(CertificateStyle style)
{
    constexpr int kSmaller = 9;
    style.table.setPixelSize(kSmaller);
    style.tableBold.setPixelSize(kSmaller);
    return style;
}

void addMissing(const CertificateData &data, const CertificateStyle &style,
    const DocumentWords &words, const BlockMaker &make, std::vector<FlowBlock> &blocks)
{
    QStringList labels;
    for (const Message &label : data.missingFields())
        labels += words(label);
    if (labels.isEmpty())
        return;
    blocks.push_back(
        make.text(QCoreApplication::translate("Report", "To be filled in before issue: %1.")
                      .arg(labels.join(QStringLiteral(", "))),
            style.body, style.missing, 6.0));
}

} // namespace

CertificateStyle::CertificateStyle()
    : title(font(22, true))
    , heading(font(14, true))
    , body(font(12))
    , bold(font(12, true))
    , table(font(10))
    , tableBold(font(10, true))
    , small(font(10))
    , mark(font(170, true))
{
}

std::vector<double> columnWidths(
    const std::vector<double> &natural, const std::vector<double> &least, double width)
{
    const double naturalSum = std::accumulate(natural.begin(), natural.end(), 0.0);
    const double leastSum = std::accumulate(least.begin(), least.end(), 0.0);
    std::vector<double> widths(natural.size());
    for (std::size_t c = 0; c < widths.size(); ++c) {
        if (naturalSum <= width)
            widths[c] = natural[c] * width / naturalSum;
        else if (leastSum >= width)
            widths[c] = least[c] * width / leastSum;
        else
            widths[c]
                = least[c] + (natural[c] - least[c]) * (width - leastSum) / (naturalSum - leastSum);
    }
    return widths;
}

std::vector<FlowBlock> certificateBlocks(const CertificateData &data,
    const std::vector<ReportFigure> &figures, const CertificateStyle &given, double width,
    QPaintDevice *device)
{
    const CertificateStyle style = data.secondLanguage.empty() ? given : forTwoLanguages(given);
    const DocumentWords words(data.secondLanguage);
    const BlockMaker make(style, words, width, device);
    std::vector<FlowBlock> blocks;
    blocks.push_back(data.logo.bytes.empty()
            ? make.text(words(data.title), style.title, style.text, 0.0)
            : make.titleWithLogo(words(data.title), ReportLogo(data.logo)));
    blocks.back().bookmark = words(data.title);
    addMissing(data, style, words, make, blocks);
    int figureNumber = 0;
    for (const CertificateSection &section : data.sections) {
        std::vector<FlowBlock> body;
        for (const Message &paragraph : section.paragraphs)
            body.push_back(make.text(words(paragraph), style.body, style.text, 4.0));
        for (std::size_t i = 0; i < section.fields.size(); ++i) {
            body.push_back(make.field(section.fields[i]));
            body.back().spaceBefore = i == 0 ? 5.0 : 0.0;
            body.back().keepWithNext = i == 0 || i + 2 == section.fields.size();
        }
        for (const CertificateTable &table : section.tables)
            make.table(table, body);
        if (!section.notes.empty() && !body.empty())
            body.back().keepWithNext = true; // what a note explains is above it
        for (const Message &note : section.notes)
            body.push_back(make.text(words(note), style.small, style.quiet, 5.0));
        for (const CertificateFigure &figure : section.figures)
            if (const PlotContent *content = findFigure(figures, figure.id))
                body.push_back(make.figure(*content,
                    QCoreApplication::translate("Report", "Figure %1. %2.")
                        .arg(++figureNumber)
                        .arg(words(figure.caption))));
        if (body.empty())
            continue; // a section without content has no heading
        for (FlowBlock &block : body) // fields: it is signed
            block.isSignature = section.id == kSignatureSection && !section.fields.empty();
        blocks.push_back(make.heading(words(section.title)));
        std::move(body.begin(), body.end(), std::back_inserter(blocks));
    }
    blocks.back().keepWithNext = true; // the end alone is no page
    blocks.push_back(make.text(data.isCertificate
            ? QCoreApplication::translate("Report", "End of the certificate")
            : QCoreApplication::translate("Report", "End of the report"),
        style.small, style.quiet, 14.0));
    return blocks;
}

} // namespace dyncal
