// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/unwrapped_phase.h"

#include "core/base/constants.h"
#include "core/model_analysis/model_response.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

constexpr int kMostHalvings = 40;

} // namespace

std::vector<double> resonantFrequencies_Hz(const SensorModel &model, double from_Hz, double to_Hz)
{
    constexpr int kReach = 8; // in quarters of the full width 2 |Re s|
    std::vector<double> list;
    for (Index i = 0; i < model.amplitudes.size(); ++i) {
        const std::complex<double> s = model.poles[static_cast<std::size_t>(i)].s_rad_s;
        if (s.imag() <= 0.0)
            continue;
        for (int k = -kReach; k <= kReach; ++k) {
            const double f_Hz = (s.imag() + 0.5 * k * std::abs(s.real())) / kTwoPi;
            if (f_Hz >= from_Hz && f_Hz <= to_Hz)
                list.push_back(f_Hz);
        }
    }
    std::sort(list.begin(), list.end());
    return list;
}

UnwrappedPhase::UnwrappedPhase(const SensorModel &model, ResponseTreatment treatment)
    : m_model(model)
    , m_treatment(treatment)
{
    double slowest = std::numeric_limits<double>::infinity();
    for (Index i = 0; i < model.amplitudes.size(); ++i) {
        const double rate = std::abs(model.poles[static_cast<std::size_t>(i)].s_rad_s);
        slowest = rate > 0.0 ? std::min(slowest, rate) : slowest;
    }
    m_begin_Hz = std::isfinite(slowest) ? 1e-4 * slowest / kTwoPi : 1.0;
    m_resonances_Hz
        = resonantFrequencies_Hz(model, m_begin_Hz, std::numeric_limits<double>::infinity());
    m_here = point(m_begin_Hz);
    m_phase_rad = std::arg(m_here.G);
    const bool isNegative = m_here.G.real() < 0.0 && isStepTreatment(treatment);
    if (isNegative && m_phase_rad < 0.0)
        m_phase_rad += kTwoPi;
}

UnwrappedPhase::Point UnwrappedPhase::point(double frequency_Hz) const
{
    return {frequency_Hz, modelResponse(m_model, m_treatment, frequency_Hz)};
}

double UnwrappedPhase::turn(const Point &from, const Point &to, int halvings) const
{
    constexpr double kSmall_rad = 0.5;
    const double direct = std::remainder(std::arg(to.G) - std::arg(from.G), kTwoPi);
    if (halvings == 0 || !(std::abs(direct) > kSmall_rad))
        return direct;
    const Point middle = point(0.5 * (from.frequency_Hz + to.frequency_Hz));
    return turn(from, middle, halvings - 1) + turn(middle, to, halvings - 1);
}

void UnwrappedPhase::moveTo(double frequency_Hz)
{
    // Octave by octave, so that a slow change cannot make a whole turn unnoticed.
    while (m_here.frequency_Hz != frequency_Hz) {
        const double octave_Hz
            = std::clamp(frequency_Hz, 0.5 * m_here.frequency_Hz, 2.0 * m_here.frequency_Hz);
        const Point next = point(octave_Hz);
        m_phase_rad += turn(m_here, next, kMostHalvings);
        m_here = next;
    }
}

double UnwrappedPhase::at(double asked_Hz)
{
    if (!std::isfinite(asked_Hz))
        return kUnknown;
    constexpr double kAsGoodAsZero = 1e-12;
    const double frequency_Hz = std::max(asked_Hz, kAsGoodAsZero * m_begin_Hz);
    const bool isUp = frequency_Hz > m_here.frequency_Hz;
    const double low_Hz = isUp ? m_here.frequency_Hz : frequency_Hz;
    const double high_Hz = isUp ? frequency_Hz : m_here.frequency_Hz;
    const auto first = std::upper_bound(m_resonances_Hz.begin(), m_resonances_Hz.end(), low_Hz);
    const auto last = std::lower_bound(first, m_resonances_Hz.end(), high_Hz);
    std::vector<double> between(first, last);
    if (!isUp)
        std::reverse(between.begin(), between.end());
    for (const double f_Hz : between)
        moveTo(f_Hz);
    moveTo(frequency_Hz);
    return m_phase_rad;
}

} // namespace dyncal
