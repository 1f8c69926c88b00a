// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QObject>

#include <vector>

namespace dyncal {

class PlotWidget;

/// Plots of one axis below each other begin at one place, so that what is above each other belongs
/// to one time or frequency: each has the left margin of the one that needs most. A margin once
/// needed is kept until letters or style change, or plots would jump under the hand.
class AlignedPlots : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    void add(PlotWidget *plot);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void setMargin(int left_px);

    std::vector<PlotWidget *> m_plots;
    int m_left_px = 0;
};

} // namespace dyncal
