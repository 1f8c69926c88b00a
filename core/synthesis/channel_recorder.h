// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/portable_random.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/channel.h"
#include "core/synthesis/coloured_noise.h"
#include "core/synthesis/front_response.h"
#include "core/synthesis/sensor_spec.h"
#include "core/synthesis/step_response.h"

#include <optional>
#include <vector>

namespace dyncal {

/// A change of pressure at the sensor's face: at once, with a time constant, or an oscillation.
struct PressureEvent
{
    double time_s = 0.0; ///< on the record's axis
    double change_Pa = 0.0; ///< amplitude of an oscillation
    double relaxation_s = 0.0; ///< 0 = at once
    std::optional<Oscillation> oscillation = {};
    std::optional<Front> front = {}; ///< `time_s` is its middle
};

/// The pressure at one sensor, and drift and noise of its signal.
struct SignalPlan
{
    SensorSpec sensor;
    double initial_Pa = 0.0; ///< before all events
    std::vector<PressureEvent> events;
    double driftPerSecond_V = 0.0; ///< from 0 at the first sample
    double noise_V = 0.0; ///< standard deviation
    NoiseKind noise = {};
};

/// When samples are taken, and what the capture says of it.
struct RecordAxis
{
    double t0_s = 0.0;
    double sampleRate_Hz = 0.0;
    Index count = 0;
    std::optional<double> statedRate_Hz = {}; ///< where it is not the true one

    /// A true time as it appears in the capture: the sample of the trigger stays where it is.
    double statedTime_s(double time_s) const
    {
        return statedRate_Hz ? time_s * (sampleRate_Hz / *statedRate_Hz) : time_s;
    }
};

/// Converter with 2^bits codes over +-range_V.
struct Digitizer
{
    int bits = 14;
    double range_V = 5.0;
    double bow_codes = 0.0; ///< too many in the middle of the range, as 1 - x^2 towards its ends

    double lowestCount() const { return -static_cast<double>(Index{1} << (bits - 1)); }
    double highestCount() const { return -lowestCount() - 1.0; }
    double step_V() const { return range_V / -lowestCount(); }

    /// Count before rounding.
    double position(double volts) const;
};

/// The recorded channel: volts rounded half to even to counts and cut at the rails; stated rate and
/// t0, unit "V", polynomial and rails filled in, name and role left to the caller. 16 bit integers
/// up to 16 bits, else 32. Fails only on a request to stop (Cancelled).
Result<Channel> recordChannel(const SignalPlan &plan, const RecordAxis &axis,
    const Digitizer &digitizer, RandomStream random, const JobControl &control);

} // namespace dyncal
