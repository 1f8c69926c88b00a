// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/record_response.h"

#include "core/base/constants.h"
#include "core/model_analysis/step_transform.h"
#include "core/signal/fft.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace dyncal {
namespace {

constexpr double kPeriodsKept = 20.0; ///< of the frequency asked, where the window has them

/// The steps between the samples; in the last tenth the record goes over to its level by half a
/// cosine, because a jump at the end would count at every frequency.
Eigen::VectorXd smoothlyEndedSteps(
    const Eigen::Ref<const Eigen::VectorXd> &y, const TransformEnd &end)
{
    Eigen::VectorXd steps(y.size() + 1);
    steps << y, end.level;
    for (Index k = 0; k < end.averaged; ++k) {
        const double share = static_cast<double>(k + 1) / static_cast<double>(end.averaged + 1);
        double &value = steps[y.size() - end.averaged + k];
        value = end.level + (value - end.level) * 0.5 * (1.0 + std::cos(std::numbers::pi * share));
    }
    for (Index k = y.size(); k > 0; --k)
        steps[k] -= steps[k - 1];
    return steps;
}

/// |S|^2 of the samples by bins of the rate, and what noise has of it.
void addPower(const RecordOfShot &shot, const NoiseDensity &noise, double length_s,
    const RealFft &fft, Eigen::ArrayXd &power, Eigen::ArrayXd &ofNoise)
{
    const double rate_Hz = shot.response->sampleRate_Hz;
    const auto y = samplesUsed(shot, length_s);
    const TransformEnd end = transformEnds(y, 0).back();
    const Eigen::VectorXcd spectrum = fft.forward(smoothlyEndedSteps(y, end));
    const Index first = spectrum.size() - power.size();
    for (Index k = 0; k < power.size(); ++k) {
        const double half
            = std::numbers::pi * static_cast<double>(first + k) / static_cast<double>(fft.length());
        const double toStep = shot.scale * half / std::sin(half);
        const double f_Hz = rate_Hz * half / std::numbers::pi;
        power[k] += toStep * toStep * std::norm(spectrum[first + k]);
        ofNoise[k] += 2.0 * shot.scale * shot.scale
            * stepTransformVariance(end, rate_Hz, noise.at(f_Hz).variance, 0.0, f_Hz);
    }
}

/// Largest |S| of a mean over `shots` spectra, as far as it stands out of the noise: by a single
/// bin, or by the mean of all (1.6: of a power that falls as 1/f^4 over the band).
double largestBeyondNoise(const Eigen::ArrayXd &power, const Eigen::ArrayXd &ofNoise, double shots)
{
    constexpr double kLargestOverMean = 1.6;
    // A mean of `shots` exponential variables exceeds 1 + sqrt(2 x) + x with less than e^(-shots
    // x): here once in a thousand spectra.
    constexpr double kLogOfRare = 7.0;
    const double bins = static_cast<double>(power.size());
    const double x = (std::log(bins) + kLogOfRare) / shots;
    const double single = (power - ofNoise * (1.0 + std::sqrt(2.0 * x) + x)).maxCoeff();
    const double spread = kSigmasOfNoise / std::sqrt(bins * shots);
    const double broad = (power - ofNoise * (1.0 + spread)).mean();
    return std::sqrt(std::max({0.0, single, kLargestOverMean * broad}) / shots);
}

} // namespace

RecordResponse::RecordResponse(
    std::vector<RecordOfShot> shots, double span_s, const FrontDuration &front)
    : m_shots(std::move(shots))
    , m_front(front)
    , m_span_s(span_s)
{
    for (RecordOfShot &shot : m_shots) {
        prepareShot(span_s, shot);
        const WindowedResponse &response = *shot.response;
        m_noise.emplace_back(response);
        m_longest_s
            = std::max(m_longest_s, static_cast<double>(response.length) / response.sampleRate_Hz);
    }
    measureTops();
}

