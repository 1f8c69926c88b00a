// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "ui/session/job_runner.h"

#include <map>
#include <memory>

namespace dyncal {

/// False for recordings that are opened but whose files have no hash yet.
bool isSealed(const CaptureSet &captures);

/// Gives opened recordings the hashes of their files, in the background. Undo steps made meanwhile
/// refer to the opened recordings, so their sealed versions are remembered.
class CaptureSealing
{
public:
    using Captures = std::shared_ptr<const CaptureSet>;
    using Deliver = std::function<void(const Captures &opened, const Result<Captures> &sealed)>;

    CaptureSealing(QObject *receiver, Deliver deliver, ProgressSink progress);

    /// The recordings as they are now: sealed, if they were sealed here.
    Captures latest(const Captures &captures) const;

    bool isSealing(const Captures &opened) const;
    void start(const Captures &opened); ///< replaces a sealing under way
    void cancel() { m_jobs.cancel(); }
    void forget(); ///< also what was sealed

private:
    Deliver m_deliver;
    ProgressSink m_progress;
    std::map<Captures, Captures> m_sealed;
    Captures m_opened; ///< being sealed
    JobRunner m_jobs;
};

} // namespace dyncal
