// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/capture_sealing.h"

#include "core/capture/capture_seal.h"

#include <algorithm>

namespace dyncal {

bool isSealed(const CaptureSet &captures)
{
    return std::ranges::none_of(captures.inputs,
        [](const InputFile &input) { return input.bytes > 0 && input.sha256.empty(); });
}

CaptureSealing::CaptureSealing(QObject *receiver, Deliver deliver, ProgressSink progress)
    : m_deliver(std::move(deliver))
    , m_progress(std::move(progress))
    , m_jobs(receiver)
{
}

CaptureSealing::Captures CaptureSealing::latest(const Captures &captures) const
{
    const auto sealed = m_sealed.find(captures);
    return sealed == m_sealed.end() ? captures : sealed->second;
}

bool CaptureSealing::isSealing(const Captures &opened) const
{
    return m_jobs.isRunning() && m_opened == opened;
}

void CaptureSealing::start(const Captures &opened)
{
    m_opened = opened;
    m_jobs.start<CaptureSet>(
        [opened](const JobControl &control) { return sealCaptures(*opened, control); },
        [this, opened](Result<CaptureSet> sealed) {
            if (!sealed) {
                m_deliver(opened, tl::unexpected(sealed.error()));
                return;
            }
            const Captures made = std::make_shared<const CaptureSet>(std::move(*sealed));
            m_sealed[opened] = made;
            m_deliver(opened, made);
        },
        m_progress);
}

void CaptureSealing::forget()
{
    m_jobs.cancel();
    m_sealed.clear();
}

} // namespace dyncal
