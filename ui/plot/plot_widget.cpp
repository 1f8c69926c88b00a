// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/plot_widget_private.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QMenu>
#include <QMimeData>
#include <QStyle>
#include <QToolTip>

#include <limits>

namespace dyncal {

namespace {

constexpr int kRing_px = 2; ///< width of the focus ring around the plot

bool sameAxis(const PlotAxis &a, const PlotAxis &b)
{
    return a.quantity == b.quantity && a.unit == b.unit && a.logarithmic == b.logarithmic;
}

} // namespace

PlotWidget::Private::Private(PlotWidget *widget)
    : q(widget)
    , plot(new QCustomPlot(widget))
    , scene(*plot)
    , handles(*plot)
    , cursors(*plot)
    , rubberBand(new QRubberBand(QRubberBand::Rectangle, widget))
{
    plot->setAttribute(Qt::WA_TransparentForMouseEvents);
    plot->setFocusPolicy(Qt::NoFocus);
    plot->setPlottingHints(QCP::phFastPolylines | QCP::phCacheLabels);
    rubberBand->hide();
    QObject::connect(plot, &QCustomPlot::afterReplot, q, [this] {
        isReplotQueued = false;
        emit q->replotted();
    });
    QObject::connect(plot->xAxis, qOverload<const QCPRange &>(&QCPAxis::rangeChanged), q,
        [this](const QCPRange &x) {
            emit q->xRangeChanged({x.lower, x.upper});
        });
}

void PlotWidget::Private::replot()
{
    isReplotQueued = true;
    plot->replot(QCustomPlot::rpQueuedReplot);
}

void PlotWidget::Private::replotDecorations()
{
    if (isReplotQueued)
        return; // they come with it
    scene.replotDecorations();
    emit q->replotted();
}

void PlotWidget::Private::applyTheme()
{
    const PlotTheme theme = screenTheme(q->palette(), q->font());
    scene.setTheme(theme);
    handles.setTheme(theme);
    cursors.refresh(scene);
    replot();
}

void PlotWidget::Private::fitView()
{
    scene.fitX();
    scene.fitY();
}

void PlotWidget::Private::fitContent(const PlotContent &before)
{
    const PlotContent &now = scene.content();
    if (hasView && !scene.hasData() && sameAxis(now.xAxis, before.xAxis)
        && sameAxis(now.yAxis, before.yAxis))
        return; // a moment without curves (a model that diverges): the view waits for the next
    const View shown = view();
    const auto isFirst = [&](bool moved) { return before.growing ? !moved : !hasView; };
    if (isFirst(shown.x != fitted.x) || !sameAxis(now.xAxis, before.xAxis)) {
        const QSignalBlocker quiet(q);
        scene.fitX();
        fitted.x = plot->xAxis->range();
    }
    if (!hasView || isFirst(shown.y != fitted.y) || !sameAxis(now.yAxis, before.yAxis)) {
        scene.fitY();
        fitted.y = plot->yAxis->range();
    }
    hasView = scene.hasData();
}

void PlotWidget::Private::setView(const View &view)
{
    plot->xAxis->setRange(view.x);
    plot->yAxis->setRange(view.y);
    replot();
}

PlotPicture PlotWidget::Private::picture() const
{
    const View shown = view();
    return {scene.sharedContent(), Interval{shown.x.lower, shown.x.upper},
        Interval{shown.y.lower, shown.y.upper}, handles.states()};
}

void PlotWidget::Private::announce(const HandleState &state, bool finished)
{
    if (state.isLine)
        emit q->lineMoved(state.id, state.x.begin, finished);
    else
        emit q->bandMoved(state.id, state.x, finished);
}

PlotWidget::PlotWidget(QWidget *parent)
    : QWidget(parent)
    , d(std::make_unique<Private>(this))
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    d->applyTheme();
}

PlotWidget::~PlotWidget() = default;

void PlotWidget::setContent(const PlotContent &content)
{
    const std::shared_ptr<const PlotContent> before = d->scene.sharedContent();
    const auto now = std::make_shared<const PlotContent>(content);
    const bool decorationsOnly = d->scene.moveDecorations(now);
    if (!decorationsOnly) {
        d->scene.setContent(now);
        d->fitContent(*before);
        d->cursors.refresh(d->scene);
    }
    setAccessibleName(content.title);
    setAccessibleDescription(content.summary);
    if (decorationsOnly)
        d->replotDecorations();
    else
        d->replot();
    emit contentChanged();
}

const PlotContent &PlotWidget::content() const
{
    return d->scene.content();
}

void PlotWidget::fit()
{
    d->remember();
    d->fitView();
    d->replot();
}

void PlotWidget::setBand(const QString &id, const QString &label, Interval x, bool movable)
{
    d->handles.set({id, label, false, x, movable, false});
    d->replot();
}

