// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/rounding.h"

#include "core/signal/level_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dyncal {
namespace {

constexpr Index kMostLooked = 8192;
constexpr Index kFewestDifferent = 8;
constexpr double kLastBits = 4.0; ///< error of a difference, in last bits of the values
constexpr double kBelievable = 100.0; ///< a step is larger than its error by this much
constexpr double kTwoValues = 1.5; ///< resolutions; a smaller range holds two values at most
constexpr int kMostTerms = 1000;
constexpr int kMostDivisions = 100; ///< Euclid's algorithm needs fewer for any two doubles

/// A difference of two values, and by how much it may be off.
struct Difference
{
    double size = 0.0;
    double error = 0.0;
};

/// Largest step that both a and b are multiples of (Euclid); of size 0 if the errors are as large
/// as the step.
Difference commonDivisor(Difference a, Difference b)
{
    if (a.size < b.size)
        std::swap(a, b);
    for (int i = 0; i < kMostDivisions && b.size > kBelievable * b.error; ++i) {
        const double multiple = std::round(a.size / b.size);
        const Difference rest{std::abs(a.size - multiple * b.size), a.error + multiple * b.error};
        if (rest.size <= rest.error)
            return a.error < b.error * multiple ? Difference{a.size / multiple, a.error / multiple}
                                                : b;
        a = b;
        b = rest;
    }
    return {};
}

/// The finite ones of at most kMostLooked samples spread evenly over the range.
Eigen::VectorXd someRawValues(const Channel &channel, const SampleRange &range)
{
    const Index stride = std::max<Index>(1, (range.size() + kMostLooked - 1) / kMostLooked);
    const Index count = (range.size() + stride - 1) / stride;
    Eigen::VectorXd values(count);
    const RawSamples samples = channel.samples.inMemory(range.begin, range.size());
    if (samples.size() == 0)
        return {};
    for (Index i = 0; i < count; ++i)
        values[i] = samples.at(i * stride);
    return finiteOnly(std::move(values));
}

Eigen::VectorXd notBelow(double magnitude, Eigen::VectorXd values)
{
    const auto end = std::remove_if(values.begin(), values.end(),
        [magnitude](double value) { return std::abs(value) < magnitude; });
    values.conservativeResize(end - values.begin());
    return values;
}

/// Physical units per raw unit around `raw`.
double slopeAt(const Channel &channel, double raw, double distance)
{
    return std::abs(physicalValue(channel, raw + distance) - physicalValue(channel, raw - distance))
        / (2.0 * distance);
}

} // namespace

double commonStep(Eigen::VectorXd values)
{
    std::sort(values.begin(), values.end());
    const Index count = std::unique(values.begin(), values.end()) - values.begin();
    if (count < kFewestDifferent)
        return 0.0;
    const double largest = std::max(std::abs(values[0]), std::abs(values[count - 1]));
    const double error = kLastBits * std::numeric_limits<double>::epsilon() * largest;
    Eigen::VectorXd differences = values.segment(1, count - 1) - values.head(count - 1);
    std::sort(differences.begin(), differences.end()); // small multiples first: errors stay small
    Difference step{differences[0], error};
    for (Index i = 1; i < differences.size() && step.size > 0.0; ++i)
        step = commonDivisor({differences[i], error}, step);
    return step.size;
}

double resolutionOf(const Channel &channel, const SampleRange &range)
{
    if (range.size() <= 0)
        return 0.0;
    if (channel.samples.isInteger())
        return countSize(channel, channel.samples.at(range.begin));
    const Eigen::VectorXd values = someRawValues(channel, range);
    if (values.size() == 0)
        return 0.0;
    const double largest = values.cwiseAbs().maxCoeff();
    if (!(largest > 0.0))
        return 0.0;
    // Numbers with a fixed count of digits have finer steps near 0, so the large values decide:
    // those of the last binary octave or decimal decade.
    const double decade = std::pow(10.0, std::floor(std::log10(largest)));
    const double lastBit = std::numeric_limits<double>::epsilon() * largest;
    const double step = std::max({commonStep(notBelow(0.5 * largest, values)),
        commonStep(notBelow(decade, values)), lastBit});
    return step * slopeAt(channel, largest, 1e-3 * largest);
}

double noiseBeforeRounding(const Eigen::Ref<const Eigen::VectorXd> &noise, double resolution)
{
    if (noise.size() < 2 || noise.maxCoeff() - noise.minCoeff() <= kTwoValues * resolution)
        return 0.0;
    const double variance = (noise.array() - noise.mean()).square().mean();
    return std::sqrt(std::max(0.0, variance - resolution * resolution / 12.0));
}

double lastingRounding(double noiseSd, double resolution)
{
    if (!(resolution > 0.0))
        return 0.0;
    if (!(noiseSd > 0.0))
        return resolution / std::sqrt(12.0);
    const double exponent = 4.0 * std::pow(std::numbers::pi * noiseSd / resolution, 2);
    double sum = 0.0;
    for (int k = 1; k <= kMostTerms; ++k) {
        const double square = static_cast<double>(k) * static_cast<double>(k);
        const double term = std::exp(-exponent * square) / square;
        sum += term;
        if (term <= 1e-6 * sum)
            break;
    }
    return resolution * std::sqrt(0.5 * sum) / std::numbers::pi;
}

} // namespace dyncal
