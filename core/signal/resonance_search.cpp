// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/resonance_search.h"

#include "core/base/distributions.h"
#include "core/base/least_squares.h"
#include "core/signal/level_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace dyncal {
namespace {

constexpr Index kLeastHalfWidth = 2; ///< bins on either side that are averaged
constexpr double kHalfWidthShare = 0.005; ///< of the frequency, where that is more bins
constexpr Index kFirstBin = 5;
constexpr double kLastShare = 0.9; ///< of Nyquist
constexpr double kLeastProminence_dB = 6.0;
constexpr double kFalseAlarm = 1e-3; ///< per spectrum of white noise
constexpr double kBackgroundOctaves = 1.0; ///< on either side
constexpr int kBackgroundPoints = 24; ///< on either side
constexpr double kNearest = 0.1; ///< of the frequency asked for

double decibels(double power)
{
    return 10.0 * std::log10(std::max(power, std::numeric_limits<double>::min()));
}

Index halfWidthAt(Index bin)
{
    return std::max(
        kLeastHalfWidth, static_cast<Index>(kHalfWidthShare * static_cast<double>(bin)));
}

/// Ratio to the mean that the mean of `count` exponentially distributed powers exceeds with
/// probability `p`.
double exceededRatio(double count, double p)
{
    double low = 1.0, high = 2.0;
    while (upperGammaRatio(count, count * high) > p)
        high *= 2.0;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (upperGammaRatio(count, count * middle) > p ? low : high) = middle;
    }
    return high;
}

/// Vertex of the least squares parabola through the log power of bins centre +- half, relative to
/// the centre; kept within that range.
double vertex(const Eigen::VectorXd &psd, Index centre, Index half)
{
    const Index n = 2 * half + 1;
    Eigen::MatrixXd terms(n, 3);
    Eigen::MatrixXd level(n, 1);
    for (Index i = 0; i < n; ++i) {
        const double x = static_cast<double>(i - half) / static_cast<double>(half);
        terms.row(i) << 1.0, x, x * x;
        level(i, 0) = decibels(psd[centre - half + i]);
    }
    const Eigen::MatrixXd c = leastSquares(terms, level);
    if (!(c(2, 0) < 0.0))
        return 0.0;
    return std::clamp(-0.5 * c(1, 0) / c(2, 0), -1.0, 1.0) * static_cast<double>(half);
}

/// Distance from `peak`, in steps of `direction`, to where `power` falls to half its value there,
/// interpolated linearly; up to the end if it does not.
template <typename Power>
double distanceToHalf(const Power &power, Index peak, Index direction, Index size)
{
    const double half = 0.5 * power(peak);
    Index i = peak;
    while (i + direction > 0 && i + direction < size && power(i + direction) > half)
        i += direction;
    const Index next = i + direction;
    if (next <= 0 || next >= size)
        return static_cast<double>(std::abs(i - peak));
    const double share = (power(i) - half) / (power(i) - power(next));
    return static_cast<double>(std::abs(i - peak)) + share;
}

} // namespace

ResonanceSearch::ResonanceSearch(const PowerSpectrum &spectrum, double averages)
    : m_spectrum(spectrum)
    , m_averages(averages)
{
    smooth();
}

void ResonanceSearch::smooth()
{
    const Index size = m_spectrum.psd.size();
    for (Index bin = 1; bin < size; bin += std::max<Index>(halfWidthAt(bin) / 2, 1))
        m_bins.push_back(bin);
    m_level_dB.resize(static_cast<Index>(m_bins.size()));
    for (Index i = 0; i < m_level_dB.size(); ++i) {
        const Index bin = m_bins[static_cast<std::size_t>(i)];
        const Index half = std::min({halfWidthAt(bin), bin - 1, size - 1 - bin});
        m_level_dB[i] = decibels(m_spectrum.psd.segment(bin - half, 2 * half + 1).mean());
    }
}

double ResonanceSearch::level_dB(double bin) const
{
    const auto next = std::lower_bound(m_bins.begin(), m_bins.end(), static_cast<Index>(bin + 0.5));
    const Index i = std::min(next - m_bins.begin(), m_level_dB.size() - 1);
    return m_level_dB[i];
}

/// Median over points spaced evenly in log frequency, so that the background of a monotone spectrum
/// is the spectrum itself. At the lower end the band shrinks on both sides for the same reason.
double ResonanceSearch::background_dB(Index point) const
{
    const auto centre = static_cast<double>(m_bins[static_cast<std::size_t>(point)]);
    const double octaves = std::min(kBackgroundOctaves, std::log2(centre));
    Eigen::VectorXd levels(2 * kBackgroundPoints + 1);
    Index used = 0;
    for (int i = -kBackgroundPoints; i <= kBackgroundPoints; ++i) {
        const double bin = centre * std::exp2(octaves * i / kBackgroundPoints);
        if (bin <= static_cast<double>(m_bins.back()))
            levels[used++] = level_dB(bin);
    }
    return median(levels.head(used));
}

double ResonanceSearch::needed_dB(Index point) const
{
    constexpr double kEnough = 40.0; ///< of so many powers the mean scatters by far less than 6 dB
    const Index bin = m_bins[static_cast<std::size_t>(point)];
    const double count = m_averages * static_cast<double>(2 * halfWidthAt(bin) + 1);
    if (count >= kEnough)
        return kLeastProminence_dB;
    const double p = kFalseAlarm / static_cast<double>(m_bins.size());
    return std::max(kLeastProminence_dB, decibels(exceededRatio(count, p)));
}

