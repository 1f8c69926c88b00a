// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/values/cursor_values.h"
#include "ui/stages/frame/value_table.h"

#include <QPointer>

namespace dyncal {

class PlotWidget;

/// What all curves of one plot are at its cursors, in a small window over the page: it follows the
/// cursors and the curves.
class CursorTable : public QWidget
{
    Q_OBJECT

public:
    explicit CursorTable(QWidget *page);

    void follow(PlotWidget *plot); ///< and shows itself

private:
    void showValues();

    QPointer<PlotWidget> m_plot;
    ValueTable *m_table;
};

} // namespace dyncal
