// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QRectF>
#include <QString>

namespace dyncal {

/// A text as a plot drew it last.
struct PlotText
{
    QString text;
    QRectF rect; ///< pixels of the plot widget
    bool isWhole = true; ///< not shortened, nor cut off by the axes or the plot
};

} // namespace dyncal
