// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/widget/plot_widget.h"

#include "ui/plot/qcp/qcp_keyboard.h"
#include "ui/plot/qcp/qcp_texts.h"
#include "ui/plot/widget/plot_export.h"
#include "ui/plot/widget/plot_notice.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>
#include <QMetaMethod>

#include <limits>
#include <utility>

namespace dyncal {

namespace {

constexpr int kRing_px = 2; ///< width of the focus ring around the plot
constexpr QSize kLeastSize(200, 130);
constexpr int kLeastAxes = 70;
constexpr int kLeastLinesOfAxes = 5;
constexpr int kLeastLinesOfMap = 10;
constexpr int kLeastColumns = 22;

} // namespace

/// The plot, and the objects that handle the events of the widget.
struct PlotWidget::Parts
{
    explicit Parts(PlotWidget &widget)
        : canvas(widget)
        , mouse(canvas)
        , keyboard(canvas, mouse)
        , plot(canvas.plot())
    {
    }

    PlotPicture picture()
    {
        const View shown = canvas.view();
        return {canvas.scene().sharedContent(), Interval{shown.x.lower, shown.x.upper},
            Interval{shown.y.lower, shown.y.upper}, canvas.handles().states()};
    }

    /// Most height of what stood around the axes at the present width. It does not shrink with the
    /// content: a page must not jump while a hand tries one model after the other.
    int besideAxes = 0;
    PlotCanvas canvas;
    PlotMouse mouse;
    PlotKeyboard keyboard;
    QCustomPlot &plot;
    PlotNotice *notice = nullptr; ///< made with the first sentence
};

PlotWidget::PlotWidget(QWidget *parent)
    : QWidget(parent)
    , d(std::make_unique<Parts>(*this))
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connectCanvas();
    d->canvas.applyTheme();
}

void PlotWidget::connectCanvas()
{
    const PlotCanvas *canvas = &d->canvas;
    connect(canvas, &PlotCanvas::replotted, this, [this] {
        const int needed = std::max(d->besideAxes, d->canvas.heightBesideAxes());
        if (std::exchange(d->besideAxes, needed) != needed)
            updateGeometry();
        emit replotted();
    });
    connect(canvas, &PlotCanvas::xRangeChanged, this, &PlotWidget::xRangeChanged);
    connect(canvas, &PlotCanvas::spanMarked, this, &PlotWidget::spanMarked);
    connect(canvas, &PlotCanvas::markingChanged, this, &PlotWidget::markingChanged);
    connect(canvas, &PlotCanvas::pointPicked, this, &PlotWidget::pointPicked);
    connect(canvas, &PlotCanvas::cursorPlaced, this, &PlotWidget::cursorPlaced);
    connect(canvas, &PlotCanvas::cursorsCleared, this, &PlotWidget::cursorsCleared);
    connect(canvas, &PlotCanvas::cursorsChanged, this, &PlotWidget::cursorsChanged);
    connect(canvas, &PlotCanvas::goToRequested, this, &PlotWidget::goToRequested);
    connect(canvas, &PlotCanvas::fitRequested, this, &PlotWidget::fit);
    connect(canvas, &PlotCanvas::menuRequested, this, &PlotWidget::showMenu);
    connect(
        canvas, &PlotCanvas::handleMoved, this, [this](const HandleState &state, bool finished) {
            if (state.isLine)
                emit lineMoved(state.id, state.x.begin, finished);
            else
                emit bandMoved(state.id, state.x, finished);
        });
    connect(canvas, &PlotCanvas::handleDragCancelled, this,
        [this](const HandleState &before) { emit dragCancelled(before.id, before.x); });
    connect(canvas, &PlotCanvas::replotted, this, [this] {
        if (d->notice)
            d->notice->placeIn(axesRect());
    });
}

PlotWidget::~PlotWidget() = default;

void PlotWidget::setContent(const PlotContent &content)
{
    setAccessibleName(content.title);
    setAccessibleDescription(content.summary);
    const bool isMap = this->content().equalAspect;
    d->canvas.setContent(content);
    if (isMap != content.equalAspect)
        updateGeometry();
    emit contentChanged();
}

const PlotContent &PlotWidget::content() const
{
    return d->canvas.scene().content();
}

void PlotWidget::fit()
{
    d->canvas.remember();
    d->canvas.fitView();
    d->canvas.replot();
}

