// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/batch/batch_follower.h"

#include "ui/text/core_text.h"

#include <algorithm>
#include <utility>

namespace dyncal {

namespace {

constexpr qint64 kPause_ms = 2000;
constexpr qint64 kShareOfTime = 4; ///< a large batch on a slow disk is not read all the time

} // namespace

BatchFollower::BatchFollower(QObject *parent)
    : QObject(parent)
    , m_job(this)
{
    m_pause.setSingleShot(true);
    connect(&m_pause, &QTimer::timeout, this, &BatchFollower::lookNow);
}

void BatchFollower::follow(const QString &planPath)
{
    m_path = planPath;
    m_moment = {};
    m_problem.clear();
    emit changed();
    lookNow();
}

void BatchFollower::lookNow()
{
    if (m_path.isEmpty())
        return;
    m_pause.stop();
    m_since.start();
    const BatchMoment before{m_moment.plan, m_moment.stamp, {}};
    m_job.start<BatchMoment>(
        [path = m_path.toStdString(), before](
            const JobControl &control) { return batchNow(path, before, control); },
        [this](Result<BatchMoment> now) { take(std::move(now)); });
}

void BatchFollower::rest()
{
    m_job.cancel();
    m_pause.stop();
}

void BatchFollower::take(Result<BatchMoment> now)
{
    m_pause.start(static_cast<int>(std::max(kPause_ms, kShareOfTime * m_since.elapsed())));
    if (now && (now->plan != m_moment.plan || now->sensors != m_moment.sensors)) {
        m_moment = std::move(*now);
        emit changed();
    }
    const QString problem = now ? QString() : translated(now.error().message);
    if (std::exchange(m_problem, problem) != problem)
        emit problemChanged(problem);
}

} // namespace dyncal
