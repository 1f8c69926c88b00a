// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui_main.h"

#include "app/base/clock.h"
#include "app/base/interrupt.h"
#include "app/base/painting_thread.h"
#include "app/base/user_name.h"
#include "app/base/window_memory.h"
#include "app/cli/console.h"
#include "core/base/compact_heap.h"
#include "core/base/version.h"
#include "core/pipeline/pipeline.h"
#include "ui/shell/main_window.h"
#include "ui/shell/preferences/theme_style.h"
#include "ui/shell/screenshot_tour.h"

#include <QApplication>
#include <QHashSeed>
#include <QIcon>
#include <QStandardPaths>
#include <QSysInfo>
#include <QTimer>

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <clocale>
#include <new>
#include <string_view>

namespace dyncal {

namespace {

constexpr const char *kTourOption = "--screenshot-tour";

constexpr std::chrono::milliseconds kMemoryWatch{500};

/// An event for which the window has no memory is dropped; kMemoryWatch below reports it.
class Application : public QApplication
{
public:
    using QApplication::QApplication;

    bool notify(QObject *receiver, QEvent *event) override
    {
        try {
            return QApplication::notify(receiver, event);
        } catch (const std::bad_alloc &) {
            return false;
        }
    }
};

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

Error noMemoryForWindow()
{
    return {ErrorKind::Internal,
        {DYNCAL_TEXT("core",
             "There is not enough memory for a window; close other programs or raise the memory limit."),
            {}},
        {}, 0};
}

std::atomic<MainWindow *> shownWindow = nullptr;

/// For INT, TERM and HUP: unsaved work is kept for the next start.
void endInOrder(int signal)
{
    constexpr int kSignalled = 128;
    MainWindow *window = shownWindow;
    if (!window)
        ::_exit(kSignalled + signal);
    QMetaObject::invokeMethod(window, [window, signal] {
        window->leaveWork();
        QCoreApplication::exit(kSignalled + signal);
    });
}

} // namespace

int runGui(int argc, char **argv, const std::vector<std::string> &files)
{
    const bool tour = argc >= 3 && std::string_view(argv[1]) == kTourOption;
    const QString tourFolder = tour ? QString::fromLocal8Bit(argv[2]) : QString();
    const QString tourLanguage(argc >= 4 ? argv[3] : "en");
    const QString tourTheme(argc >= 5 ? argv[4] : "light");
    if (tour && !qEnvironmentVariableIsSet("DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    keepHeapCompact();
    if (!keepMemoryForWindow())
        return report(noMemoryForWindow());
    // What is exported must be the same bytes as from the command line.
    QHashSeed::setDeterministicGlobalSeed();
    onEndRequest(endInOrder);
    if (!keepPaintingThread())
        ::_exit(report(noMemoryForWindow()));
    Application application(argc, argv);
    prepareApplication();

    Preferences preferences;
    Prompts prompts;
    Language language;
    language.install(tour ? tourLanguage : preferences.language());
    useTheme(tour ? themeKindFromName(tourTheme) : preferences.theme());
    MainWindow window(runPipeline, currentUtc, preferences, prompts, language);
    window.show();
    if (tour)
        return runScreenshotTour(window, tourFolder) ? 0 : 5;
    window.keepWork(
        QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/recovery");
    window.files().holdProjectsAs(userName(), QSysInfo::machineHostName().toStdString());
    QStringList paths;
    for (const std::string &file : files)
        paths << QString::fromStdString(file);
    window.files().openPaths(paths);
    QTimer watch;
    QObject::connect(&watch, &QTimer::timeout, &window, [&] {
        if (wasWindowMemoryUsed())
            window.files().stopForMemory();
    });
    watch.start(kMemoryWatch);
    shownWindow = &window;
    const int code = QApplication::exec();
    shownWindow = nullptr;
    return code;
}

} // namespace dyncal
