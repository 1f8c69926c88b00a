// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/interval.h"
#include "ui/plot/values/cursor_values.h"
#include "ui/plot/values/plot_content.h"
#include "ui/plot/values/plot_handle_state.h"
#include "ui/plot/values/plot_text.h"

#include <QWidget>

#include <memory>
#include <vector>

class QMenu;
class QPainter;

namespace dyncal {

/// The only plot of the program: wraps QCustomPlot, so that zoom, pan, cursors, handles, theme and
/// export are the same everywhere. Setting content keeps the view (zoom, pan); only fit() and the
/// first content change it (a content that is still growing counts as the first until it is
/// complete or the operator moves the view). It knows values only: no results, no session.
///
/// Mouse: wheel zooms x at the pointer, Ctrl+wheel y, Shift+wheel pans; left drag pans; right drag
/// zooms a box; double click fits; hover shows the nearest point. Keys: F fit, G grid, 1 / 2 put
/// cursor A / B at the pointer (then the mouse drags them, and Ctrl+arrows move the last one by
/// samples), Ctrl+G asks where to go, arrows move the focused handle by one step (signals
/// bandMoved, lineMoved; Shift: ten steps) or else the view, + / - zoom, Backspace the view before,
/// Tab the next handle, Esc ends a drag and restores, or removes the cursors. Where spans can be
/// marked (setMarkable): Shift and left drag, or left drag while setMarking is on.
class PlotWidget : public QWidget
{
    Q_OBJECT

public:
    explicit PlotWidget(QWidget *parent = nullptr);
    ~PlotWidget() override;

    void setContent(const PlotContent &content);
    const PlotContent &content() const;
    void fit();

    /// A sentence over the curves: why there are none, or why those on show are out of date and
    /// pale (`dimmed`). Empty takes it away.
    void setNotice(const QString &sentence, bool dimmed);
    QString notice() const;
    bool isDimmed() const;

    /// A draggable band over x with two edges; `id` names it in signals. Drawn behind the curves,
    /// hatched where it cannot be moved.
    void setBand(const QString &id, const QString &label, Interval x, bool movable = true);
    /// A draggable band, hatched: what it covers takes no part.
    void setHatchedBand(const QString &id, const QString &label, Interval x);
    void removeBand(const QString &id);
    /// A draggable vertical line. With `snapToIntegers` it stops between whole numbers
    /// (the cut in the singular values: value n means "keep n").
    void setLine(const QString &id, const QString &label, double x, bool snapToIntegers = false);
    void removeLine(const QString &id);
    const std::vector<HandleState> &handles() const; ///< bands and lines as they stand
    /// Whether the operator holds one of them: it is not to be set meanwhile.
    bool isHandleDragged() const;

    /// Shift and left drag mark a span of x (spanMarked).
    void setMarkable(bool markable);
    /// The next left drag marks a span, even if it begins on a handle; this drag or Esc ends the
    /// mode.
    void setMarking(bool on);

    /// Pixel position (widget coordinates) of a plot coordinate: for tests that use the mouse.
    QPoint pixelOf(double x, double y) const;
    QRect axesRect() const; ///< where curves are drawn, widget coordinates
    Interval xRange() const;
    void setXRange(Interval x); ///< y stays
    /// What is written in the plot and where, after it was drawn.
    std::vector<PlotText> texts() const;
    Interval yRange() const;

    /// Draws the plot as vectors, light theme, opaque colours, no background, into `target` of a
    /// painter (PDF, SVG). Text and pens are sized in millimetres of a page at 96 dpi.
    static void paint(QPainter &painter, const QRectF &target, const PlotContent &content);

    /// The legend is shown above the plot by itself when two or more curves have names; a click
    /// on an entry hides or shows its curve, Ctrl+click shows it alone.
    void setLegendVisible(bool visible);

    /// Readings of the cursors as shown ("A: 1.2 µs; 0.98 V"), empty without cursors.
    QString cursorReadout() const;

    /// What all visible curves are where the cursors stand.
    CursorValues cursorValues() const;
    /// Puts cursor A on the sample nearest to `x`, in the middle of the view.
    void goTo(double x);

    /// Puts cursor A (0) or B (1) at `x`, where another plot has it; without `x` both are removed.
    void followCursor(int which, std::optional<double> x);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    /// The plot as a file of a format: "png", "svg", "pdf" or "csv" (csv()), as large as on the
    /// screen without a size; empty of any other, and where it cannot be drawn.
    std::optional<QByteArray> fileBytes(const QString &format, QSize size = {}) const;
    /// The plotted numbers at full precision, '.' as decimal mark; of a long record those of the
    /// present view: its samples when they are few, else extremes of pixel columns.
    QString csv() const;
    /// The same for a spreadsheet: cells joined by tabs, the decimal mark of the language.
    QString dataToPaste() const;

signals:
    void exportRequested(); ///< by the menu, which offers what somebody listens to
    void goToRequested(); ///< likewise, and by Ctrl+G
    void cursorTableRequested(); ///< likewise
    void bandMoved(const QString &id, dyncal::Interval x, bool finished); ///< finished = released
    void lineMoved(const QString &id, double x, bool finished);
    /// Esc ended the drag of a band or line: it stands where it stood before, and what was done at
    /// its moves is to be taken back.
    void dragCancelled(const QString &id, dyncal::Interval x);
    void spanMarked(dyncal::Interval x);
    void markingChanged(bool on); ///< also when it ends by itself
    void pointPicked(double x, double y); ///< plain click, at the nearest data point
    void xRangeChanged(dyncal::Interval x); ///< other than by setting content
    void contentChanged(); ///< and the view fitted to it, if it has to be
    void cursorPlaced(int which, double x); ///< by the operator
    void cursorsCleared(); ///< likewise
    void cursorsChanged(); ///< by anybody, or the values beneath them
    void replotted(); ///< after the pixels are up to date

protected:
    void changeEvent(QEvent *event) override; ///< follows the palette (light, dark)
    bool event(QEvent *event) override; ///< tool tip; Esc ends a drag before shortcuts see it
    void resizeEvent(QResizeEvent *event) override;
    void paintEvent(QPaintEvent *event) override; ///< focus ring
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    bool focusNextPrevChild(bool next) override; ///< Tab walks through the handles first
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    void connectCanvas();
    void showMenu(const QPoint &globalPosition);
    void addToMenu(QMenu &menu, const QString &text, void (PlotWidget::*signal)());

    struct Parts;
    std::unique_ptr<Parts> d;
};

} // namespace dyncal
