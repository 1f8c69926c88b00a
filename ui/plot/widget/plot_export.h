// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/values/plot_content.h"
#include "ui/plot/values/plot_handle_state.h"

#include <QImage>

#include <memory>
#include <optional>
#include <vector>

class QIODevice;
class QPainter;

namespace dyncal {

/// One plot as it is to be drawn off screen: the content with the view and the handles on it.
struct PlotPicture
{
    std::shared_ptr<const PlotContent> content;
    std::optional<Interval> x; ///< empty: fitted
    std::optional<Interval> y;
    std::vector<HandleState> handles;
};

/// Draws into `target` as vectors, light, opaque colours, without a background.
void paintPicture(QPainter &painter, const QRectF &target, const PlotPicture &picture);

QImage renderPicture(const PlotPicture &picture, QSize size, double scale);

/// Writes the picture as "png", "svg" or "pdf"; false if that failed.
bool writePicture(const PlotPicture &picture, QSize size, const QString &format, QIODevice &device);

/// The same in memory; empty if that failed.
std::optional<QByteArray> pictureBytes(
    const PlotPicture &picture, QSize size, const QString &format);

enum class TableFormat {
    Csv, ///< commas, '.' as decimal mark
    Paste, ///< tabs, the decimal mark of the language: what a spreadsheet takes
};

/// The curves as a table: one x column if all curves share it, else a pair of columns per curve. SI
/// units, shortest round-trip numbers, LF; empty cells for missing numbers.
QString contentTable(const PlotContent &content, TableFormat format);

} // namespace dyncal
