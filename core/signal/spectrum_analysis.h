// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/signal/power_spectrum.h"
#include "core/signal/resonance_search.h"
#include "core/signal/response_window.h"
#include "core/signal/signal_settings.h"

#include <optional>
#include <vector>

namespace dyncal {

/// A peak that stands out of the spectrum of the shots.
struct Resonance
{
    double frequency_Hz = 0.0; ///< mean over the shots that show it
    double prominence_dB = 0.0; ///< over the spectrum's local background, smallest over the shots
    double q = 0.0; ///< frequency over half-power width (limited by the window)
    std::vector<std::optional<double>> perShot_Hz;
};

struct SpectrumResult
{
    std::vector<PowerSpectrum> perShot; ///< same order as the responses
    std::vector<std::vector<SpectralPeak>> peaks; ///< of each shot, all prominent ones
    std::vector<Resonance> resonances; ///< most prominent first
    Findings findings; ///< SPC-001, SPC-002
};

/// Spectra of all responses and the resonances they share (thesis 3.7 step 3). A resonance is a
/// local maximum with at least 6 dB prominence in the smoothed log spectrum (background: running
/// median over a band of log frequency; more than 6 dB where few bins are averaged, so that white
/// noise gives a false peak in one of a thousand spectra), above the fourth bin and below 0.9
/// Nyquist, its frequency interpolated by a parabola through the log power. Peaks of different
/// shots within 5 % are one resonance if at least half of the shots show it; a spread beyond 2 % is
/// SPC-002. The operator's own list is matched to the nearest maxima within 10 %. Details:
/// docs/method/spectrum.md.
Result<SpectrumResult> analyseSpectra(const std::vector<WindowedResponse> &responses,
    const SpectrumSettings &settings, const JobControl &control = {});

} // namespace dyncal
