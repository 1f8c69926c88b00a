// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/model/sensor_model.h"
#include "core/signal/signal_settings.h"

#include <complex>
#include <vector>

namespace dyncal {

/// Frequencies within [from_Hz, to_Hz] at which the response may change fast, ascending: about the
/// damped frequency of every pole, up to four half widths away.
std::vector<double> resonantFrequencies_Hz(const SensorModel &model, double from_Hz, double to_Hz);

/// Phase of modelResponse() on the branch that is 0 (a negative plateau: +pi) at f -> 0. It is
/// followed from there through every resonance, whatever the spacing and width of the modes.
class UnwrappedPhase
{
public:
    UnwrappedPhase(const SensorModel &model, ResponseTreatment treatment);

    /// In radians; unknown where the frequency is not finite. Fastest for ascending frequencies.
    double at(double asked_Hz);

private:
    struct Point
    {
        double frequency_Hz = 0.0;
        std::complex<double> G;
    };

    Point point(double frequency_Hz) const;
    double turn(const Point &from, const Point &to, int halvings) const;
    void moveTo(double frequency_Hz);

    const SensorModel &m_model;
    ResponseTreatment m_treatment;
    std::vector<double> m_resonances_Hz;
    double m_begin_Hz = 0.0; ///< so low that nothing has turned yet
    Point m_here;
    double m_phase_rad = 0.0;
};

} // namespace dyncal
