// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/preferences/theme_style.h"

#include <QApplication>
#include <QPainter>
#include <QPixmapCache>
#include <QStyleFactory>
#include <QStyleOption>
#include <QToolTip>

namespace dyncal {

namespace {

constexpr double kFocus_px = 2.0;
constexpr double kCorner_px = 2.0;

} // namespace

ThemeStyle::ThemeStyle(const Theme &theme)
    : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion")))
    , m_outline(theme.outline)
    , m_focus(theme.plots.focus)
{
}

void ThemeStyle::drawPrimitive(PrimitiveElement element, const QStyleOption *option,
    QPainter *painter, const QWidget *widget) const
{
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    switch (element) {
    case PE_PanelButtonCommand:
    case PE_IndicatorCheckBox:
    case PE_IndicatorItemViewItemCheck:
        outline(*option, *painter);
        break;
    case PE_FrameLineEdit:
        if (option->rect.isValid())
            outline(*option, *painter);
        break;
    default:
        break;
    }
}

int ThemeStyle::styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
    QStyleHintReturn *returned) const
{
    // Qt's icons are drawn for one theme, and only some buttons have one.
    return hint == SH_DialogButtonBox_ButtonsHaveIcons
        ? 0
        : QProxyStyle::styleHint(hint, option, widget, returned);
}

void ThemeStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex *option,
    QPainter *painter, const QWidget *widget) const
{
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (control == CC_SpinBox || control == CC_ComboBox)
        outline(*option, *painter);
}

void ThemeStyle::outline(const QStyleOption &option, QPainter &painter) const
{
    const bool focused
        = option.state.testFlag(State_HasFocus) && option.state.testFlag(State_Enabled);
    const double width = focused ? kFocus_px : 1.0;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(focused ? m_focus : m_outline, width));
    const double inset = 0.5 * width;
    painter.drawRoundedRect(
        QRectF(option.rect).adjusted(inset, inset, -inset, -inset), kCorner_px, kCorner_px);
    painter.restore();
}

void useTheme(ThemeKind kind)
{
    // The style keeps a picture of every frame, button and arrow in every size they ever had, and
    // Qt 6.4 the name of each for ever, cleared or not: a window resized all day would grow. Drawn
    // anew each time they cost a twentieth of a page.
    QPixmapCache::setCacheLimit(0);
    const Theme theme = themeOf(kind);
    QApplication::setStyle(new ThemeStyle(theme));
    QApplication::setPalette(theme.palette);
    QToolTip::setPalette(theme.palette);
}

} // namespace dyncal
