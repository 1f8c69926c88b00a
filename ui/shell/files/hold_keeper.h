// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/current_utc.h"
#include "ui/session/job_runner.h"
#include "ui/shell/files/project_access.h"

#include <QTimer>

namespace dyncal {

/// Keeps the access to the project that is open: the sign of life that tells others who has it.
class HoldKeeper : public QObject
{
    Q_OBJECT

public:
    HoldKeeper(CurrentUtc currentUtc, QObject *parent);

    /// From now on others are told. Without this call nobody is.
    void holdAs(const std::string &name, const std::string &machine);
    HoldRequest request() const; ///< of a project that is opened now

    const ProjectAccess &access() const { return m_access; }
    /// In the place of the access to the project before, which is given back.
    void keep(const ProjectAccess &access) { m_access = access; }

private:
    void beat();

    CurrentUtc m_currentUtc;
    std::optional<ProjectHolder> m_who;
    ProjectAccess m_access;
    QTimer m_beat;
    JobRunner m_jobs; ///< a network folder may be slow to answer
};

} // namespace dyncal