void PlotWidget::setHatchedBand(const QString &id, const QString &label, Interval x)
{
    d->handles.set({id, label, false, x, true, false, true});
    d->replot();
}

void PlotWidget::removeBand(const QString &id)
{
    d->handles.remove(id, false);
    d->replot();
}

void PlotWidget::setLine(const QString &id, const QString &label, double x, bool snapToIntegers)
{
    d->handles.set({id, label, true, {x, x}, true, snapToIntegers});
    d->replot();
}

void PlotWidget::removeLine(const QString &id)
{
    d->handles.remove(id, true);
    d->replot();
}

void PlotWidget::setMarkable(bool markable)
{
    d->markable = markable;
}

void PlotWidget::setMarking(bool on)
{
    if (d->marking == on)
        return;
    d->marking = on;
    setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
    emit markingChanged(on);
}

QPoint PlotWidget::pixelOf(double x, double y) const
{
    const QPointF inner(d->plot->xAxis->coordToPixel(x), d->plot->yAxis->coordToPixel(y));
    return d->plot->mapTo(this, inner.toPoint());
}

Interval PlotWidget::xRange() const
{
    return {d->plot->xAxis->range().lower, d->plot->xAxis->range().upper};
}

void PlotWidget::setXRange(Interval x)
{
    d->plot->xAxis->setRange(x.begin, x.end);
    d->replot();
}

QRect PlotWidget::axesRect() const
{
    return d->plot->axisRect()->rect().translated(d->plot->pos());
}

Interval PlotWidget::yRange() const
{
    return {d->plot->yAxis->range().lower, d->plot->yAxis->range().upper};
}

void PlotWidget::paint(QPainter &painter, const QRectF &target, const PlotContent &content)
{
    paintPicture(painter, target, {std::make_shared<const PlotContent>(content), {}, {}, {}});
}

void PlotWidget::setLegendVisible(bool visible)
{
    d->scene.setLegendVisible(visible);
    d->replot();
}

QString PlotWidget::cursorReadout() const
{
    return d->cursors.readout(d->scene.content());
}

void PlotWidget::followCursor(int which, std::optional<double> x)
{
    if (x)
        d->cursors.place(which, {0, *x, std::numeric_limits<double>::quiet_NaN()});
    else
        d->cursors.clear();
    d->cursors.refresh(d->scene);
    d->replot();
}

QSize PlotWidget::sizeHint() const
{
    return {480, 300};
}

QSize PlotWidget::minimumSizeHint() const
{
    return {160, 110};
}

bool PlotWidget::exportImage(const QString &path) const
{
    return savePicture(d->picture(), d->plot->size(), path);
}

QString PlotWidget::csv() const
{
    return contentCsv(d->scene.contentInView());
}

void PlotWidget::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange
        || event->type() == QEvent::StyleChange)
        d->applyTheme();
}

void PlotWidget::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    const QRect inner = rect().adjusted(kRing_px, kRing_px, -kRing_px, -kRing_px);
    if (inner.isEmpty()) // a splitter folded it away: there is nothing to paint on
        return;
    d->plot->setGeometry(inner);
    d->replot();
}

void PlotWidget::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), hasFocus() ? d->scene.theme().focus : d->scene.theme().background);
}

void PlotWidget::showMenu(const QPoint &globalPosition)
{
    QMenu menu(this);
    menu.addAction(tr("Copy image"), this, [this] {
        QApplication::clipboard()->setImage(renderPicture(d->picture(), d->plot->size(), 2.0));
    });
    menu.addAction(tr("Copy data"), this, [this] { QApplication::clipboard()->setText(csv()); });
    menu.addAction(tr("Export..."), this, &PlotWidget::exportWithDialog);
    menu.addSeparator();
    menu.addAction(tr("Fit"), this, &PlotWidget::fit);
    QAction *grid = menu.addAction(tr("Grid"), this, [this](bool visible) {
        d->scene.setGridVisible(visible);
        d->replot();
    });
    grid->setCheckable(true);
    grid->setChecked(d->scene.isGridVisible());
    menu.exec(globalPosition);
}

void PlotWidget::exportWithDialog()
{
    const QString path = QFileDialog::getSaveFileName(this, tr("Export plot"), QString(),
        tr("Vector image (*.svg);;Image (*.png);;PDF (*.pdf);;Data (*.csv)"));
    if (path.isEmpty())
        return;
    bool done = false;
    if (path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)) {
        QSaveFile file(path);
        done = file.open(QIODevice::WriteOnly) && file.write(csv().toUtf8()) >= 0 && file.commit();
    } else {
        done = exportImage(path);
    }
    if (!done)
        QToolTip::showText(mapToGlobal(rect().center()),
            tr("The plot could not be written to %1; choose a folder that can be written and a "
               "name that ends in .svg, .png, .pdf or .csv.")
                .arg(path),
            this);
}

} // namespace dyncal
