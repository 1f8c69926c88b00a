// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/interval.h"
#include "ui/plot/qcp/qcp_cursors.h"
#include "ui/plot/qcp/qcp_handles.h"
#include "ui/plot/qcp/qcp_scene.h"

#include <QObject>

namespace dyncal {

/// A range moved by a fraction of itself, along the axis' own scale.
QCPRange shiftedRange(const QCPAxis &axis, const QCPRange &range, double fraction);

/// What is in view.
struct View
{
    QCPRange x, y;
};

/// One plot on show: content, handles, cursors, and the view with its history. Positions are pixels
/// of the inner QCustomPlot. It handles no events: PlotMouse and PlotKeyboard do. Its signals
/// report what has happened; PlotWidget passes them on.
class PlotCanvas : public QObject
{
    Q_OBJECT

public:
    explicit PlotCanvas(QWidget &owner);

    QWidget &owner() { return m_owner; }
    QCustomPlot &plot() { return *m_plot; }
    PlotScene &scene() { return m_scene; }
    PlotHandles &handles() { return m_handles; }
    PlotCursors &cursors() { return m_cursors; }

    void setContent(const PlotContent &content);
    void applyTheme(); ///< that of the owner's palette and font
    void setDimmed(bool dimmed); ///< pale curves: what they show is out of date
    bool isDimmed() const { return m_isDimmed; }
    /// Height of title, legend and labels as drawn last, beside that of the axes.
    int heightBesideAxes() const { return m_plot->height() - m_plot->axisRect()->height(); }
    void replot();

    View view() const { return {m_plot->xAxis->range(), m_plot->yAxis->range()}; }
    void setView(const View &view);
    void fitView();
    void pan(double xFraction, double yFraction);
    void zoomBy(double factor);
    void remember(); ///< keeps the view, to go back to it
    void goBack(bool forward);

    void placeCursor(int which, const CurvePoint &point);
    void moveCursor(int which, const CurvePoint &point); ///< by the operator: others follow
    /// Cursor A to the sample nearest to `x`, in the middle of the view.
    void goTo(double x);
    void clearCursors();
    const std::optional<HandleGrip> &focusedGrip() const { return m_focused; }
    void focusGrip(const std::optional<HandleGrip> &grip);

signals:
    void replotted(); ///< after the pixels are up to date
    void xRangeChanged(dyncal::Interval x); ///< other than by setting content
    void handleMoved(const dyncal::HandleState &state, bool finished);
    void handleDragCancelled(const dyncal::HandleState &before); ///< it stands there again
    void spanMarked(dyncal::Interval x);
    void markingChanged(bool on);
    void pointPicked(double x, double y);
    void cursorPlaced(int which, double x);
    void cursorsCleared();
    void cursorsChanged(); ///< by anybody, or the curves beneath them
    void fitRequested();
    void goToRequested();
    void menuRequested(const QPoint &globalPosition);

private:
    void replotDecorations();
    void fitContent(const PlotContent &before);

    QWidget &m_owner;
    QCustomPlot *m_plot; ///< child of the owner, shows only; all events are handled by the owner
    PlotScene m_scene;
    PlotHandles m_handles;
    PlotCursors m_cursors;
    bool m_isReplotQueued = false;
    bool m_isDimmed = false;
    bool m_hasView = false; ///< a content with data has been fitted
    View m_fitted; ///< the view as it was last fitted to a content
    std::vector<View> m_back, m_forward;
    std::optional<HandleGrip> m_focused;
};

} // namespace dyncal
