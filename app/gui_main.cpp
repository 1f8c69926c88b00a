// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui_main.h"

#include "app/clock.h"
#include "core/base/version.h"
#include "core/pipeline/pipeline.h"
#include "ui/shell/main_window.h"
#include "ui/shell/screenshot_tour.h"

#include <QApplication>
#include <QHashSeed>
#include <QIcon>
#include <QStandardPaths>

#include <clocale>
#include <string_view>

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
    const bool tour = argc >= 3 && std::string_view(argv[1]) == kTourOption;
    const QString tourFolder = tour ? QString::fromLocal8Bit(argv[2]) : QString();
    const QString tourLanguage(argc == 4 ? argv[3] : "en");
    if (tour && !qEnvironmentVariableIsSet("DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    // What is exported must be the same bytes as from the command line.
    QHashSeed::setDeterministicGlobalSeed();
    QApplication application(argc, argv);
    prepareApplication();

    Preferences preferences;
    Prompts prompts;
    Language language;
    language.install(tour ? tourLanguage : preferences.language());
    MainWindow window(runPipeline, currentUtc, preferences, prompts, language);
    window.show();
    if (tour)
        return runScreenshotTour(window, tourFolder) ? 0 : 5;
    window.keepWork(
        QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/recovery");
    QStringList paths;
    for (const std::string &file : files)
        paths << QString::fromStdString(file);
    window.files().openPaths(paths);
    return QApplication::exec();
}

} // namespace dyncal
