// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/job_runner.h"
#include "ui/session/pipeline_request.h"

#include <string>

namespace dyncal {

/// Computes the whole decomposition while its first singular triplets are on show. Orders tried
/// meanwhile do not start it anew; after a cancel it waits until it is asked for. Sets are told
/// apart by the keys of their decompositions.
class WholeSetRun
{
public:
    using Deliver = std::function<void(const PipelineOutcome &outcome)>;

    WholeSetRun(QObject *receiver, Deliver deliver, ProgressSink progress);

    /// False, and nothing is done, if the set is withheld. One that is under way goes on.
    bool start(const PipelineRequest &request);
    /// The key of the set made last; empty while one is being made.
    const std::string &made() const { return m_made; }

    void cancel() { m_jobs.cancel(); }
    void withhold(const std::string &key) { m_withheld = key; } ///< after a cancel
    void allow() { m_withheld.clear(); } ///< it is asked for
    void forget();

private:
    Deliver m_deliver;
    ProgressSink m_progress;
    std::string m_making; ///< or made, or cancelled
    std::string m_made;
    std::string m_withheld;
    JobRunner m_jobs; ///< of its own: goes on while orders are tried among the first triplets
};

} // namespace dyncal
