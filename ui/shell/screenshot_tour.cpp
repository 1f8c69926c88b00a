// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/screenshot_tour.h"

#include "ui/shell/main_window.h"
#include "ui/stages/certificate/preview_panel.h"
#include "ui/stages/frame/stage_page.h"

#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QTimer>

#include <cstdio>
#include <functional>

namespace dyncal {

namespace {

constexpr int kSettle_ms = 400; ///< for layouts and replots that come by the event loop
constexpr qint64 kPatience_ms = 180'000;

void wait(int milliseconds)
{
    QEventLoop loop;
    QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
    loop.exec();
}

bool waitUntil(const std::function<bool()> &isDone)
{
    QElapsedTimer clock;
    clock.start();
    while (!isDone()) {
        if (clock.elapsed() > kPatience_ms)
            return false;
        wait(50);
    }
    return true;
}

bool waitUntilComputed(MainWindow &window)
{
    return waitUntil([&] {
        return !window.files().isBusy() && !window.session().isComputing()
            && window.session().state().hasShots();
    });
}

/// A page that draws a document draws it once it is on show.
bool waitUntilDrawn(const MainWindow &window)
{
    const auto *preview = window.findChild<PreviewPanel *>();
    return waitUntil([&] { return !preview || !preview->isVisible() || preview->isCurrent(); });
}

bool shoot(MainWindow &window, const QDir &folder, const QString &name)
{
    wait(kSettle_ms);
    if (window.grab().save(folder.filePath(name + ".png")))
        return true;
    std::fprintf(stderr, "dyncal: cannot write %s\n", qPrintable(folder.filePath(name + ".png")));
    return false;
}

} // namespace

bool runScreenshotTour(MainWindow &window, const QString &folder)
{
    const QDir target(folder);
    if (folder.isEmpty() || !target.mkpath(".")) {
        std::fprintf(stderr, "dyncal: --screenshot-tour needs a folder to write into\n");
        return false;
    }
    bool done = shoot(window, target, "00-start");
    window.files().openExample();
    if (!waitUntilComputed(window)) {
        std::fprintf(stderr, "dyncal: the example was not computed in time\n");
        return false;
    }
    for (std::size_t row = 0; done && row < window.pages().size(); ++row) {
        window.showPage(static_cast<int>(row));
        done = waitUntilDrawn(window)
            && shoot(window, target,
                QString("%1-%2")
                    .arg(row + 1, 2, 10, QChar('0'))
                    .arg(window.pages()[row]->text().name));
    }
    return done;
}

} // namespace dyncal
