// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/realization/input/whitening.h"
#include "core/signal/response_window.h"

#include <vector>

namespace dyncal {

/// Spectral density of a shot's noise, from its record before the step (docs/method/response.md):
/// that of an autoregressive model, which is precise, and at low frequencies, which such a model
/// cannot tell apart, that of the periodogram by octaves where the two differ by more than both
/// scatter. In the units of WindowedResponse::values, as the variance of the white noise that has
/// the same density.
class NoiseDensity
{
public:
    struct Value
    {
        double variance = 0.0;
        double dof = 0.0; ///< infinite where the noise is known without a record
    };

    /// What the response's noiseSd has beyond its noise record (rounding; or all, without a record)
    /// is white.
    explicit NoiseDensity(const WindowedResponse &response);

    Value at(double frequency_Hz) const;
    /// Variance of a mean of so many samples in a row against another stretch at most `apart`
    /// samples away: slower noise is in both.
    double ofMean(Index samples, Index apart) const;
    /// Variance of the level of the baseline, which was subtracted, with what rounding leaves.
    double ofBaseline() const { return m_ofBaseline; }

private:
    struct Octave
    {
        double centre_Hz = 0.0;
        double logDensity = 0.0;
        double dof = 0.0;
        double aboveModel = 0.0; ///< logarithm of its density over the model's
    };

    void findOctaves(const Eigen::VectorXd &noise);
    double modelAt(double frequency_Hz) const;
    Value octavesAt(double frequency_Hz) const;
    bool differsFromModel(double frequency_Hz) const;

    double m_rate_Hz = 0.0;
    double m_white = 0.0;
    double m_ofBaseline = 0.0;
    Index m_count = 0; ///< of the noise record
    AutoregressiveModel m_model;
    std::vector<Octave> m_octaves; ///< from low frequencies on
};

} // namespace dyncal
