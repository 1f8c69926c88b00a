// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/realization/model/model_assessment.h"
#include "core/realization/model/sensor_model.h"
#include "core/signal/signal_settings.h"

#include <array>
#include <optional>
#include <utility>

namespace dyncal {

/// What is reported of a model, as numbers; NaN where one does not exist.
struct CharacteristicValues
{
    double f0_Hz = kUnknown;
    double zeta = kUnknown;
    double q = kUnknown;
    double resonance_Hz = kUnknown;
    double resonanceGain = kUnknown;
    double within5percent_Hz = kUnknown;
    double within10percent_Hz = kUnknown;
    double minus3dB_Hz = kUnknown;
    double riseTime_s = kUnknown;
    double overshoot_percent = kUnknown;
    double settlingTime_s = kUnknown;
};

enum class CharacteristicKind { Number, Frequency, Time };

/// One of them: its name in results.json, and what it depends on.
struct Characteristic
{
    const char *of;
    const char *unit;
    double CharacteristicValues::*value;
    CharacteristicKind kind;
    bool ofPoles = false; ///< does not depend on amplitudes
};

inline constexpr std::array<Characteristic, 11> kCharacteristics{{
    {"f0_hz", "Hz", &CharacteristicValues::f0_Hz, CharacteristicKind::Frequency, true},
    {"damping_ratio", "", &CharacteristicValues::zeta, CharacteristicKind::Number, true},
    {"q", "", &CharacteristicValues::q, CharacteristicKind::Number, true},
    {"resonance_hz", "Hz", &CharacteristicValues::resonance_Hz, CharacteristicKind::Frequency},
    {"resonance_gain", "", &CharacteristicValues::resonanceGain, CharacteristicKind::Number},
    {"within_5_percent_hz", "Hz", &CharacteristicValues::within5percent_Hz,
        CharacteristicKind::Frequency},
    {"within_10_percent_hz", "Hz", &CharacteristicValues::within10percent_Hz,
        CharacteristicKind::Frequency},
    {"minus_3_db_hz", "Hz", &CharacteristicValues::minus3dB_Hz, CharacteristicKind::Frequency},
    {"rise_time_s", "s", &CharacteristicValues::riseTime_s, CharacteristicKind::Time},
    {"overshoot_percent", "%", &CharacteristicValues::overshoot_percent,
        CharacteristicKind::Number},
    {"settling_time_s", "s", &CharacteristicValues::settlingTime_s, CharacteristicKind::Time},
}};

/// The two poles that f0 and zeta are of, as positions in the list.
using MainPair = std::optional<std::pair<std::size_t, std::size_t>>;

/// Empty where there are none.
MainPair mainPair(const SensorModel &model, const ModelAssessment &assessment);

/// All of one model, which may be one that was moved: poles, amplitudes and level are looked at.
CharacteristicValues characteristicValues(
    const SensorModel &model, const MainPair &pair, ResponseTreatment treatment);

} // namespace dyncal
