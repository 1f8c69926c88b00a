// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/realization/input/whitening.h"
#include "core/signal/response_window.h"

#include <vector>

namespace dyncal {

/// Spectral density of a shot's noise, from its record before the step (docs/method/response.md):
/// autoregressive models of the record, of its means of 8 samples, of 64, ... each for the
/// frequencies that lie well inside its own rate, because a model of full rate cannot tell low
/// frequencies apart. A slower one counts where it differs by more than both scatter. In the units
/// of WindowedResponse::values, as the variance of the white noise that has the same density.
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
    struct Layer
    {
        double rate_Hz = 0.0;
        double samples = 1.0; ///< of the record to each of its values
        Index count = 0;
        AutoregressiveModel model;

        double dof() const
        {
            return static_cast<double>(count) / static_cast<double>(model.order() + 1);
        }
    };

    static double densityOf(const Layer &layer, double frequency_Hz);

    double m_rate_Hz = 0.0;
    double m_white = 0.0;
    double m_ofBaseline = 0.0;
    std::vector<Layer> m_layers; ///< the record's own rate first; empty without a noise record
};

} // namespace dyncal
