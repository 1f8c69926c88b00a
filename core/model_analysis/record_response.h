// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/noise_density.h"
#include "core/model_analysis/response_source.h"
#include "core/model_analysis/shot_point.h"
#include "core/realization/exponentials/front.h"

#include <vector>

namespace dyncal {

/// S(f) from the records alone, mean over the shots, with two bounds of its error
/// (docs/method/response.md). The magnitude holds for any model, or none.
class RecordResponse : public ResponseSource
{
public:
    using Point = ResponsePoint;

    /// At least one shot. Of every record `span_s` or 20 periods are used, because noise grows with
    /// the length; twice, four times ... as much while its end would change S by more than noise.
    /// What the front takes off is divided out (docs/method/front.md).
    RecordResponse(std::vector<RecordOfShot> shots, double span_s, const FrontDuration &front = {});

    Point at(double frequency_Hz) const override;

    /// What one shot (by its place) alone says, over so long behind its detected start.
    ShotPoint pointOf(std::size_t shot, double length_s, double frequency_Hz) const;

private:
    /// Shots of one rate, between 0.4 and 0.5 of it.
    struct TopOfBand
    {
        double rate_Hz = 0.0;
        double shots = 0.0;
        double largest = 0.0; ///< |S| there, as far as it stands out of the noise
    };

    /// Of the records over so long.
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
