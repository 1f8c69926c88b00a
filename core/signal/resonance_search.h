// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/interval.h"
#include "core/signal/power_spectrum.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dyncal {

/// A maximum of one spectrum.
struct SpectralPeak
{
    double frequency_Hz = 0.0;
    double prominence_dB = 0.0; ///< over the local background
    double q = 0.0; ///< frequency over half-power width
};

/// Frequency within 3/4 of a bin of `frequency_Hz` where the continuous spectrum of `values` is
/// largest: for peaks as narrow as a bin, where a parabola through three bins is off by 0.15 bins.
double refinedFrequency_Hz(const Eigen::Ref<const Eigen::VectorXd> &values, double rate_Hz,
    double frequency_Hz, double bin_Hz);

/// Looks for maxima that noise, leakage and the slope of the spectrum do not explain
/// (docs/method/spectrum.md). Holds the smoothed spectrum and its background.
class ResonanceSearch
{
public:
    /// `averages` = independent periodograms that each bin of `spectrum` is the mean of. The
    /// spectrum must outlive the search.
    ResonanceSearch(const PowerSpectrum &spectrum, double averages);

    /// Peaks above the fourth bin and below 0.9 Nyquist, within `band_Hz` if given; most prominent
    /// first.
    std::vector<SpectralPeak> prominentPeaks(const std::optional<Interval> &band_Hz) const;

    /// The maximum nearest to `frequency_Hz`, however small, within a tenth of it.
    std::optional<SpectralPeak> nearestPeak(double frequency_Hz) const;

private:
    void smooth();
    double level_dB(double bin) const; ///< smoothed, at the nearest grid point
    double background_dB(Index point) const;
    double needed_dB(Index point) const;
    double dipBeside(Index point) const;
    bool isMaximum(Index point) const;
    SpectralPeak measured(Index point, double prominence_dB) const;

    const PowerSpectrum &m_spectrum;
    double m_averages;
    std::vector<Index> m_bins; ///< bin of each grid point: every bin at first, then logarithmic
    Eigen::VectorXd m_level_dB; ///< smoothed spectrum at the grid points
};

} // namespace dyncal
