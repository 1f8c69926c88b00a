// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/values/plot_theme.h"

#include <QPalette>

#include <array>

namespace dyncal {

enum class ThemeKind { Light, Dark, HighContrast };
inline constexpr std::array kThemeKinds{ThemeKind::Light, ThemeKind::Dark, ThemeKind::HighContrast};

/// How the program looks on the screen, whatever the desktop's colours are: what palette, style and
/// plots take. Print has a look of its own (printTheme).
struct Theme
{
    ThemeKind kind = ThemeKind::Light;
    QPalette palette;
    QColor outline; ///< of fields, buttons and frames
    PlotTheme plots; ///< without font
};

Theme themeOf(ThemeKind kind);

/// The one whose palette this is; of any other palette light or dark, after its window colour.
ThemeKind themeKindOf(const QPalette &palette);

/// For plots on a widget.
PlotTheme screenTheme(const QPalette &palette, const QFont &font);

/// "light", "dark", "high-contrast": as it is remembered.
QString themeName(ThemeKind kind);
ThemeKind themeKindFromName(const QString &name); ///< Light for any other word

} // namespace dyncal
