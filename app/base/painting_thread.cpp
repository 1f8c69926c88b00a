// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/painting_thread.h"

#include <QSemaphore>
#include <QThreadPool>

namespace dyncal {
namespace {

bool s_isRefused = false;

/// All that Qt does about a thread that did not start is to warn.
void takeRefusal(QtMsgType, const QMessageLogContext &, const QString &)
{
    s_isRefused = true;
}

} // namespace

bool keepPaintingThread()
{
    static QSemaphore isThere;
    qputenv("QT_NO_GUI_THREADPOOL", "1"); // newer versions of Qt paint without threads then
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
