// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QLabel>

namespace dyncal {

/// A sentence over the curves of a plot.
class PlotNotice : public QLabel
{
    Q_OBJECT

public:
    explicit PlotNotice(QWidget *plot);

    void say(const QString &sentence); ///< empty: it goes
    void placeIn(const QRect &axes); ///< in the upper part of the axes, as wide as they allow
};

} // namespace dyncal
