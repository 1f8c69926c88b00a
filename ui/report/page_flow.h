// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QFont>
#include <QPainter>
#include <QRectF>
#include <QString>

#include <functional>
#include <memory>
#include <vector>

namespace dyncal {

/// A piece of a page that is never split: a paragraph, a table row, a figure with its caption.
struct FlowBlock
{
    double height = 0.0;
    double spaceBefore = 0.0; ///< not at the top of a page
    bool keepWithNext = false; ///< never the last on a page
    std::function<void(QPainter &, const QRectF &)> paint;
    /// Drawn above the block when it is the first on a page: a table's heading.
    std::shared_ptr<const FlowBlock> repeatedHeader;
    QString bookmark; ///< its line in the document's list of contents; empty: none
    bool isSignature = false; ///< a signature is to be seen over it
};

/// Where one block stands; the header stands above it.
struct PlacedBlock
{
    std::size_t block = 0;
    int page = 0; ///< from 0
    double top = 0.0; ///< from the top of the text area
    bool withHeader = false;
};

/// Puts blocks on pages of the given text height. Blocks that keep with the next move to a new page
/// together, unless they fill more than a page.
std::vector<PlacedBlock> placeBlocks(const std::vector<FlowBlock> &blocks, double pageHeight);

int pageCount(const std::vector<PlacedBlock> &placed);

/// Text in a column, broken at words and, where a word is too long, anywhere. The same code
/// measures and draws, so that what was measured fits.
class FlowText
{
public:
    FlowText(const QString &text, const QFont &font, double width, QPaintDevice *device,
        Qt::Alignment alignment = Qt::AlignLeft);

    double height() const { return m_height; }
    void draw(QPainter &painter, const QPointF &topLeft, const QColor &color) const;

    static double naturalWidth(const QString &text, const QFont &font, QPaintDevice *device);
    static double longestWord(const QString &text, const QFont &font, QPaintDevice *device);

private:
    QString m_text;
    QFont m_font;
    double m_width = 0.0;
    QPaintDevice *m_device = nullptr;
    Qt::Alignment m_alignment;
    double m_height = 0.0;
};

} // namespace dyncal
