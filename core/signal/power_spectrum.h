// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/result.h"
#include "core/signal/signal_settings.h"

#include <Eigen/Core>

namespace dyncal {

/// One-sided power spectral density, (unit of the values)^2/Hz; Parseval: sum(psd) df = mean
/// square of the detrended series, weighted by the square of the taper.
struct PowerSpectrum
{
    Eigen::VectorXd frequency_Hz; ///< from 0 (or df) up to Nyquist
    Eigen::VectorXd psd;
};

/// Parts of a series whose spectra are averaged.
struct SpectrumSegments
{
    Index length = 0;
    Index hop = 0;
    Index count = 0;
};

/// Those of a series of `size` samples.
SpectrumSegments segmentsOf(Index size, const SpectrumSettings &settings);

/// The whole series as one segment, detrended and tapered as the settings say.
Eigen::VectorXd asOneSegment(
    const Eigen::Ref<const Eigen::VectorXd> &values, const SpectrumSettings &settings);

/// PSD of one series sampled at `rate_Hz`; at least 8 values, all finite.
Result<PowerSpectrum> computePowerSpectrum(const Eigen::Ref<const Eigen::VectorXd> &values,
    double rate_Hz, const SpectrumSettings &settings);

} // namespace dyncal
