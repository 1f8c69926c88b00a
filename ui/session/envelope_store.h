// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/channel_envelope.h"
#include "ui/session/job_runner.h"

#include <QObject>

#include <memory>
#include <vector>

namespace dyncal {

/// The envelopes of the long records on the screen: built one after the other in the background,
/// each handed over when it is complete, kept while their records are wanted.
class EnvelopeStore : public QObject
{
    Q_OBJECT

public:
    explicit EnvelopeStore(QObject *parent = nullptr);

    /// From now on these records are wanted, in this order; others are forgotten. A known record
    /// with another conversion costs nothing if its envelope can be used for it too.
    void want(std::vector<Channel> channels);

    /// Null while it is being built, if it was not wanted, or if its record cannot be read.
    std::shared_ptr<const ChannelEnvelope> find(const Channel &channel) const;
    bool isBusy() const { return !m_missing.empty(); }
    /// Share of the samples of all wanted records that have been read.
    double progress() const;

signals:
    void changed(); ///< an envelope is there, or the progress moved

private:
    void start();
    void deliver(const Channel &channel, Result<ChannelEnvelope> built);

    using Envelopes = std::vector<std::shared_ptr<const ChannelEnvelope>>;
    std::vector<Channel> m_wanted;
    Envelopes m_known;
    std::vector<Channel> m_missing;
    std::vector<Channel> m_unreadable;
    double m_partOfFirst = 0.0; ///< share of the first missing record that has been read
    JobRunner m_jobs; ///< last: stops before any member that a delivery uses is destroyed
};

} // namespace dyncal