void RecordResponse::measureTops()
{
    Index longest = 0;
    for (const RecordOfShot &shot : m_shots) {
        const double rate_Hz = shot.response->sampleRate_Hz;
        longest = std::max(longest, samplesUsed(shot, m_span_s).size());
        if (std::ranges::find(m_tops, rate_Hz, &TopOfBand::rate_Hz) == m_tops.end())
            m_tops.push_back({rate_Hz, 0.0, 0.0});
    }
    const RealFft fft(fastFftLength(longest + 1));
    const Index half = fft.length() / 2 + 1;
    const Index bins
        = half - static_cast<Index>(std::ceil(0.4 * static_cast<double>(fft.length())));
    for (TopOfBand &top : m_tops) {
        Eigen::ArrayXd power = Eigen::ArrayXd::Zero(std::max<Index>(bins, 1));
        Eigen::ArrayXd ofNoise = power;
        for (std::size_t i = 0; i < m_shots.size(); ++i) {
            if (m_shots[i].response->sampleRate_Hz != top.rate_Hz)
                continue;
            addPower(m_shots[i], m_noise[i], m_span_s, fft, power, ofNoise);
            top.shots += 1.0;
        }
        top.largest = largestBeyondNoise(power, ofNoise, top.shots);
    }
}

/// Of a front that lasts longer by `change_s`.
double RecordResponse::frontGain(double frequency_Hz, double change_s) const
{
    return std::abs(frontFactor(m_front.duration_s + change_s, {0.0, kTwoPi * frequency_Hz}));
}

double RecordResponse::boundAlias(double frequency_Hz) const
{
    double sum = 0.0;
    for (const TopOfBand &top : m_tops)
        sum += top.shots * top.largest * aliasShare(top.rate_Hz, frequency_Hz);
    return sum / static_cast<double>(m_shots.size());
}

RecordResponse::Point RecordResponse::at(double frequency_Hz) const
{
    // A sensor that rings on for longer needs more of the record, as far as noise lets it win.
    double length_s = std::max(m_span_s, kPeriodsKept / frequency_Hz);
    Point best = over(length_s, frequency_Hz);
    for (Point last = best; last.boundEnd > last.u_magnitude && length_s < m_longest_s;) {
        length_s *= 2.0;
        last = over(length_s, frequency_Hz);
        if (std::hypot(last.u_magnitude, last.boundEnd)
            < std::hypot(best.u_magnitude, best.boundEnd))
            best = last;
    }
    return best;
}

ShotPoint RecordResponse::pointOf(std::size_t shot, double length_s, double frequency_Hz) const
{
    return shotPoint(m_shots[shot], m_noise[shot], length_s, frequency_Hz);
}

RecordResponse::Point RecordResponse::over(double length_s, double frequency_Hz) const
{
    std::vector<ShotPoint> shots;
    double variance = 0.0, ofOnsets_s2 = 0.0;
    for (std::size_t i = 0; i < m_shots.size(); ++i) {
        shots.push_back(pointOf(i, length_s, frequency_Hz));
        variance += shots.back().variance;
        ofOnsets_s2 += shots.back().u_onset_s * shots.back().u_onset_s;
    }
    const double n = static_cast<double>(shots.size());
    const double front = frontGain(frequency_Hz, 0.0);
    Point point{meanMagnitude(shots) / front, meanPhase_rad(shots, kTwoPi * frequency_Hz),
        std::sqrt(variance) / n / front, 0.0, dofOf(shots), boundOfEnd(shots) / front,
        boundAlias(frequency_Hz) / front};
    point.length_s = std::min(length_s, m_longest_s);
    point.u_front = point.magnitude
        * std::abs(frontGain(frequency_Hz, m_front.u_s) - frontGain(frequency_Hz, -m_front.u_s))
        / (2.0 * front);
    point.u_phase_rad = std::hypot(
        point.u_magnitude / point.magnitude, kTwoPi * frequency_Hz * std::sqrt(ofOnsets_s2) / n);
    return point;
}

} // namespace dyncal
