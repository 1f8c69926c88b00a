// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QFont>

/// One scale of distances (pixels) and of type for pages, inspectors and docks.
namespace dyncal::scale {

inline constexpr int kHair = 2;
inline constexpr int kSmall = 4;
inline constexpr int kMedium = 8; ///< margins; between rows of controls
inline constexpr int kLarge = 12; ///< between groups
inline constexpr int kHuge = 20;

inline constexpr int kLeastPlot = 120; ///< a plot is never lower; its page scrolls or folds instead
inline constexpr int kLeastTarget = 24; ///< of the mouse

/// Type: headings of pages, of groups, and all the rest.
inline QFont title(QFont font)
{
    font.setPointSizeF(1.4 * font.pointSizeF());
    font.setBold(true);
    return font;
}

inline QFont heading(QFont font)
{
    font.setBold(true);
    return font;
}

} // namespace dyncal::scale
