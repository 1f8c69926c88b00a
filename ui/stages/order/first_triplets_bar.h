// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace dyncal {

class Session;

/// Says that only the first singular values are on show, how far the rest is, and stops it or asks
/// for it again. Hidden when all of them are there, and where the rest takes a moment only.
class FirstTripletsBar : public QWidget
{
    Q_OBJECT

public:
    explicit FirstTripletsBar(Session &session, QWidget *parent = nullptr);

private:
    void refresh();
    QString sentence() const;

    Session &m_session;
    QLabel *m_text;
    QProgressBar *m_progress;
    QPushButton *m_cancel;
    QPushButton *m_compute;
    QTimer m_slow; ///< active: too early to show it, the rest may be done in a moment
};

} // namespace dyncal