void PlotWidget::setNotice(const QString &sentence, bool dimmed)
{
    d->canvas.setDimmed(dimmed && !sentence.isEmpty());
    if (!d->notice && sentence.isEmpty())
        return;
    if (!d->notice)
        d->notice = new PlotNotice(this);
    d->notice->say(sentence);
    d->notice->placeIn(axesRect());
}

QString PlotWidget::notice() const
{
    return d->notice && !d->notice->isHidden() ? d->notice->text() : QString();
}

bool PlotWidget::isDimmed() const
{
    return d->canvas.isDimmed();
}

void PlotWidget::setBand(const QString &id, const QString &label, Interval x, bool movable)
{
    d->canvas.handles().set({id, label, false, x, movable, false});
    d->canvas.replot();
}

void PlotWidget::setHatchedBand(const QString &id, const QString &label, Interval x)
{
    d->canvas.handles().set({id, label, false, x, true, false, true});
    d->canvas.replot();
}

void PlotWidget::removeBand(const QString &id)
{
    d->canvas.handles().remove(id, false);
    d->canvas.replot();
}

void PlotWidget::setLine(const QString &id, const QString &label, double x, bool snapToIntegers)
{
    d->canvas.handles().set({id, label, true, {x, x}, true, snapToIntegers});
    d->canvas.replot();
}

void PlotWidget::removeLine(const QString &id)
{
    d->canvas.handles().remove(id, true);
    d->canvas.replot();
}

const std::vector<HandleState> &PlotWidget::handles() const
{
    return d->canvas.handles().states();
}

bool PlotWidget::isHandleDragged() const
{
    return d->mouse.isDraggingHandle();
}

void PlotWidget::setMarkable(bool markable)
{
    d->mouse.setMarkable(markable);
}

void PlotWidget::setMarking(bool on)
{
    d->mouse.setMarking(on);
}

QPoint PlotWidget::pixelOf(double x, double y) const
{
    const QPointF inner(d->plot.xAxis->coordToPixel(x), d->plot.yAxis->coordToPixel(y));
    return d->plot.mapTo(this, inner.toPoint());
}

Interval PlotWidget::xRange() const
{
    return {d->plot.xAxis->range().lower, d->plot.xAxis->range().upper};
}

void PlotWidget::setXRange(Interval x)
{
    d->plot.xAxis->setRange(x.begin, x.end);
    d->canvas.replot();
}

std::vector<PlotText> PlotWidget::texts() const
{
    std::vector<PlotText> texts = textsOf(d->plot, d->canvas.scene());
    for (PlotText &text : texts)
        text.rect.translate(d->plot.pos());
    return texts;
}

QRect PlotWidget::axesRect() const
{
    return d->plot.axisRect()->rect().translated(d->plot.pos());
}

Interval PlotWidget::yRange() const
{
    return {d->plot.yAxis->range().lower, d->plot.yAxis->range().upper};
}

void PlotWidget::paint(QPainter &painter, const QRectF &target, const PlotContent &content)
{
    paintPicture(painter, target, {std::make_shared<const PlotContent>(content), {}, {}, {}});
}

void PlotWidget::setLegendVisible(bool visible)
{
    d->canvas.scene().setLegendVisible(visible);
    d->canvas.replot();
}

QString PlotWidget::cursorReadout() const
{
    return d->canvas.cursors().readout(d->canvas.scene().content());
}

void PlotWidget::followCursor(int which, std::optional<double> x)
{
    if (x)
        d->canvas.placeCursor(which, {0, *x, std::numeric_limits<double>::quiet_NaN()});
    else
        d->canvas.clearCursors();
}

QSize PlotWidget::sizeHint() const
{
    return {480, 300};
}

/// Room for what stands around the axes and for the curves; a map of equal scales needs more of
/// it.
QSize PlotWidget::minimumSizeHint() const
{
    const int line = fontMetrics().lineSpacing();
    const int axes = std::max(
        kLeastAxes, line * (content().equalAspect ? kLeastLinesOfMap : kLeastLinesOfAxes));
    return {std::max(kLeastSize.width(), kLeastColumns * fontMetrics().averageCharWidth()),
        std::max(kLeastSize.height(), d->besideAxes + axes + 2 * kRing_px)};
}

CursorValues PlotWidget::cursorValues() const
{
    return d->canvas.cursors().values(d->canvas.scene());
}

