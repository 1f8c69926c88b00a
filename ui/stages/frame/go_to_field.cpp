// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/go_to_field.h"

#include "ui/plot/values/axis_prefix.h"
#include "ui/stages/frame/layout_scale.h"
#include "ui/stages/frame/refusal_note.h"
#include "ui/text/typed_quantity.h"

#include <QKeyEvent>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kWidth_chars = 30;
constexpr int kReachDigits = 4;

/// The unit that the axis is labelled with.
ShownUnit axisUnit(const PlotWidget &plot)
{
    const PlotAxis &axis = plot.content().xAxis;
    const QString &unit = axis.unit;
    const AxisPrefix prefix = prefixOf(axis, plot.xRange().begin, plot.xRange().end);
    if (!takesPrefix(unit))
        return {unit, 1.0};
    return {prefix.symbol + unit, prefix.factor};
}

std::optional<Interval> reachOf(const PlotContent &content)
{
    std::optional<Interval> reach;
    for (const PlotCurve &curve : content.curves)
        for (const double x : curve.x)
            reach = reach ? Interval{std::min(reach->begin, x), std::max(reach->end, x)}
                          : Interval{x, x};
    return reach;
}

} // namespace

GoToField::GoToField(PlotWidget &plot)
    : QLineEdit(&plot)
    , m_plot(plot)
{
    setObjectName("goToField");
    setAttribute(Qt::WA_DeleteOnClose);
    setAccessibleName(tr("Go to"));
    const QString unit = axisUnit(plot).text;
    setPlaceholderText(unit.isEmpty() ? tr("Go to") : tr("Go to, in %1").arg(unit));
    const QRect axes = plot.axesRect();
    const int width = std::min(
        kWidth_chars * fontMetrics().averageCharWidth(), axes.width() - 2 * scale::kSmall);
    setGeometry(
        axes.left() + scale::kSmall, axes.top() + scale::kSmall, width, sizeHint().height());
    show();
    setFocus();
}

void GoToField::go()
{
    const ShownUnit unit = axisUnit(m_plot);
    const TypedQuantity typed = typedQuantity(text(), unit);
    const std::optional<Interval> reach = reachOf(m_plot.content());
    const double x = typed.value.value_or(0.0) * unit.si;
    const QString si = m_plot.content().xAxis.unit;
    if (!typed.value)
        showRefusal(this, typed.fault);
    else if (!reach || x < reach->begin || x > reach->end)
        showRefusal(this,
            !reach ? tr("There is no curve to go to.")
                   : tr("Nothing is shown at %1: the curves reach from %2 to %3.")
                         .arg(valueWithUnit(x, si, kReachDigits),
                             valueWithUnit(reach->begin, si, kReachDigits),
                             valueWithUnit(reach->end, si, kReachDigits)));
    else {
        m_plot.goTo(x);
        close();
    }
}

void GoToField::close()
{
    hideRefusal(this);
    m_plot.setFocus();
    QLineEdit::close();
}

bool GoToField::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    return QLineEdit::event(event);
}

void GoToField::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape)
        close();
    else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        go();
    else
        QLineEdit::keyPressEvent(event);
}

void GoToField::focusOutEvent(QFocusEvent *event)
{
    QLineEdit::focusOutEvent(event);
    if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason) {
        hideRefusal(this);
        QLineEdit::close();
    }
}

/// Also when its page is left: the focus must not come back to it with the page.
void GoToField::hideEvent(QHideEvent *event)
{
    QLineEdit::hideEvent(event);
    clearFocus();
    deleteLater();
}

} // namespace dyncal
