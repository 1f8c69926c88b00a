// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp/qcp_texts.h"

#include <algorithm>

namespace dyncal {

namespace {

using Texts = std::vector<PlotText>;

QSizeF sizeOf(const QFont &font, const QString &text)
{
    return QFontMetricsF(font).size(0, text);
}

/// Labels of the ticks in view, beside the axes' rectangle.
void addTickLabels(const QCPAxis &axis, Texts &texts)
{
    if (!axis.visible() || !axis.tickLabels())
        return;
    const QRectF axes = axis.axisRect()->rect();
    const double away = std::max(0, axis.tickLengthOut()) + axis.tickLabelPadding();
    const QVector<double> ticks = axis.tickVector();
    const QVector<QString> labels = axis.tickVectorLabels();
    for (qsizetype i = 0; i < std::min(ticks.size(), labels.size()); ++i) {
        if (labels[i].isEmpty() || !axis.range().contains(ticks[i]))
            continue;
        const QSizeF size = sizeOf(axis.tickLabelFont(), labels[i]);
        const double at = axis.coordToPixel(ticks[i]);
        QRectF rect({at - 0.5 * size.width(), axes.bottom() + away}, size);
        if (axis.axisType() == QCPAxis::atLeft)
            rect.moveTopLeft({axes.left() - away - size.width(), at - 0.5 * size.height()});
        else if (axis.axisType() == QCPAxis::atRight)
            rect.moveTopLeft({axes.right() + away, at - 0.5 * size.height()});
        // Figures have no tails: what is seen of them is lower than their line.
        const QFontMetricsF metrics(axis.tickLabelFont());
        const double empty = 0.5 * (size.height() - metrics.tightBoundingRect(labels[i]).height());
        texts.push_back({labels[i], rect.adjusted(0.0, empty, 0.0, -empty), true});
    }
}

/// At the outer edge of the margin, in the middle of its axis.
void addAxisLabel(const QCPAxis &axis, const QRectF &outer, Texts &texts)
{
    if (!axis.visible() || axis.label().isEmpty())
        return;
    const QRectF axes = axis.axisRect()->rect();
    const QSizeF size = sizeOf(axis.labelFont(), axis.label());
    QRectF rect({axes.center().x() - 0.5 * size.width(), outer.bottom() - size.height()}, size);
    if (axis.axisType() != QCPAxis::atBottom) {
        rect = QRectF({outer.left(), axes.center().y() - 0.5 * size.width()}, size.transposed());
        if (axis.axisType() == QCPAxis::atRight)
            rect.moveRight(outer.right());
    }
    texts.push_back({axis.label(), rect, !axis.label().contains(QChar(0x2026))});
}

/// Labels of marks, levels, handles and cursors, where they are in view.
void addItems(const QCustomPlot &plot, Texts &texts)
{
    for (int i = 0; i < plot.itemCount(); ++i) {
        const auto *item = qobject_cast<const QCPItemText *>(plot.item(i));
        if (!item || !item->visible() || item->text().isEmpty())
            continue;
        const QMargins padding = item->padding();
        const QRectF rect
            = QRectF(item->topLeft->pixelPosition(), item->bottomRight->pixelPosition())
                  .marginsRemoved(QMarginsF(padding));
        const QRectF clip = item->clipToAxisRect() ? plot.axisRect()->rect() : plot.viewport();
        const QRectF seen = rect & clip;
        if (seen.width() > 1.0 && seen.height() > 1.0)
            texts.push_back({item->text(), seen,
                seen.width() > rect.width() - 2.0 && seen.height() > rect.height() - 2.0});
    }
}

} // namespace

std::vector<PlotText> textsOf(const QCustomPlot &plot, const PlotScene &scene)
{
    Texts texts;
    const QRectF outer = plot.axisRect()->outerRect();
    for (const QCPAxis *axis : {plot.xAxis, plot.yAxis, plot.yAxis2}) {
        addTickLabels(*axis, texts);
        addAxisLabel(*axis, outer, texts);
    }
    addItems(plot, texts);
    scene.addTexts(texts);
    return texts;
}

} // namespace dyncal
