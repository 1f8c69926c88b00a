// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/batch/batch_watch.h"
#include "ui/session/job_runner.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace dyncal {

/// Looks again and again where the sensors of a plan stand, in the background, whoever computes
/// them: this window, another program or a cluster. Between two looks it rests 2 s, or four times
/// as long as a look took.
class BatchFollower : public QObject
{
    Q_OBJECT

public:
    explicit BatchFollower(QObject *parent);

    void follow(const QString &planPath); ///< from now on this plan
    void lookNow();
    void rest(); ///< until the next lookNow()

    QString planPath() const { return m_path; } ///< empty: none
    const BatchMoment &moment() const { return m_moment; }

signals:
    void changed(); ///< what moment() says
    void problemChanged(const QString &sentence); ///< why it cannot be read; empty: it can again

private:
    void take(Result<BatchMoment> now);

    QString m_path;
    BatchMoment m_moment;
    QString m_problem;
    QTimer m_pause;
    QElapsedTimer m_since; ///< the last look began
    JobRunner m_job;
};

} // namespace dyncal
