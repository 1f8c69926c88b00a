// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <Eigen/Core>

#include <complex>
#include <optional>

namespace dyncal {

/// Linear-phase low-pass for a reduction of the sample rate: Kaiser-windowed sinc of odd length.
struct AntiAliasFilter
{
    double factor = 1.0; ///< input samples per output sample, >= 1, mostly whole
    Eigen::VectorXd taps; ///< symmetric, sum 1; {1} for factor 1
    double rate_Hz = 0.0; ///< input rate

    Index halfLength() const { return (taps.size() - 1) / 2; }
    /// Time that the filter spans, (taps - 1) / rate: how long after the onset an output sample no
    /// longer depends on the time before the onset.
    double span_s() const { return static_cast<double>(taps.size() - 1) / rate_Hz; }
    /// Gain for e^(s t), s complex: sum taps[k] e^(s (k - half) / rate); real on the jw axis.
    /// A decaying exponential passes with exactly this constant gain (docs/adr/0008).
    std::complex<double> gain(std::complex<double> s_rad_s) const;
    /// gain(s) e^(s delay): finite for every decaying s if the delay is at least the filter's half
    /// length, where the gain alone would overflow.
    std::complex<double> delayedGain(std::complex<double> s_rad_s, double delay_s) const;
};

/// Filter for a reduction by `factor` >= 1 of a record at `rate_Hz`: 12 factor + 1 taps, within
/// 0.004 dB up to 0.64 of the new Nyquist frequency, -6 dB at it, at least 68 dB down from 1.36 of
/// it on and 70 dB from 1.42 (docs/method/resampling.md). Factor 1 passes everything. For a factor
/// that is not whole the prototype is sampled anew for every output; its gain then varies with the
/// output's place between the inputs by less than 1e-3.
AntiAliasFilter designAntiAliasFilter(double factor, double rate_Hz);

/// span_s() of that filter, without designing it.
double antiAliasSpan_s(double factor, double rate_Hz);

/// Output k is centred on input sample first + k factor. All input samples that the filter
/// touches must exist: first >= half and first + (count-1) factor + half < size.
Eigen::VectorXd decimate(const Eigen::Ref<const Eigen::VectorXd> &values,
    const AntiAliasFilter &filter, Index first, Index count);

/// Outputs that decimate() can give from `first` on when input `last` is the last that the filter
/// may touch; 0 if none.
Index outputCount(const AntiAliasFilter &filter, Index first, Index last);

/// from_Hz / to_Hz, exactly whole where it is within 1e-9 of it; empty below 1 (rates are not
/// raised).
std::optional<double> reductionFactor(double from_Hz, double to_Hz);

} // namespace dyncal
