// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/correction/known_response.h"
#include "core/correction/low_pass.h"

#include <optional>

namespace dyncal {

/// What is asked of a correction filter.
struct CorrectionSettings
{
    std::optional<double> band_Hz = {}; ///< wanted up to here; empty: widestBand_Hz()
    std::optional<double> edge_Hz = {}; ///< beyond which nothing is left; empty: 1.5 band_Hz
    std::optional<double> delay_s = {}; ///< in whole samples; empty: the shortest that does
    LowPassKind lowPass = LowPassKind::Gaussian;
};

/// By how much H(f) S(f) may differ from the low-pass within the band.
inline constexpr double kLargestPassError = 2e-4;
/// The edge lies at so many times the band where none is given.
inline constexpr double kEdgeOverBand = 1.5;
/// The edge is at most this share of the recording's sample rate.
inline constexpr double kHighestEdge = 0.45;
/// The noise of no frequency is amplified more than this against the lowest one.
inline constexpr double kMostAmplified = 50.0;

/// The widest band that the response allows at this rate: up to its end, with the edge where it is
/// still known and within kHighestEdge, and |S| above 1/kMostAmplified of its lowest frequency.
double widestBand_Hz(const KnownResponse &response, double rate_Hz);

/// The low-pass that is asked for, with what is left open put in. Fails as designCorrection(), as
/// far as the request and the response alone decide.
Result<LowPass> requestedLowPass(
    const KnownResponse &response, double rate_Hz, const CorrectionSettings &settings);

} // namespace dyncal
