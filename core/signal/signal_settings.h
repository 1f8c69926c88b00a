// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/auto_value.h"
#include "core/base/index.h"
#include "core/base/interval.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// What the model input is: a step with its pole deflated (default), the thesis's step fed as if
/// it were an impulse response, its first difference, or a true impulse response / free decay.
enum class ResponseTreatment { StepDeflated, StepAsImpulse, Differenced, Impulse };

const char *responseTreatmentName(ResponseTreatment treatment); ///< "step-deflated", ...
inline bool isStepTreatment(ResponseTreatment t)
{
    return t != ResponseTreatment::Impulse;
}

/// A part of a record that takes no part in the fit: a disturbance that nobody can explain.
struct ExcludedStretch
{
    Index shot = 1;
    double from_s = 0.0; ///< relative to the start
    double to_s = 0.0;
    std::string reason;

    bool operator==(const ExcludedStretch &) const = default;
};

/// Recipe section "window". Baseline, end and settle are seconds relative to the start.
struct WindowSettings
{
    /// Empty = detect; one value = that time on each record's own axis; else one value per shot.
    std::vector<double> start_s;
    bool subtractBaseline = true; ///< false = recipe's "baseline_s": null
    Auto<Interval> baseline_s;
    Auto<double> end_s; ///< relative to the start; common to all shots
    std::vector<Auto<double>> ownEnds_s; ///< not empty: one per shot, in place of the common end
    bool endAtPlateau = false; ///< recipe's "end_s": "plateau"
    Auto<Interval> settle_s;
    std::vector<ExcludedStretch> excludeStretches;

    /// The end that is set for a shot (from 1): its own, or the common one. A shot that ownEnds_s
    /// does not reach has an automatic end; the window stage refuses such settings.
    Auto<double> endOfShot_s(Index shot) const;
    bool operator==(const WindowSettings &) const = default;
};

enum class Taper { Rectangular, Hann };
enum class SpectrumMethod { Periodogram, Welch };
enum class Detrend { None, Mean, Linear };

/// Recipe section "spectrum".
struct SpectrumSettings
{
    Taper taper = Taper::Rectangular; ///< as the thesis
    SpectrumMethod method = SpectrumMethod::Periodogram;
    std::optional<Index> segment; ///< Welch segment length in samples; empty = an eighth
    Detrend detrend = Detrend::Mean;
    std::optional<Interval> resonanceBand_Hz;
    bool searchResonance = true; ///< recipe's "resonance": "auto"
    std::vector<double> resonances_Hz; ///< given by the operator; with search off and empty = none

    bool operator==(const SpectrumSettings &) const = default;
};

enum class CombineMethod { Stacked, PcaAverage };

/// Recipe section "input": what the identification gets.
struct InputSettings
{
    Auto<double> sampleRate_Hz;
    Auto<Index> samples;
    Auto<double>
        offset_s; ///< begin of the model input after the start; auto = half the filter span
    std::optional<CombineMethod> combine; ///< empty = stacked, or pca-average with step-as-impulse
    ResponseTreatment treatment = ResponseTreatment::StepDeflated;

    CombineMethod effectiveCombine() const
    {
        if (combine)
            return *combine;
        return treatment == ResponseTreatment::StepAsImpulse ? CombineMethod::PcaAverage
                                                             : CombineMethod::Stacked;
    }
    bool operator==(const InputSettings &) const = default;
};

} // namespace dyncal
