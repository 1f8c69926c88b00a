// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/widget/plot_export.h"

#include "core/base/number_text.h"
#include "core/results/csv_table.h"
#include "ui/plot/qcp/qcp_handles.h"
#include "ui/plot/qcp/qcp_scene.h"
#include "ui/plot/values/axis_prefix.h"
#include "ui/text/shown_text.h"

#include <QBuffer>
#include <QPdfWriter>
#include <QPicture>
#include <QSvgGenerator>

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

constexpr int kPageDpi = 96;
constexpr double kImageScale = 2.0;
constexpr int kPrintColumnsPerPixel = 3; ///< columns of an envelope: finer than print shows

/// Records the plot, 1:1 in pixels of a 96 dpi page, to be played by any painter: QCustomPlot
/// itself draws only with its own painter class.
QPicture record(const PlotPicture &picture, QSize size)
{
    QCustomPlot plot;
    plot.setViewport(QRect(QPoint(0, 0), size));
    PlotScene scene(plot);
    scene.setColumnsPerPixel(kPrintColumnsPerPixel);
    scene.setTheme(printTheme());
    scene.setContent(picture.content);
    plot.setBackground(Qt::NoBrush); // what lies under the plot on its page stays visible
    PlotHandles handles(plot);
    handles.setTheme(printTheme());
    for (const HandleState &state : picture.handles)
        handles.set(state);
    scene.fitX();
    scene.fitY();
    if (picture.x)
        plot.xAxis->setRange(picture.x->begin, picture.x->end);
    if (picture.y)
        plot.yAxis->setRange(picture.y->begin, picture.y->end);
    scene.prepare();

    QPicture recorded;
    QCPPainter painter(&recorded);
    painter.setMode(QCPPainter::pmVectorized);
    painter.setMode(QCPPainter::pmNoCaching);
    plot.toPainter(&painter, size.width(), size.height());
    painter.end();
    return recorded;
}

bool saveSvg(const PlotPicture &picture, QSize size, QIODevice &device)
{
    QSvgGenerator generator;
    generator.setOutputDevice(&device);
    generator.setResolution(kPageDpi);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(0, 0), size));
    // Qt 6.4 writes title and description into the SVG without escaping them.
    generator.setTitle(picture.content->title.toHtmlEscaped());
    generator.setDescription(picture.content->summary.toHtmlEscaped());
    QPainter painter;
    if (!painter.begin(&generator))
        return false;
    painter.fillRect(QRect(QPoint(0, 0), size), printTheme().background);
    paintPicture(painter, QRectF(QPointF(0, 0), size), picture);
    return painter.end();
}

bool savePdf(const PlotPicture &picture, QSize size, QIODevice &device)
{
    QPdfWriter writer(&device);
    writer.setResolution(kPageDpi);
    const double points = 72.0 / kPageDpi;
    writer.setPageSize(QPageSize(QSizeF(size) * points, QPageSize::Point));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    writer.setTitle(picture.content->title);
    QPainter painter;
    if (!painter.begin(&writer))
        return false;
    paintPicture(painter, QRectF(QPointF(0, 0), size), picture);
    return painter.end();
}

QString cell(const std::vector<double> &values, std::size_t row, TableFormat format)
{
    if (row >= values.size() || !std::isfinite(values[row]))
        return {};
    QString number = rawText(numberText(values[row]));
    return format == TableFormat::Csv ? number : number.replace('.', plotLocale().decimalPoint());
}

QString heading(const QString &name, const PlotAxis &axis, TableFormat format)
{
    const QString quantity = name.isEmpty() ? axis.quantity : name;
    const QString text = axisLabel(quantity, axis.unit, {});
    return format == TableFormat::Csv ? rawText(csvCell(text.toStdString())) : pasted(text);
}

} // namespace

void paintPicture(QPainter &painter, const QRectF &target, const PlotPicture &picture)
{
    const QSize size = target.size().toSize();
    if (size.isEmpty())
        return;
    const QPicture recorded = record(picture, size);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(target.topLeft());
    painter.drawPicture(0, 0, recorded);
    painter.restore();
}

QImage renderPicture(const PlotPicture &picture, QSize size, double scale)
{
    QImage image(size * scale, QImage::Format_RGB32);
    image.fill(printTheme().background);
    QPainter painter(&image);
    painter.scale(scale, scale);
    paintPicture(painter, QRectF(QPointF(0, 0), size), picture);
    return image;
}

bool writePicture(const PlotPicture &picture, QSize size, const QString &format, QIODevice &device)
{
    if (size.isEmpty())
        return false;
    if (format == QLatin1String("png"))
        return renderPicture(picture, size, kImageScale).save(&device, "PNG");
    if (format == QLatin1String("svg"))
        return saveSvg(picture, size, device);
    return format == QLatin1String("pdf") && savePdf(picture, size, device);
}

std::optional<QByteArray> pictureBytes(
    const PlotPicture &picture, QSize size, const QString &format)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly) || !writePicture(picture, size, format, buffer))
        return std::nullopt;
    return bytes;
}

QString contentTable(const PlotContent &content, TableFormat format)
{
    const QChar separator = format == TableFormat::Csv ? ',' : '\t';
    const std::vector<PlotCurve> &curves = content.curves;
    const bool shared = std::all_of(curves.begin(), curves.end(),
        [&curves](const PlotCurve &curve) { return curve.x == curves.front().x; });
    QStringList headings;
    std::vector<const std::vector<double> *> columns;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (i == 0 || !shared) {
            const QString name = shared ? QString() : content.xAxis.quantity + " " + curves[i].name;
            headings += heading(name, content.xAxis, format);
            columns.push_back(&curves[i].x);
        }
        const bool second = curves[i].onSecondAxis && content.yAxis2;
        headings += heading(curves[i].name, second ? *content.yAxis2 : content.yAxis, format);
        columns.push_back(&curves[i].y);
    }
    std::size_t rows = 0;
    for (const std::vector<double> *column : columns)
        rows = std::max(rows, column->size());
    QString text = headings.join(separator) + QLatin1Char('\n');
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t c = 0; c < columns.size(); ++c)
            text += (c ? QString(separator) : QString()) + cell(*columns[c], row, format);
        text += QLatin1Char('\n');
    }
    return text;
}

} // namespace dyncal
