// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/help_dialogs.h"

#include "core/base/version.h"
#include "ui/shell/shortcut_sheet.h"
#include "ui/stages/frame/within_screen.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QMessageBox>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

namespace dyncal {

namespace {

/// Gives the sentences below their translation context.
struct Help
{
    Q_DECLARE_TR_FUNCTIONS(Help)
};

QString tableOf(const std::vector<std::pair<QString, QString>> &rows)
{
    QString table = "<table cellpadding='2'>";
    for (const auto &[keys, what] : rows)
        table += "<tr><td><b>" + keys.toHtmlEscaped() + "</b></td><td>" + what.toHtmlEscaped()
            + "</td></tr>";
    return table + "</table>";
}

QSize scrollBars(const QScrollArea &area)
{
    return {area.verticalScrollBar()->sizeHint().width(),
        area.horizontalScrollBar()->sizeHint().height()};
}

} // namespace

void showShortcuts(QMainWindow &window)
{
    QDialog dialog(&window);
    dialog.setObjectName("shortcutSheet");
    dialog.setWindowTitle(Help::tr("Keyboard and mouse"));
    auto *layout = new QVBoxLayout(&dialog);
    auto *sheet = new QWidget;
    auto *columns = new QHBoxLayout(sheet);
    for (const auto &[heading, rows] : {std::pair(Help::tr("Everywhere"), shortcutsOf(window)),
             std::pair(Help::tr("In plots"), plotShortcuts())}) {
        auto *table
            = new QLabel("<h4>" + heading.toHtmlEscaped() + "</h4>" + tableOf(rows), &dialog);
        table->setTextFormat(Qt::RichText);
        table->setAlignment(Qt::AlignTop);
        columns->addWidget(table);
    }
    auto *area = new QScrollArea(&dialog);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setWidget(sheet);
    layout->addWidget(area);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, &dialog);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    layout->addWidget(buttons);
    // As large as its tables, which in large letters are larger than the screen.
    const QSize beside = dialog.sizeHint() - area->sizeHint() + scrollBars(*area);
    dialog.resize(withinScreen(window, sheet->sizeHint() + beside));
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
