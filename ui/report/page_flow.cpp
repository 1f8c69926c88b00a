// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/page_flow.h"

#include <QFontMetricsF>
#include <QTextLayout>

#include <algorithm>

namespace dyncal {

namespace {

constexpr QChar kSoftHyphen(0x00ad);

QString withoutSoftHyphens(QString line)
{
    return line.remove(kSoftHyphen);
}

double spaceBefore(const FlowBlock &block, double top)
{
    return top > 0.0 ? block.spaceBefore : 0.0;
}

/// Height of the block at `first` with all that must stay with it.
double chainHeight(const std::vector<FlowBlock> &blocks, std::size_t first, double top)
{
    double height = spaceBefore(blocks[first], top) + blocks[first].height;
    for (std::size_t i = first; blocks[i].keepWithNext && i + 1 < blocks.size(); ++i)
        height += blocks[i + 1].spaceBefore + blocks[i + 1].height;
    return height;
}

std::unique_ptr<QTextLayout> layOut(const QString &text, const QFont &font, double width,
    QPaintDevice *device, Qt::Alignment alignment, double &height)
{
    auto layout = std::make_unique<QTextLayout>(text, font, device);
    QTextOption option(alignment);
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout->setTextOption(option);
    layout->beginLayout();
    height = 0.0;
    for (QTextLine line = layout->createLine(); line.isValid(); line = layout->createLine()) {
        line.setLineWidth(width);
        line.setPosition(QPointF(0.0, height));
        height += line.height();
    }
    layout->endLayout();
    return layout;
}

} // namespace

std::vector<PlacedBlock> placeBlocks(const std::vector<FlowBlock> &blocks, double pageHeight)
{
    std::vector<PlacedBlock> placed;
    int page = 0;
    double top = 0.0;
    bool chained = false; // the block before must stay with this one
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const FlowBlock &block = blocks[i];
        const bool chainFits = top + chainHeight(blocks, i, top) <= pageHeight;
        const bool blockFits = top + spaceBefore(block, top) + block.height <= pageHeight;
        if (top > 0.0 && (chained ? !blockFits : !chainFits)) {
            ++page;
            top = 0.0;
        }
        PlacedBlock place{i, page, top + spaceBefore(block, top), false};
        if (top == 0.0 && block.repeatedHeader) {
            place.withHeader = true;
            top += block.repeatedHeader->height;
            place.top = top;
        }
        placed.push_back(place);
        top = place.top + block.height;
        chained = block.keepWithNext;
    }
    return placed;
}

int pageCount(const std::vector<PlacedBlock> &placed)
{
    return placed.empty() ? 1 : placed.back().page + 1;
}

FlowText::FlowText(const QString &text, const QFont &font, double width, QPaintDevice *device,
    Qt::Alignment alignment)
    : m_text(text)
    , m_font(font)
    , m_width(width)
    , m_device(device)
    , m_alignment(alignment)
{
    m_text.replace(QLatin1Char('\n'), QChar::LineSeparator);
    layOut(m_text, m_font, m_width, m_device, m_alignment, m_height);
}

void FlowText::draw(QPainter &painter, const QPointF &topLeft, const QColor &color) const
{
    double height = 0.0;
    const auto layout = layOut(m_text, m_font, m_width, m_device, m_alignment, height);
    painter.setPen(color);
    layout->draw(&painter, topLeft);
}

double FlowText::naturalWidth(const QString &text, const QFont &font, QPaintDevice *device)
{
    const QFontMetricsF metrics(font, device);
    double widest = 0.0;
    for (const QString &line : text.split(QLatin1Char('\n')))
        widest = std::max(widest, metrics.horizontalAdvance(withoutSoftHyphens(line)));
    return widest;
}

double FlowText::longestWord(const QString &text, const QFont &font, QPaintDevice *device)
{
    const QFontMetricsF metrics(font, device);
    double widest = 0.0;
    // A no-break space belongs to its word: only real spaces and line ends separate words. A soft
    // hyphen is shown where the line ends there.
    for (const QString &line : text.split(QLatin1Char('\n')))
        for (const QString &word : line.split(QLatin1Char(' '))) {
            const QStringList parts = word.split(kSoftHyphen);
            for (const QString &part : parts)
                widest = std::max(widest,
                    metrics.horizontalAdvance(
                        &part == &parts.back() ? part : part + QLatin1Char('-')));
        }
    return widest;
}

} // namespace dyncal
