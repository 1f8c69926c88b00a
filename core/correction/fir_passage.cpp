// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/fir_passage.h"

namespace dyncal {

// The transform is as long as the record or longer: what wraps around lies in the first taps - 1
// values, which are left out.

FirPassage::FirPassage(const Eigen::VectorXd &record, Index taps)
    : m_fft(fastFftLength(record.size()))
    , m_spectrum(m_fft.forward(record))
    , m_taps(taps)
    , m_size(record.size() - taps + 1)
{
}

Eigen::VectorXd FirPassage::through(const Eigen::Ref<const Eigen::VectorXd> &taps) const
{
    return m_fft.inverse(m_spectrum.cwiseProduct(m_fft.forward(taps))).segment(m_taps - 1, m_size);
}

} // namespace dyncal
