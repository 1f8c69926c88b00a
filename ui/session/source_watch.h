// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/source_check.h"
#include "ui/session/job_runner.h"

#include <QTimer>

#include <functional>
#include <memory>

namespace dyncal {

/// Looks every second, in the background, whether the files of the open recordings are still as
/// they were. It asks the files themselves: the notices of file systems do not come from network
/// drives.
class SourceWatch
{
public:
    using Captures = std::shared_ptr<const CaptureSet>;
    using Changes = std::vector<ChangedSource>;

    /// `changed` is called when changes() are others than before.
    SourceWatch(QObject *receiver, std::function<void()> changed);

    void watch(const Captures &captures); ///< from now on these
    /// As they were seen last.
    const Changes &changes() const { return m_changes; }

private:
    void look();
    void take(const Captures &captures, const Result<Changes> &found);

    std::function<void()> m_changed;
    Captures m_captures;
    Changes m_changes;
    QTimer m_pause; ///< until the next look
    JobRunner m_jobs;
};

} // namespace dyncal
