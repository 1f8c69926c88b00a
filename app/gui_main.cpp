// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui_main.h"

#include <QApplication>
#include <QMainWindow>

namespace dyncal {

int runGui(int argc, char **argv, const std::vector<std::string> &)
{
    const QApplication application(argc, argv);
    QMainWindow window;
    window.setWindowTitle(QStringLiteral("Dyncal"));
    window.show();
    return QApplication::exec();
}

} // namespace dyncal
