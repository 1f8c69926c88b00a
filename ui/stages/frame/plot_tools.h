// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/widget/plot_widget.h"

namespace dyncal {

class CursorTable;
class SharedCursors;

/// What a page gives its plots beside what they do by themselves: the field that asks where to go,
/// and the table of values, which is hidden and shown with the page.
class PlotTools : public QObject
{
    Q_OBJECT

public:
    explicit PlotTools(QWidget *page);

    void attach(PlotWidget *plot);
    /// The cursors of the plot stand where those of all others stand that share them.
    static void share(PlotWidget *plot, SharedCursors *cursors);
    void setTableVisible(bool visible); ///< if it was asked for

private:
    void showTable(PlotWidget *plot);

    QWidget *m_page;
    CursorTable *m_table = nullptr; ///< made when first asked for
    bool m_isHiddenWithPage = false;
};

} // namespace dyncal
