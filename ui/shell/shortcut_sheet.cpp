// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/shortcut_sheet.h"

#include <QAction>
#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

namespace dyncal {

namespace {

/// Gives the sentences below their translation context.
struct Sheet
{
    Q_DECLARE_TR_FUNCTIONS(Help)
};

void collect(const QList<QAction *> &actions, std::vector<std::pair<QString, QString>> &rows)
{
    for (const QAction *action : actions) {
        if (const auto *menu = action->menu<QMenu *>()) {
            collect(menu->actions(), rows);
            continue;
        }
        QStringList keys;
        for (const QKeySequence &sequence : action->shortcuts())
            keys << sequence.toString(QKeySequence::NativeText);
        if (!keys.isEmpty())
            rows.emplace_back(keys.join(QStringLiteral(", ")), plainText(*action));
    }
}

} // namespace

QString plainText(const QAction &action)
{
    QString text = action.text();
    text.replace(QLatin1String("&&"), QLatin1String("\x01"));
    text.remove('&').replace('\x01', '&');
    return text.endsWith(QLatin1String("...")) ? text.chopped(3) : text;
}

std::vector<std::pair<QString, QString>> shortcutsOf(const QMainWindow &window)
{
    std::vector<std::pair<QString, QString>> rows;
    if (const auto *bar = qobject_cast<const QMenuBar *>(window.menuWidget()))
        collect(bar->actions(), rows);
    return rows;
}

std::vector<std::pair<QString, QString>> plotShortcuts()
{
    return {
        {Sheet::tr("Wheel, +, -"), Sheet::tr("zoom the x axis at the pointer")},
        {Sheet::tr("Ctrl+wheel"), Sheet::tr("zoom the y axis")},
        {Sheet::tr("Shift+wheel, left drag, arrows"), Sheet::tr("move the plot")},
        {Sheet::tr("Right drag"), Sheet::tr("zoom a box")},
        {Sheet::tr("Shift+drag (Window)"), Sheet::tr("mark a stretch to be left out of the fit")},
        {Sheet::tr("Double click, F"), Sheet::tr("show everything")},
        {Sheet::tr("Backspace"), Sheet::tr("the view before; with Shift the one after")},
        {Sheet::tr("G"), Sheet::tr("grid on or off")},
        {Sheet::tr("1, 2"), Sheet::tr("put cursor A or B at the pointer; the mouse drags it")},
        {Sheet::tr("Ctrl+Left, Ctrl+Right"),
            Sheet::tr("move the cursor placed last by one sample; with Shift by ten")},
        {Sheet::tr("Ctrl+G"), Sheet::tr("go to a place that is typed")},
        {Sheet::tr("Tab"), Sheet::tr("to the next handle; Left and Right move it")},
        {Sheet::tr("Escape"),
            Sheet::tr("ends a drag as if it had not been, then takes cursors away")},
        {Sheet::tr("Left, Right (Order)"), Sheet::tr("order minus or plus one")},
        {Sheet::tr("Page Up, Page Down (Order)"), Sheet::tr("order plus or minus ten")},
        {Sheet::tr("Home (Order)"), Sheet::tr("take the suggested order")},
    };
}

} // namespace dyncal
