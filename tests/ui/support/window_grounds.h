// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/ui/support/layout_faults.h"
#include "tests/ui/support/still.h"
#include "ui/shell/preferences/language.h"
#include "ui/shell/preferences/theme_style.h"

namespace dyncal::test {

/// Words and layouts come by the event loop.
inline void waitUntilLaidOut(const QWidget &window)
{
    constexpr int kPatience_ms = 5000;
    const auto look = [&window] {
        QList<QRect> places;
        for (const QWidget *widget : window.findChildren<QWidget *>())
            places << widget->geometry();
        return places;
    };
    waitUntilStill(look, kPatience_ms);
}

/// What cannot be read of a window on every ground; DYNCAL_SHOTS=FOLDER keeps pictures.
inline QString faultsOnEveryGround(QWidget &window, const Language &language)
{
    QStringList faults;
    const QString shots = qEnvironmentVariable("DYNCAL_SHOTS");
    for (const ThemeKind theme : {ThemeKind::Light, ThemeKind::Dark, ThemeKind::HighContrast}) {
        useTheme(theme);
        waitUntilLaidOut(window);
        faults += LayoutFaults(window).found();
        if (!shots.isEmpty())
            window.grab().save(
                QString("%1/%2-%3-%4.png")
                    .arg(shots, window.objectName(), themeName(theme), language.code()));
    }
    useTheme(ThemeKind::Light);
    return faults.join('\n');
}

} // namespace dyncal::test