void PlotWidget::goTo(double x)
{
    d->canvas.goTo(x);
}

void PlotWidget::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange
        || event->type() == QEvent::StyleChange) {
        d->besideAxes = 0;
        d->canvas.applyTheme();
    }
}

void PlotWidget::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    const QRect inner = rect().adjusted(kRing_px, kRing_px, -kRing_px, -kRing_px);
    if (inner.isEmpty()) // a splitter folded it away: there is nothing to paint on
        return;
    if (event->size().width() != event->oldSize().width())
        d->besideAxes = 0;
    d->plot.setGeometry(inner);
    d->canvas.replot();
}

void PlotWidget::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(),
        hasFocus() ? d->canvas.scene().theme().focus : d->canvas.scene().theme().background);
}

void PlotWidget::mousePressEvent(QMouseEvent *event)
{
    d->mouse.press(*event);
}

void PlotWidget::mouseMoveEvent(QMouseEvent *event)
{
    d->mouse.move(*event);
}

void PlotWidget::mouseReleaseEvent(QMouseEvent *event)
{
    d->mouse.release(*event);
}

void PlotWidget::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        fit();
}

void PlotWidget::wheelEvent(QWheelEvent *event)
{
    d->mouse.wheel(*event);
    event->accept();
}

void PlotWidget::contextMenuEvent(QContextMenuEvent *event)
{
    // The right button opens the menu on release: a drag with it zooms.
    if (event->reason() == QContextMenuEvent::Keyboard)
        showMenu(mapToGlobal(rect().center()));
    event->accept();
}

void PlotWidget::keyPressEvent(QKeyEvent *event)
{
    if (!d->keyboard.press(*event))
        QWidget::keyPressEvent(event);
}

bool PlotWidget::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride
        && d->keyboard.takesPrecedence(*static_cast<QKeyEvent *>(event))) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

bool PlotWidget::focusNextPrevChild(bool next)
{
    return (hasFocus() && d->keyboard.focusNextGrip(next)) || QWidget::focusNextPrevChild(next);
}

void PlotWidget::focusInEvent(QFocusEvent *event)
{
    QWidget::focusInEvent(event);
    update();
}

void PlotWidget::focusOutEvent(QFocusEvent *event)
{
    QWidget::focusOutEvent(event);
    d->canvas.focusGrip(std::nullopt);
    update();
}

/// What nobody listens to is not offered.
void PlotWidget::addToMenu(QMenu &menu, const QString &text, void (PlotWidget::*signal)())
{
    if (isSignalConnected(QMetaMethod::fromSignal(signal)))
        menu.addAction(text, this, signal);
}

void PlotWidget::showMenu(const QPoint &globalPosition)
{
    // Not on the stack: its plot may be gone before it, when the pages are built anew.
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setObjectName("plotMenu");
    menu->addAction(tr("Copy image"), this, [this] {
        QApplication::clipboard()->setImage(renderPicture(d->picture(), d->plot.size(), 2.0));
    });
    menu->addAction(
        tr("Copy data"), this, [this] { QApplication::clipboard()->setText(dataToPaste()); });
    addToMenu(*menu, tr("Export..."), &PlotWidget::exportRequested);
    menu->addSeparator();
    menu->addAction(tr("Fit"), this, &PlotWidget::fit);
    addToMenu(*menu, tr("Go to..."), &PlotWidget::goToRequested);
    addToMenu(*menu, tr("Values at the cursors"), &PlotWidget::cursorTableRequested);
    QAction *grid = menu->addAction(tr("Grid"), this, [this](bool visible) {
        d->canvas.scene().setGridVisible(visible);
        d->canvas.replot();
    });
    grid->setCheckable(true);
    grid->setChecked(d->canvas.scene().isGridVisible());
    menu->popup(globalPosition);
}

QString PlotWidget::csv() const
{
    return contentTable(d->canvas.scene().contentInView(), TableFormat::Csv);
}

QString PlotWidget::dataToPaste() const
{
    return contentTable(d->canvas.scene().contentInView(), TableFormat::Paste);
}

std::optional<QByteArray> PlotWidget::fileBytes(const QString &format, QSize size) const
{
    if (format == QLatin1String("csv"))
        return csv().toUtf8();
    return pictureBytes(d->picture(), size.isEmpty() ? d->plot.size() : size, format);
}

} // namespace dyncal
