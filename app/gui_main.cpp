// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui_main.h"

#include "app/clock.h"
#include "core/base/version.h"
#include "core/pipeline/pipeline.h"
#include "ui/shell/main_window.h"
#include "ui/shell/screenshot_tour.h"

#include <QApplication>
#include <QIcon>

#include <clocale>

namespace dyncal {

namespace {

constexpr const char *kTourOption = "--screenshot-tour";

/// The numbers of C libraries keep '.' whatever the desktop's language.
void prepareApplication()
{
    std::setlocale(LC_NUMERIC, "C");
    QCoreApplication::setApplicationName("dyncal");
    QCoreApplication::setOrganizationName("dyncal");
    QCoreApplication::setApplicationVersion(versionText());
    QGuiApplication::setDesktopFileName("dyncal");
    QApplication::setWindowIcon(QIcon(":/icons/dyncal.svg"));
}

} // namespace

int runGui(int argc, char **argv, const std::vector<std::string> &files)
{
    QApplication application(argc, argv);
    prepareApplication();
    const QStringList arguments = QCoreApplication::arguments();
    const auto tour = arguments.indexOf(kTourOption);

    Preferences preferences;
    Prompts prompts;
    Language language;
    language.install(tour >= 0 ? QString("en") : preferences.language());
    MainWindow window(runPipeline, currentUtc, preferences, prompts, language);
    window.show();
    if (tour >= 0)
        return runScreenshotTour(window, arguments.value(tour + 1)) ? 0 : 5;
    QStringList paths;
    for (const std::string &file : files)
        paths << QString::fromStdString(file);
    window.files().openPaths(paths);
    return QApplication::exec();
}

} // namespace dyncal
