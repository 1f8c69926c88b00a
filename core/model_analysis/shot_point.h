// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/noise_density.h"
#include "core/model_analysis/sensor_record.h"
#include "core/signal/response_window.h"

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace dyncal {

/// What S(f) takes of one shot. The model gives the onset alone, and that turns the phase only.
struct RecordOfShot
{
    const WindowedResponse *response = nullptr;
    SensorRecord record;
    double scale = 1.0; ///< from the record's values to S
    double onset_s = 0.0; ///< relative to the detected start
    double u_onset_s = 0.0; ///< not finite where unknown; the phase has no u then
    double middle_s = 0.0; ///< of the rise, relative to the detected start; found by prepareShot()
};

/// Leaves a sixteenth of the time that the sensor needs to settle, `span_s`, before the detected
/// start, so that the whole rise is among the samples wherever the onset lies; finds its middle.
void prepareShot(double span_s, RecordOfShot &shot);

/// The samples that S(f) is taken from: so long behind the detected start, within the window.
Eigen::Ref<const Eigen::VectorXd> samplesUsed(const RecordOfShot &shot, double length_s);

/// A change up to so many standard deviations may be noise: it exceeds that in 0.2 %.
inline constexpr double kSigmasOfNoise = 2.5;

/// One shot's S at one frequency.
struct ShotPoint
{
    std::complex<double> S;
    double variance = 0.0; ///< of Re S and of Im S
    double dof = 0.0;
    Eigen::VectorXcd changes; ///< of S by each cut, along S and across it
    Eigen::VectorXd variancesOfChanges;
    double u_onset_s = 0.0;
    double onsetBehindRise_s = 0.0; ///< the model's onset less the middle of the record's rise
};

/// Of the first `length_s` behind the detected start, cut 12 times over their last third. `noise`:
/// that of the shot. 0 < frequency_Hz <= 0.4 of its rate.
ShotPoint shotPoint(
    const RecordOfShot &shot, const NoiseDensity &noise, double length_s, double frequency_Hz);

/// Mean of the magnitudes, each freed of what its noise adds.
double meanMagnitude(const std::vector<ShotPoint> &shots);

/// Phases are known but for whole turns, their mean but for a share of one: they are compared where
/// the records say that the shots lie, for a model's onset may be wrong by more than a turn.
double meanPhase_rad(const std::vector<ShotPoint> &shots, double omega);

/// Of the mean's error by the end of the records: from the largest change that a cut makes beyond
/// what noise does.
double boundOfEnd(const std::vector<ShotPoint> &shots);

/// Of the noise of the mean, by Welch and Satterthwaite.
double dofOf(const std::vector<ShotPoint> &shots);

} // namespace dyncal
