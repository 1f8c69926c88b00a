// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"
#include "ui/shell/files/file_actions.h"

#include <QTimer>

class QLabel;
class QProgressBar;
class QPushButton;
class QStatusBar;

namespace dyncal {

/// What is under way, in the status bar: a sentence, progress, and a button that stops it.
class WorkStatus : public QObject
{
    Q_OBJECT

public:
    WorkStatus(QStatusBar &bar, Session &session, FileActions &files, QObject *parent);

    void showWords(); ///< in the language of the moment

private:
    void showBusy(const QString &what);
    void showIdle(const QString &outcome);
    void showComputing();

    Session &m_session;
    FileActions &m_files;
    QLabel *m_message;
    QProgressBar *m_progress;
    QPushButton *m_cancel;
    QTimer m_slow; ///< short computations show no progress bar
};

} // namespace dyncal
