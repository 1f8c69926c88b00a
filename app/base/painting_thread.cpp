// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/painting_thread.h"

#include <QSemaphore>
#include <QThreadPool>

namespace dyncal {
namespace {

bool s_isRefused = false;

/// When a thread does not start, Qt only warns; so this catches the warning.
void takeRefusal(QtMsgType, const QMessageLogContext &, const QString &)
{
    s_isRefused = true;
}

} // namespace

bool keepPaintingThread()
{
    static QSemaphore isThere;
    qputenv("QT_NO_GUI_THREADPOOL", "1"); // makes newer versions of Qt paint without threads
    QThreadPool *pool = QThreadPool::globalInstance();
    pool->setMaxThreadCount(1);
    pool->setExpiryTimeout(-1);
    const QtMessageHandler before = qInstallMessageHandler(takeRefusal);
    pool->start([] { isThere.release(); });
    qInstallMessageHandler(before);
    if (s_isRefused)
        return false;
    isThere.acquire();
    return true;
}

} // namespace dyncal
