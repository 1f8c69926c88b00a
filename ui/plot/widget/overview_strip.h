// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/interval.h"
#include "ui/plot/values/plot_content.h"

#include <QPixmap>
#include <QWidget>

#include <vector>

namespace dyncal {

class PlotWidget;

/// A narrow strip with the whole length of the curves of a plot and a box around the part that the
/// plot shows. Dragging the box moves the view, dragging an edge of it zooms, a press beside it
/// moves it there, a double click shows everything. Several plots may follow one strip: they then
/// always show the same stretch; the strip draws the curves of the first.
class OverviewStrip : public QWidget
{
    Q_OBJECT

public:
    explicit OverviewStrip(QWidget *parent = nullptr);

    void follow(PlotWidget *plot);

    Interval whole() const { return m_whole; } ///< all of the curves' x
    /// The box in pixels of this widget: for tests that use the mouse.
    QRectF box() const;
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;

private:
    enum class Grip { None, Begin, End, Box };

    void takeContent();
    void redraw();
    void drawCurve(QPainter &painter, const PlotCurve &curve, Interval y) const;
    QRect area() const;
    double pixelOf(double x) const;
    double xAt(double pixel) const;
    Grip gripAt(double pixel) const;
    void showX(Interval x);

    std::vector<PlotWidget *> m_plots;
    Interval m_whole{0.0, 0.0};
    QPixmap m_picture; ///< null: to be drawn
    QRect m_drawnArea;
    Grip m_grip = Grip::None;
    Interval m_before; ///< of the box when it was grabbed
    double m_grabbedAt = 0.0;
};

} // namespace dyncal
