// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/realization/exponentials/exponential_sum.h"
#include "core/realization/hankel/state_space_model.h"
#include "core/realization/input/nuisance_term.h"
#include "core/realization/input/realization_settings.h"
#include "core/realization/refinement/model_draft.h"
#include "core/realization/second_order/second_order_model.h"
#include "core/signal/window_bands.h"

#include <Eigen/Core>

#include <complex>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace dyncal {

enum class PoleClass { Sensor, Step, Nyquist, Unstable, Other };

const char *poleClassName(PoleClass poleClass); ///< "sensor", "step", ...

inline constexpr const char *kBelowNoiseFlag = "below-noise";
inline constexpr const char *kShotsDisagreeFlag = "shots-disagree";
inline constexpr const char *kDriftFlag = "drift"; ///< slower than the sensor, no part of it
inline constexpr const char *kTubeModeFlag = "tube-mode"; ///< near a mode of the tube's gas

/// One pole of the model: z in the sampled plane, s = ln(z)/Ts in the continuous one.
struct Pole
{
    std::complex<double> z;
    std::complex<double> s_rad_s;
    PoleClass poleClass = PoleClass::Other;
    std::vector<std::string> flags; ///< "below-noise" and those of flagPoles()
    double frequency_Hz = 0.0; ///< undamped, |s|/2pi, for real poles too
    double u_frequency_Hz = kUnknown;
    double dampingRatio = 0.0; ///< -Re s/|s|
    double u_dampingRatio = kUnknown;
    double amplitude = 0.0; ///< |c_i| at the onset, pooled over the shots
    double coverageFactor = kUnknown; ///< k: value +- k u is a 95 % interval of f0 and of zeta
};

/// |z|; poles and zeros further out are not drawn in the map of the z-plane, but counted.
inline constexpr double kFarthestInMap = 2.0;

/// How one series is described by the shared poles: y(t) = c0 + sum c_i e^(s_i (t - onset)).
struct SeriesFit
{
    Index shot = 0; ///< number from 1; 0 = the average
    double plateauGain = 0.0; ///< c0, in the units of the series (0 for impulse)
    double u_plateauGain = kUnknown;
    std::optional<double> stepLevel; ///< with a drift: of the step itself (onset_level.h)
    double u_stepLevel = kUnknown;
    ExponentialSum sensorStep; ///< with a drift: the sensor's own answer to a step of 1
    Eigen::VectorXcd amplitudes; ///< c_i at the onset, the anti-alias filter's gain divided out,
                                 ///< as the step alone would give them
    ExponentialSum recorded; ///< as fitted, without the nuisance modes; time 0 = detected start
    std::vector<SampleRange> leftOut; ///< of the record from the start on: not fitted
    double onset_s = 0.0; ///< relative to the detected start
    double u_onset_s = kUnknown;
    Eigen::VectorXd simulated; ///< at the samples of the series, through the filter as measured,
                               ///< nuisance modes included
    Eigen::VectorXd error; ///< y - simulated
    double fit_percent = 0.0;
    double fitAttainable_percent = 0.0; ///< what the true model would score, from pre-trigger noise

    /// Of the step itself, at the onset: c0 without a drift.
    double level() const { return stepLevel.value_or(plateauGain); }
    double u_level() const { return stepLevel ? u_stepLevel : u_plateauGain; }
};

/// One mode that is not the sensor's, in one shot.
struct NuisanceOfShot
{
    Index shot = 0;
    NuisanceTerm term; ///< time 0 at the detected start
    double u_frequency_Hz = kUnknown;
    double u_dampingRatio = kUnknown;
    double relativeAmplitude = 0.0; ///< of the plateau, at the onset
    double phase_rad = 0.0; ///< at the onset, of a cosine
};

/// One mode of the recipe that was taken out of the response.
struct NuisanceResult
{
    NuisanceMode mode;
    std::vector<NuisanceOfShot> perShot;
};

/// The realised model of one order, as fitModel() makes it. Immutable. The uncertainties of its
/// poles are unknown here: like all that tells how good the model is, they are in its
/// ModelAssessment.
struct SensorModel
{
    Index order = 0;
    StateSpaceModel stateSpace;
    std::vector<Pole> poles; ///< by frequency, upper half first; the step's own pole last
    std::vector<std::complex<double>> zeros;
    std::vector<SeriesFit> series;
    double plateauGain = 0.0; ///< pooled c0
    std::optional<double> stepLevel; ///< with a drift: pooled
    ExponentialSum sensorStep; ///< pooled; empty without a drift
    std::vector<Index> slowPoles; ///< positions of those that are a drift, no part of the sensor
    double drift = 0.0; ///< by them from the onset to the end of the model input, of the level
    std::optional<Index> doubtfulPole; ///< one that might be a drift, too fast to be told apart
    double doubtfulShare = 0.0; ///< of the level that it would add, if it is one
    Eigen::VectorXcd
        amplitudes; ///< pooled c_i at the onset, order of `poles` without the step pole
    double fit_percent = 0.0; ///< aligned, pooled over the shots
    double fitAttainable_percent = 0.0;
    std::optional<double> fitListing_percent; ///< thesis mode: as the listing computes it
    bool diverges = false; ///< with a pole outside the unit circle the simulation diverges
    bool refined = false;
    ModelDraft draft; ///< input of the assessment
    /// Where it has the smaller BIC: poles, amplitudes and onsets above are this sensor's.
    std::optional<SecondOrderModel> secondOrder;
    std::vector<NuisanceResult> nuisance; ///< not part of the above, except of `simulated`
    /// Noise that the uncertainties rest on: "white", "AR(p)", with " of the residual" where
    /// that exceeds the noise before the start; empty without refinement.
    std::string uncertaintyMethod;
    Findings findings; ///< ORD-001, ORD-003, MOD-001..006, 008, 009, 012..016

    /// Of the step itself, at the onset: c0 without a drift.
    double level() const { return stepLevel.value_or(plateauGain); }
};

/// The sensor's main resonance, f0 and zeta of results and certificate: the oscillating sensor pole
/// (upper half) whose ringing has most energy, |c|^2 / |Re s|. Not the largest amplitude, which at
/// high orders is a well-damped spurious pole. The median over the shots counts: what rings in one
/// of three shots only is not the sensor. Null if nothing oscillates. `poles` are those of the
/// model, as fitted or as assessed, `series` its fits.
const Pole *mainPole(const std::vector<Pole> &poles, const std::vector<SeriesFit> &series);

/// Whether c0, to which the response would tend, may be stated: with a drift that has hardly begun
/// it is an extrapolation, and is not where its u is more than 5 % of it.
bool isPlateauKnown(const SensorModel &model);

/// How many poles and zeros lie beyond kFarthestInMap.
Index countBeyondMap(const SensorModel &model);

} // namespace dyncal
