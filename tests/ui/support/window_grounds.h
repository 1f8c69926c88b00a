// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/ui/support/layout_faults.h"
#include "ui/shell/preferences/language.h"
#include "ui/shell/preferences/theme_style.h"

#include <QTest>

namespace dyncal::test {

/// What cannot be read of a window once it is laid out: on a busy machine that may take some looks.
inline QStringList faultsThatStay(QWidget &window)
{
    constexpr int kSettle_ms = 100; // for words and layouts that come by the event loop
    constexpr int kLooks = 5;
    QStringList faults;
    for (int look = 0; look < kLooks && (look == 0 || !faults.isEmpty()); ++look) {
        QTest::qWait(kSettle_ms);
        faults = LayoutFaults(window).found();
    }
    return faults;
}

/// What cannot be read of a window on every ground; DYNCAL_SHOTS=FOLDER keeps pictures.
inline QString faultsOnEveryGround(QWidget &window, const Language &language)
{
    QStringList faults;
    const QString shots = qEnvironmentVariable("DYNCAL_SHOTS");
    for (const ThemeKind theme : {ThemeKind::Light, ThemeKind::Dark, ThemeKind::HighContrast}) {
        useTheme(theme);
        faults += faultsThatStay(window);
        if (!shots.isEmpty())
            window.grab().save(
                QString("%1/%2-%3-%4.png")
                    .arg(shots, window.objectName(), themeName(theme), language.code()));
    }
    useTheme(ThemeKind::Light);
    return faults.join('\n');
}

} // namespace dyncal::test
