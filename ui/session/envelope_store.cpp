// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/envelope_store.h"

#include <algorithm>

namespace dyncal {

namespace {

bool sameRecord(const Channel &a, const Channel &b)
{
    return a.samples.sharesWith(b.samples) && a.polynomial == b.polynomial
        && a.polarity == b.polarity && a.userScale == b.userScale
        && a.sampleRate_Hz == b.sampleRate_Hz && a.t0_s == b.t0_s;
}

bool holds(const std::vector<Channel> &channels, const Channel &channel)
{
    return std::ranges::any_of(
        channels, [&](const Channel &each) { return sameRecord(each, channel); });
}

double samplesOf(const std::vector<Channel> &channels)
{
    double total = 0.0;
    for (const Channel &channel : channels)
        total += static_cast<double>(channel.samples.size());
    return total;
}

} // namespace

EnvelopeStore::EnvelopeStore(QObject *parent)
    : QObject(parent)
    , m_jobs(this)
{
}

void EnvelopeStore::want(std::vector<Channel> channels)
{
    const Envelopes before = std::exchange(m_known, {});
    std::vector<Channel> missing;
    for (const Channel &channel : channels) {
        std::optional<ChannelEnvelope> known;
        for (auto each = before.begin(); each != before.end() && !known; ++each)
            known = (*each)->of(channel);
        if (known)
            m_known.push_back(std::make_shared<const ChannelEnvelope>(std::move(*known)));
        else if (!holds(m_unreadable, channel))
            missing.push_back(channel);
    }
    m_wanted = std::move(channels);
    std::erase_if(m_unreadable, [this](const Channel &each) { return !holds(m_wanted, each); });
    if (std::ranges::equal(missing, m_missing, sameRecord))
        return; // the running job builds just these
    m_missing = std::move(missing);
    start();
}

void EnvelopeStore::start()
{
    m_partOfFirst = 0.0;
    m_jobs.cancel();
    if (m_missing.empty())
        return;
    const auto job
        = [channel = m_missing.front()](const JobControl &control) -> Result<ChannelEnvelope> {
        return ChannelEnvelope::build(channel, control);
    };
    m_jobs.start<ChannelEnvelope>(
        job,
        [this, channel = m_missing.front()](
            Result<ChannelEnvelope> built) { deliver(channel, std::move(built)); },
        [this](double part) {
            m_partOfFirst = part;
            emit changed();
        });
}

void EnvelopeStore::deliver(const Channel &channel, Result<ChannelEnvelope> built)
{
    if (built)
        m_known.push_back(std::make_shared<const ChannelEnvelope>(std::move(*built)));
    else
        m_unreadable.push_back(channel); // the analysis reads it too and says why
    m_missing.erase(m_missing.begin());
    start();
    emit changed();
}

std::shared_ptr<const ChannelEnvelope> EnvelopeStore::find(const Channel &channel) const
{
    const auto known = std::ranges::find_if(
        m_known, [&](const auto &each) { return sameRecord(each->channel(), channel); });
    return known == m_known.end() ? nullptr : *known;
}

double EnvelopeStore::progress() const
{
    const double all = samplesOf(m_wanted);
    const double first
        = m_missing.empty() ? 0.0 : static_cast<double>(m_missing.front().samples.size());
    return all > 0.0 ? 1.0 - (samplesOf(m_missing) - m_partOfFirst * first) / all : 1.0;
}

} // namespace dyncal
