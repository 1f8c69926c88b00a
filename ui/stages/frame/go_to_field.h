// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/widget/plot_widget.h"

#include <QLineEdit>

namespace dyncal {

/// A field in the corner of a plot: where to go, typed with its unit or in that of the axis. Enter
/// goes there; what cannot be taken, or lies outside the curves, is said below the field. It leaves
/// with Esc, with the focus, and when it is done.
class GoToField : public QLineEdit
{
    Q_OBJECT

public:
    explicit GoToField(PlotWidget &plot);

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    bool event(QEvent *event) override; ///< Esc and Enter come before shortcuts

private:
    void go();
    void close();

    PlotWidget &m_plot;
};

} // namespace dyncal
