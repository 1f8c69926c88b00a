// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/qcp/qcp_label.h"
#include "ui/plot/values/plot_handle_state.h"
#include "ui/plot/values/plot_theme.h"

#include <qcustomplot.h>

#include <optional>
#include <vector>

namespace dyncal {

enum class HandlePart { Begin, End, Whole };

/// One part of one handle: what the pointer grabs and what the keyboard moves.
struct HandleGrip
{
    QString id;
    HandlePart part = HandlePart::Whole;
    bool operator==(const HandleGrip &) const = default;
};

/// Bands and lines of one plot as items: geometry, drawing, hit testing. No events.
class PlotHandles
{
public:
    explicit PlotHandles(QCustomPlot &plot);

    void set(const HandleState &state); ///< new or changed
    void remove(const QString &id, bool isLine);
    const HandleState *find(const QString &id) const;
    const std::vector<HandleState> &states() const { return m_states; }
    /// Every grip that can move, in the order of Tab.
    std::vector<HandleGrip> grips() const;

    /// The grip within reach of a pixel position, edges before labels.
    std::optional<HandleGrip> gripAt(const QPointF &position) const;
    /// State of the handle after its grip is put to `x`; edges never pass each other.
    HandleState moved(const HandleState &before, const HandleGrip &grip, double x) const;
    /// Where the grip is drawn (the begin of a band moved as a whole).
    double positionOf(const HandleGrip &grip) const;
    void setFocus(const std::optional<HandleGrip> &grip);

    void setTheme(const PlotTheme &theme);

private:
    struct Items
    {
        QCPItemRect *fill = nullptr;
        QCPItemLine *begin = nullptr;
        QCPItemLine *end = nullptr;
        PlotLabel *label = nullptr;
    };
    Items makeItems(const HandleState &state);
    QCPItemLine *makeLine();
    void place(std::size_t position);
    void placeLabels();
    void paint(std::size_t position);

    QCustomPlot &m_plot;
    PlotTheme m_theme;
    std::optional<HandleGrip> m_focus;
    std::vector<HandleState> m_states;
    std::vector<Items> m_items; ///< same order as m_states
};

} // namespace dyncal
