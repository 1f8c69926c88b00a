// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QScreen>
#include <QWidget>

namespace dyncal {

/// A first size for a window that belongs to the screen of `beside`: nine tenths of it at most.
inline QSize withinScreen(const QWidget &beside, QSize wanted)
{
    constexpr double kMostOfScreen = 0.9;
    return wanted.boundedTo(kMostOfScreen * beside.screen()->availableGeometry().size());
}

} // namespace dyncal
