// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/values/plot_content.h"

#include <QColor>
#include <QFont>

namespace dyncal {

enum class MarkerShape {
    None,
    Dot,
    Circle,
    TriangleUp,
    TriangleDown,
    Square,
    Diamond,
    Cross,
    Plus,
    Star,
    CrossInBox
};

/// How curves of one role look. Colour, dash and marker always differ together, so that no
/// distinction rests on colour alone.
struct RoleStyle
{
    QColor color;
    Qt::PenStyle dash = Qt::SolidLine;
    double width = 1.0;
    MarkerShape marker = MarkerShape::None;
};

/// The colours of a plot that belong to no curve. All opaque: a PDF/A page knows no alpha.
struct PlotTheme
{
    bool dark = false;
    double lineScale = 1.0; ///< of all lines of curves
    QFont font;
    QColor background;
    QColor text;
    QColor axis;
    QColor grid;
    QColor fineGrid;
    QColor bandFill;
    QColor handle; ///< edges of bands, lines
    QColor focus; ///< ring, focused handle
    QColor readoutFill;
    double fading = 0.0; ///< share of the background in the colours of curves, 0 to 1

    RoleStyle style(CurveRole role, int variant = 0) const;
};

PlotTheme lightPlots();
PlotTheme darkPlots();
PlotTheme highContrastPlots(); ///< on black

/// Always light, with a font size in pixels of a 96 dpi page: the same bytes on every screen.
PlotTheme printTheme();

} // namespace dyncal
