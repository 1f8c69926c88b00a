// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/signal/fft.h"

#include <Eigen/Core>

namespace dyncal {

/// A record through FIR filters of one length: the values for which all samples are there.
class FirPassage
{
public:
    /// 1 <= taps <= record.size().
    FirPassage(const Eigen::VectorXd &record, Index taps);

    /// Values that each passage has: record less taps plus one.
    Index size() const { return m_size; }
    /// sum over k of taps[k] record[n - k], n from taps - 1 on; as many taps as stated.
    Eigen::VectorXd through(const Eigen::Ref<const Eigen::VectorXd> &taps) const;

private:
    RealFft m_fft;
    Eigen::VectorXcd m_spectrum;
    Index m_taps;
    Index m_size;
};

} // namespace dyncal
