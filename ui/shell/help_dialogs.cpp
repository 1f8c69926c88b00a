// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/help_dialogs.h"

#include "core/base/version.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QMessageBox>
#include <QVBoxLayout>

namespace dyncal {

namespace {

/// Gives the sentences below their translation context.
struct Help
{
    Q_DECLARE_TR_FUNCTIONS(Help)
};

QString shortcutTable()
{
    const std::pair<QString, QString> rows[] = {
        {Help::tr("Alt+1 … Alt+9"), Help::tr("go to a stage")},
        {Help::tr("Ctrl+Z, Ctrl+Shift+Z"), Help::tr("undo, redo")},
        {Help::tr("Wheel"), Help::tr("zoom the x axis at the pointer")},
        {Help::tr("Ctrl+wheel"), Help::tr("zoom the y axis")},
        {Help::tr("Shift+wheel, left drag"), Help::tr("move the plot")},
        {Help::tr("Right drag"), Help::tr("zoom a box")},
        {Help::tr("Shift+drag (Window)"), Help::tr("mark a stretch to be left out of the fit")},
        {Help::tr("Double click, F"), Help::tr("show everything")},
        {Help::tr("G"), Help::tr("grid on or off")},
        {Help::tr("1, 2"), Help::tr("put cursor A or B at the pointer")},
        {Help::tr("Left, Right (Order)"), Help::tr("order minus or plus one")},
        {Help::tr("Page Up, Page Down (Order)"), Help::tr("order plus or minus ten")},
        {Help::tr("Home (Order)"), Help::tr("take the suggested order")},
        {Help::tr("F9"), Help::tr("compute again")},
        {Help::tr("F4, F5, F6"), Help::tr("inspector, stages, findings on or off")},
    };
    QString table = "<table cellpadding='3'>";
    for (const auto &[keys, what] : rows)
        table += "<tr><td><b>" + keys.toHtmlEscaped() + "</b></td><td>" + what.toHtmlEscaped()
            + "</td></tr>";
    return table + "</table>";
}

} // namespace

void showShortcuts(QWidget *parent)
{
    QDialog dialog(parent);
    dialog.setWindowTitle(Help::tr("Keyboard and mouse"));
    auto *layout = new QVBoxLayout(&dialog);
    auto *table = new QLabel(shortcutTable(), &dialog);
    table->setTextFormat(Qt::RichText);
    layout->addWidget(table);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, &dialog);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    layout->addWidget(buttons);
    dialog.exec();
}

void showAbout(QWidget *parent)
{
    QMessageBox box(QMessageBox::NoIcon, Help::tr("About Dyncal"),
        Help::tr(
            "<h3>Dyncal %1</h3><p>Dynamic calibration of pressure sensors.</p>"
            "<p>Build %2</p><p>Copyright 2026 The Dyncal authors. Free software under the GNU General Public License, version 3 or later. It comes with no warranty.</p>")
            .arg(versionText(), buildText()),
        QMessageBox::Ok, parent);
    box.setTextFormat(Qt::RichText);
    box.setIconPixmap(parent->windowIcon().pixmap(64));
    box.exec();
}

} // namespace dyncal
