// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/values/theme.h"

#include <QProxyStyle>

namespace dyncal {

/// Qt's own "Fusion" style with the outlines of a theme, so that fields and buttons are seen on any
/// ground, and a focus ring of two pixels.
class ThemeStyle : public QProxyStyle
{
    Q_OBJECT

public:
    explicit ThemeStyle(const Theme &theme);

    void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
        const QWidget *widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex *option,
        QPainter *painter, const QWidget *widget) const override;
    int styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
        QStyleHintReturn *returned) const override;

private:
    void outline(const QStyleOption &option, QPainter &painter) const;

    QColor m_outline;
    QColor m_focus;
};

/// Style and palette of the whole program.
void useTheme(ThemeKind kind);

} // namespace dyncal
