// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/noise_density.h"
#include "core/model_analysis/shot_point.h"
#include "core/realization/exponentials/front.h"

#include <limits>
#include <vector>

namespace dyncal {

/// S(f) from the records alone, mean over the shots, with two bounds of its error
/// (docs/method/response.md). The magnitude holds for any model, or none.
class RecordResponse
{
public:
    struct Point
    {
        double magnitude = 0.0;
        double phase_rad = 0.0; ///< in -pi .. pi
        double u_magnitude = 0.0; ///< from the noise
        double u_phase_rad = 0.0; ///< from the noise and the onsets
        double dof = std::numeric_limits<double>::infinity(); ///< of u, for it rests on a record
        double boundEnd = 0.0; ///< of the error by the end of the records
        double boundAlias
            = 0.0; ///< of that by sampling, if nothing is stronger above half the rate
        double length_s = 0.0; ///< used behind the detected start, of a shot at most its window
        double u_front = 0.0; ///< of the magnitude, from that of the front's duration

        double bound() const { return boundEnd + boundAlias; }
    };

    /// At least one shot. Of every record `span_s` or 20 periods are used, because noise grows with
    /// the length; twice, four times ... as much while its end would change S by more than noise.
    /// What the front takes off is divided out (docs/method/front.md).
    RecordResponse(std::vector<RecordOfShot> shots, double span_s, const FrontDuration &front = {});

    /// 0 < frequency_Hz <= 0.4 of every shot's rate.
    Point at(double frequency_Hz) const;

private:
    /// Shots of one rate, between 0.4 and 0.5 of it.
    struct TopOfBand
    {
        double rate_Hz = 0.0;
        double shots = 0.0;
        double largest = 0.0; ///< |S| there, as far as it stands out of the noise
    };

    Point over(double length_s, double frequency_Hz) const;
    void measureTops();
    double boundAlias(double frequency_Hz) const;
    double frontGain(double frequency_Hz, double change_s) const;

    std::vector<RecordOfShot> m_shots;
    std::vector<NoiseDensity> m_noise; ///< of each shot
    std::vector<TopOfBand> m_tops;
    FrontDuration m_front;
    double m_span_s = 0.0;
    double m_longest_s = 0.0; ///< window
};

} // namespace dyncal
