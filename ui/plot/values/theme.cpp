// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/values/theme.h"

#include <algorithm>
#include <iterator>

namespace dyncal {

namespace {

struct Colors
{
    ThemeKind kind;
    const char *name;
    const char *window;
    const char *base; ///< of fields and lists
    const char *alternateBase;
    const char *button;
    const char *text;
    const char *quiet; ///< placeholders
    const char *disabled;
    const char *highlight;
    const char *highlightedText;
    const char *link;
    const char *outline;
};

// Text on each of its grounds at least 4.5:1, outlines and what is disabled 3:1 (tested).
constexpr Colors kColors[] = {
    {ThemeKind::Light, "light", "#F2F2F2", "#FFFFFF", "#F5F7FA", "#E9E9E9", "#1A1A1A", "#666666",
        "#767676", "#2A65A8", "#FFFFFF", "#1A5FB4", "#858585"},
    {ThemeKind::Dark, "dark", "#2A2A2A", "#1E1E1E", "#262626", "#383838", "#E8E8E8", "#A8A8A8",
        "#959595", "#2F62A0", "#FFFFFF", "#8AB8F0", "#8A8A8A"},
    {ThemeKind::HighContrast, "high-contrast", "#000000", "#000000", "#101010", "#000000",
        "#FFFFFF", "#D0D0D0", "#B0B0B0", "#FFD84A", "#000000", "#7FD0FF", "#FFFFFF"},
};

const Colors &colorsOf(ThemeKind kind)
{
    return *std::ranges::find(kColors, kind, &Colors::kind);
}

QPalette paletteOf(const Colors &colors)
{
    const QColor window(colors.window);
    const QColor button(colors.button);
    QPalette palette(button, window);
    const auto set = [&](QPalette::ColorRole role, const char *color) {
        palette.setColor(QPalette::All, role, QColor(color));
    };
    set(QPalette::Base, colors.base);
    set(QPalette::AlternateBase, colors.alternateBase);
    set(QPalette::ToolTipBase, colors.base);
    set(QPalette::PlaceholderText, colors.quiet);
    set(QPalette::Highlight, colors.highlight);
    set(QPalette::HighlightedText, colors.highlightedText);
    set(QPalette::Link, colors.link);
    set(QPalette::LinkVisited, colors.link);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text,
             QPalette::ButtonText, QPalette::ToolTipText, QPalette::BrightText})
        set(role, colors.text);
    for (const QPalette::ColorRole role :
        {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::PlaceholderText})
        palette.setColor(QPalette::Disabled, role, QColor(colors.disabled));
    return palette;
}

PlotTheme plotsOf(ThemeKind kind)
{
    switch (kind) {
    case ThemeKind::Light:
        break;
    case ThemeKind::Dark:
        return darkPlots();
    case ThemeKind::HighContrast:
        return highContrastPlots();
    }
    return lightPlots();
}

} // namespace

Theme themeOf(ThemeKind kind)
{
    const Colors &colors = colorsOf(kind);
    return {kind, paletteOf(colors), QColor(colors.outline), plotsOf(kind)};
}

ThemeKind themeKindOf(const QPalette &palette)
{
    const QColor window = palette.color(QPalette::Window);
    for (const Colors &colors : kColors)
        if (window == QColor(colors.window))
            return colors.kind;
    return window.lightness() < 128 ? ThemeKind::Dark : ThemeKind::Light;
}

PlotTheme screenTheme(const QPalette &palette, const QFont &font)
{
    PlotTheme theme = plotsOf(themeKindOf(palette));
    theme.font = font;
    return theme;
}

QString themeName(ThemeKind kind)
{
    return QString::fromLatin1(colorsOf(kind).name);
}

ThemeKind themeKindFromName(const QString &name)
{
    for (const Colors &colors : kColors)
        if (name == QLatin1String(colors.name))
            return colors.kind;
    return ThemeKind::Light;
}

} // namespace dyncal
