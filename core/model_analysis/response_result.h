// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/model_analysis/drift.h"
#include "core/model_analysis/model_characteristics.h"
#include "core/model_analysis/model_curves.h"
#include "core/model_analysis/shot_sensitivity.h"
#include "core/realization/exponentials/front.h"

#include <Eigen/Core>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// Why a model has no characteristics.
enum class CharacteristicsGap { None, FreeDecay, Diverges, LevelUnknown };

/// Why the band of the response ends where it does.
enum class BandEnd {
    Window, ///< shortest window
    Noise, ///< above 10 % of the magnitude
    Rate, ///< 0.4 of the lowest sample rate
    ModelRate, ///< half the model's rate, of a free decay
    Reference, ///< where the reference transducer was calibrated
    Chain ///< where the chain's response is stated
};

/// Why S(f) is not stated at a frequency: the bound of its error by the end of the records or by
/// sampling exceeds both its u and 2 % of it, the records do not hold the frequency, the reference
/// transducer was not calibrated there, or the chain's response is not stated there.
enum class WithheldReason { None, End, Alias, AboveRate, NotCalibrated, ChainUnknown };

/// What a frequency is at which S(f) is always stated, whatever the recipe asks for; Known: another
/// calibration states a value there.
enum class RowMark { LowEnd, Within5percent, Within10percent, Minus3dB, Resonance, HighEnd, Known };

struct ResponseResult
{
    Eigen::VectorXd frequency_Hz; ///< by the recipe; a grid lies inside the usable band
    Eigen::VectorXd magnitude; ///< non-parametric, docs/method/response.md; empty for impulse
    Eigen::VectorXd u_magnitude; ///< noise, both bounds and the front
    Eigen::VectorXd u_noiseMagnitude;
    Eigen::VectorXd u_frontMagnitude;
    Eigen::VectorXd u_referenceMagnitude; ///< of the reference transducer's sensitivity; else empty
    Eigen::VectorXd u_referencePhase_rad;
    Eigen::VectorXd dofReference;
    Eigen::VectorXd u_chain_relative; ///< of the chain's response at each frequency; else empty
    Eigen::VectorXd u_chainPhase_rad;
    Eigen::VectorXd dofChain;
    Eigen::VectorXd phase_rad;
    Eigen::VectorXd u_phase_rad; ///< the same, and the onset
    Eigen::VectorXd u_noisePhase_rad; ///< with the onset, without the bounds
    Eigen::VectorXd dof; ///< of u_magnitude, effective
    Eigen::VectorXd boundEnd; ///< of the error by the end of the records; also where withheld
    Eigen::VectorXd boundAlias; ///< of that by sampling
    Eigen::VectorXd length_s; ///< used behind the detected start, of a shot at most its window
    std::vector<WithheldReason> withheld; ///< of each frequency
    Eigen::VectorXd modelMagnitude;
    Eigen::VectorXd modelPhase_rad;
    bool isByTransducer = false; ///< against a reference transducer, not the pressure step
    bool isWithoutChain = false; ///< the chain's response is divided out
    double u_chainLowest_relative = 0.0; ///< of the chain's response at its lowest frequency
    FrontDuration front; ///< divided out of S(f); its u is in u_magnitude
    double fLow_Hz = 0.0; ///< 1 / shortest window
    /// Where the noise exceeds 10 % of the magnitude, at most 0.4 of the record's rate; of a free
    /// decay, which has the model's answer only, also at most half the model's rate.
    double fHigh_Hz = 0.0;
    BandEnd lowEnd = BandEnd::Window;
    BandEnd highEnd = BandEnd::Rate;
    std::string unit; ///< "V/Pa" with a pressure step, "1" without
    StepCharacteristics characteristics; ///< what may be stated: stated_characteristics.h
    CharacteristicsGap gap = CharacteristicsGap::None;
    double modelLimit_Hz = std::numeric_limits<double>::infinity(); ///< half the model's rate
    double window_s = std::numeric_limits<double>::infinity(); ///< the shortest
    double resolution_s = 0.0; ///< between the samples that the model was fitted to, the longest
    std::vector<ShotSensitivity> shots;
    std::optional<double> sensitivity; ///< mean over the shots
    std::string sensitivityUnit;
    SensitivitySummary summary; ///< of computeResponse(); its mean is `sensitivity`
    DriftResult drift;
    /// The same response at the marked frequencies inside the band, which `marks` names; without
    /// curve and findings. Null where nothing was measured.
    std::shared_ptr<const ResponseResult> atMarks;
    std::vector<RowMark> marks; ///< of each row of `atMarks`, there only
    ResponseCurve modelCurve; ///< for plots: 600 points over the band and past it
    Findings findings;
};

} // namespace dyncal
