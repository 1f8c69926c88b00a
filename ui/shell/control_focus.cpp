// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/control_focus.h"

#include "ui/stages/frame/layout_scale.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QScrollArea>
#include <QTabWidget>
#include <QTableWidget>
#include <QTimer>

#include <algorithm>

namespace dyncal {

namespace {

bool isHardlySeen(const QWidget &widget)
{
    const QRect seen = widget.visibleRegion().boundingRect();
    return seen.width() < std::min(widget.width(), scale::kLeastTarget)
        || seen.height() < std::min(widget.height(), scale::kLeastTarget);
}

void scrollTo(QWidget &widget)
{
    for (QWidget *parent = widget.parentWidget(); parent; parent = parent->parentWidget()) {
        if (auto *scroll = qobject_cast<QScrollArea *>(parent))
            scroll->ensureWidgetVisible(&widget);
        else if (auto *view = qobject_cast<QAbstractItemView *>(parent))
            view->scrollTo(view->indexAt(widget.mapTo(view->viewport(), widget.rect().center())));
    }
}

/// The part of a control that takes the keys: its value rather than its box "auto".
QWidget *focusableOf(QWidget &control)
{
    const auto takesFocus = [](const QWidget &widget) {
        return widget.focusPolicy() != Qt::NoFocus && widget.isEnabled();
    };
    if (takesFocus(control))
        return &control;
    QWidget *found = nullptr;
    for (QWidget *part : control.findChildren<QWidget *>()) {
        const bool isValue = part->objectName() == control.objectName() + "Value"
            || part->objectName() == control.objectName() + "Begin";
        if (takesFocus(*part) && (!found || isValue))
            found = part;
    }
    return found;
}

void focus(QWidget &control)
{
    QWidget *child = &control;
    for (QWidget *parent = control.parentWidget(); parent; parent = parent->parentWidget()) {
        if (auto *tabs = qobject_cast<QTabWidget *>(parent)) {
            for (int i = 0; i < tabs->count(); ++i)
                if (tabs->widget(i) == child || tabs->widget(i)->isAncestorOf(&control))
                    tabs->setCurrentIndex(i);
        } else if (auto *scroll = qobject_cast<QScrollArea *>(parent)) {
            scroll->ensureWidgetVisible(&control);
        }
        child = parent;
    }
    QWidget *target = focusableOf(control);
    if (!target)
        return;
    target->setFocus(Qt::OtherFocusReason);
    // A page that was never shown is laid out behind this event, and what was in view moves.
    QTimer::singleShot(0, target, [target] {
        if (target->hasFocus() && isHardlySeen(*target))
            scrollTo(*target);
    });
}

} // namespace

QWidget *controlIn(QWidget &root, const QString &name)
{
    if (!name.endsWith('*'))
        return root.findChild<QWidget *>(name);
    for (QWidget *widget : root.findChildren<QWidget *>())
        if (widget->objectName().startsWith(name.chopped(1)))
            return widget;
    return nullptr;
}

void bringIntoView(QWidget &page, QWidget &inspector, const QString &name)
{
    QWidget *control = name.isEmpty() ? nullptr : controlIn(page, name);
    if (!control && !name.isEmpty())
        control = controlIn(inspector, name);
    if (control)
        focus(*control);
    else
        page.setFocus(Qt::OtherFocusReason);
}

void keepFocusInView(QWidget &window)
{
    QObject::connect(
        qApp, &QApplication::focusChanged, &window, [&window](QWidget *, QWidget *now) {
            if (now && window.isAncestorOf(now) && isHardlySeen(*now))
                scrollTo(*now);
        });
}

void selectShot(QWidget &page, Index shot)
{
    auto *table = page.findChild<QTableWidget *>("shotTable");
    if (table && page.window()->focusWidget() == table && shot > 0)
        table->setCurrentCell(static_cast<int>(shot) - 1, 0);
}

} // namespace dyncal