/// The least descent on the way from a grid point to a higher one; infinite for the highest point.
double ResonanceSearch::dipBeside(Index point) const
{
    double shallowest = std::numeric_limits<double>::infinity();
    for (const Index direction : {-1, 1}) {
        double lowest = m_level_dB[point];
        for (Index i = point; i >= 0 && i < m_level_dB.size(); i += direction) {
            if (m_level_dB[i] > m_level_dB[point]) {
                shallowest = std::min(shallowest, m_level_dB[point] - lowest);
                break;
            }
            lowest = std::min(lowest, m_level_dB[i]);
        }
    }
    return shallowest;
}

bool ResonanceSearch::isMaximum(Index point) const
{
    return point > 0 && point + 1 < m_level_dB.size() && m_level_dB[point] > m_level_dB[point - 1]
        && m_level_dB[point] >= m_level_dB[point + 1];
}

SpectralPeak ResonanceSearch::measured(Index point, double prominence_dB) const
{
    const Eigen::VectorXd &psd = m_spectrum.psd;
    const Index bin = m_bins[static_cast<std::size_t>(point)];
    const Index half = halfWidthAt(bin);
    const auto raw = [&](Index i) { return psd[i]; };
    const auto smoothed = [&](Index i) { // less than for the search: smoothing widens
        const Index h = std::min({std::max(half / 4, kLeastHalfWidth), i, psd.size() - 1 - i});
        return psd.segment(i - h, 2 * h + 1).mean();
    };
    double width = distanceToHalf(smoothed, bin, 1, psd.size())
        + distanceToHalf(smoothed, bin, -1, psd.size());
    Index centre = bin;
    if (width <= static_cast<double>(4 * half)) { // as narrow as the smoothing: look at single bins
        const Index begin = std::max<Index>(bin - half, 1);
        const Index count = std::min(bin + half + 1, psd.size()) - begin;
        psd.segment(begin, count).maxCoeff(&centre);
        centre += begin;
        width = distanceToHalf(raw, centre, 1, psd.size())
            + distanceToHalf(raw, centre, -1, psd.size());
    }
    const Index reach = std::min(
        {std::max<Index>(static_cast<Index>(0.4 * width), 1), centre - 1, psd.size() - 1 - centre});
    const double offset = reach > 0 ? vertex(psd, centre, reach) : 0.0;
    const double place = static_cast<double>(centre) + offset;
    return {place * m_spectrum.frequency_Hz[1], prominence_dB, place / std::max(width, 1.0)};
}

std::vector<SpectralPeak> ResonanceSearch::prominentPeaks(
    const std::optional<Interval> &band_Hz) const
{
    std::vector<SpectralPeak> peaks;
    const double last = kLastShare * static_cast<double>(m_spectrum.psd.size() - 1);
    for (Index i = 0; i < m_level_dB.size(); ++i) {
        const Index bin = m_bins[static_cast<std::size_t>(i)];
        if (bin < kFirstBin || static_cast<double>(bin) > last || !isMaximum(i))
            continue;
        if (band_Hz && !band_Hz->contains(m_spectrum.frequency_Hz[bin]))
            continue;
        const double prominence_dB = m_level_dB[i] - background_dB(i);
        if (prominence_dB >= needed_dB(i) && dipBeside(i) >= kLeastProminence_dB)
            peaks.push_back(measured(i, prominence_dB));
    }
    std::stable_sort(peaks.begin(), peaks.end(), [](const SpectralPeak &a, const SpectralPeak &b) {
        return a.prominence_dB > b.prominence_dB;
    });
    return peaks;
}

std::optional<SpectralPeak> ResonanceSearch::nearestPeak(double frequency_Hz) const
{
    std::optional<Index> nearest;
    double distance = kNearest;
    for (Index i = 0; i < m_level_dB.size(); ++i) {
        const Index bin = m_bins[static_cast<std::size_t>(i)];
        const double apart = std::abs(m_spectrum.frequency_Hz[bin] / frequency_Hz - 1.0);
        if (isMaximum(i) && apart <= distance) {
            nearest = i;
            distance = apart;
        }
    }
    if (!nearest)
        return std::nullopt;
    return measured(*nearest, m_level_dB[*nearest] - background_dB(*nearest));
}

double refinedFrequency_Hz(const Eigen::Ref<const Eigen::VectorXd> &values, double rate_Hz,
    double frequency_Hz, double bin_Hz)
{
    constexpr int kPerBin = 8, kReach = 6; ///< eighths of a bin on either side
    std::array<double, 2 * kReach + 1> level_dB{};
    for (int j = -kReach; j <= kReach; ++j) {
        const double at_Hz = frequency_Hz + bin_Hz * j / kPerBin;
        const auto turn = std::polar(1.0, -2.0 * std::numbers::pi * at_Hz / rate_Hz);
        std::complex<double> sum, phasor = 1.0;
        for (const double value : values) {
            sum += value * phasor;
            phasor *= turn;
        }
        level_dB[static_cast<std::size_t>(j + kReach)] = decibels(std::norm(sum));
    }
    const auto top = std::max_element(level_dB.begin() + 1, level_dB.end() - 1);
    const double bend = top[-1] - 2.0 * top[0] + top[1];
    const double offset = bend < 0.0 ? std::clamp(0.5 * (top[-1] - top[1]) / bend, -1.0, 1.0) : 0.0;
    const auto place = static_cast<double>(top - level_dB.begin() - kReach) + offset;
    return frequency_Hz + bin_Hz * place / kPerBin;
}

} // namespace dyncal
