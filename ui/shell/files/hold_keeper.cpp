// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/files/hold_keeper.h"

namespace dyncal {

HoldKeeper::HoldKeeper(CurrentUtc currentUtc, QObject *parent)
    : QObject(parent)
    , m_currentUtc(std::move(currentUtc))
    , m_jobs(this)
{
    connect(&m_beat, &QTimer::timeout, this, &HoldKeeper::beat);
    m_beat.start(std::chrono::seconds(kHoldBeat_s));
}

void HoldKeeper::holdAs(const std::string &name, const std::string &machine)
{
    m_who = {name, machine, {}};
}

HoldRequest HoldKeeper::request() const
{
    HoldRequest request{m_who, m_access.hold};
    if (request.who)
        request.who->sinceUtc = m_currentUtc().value_or("");
    return request;
}

void HoldKeeper::beat()
{
    if (!m_access.hold || m_jobs.isRunning())
        return;
    m_jobs.start<void>(
        [hold = m_access.hold](const JobControl &) -> Result<void> {
            hold->beat();
            return {};
        },
        [](const Result<void> &) {});
}

} // namespace dyncal
