// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/shot_point.h"
#include "tests/support/model_inputs.h"

#include <complex>
#include <cstdint>
#include <deque>
#include <vector>

namespace dyncal::testing {

/// Records of one sensor, each with its own onset between two samples; they stay where they are.
struct StepRecords
{
    static constexpr double kF0_Hz = 300e3;
    static constexpr double kZeta = 0.05;
    static constexpr Index kLead = 300;

    struct Mode
    {
        double f0_Hz, zeta, share;
    };

    std::deque<WindowedResponse> responses;
    std::vector<RecordOfShot> shots;
    std::vector<Mode> modes{{kF0_Hz, kZeta, 1.0}};

    void add(
        double rate_Hz, Index length, double fraction, double noise = 0.0, std::uint64_t seed = 1)
    {
        Noise source(seed);
        WindowedResponse response;
        response.sampleRate_Hz = rate_Hz;
        response.lead = kLead;
        response.length = length;
        response.values = source.series(kLead + length, noise);
        for (const Mode &mode : modes)
            response.values.tail(length + 1) += mode.share
                * sampledStep(mode.f0_Hz, mode.zeta, rate_Hz, length + 1, 1.0 - fraction);
        response.noise = source.series(20000, noise);
        response.noiseSd = noise;
        responses.push_back(response);
        RecordOfShot shot{&responses.back(), {}};
        shot.record.values = response.values;
        shot.record.early = kLead;
        shot.onset_s = (fraction - 2.0) / rate_Hz;
        shots.push_back(shot);
    }

    std::complex<double> truth(double f_Hz) const
    {
        std::complex<double> sum = 0.0;
        for (const Mode &mode : modes) {
            const double r = f_Hz / mode.f0_Hz;
            sum += mode.share / std::complex<double>(1.0 - r * r, 2.0 * mode.zeta * r);
        }
        return sum;
    }
};

} // namespace dyncal::testing
