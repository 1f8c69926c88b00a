// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/capture/capture_set.h"
#include "core/realization/exponentials/front.h"
#include "core/realization/input/echo.h"
#include "core/realization/input/nuisance_term.h"
#include "core/realization/input/realization_settings.h"
#include "core/realization/input/whitening.h"
#include "core/signal/resampler.h"
#include "core/signal/signal_settings.h"
#include "core/signal/window_bands.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dyncal {

/// Samples left out, counted from the start of the response, with their recorded values.
struct LeftOut
{
    SampleRange samples;
    Eigen::VectorXd recorded;
    bool isFront = false; ///< the rise of the pressure: recorded, but no free ringing
};

/// One series that goes into the Hankel matrix: one shot, or the average of the reconstructions.
struct ModelSeries
{
    Index shot = 0; ///< number from 1; 0 = the average
    Eigen::VectorXd y; ///< at the model rate
    double first_s = 0.0; ///< time of y[0] relative to the detected start
    Eigen::VectorXd noise; ///< pre-trigger noise through the same filter, at the model rate
    double noiseSd = 0.0; ///< of `noise`, with what rounding leaves; 0 = not known
    double roundingSd = 0.0; ///< rounding error of y that averaging does not remove: usually
                             ///< far below the noise (docs/method/order.md)
    AntiAliasFilter filter; ///< identity when nothing was reduced
    /// The same stretch at the shot's own rate, from the start on: what the refinement works on.
    Eigen::VectorXd fullRate;
    double fullRate_Hz = 0.0;
    double fullRateNoiseSd = 0.0; ///< at least that of rounding; 0 = not known
    ShotLevel level = ShotLevel::None;
    double step = 0.0; ///< of the shot, in the unit of its recording; 0 for the average
    NoiseCovariance fullRateNoise = {}; ///< of the pre-trigger noise at the shot's own rate
    double u_baseline = 0.0; ///< of the level that was subtracted

    /// Modes that are not the sensor's, as separateNuisance() found them; fullRate is then long
    /// enough to separate them from the plateau.
    std::vector<NuisanceTerm> nuisance = {};
    std::vector<LeftOut> leftOut = {}; ///< in order, not touching
    Eigen::VectorXd correction = {}; ///< added to y it leaves the sensor's part; empty = none
};

/// Whether rounding errors exceed a tenth of the noise: the noise before the start is then not the
/// noise in the response.
bool roundingCounts(const ModelSeries &series);

struct ModelInput
{
    ResponseTreatment treatment = ResponseTreatment::StepDeflated;
    CombineMethod combine = CombineMethod::Stacked;
    double sampleRate_Hz = 0.0;
    double offset_s = 0.0; ///< begin of the input after the detected start
    FrontDuration front;
    Index samples = 0;
    std::vector<ModelSeries> series;
    std::optional<double> samplesPerPeriod; ///< of the main resonance
    std::optional<double> lostResponse_percent; ///< energy of the ringing before the input starts
    std::vector<NuisanceMode> nuisanceModes; ///< NuisanceTerm::mode is a position in it
    std::vector<ExcludedStretch> leftOut; ///< what was left out of the series
    std::vector<std::optional<double>> soundSpeeds_m_s; ///< of region 5, per shot of the set: what
                                                        ///< their frequencies were scaled by
    Echoes echoes;
    Findings findings; ///< MIN-001..007, CAP-004, WIN-007..009, NUI-001..005
};

/// The thesis's own way: the step is one of the states.
bool isThesisMode(const ModelInput &input);

/// Sampling interval of the model.
double sampleInterval_s(const ModelInput &input);

} // namespace dyncal
