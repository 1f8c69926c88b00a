// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/level_statistics.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr Index kRestPieces = 20;
constexpr double kRestShare = 0.1; ///< of the event's height
constexpr double kRestSigmas = 6.0;

/// Sample positions of a stretch, counted from its middle.
auto centredPositions(Index size)
{
    const double half = 0.5 * static_cast<double>(size - 1);
    return Eigen::ArrayXd::LinSpaced(size, -half, half);
}

} // namespace

LineFit fitLine(const Eigen::Ref<const Eigen::VectorXd> &values)
{
    const Index n = values.size();
    LineFit fit;
    if (n == 0)
        return fit;
    fit.mean = values.mean();
    if (n < 2)
        return fit;
    const Eigen::ArrayXd position = centredPositions(n);
    fit.slope = (position * (values.array() - fit.mean)).sum() / position.square().sum();
    if (n > 2) {
        const double rest = (values.array() - fit.mean - fit.slope * position).square().sum();
        fit.sd = std::sqrt(rest / static_cast<double>(n - 2));
    }
    return fit;
}

double uOfSlope(double sd, Index count)
{
    const auto n = static_cast<double>(count);
    return sd / std::sqrt(n * (n * n - 1.0) / 12.0);
}

Eigen::VectorXd meansOf(const Eigen::Ref<const Eigen::VectorXd> &values, Index each)
{
    Eigen::VectorXd means(values.size() / each);
    for (Index i = 0; i < means.size(); ++i)
        means[i] = values.segment(i * each, each).mean();
    return means;
}

Eigen::VectorXd withoutLine(const Eigen::Ref<const Eigen::VectorXd> &values)
{
    if (values.size() == 0)
        return values;
    const LineFit fit = fitLine(values);
    return (values.array() - fit.mean - fit.slope * centredPositions(values.size())).matrix();
}

double median(Eigen::VectorXd values)
{
    const Index n = values.size();
    if (n == 0)
        return 0.0;
    const auto middle = values.begin() + n / 2;
    std::nth_element(values.begin(), middle, values.end());
    if (n % 2 == 1)
        return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

Eigen::VectorXd finiteOnly(Eigen::VectorXd values)
{
    const auto end = std::remove_if(
        values.begin(), values.end(), [](double value) { return !std::isfinite(value); });
    values.conservativeResize(end - values.begin());
    return values;
}

double robustNoiseSd(const Eigen::Ref<const Eigen::VectorXd> &values, Index piece)
{
    const Index n = values.size();
    const Index pieces
        = std::max<Index>(n / piece, 1); // equal pieces: a line fits a short last one too well
    Eigen::VectorXd rest(n);
    for (Index i = 0; i < pieces; ++i) {
        const Index begin = i * n / pieces, count = (i + 1) * n / pieces - begin;
        rest.segment(begin, count) = withoutLine(values.segment(begin, count));
    }
    Eigen::VectorXd size = rest.cwiseAbs();
    const double sd = kNormalSdPerMad * median(size);
    if (sd > 0.0 || n == 0)
        return sd;
    const Index kept = n - n / 10; // the largest tenth may be spikes
    std::nth_element(size.begin(), size.begin() + kept - 1, size.end());
    return std::sqrt(size.head(kept).squaredNorm() / static_cast<double>(kept));
}

bool isAtRest(const Eigen::Ref<const Eigen::VectorXd> &values, double height, double noiseSd)
{
    const Index piece = std::max<Index>(values.size() / kRestPieces, 8);
    double lowest = 0.0, highest = 0.0;
    for (Index begin = 0; begin + piece <= values.size(); begin += piece) {
        const double level = median(values.segment(begin, piece));
        lowest = begin == 0 ? level : std::min(lowest, level);
        highest = begin == 0 ? level : std::max(highest, level);
    }
    const double noise = kRestSigmas * noiseSd / std::sqrt(static_cast<double>(piece));
    return highest - lowest <= std::max(kRestShare * std::abs(height), noise);
}

double countSize(const Channel &channel, double raw)
{
    if (!channel.samples.isInteger())
        return 0.0;
    return std::abs(physicalValue(channel, raw + 1.0) - physicalValue(channel, raw));
}

} // namespace dyncal
