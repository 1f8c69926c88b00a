// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/step_transform.h"

#include "core/base/constants.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

/// jx / (1 - e^(-jx)), 1 at x = 0.
std::complex<double> sampledStepCorrection(double x)
{
    if (x == 0.0)
        return 1.0;
    return std::complex<double>(0.0, x) / (1.0 - std::polar(1.0, -x));
}

constexpr Index kBlock = 256; ///< a table of this length stays in the nearest cache

/// e^(-jxn) for the samples of one block: a whole record is turned block by block.
class Rotation
{
public:
    explicit Rotation(double x)
    {
        for (Index n = 0; n < kBlock; ++n) {
            m_cos[n] = std::cos(x * static_cast<double>(n));
            m_sin[n] = -std::sin(x * static_cast<double>(n));
        }
    }

    /// Sum of d_n e^(-jxn), n = 0 .. at most kBlock - 1.
    template <typename Differences>
    std::complex<double> sum(const Differences &d) const
    {
        const Table values = d;
        return {values.dot(m_cos.head(values.size())), values.dot(m_sin.head(values.size()))};
    }

private:
    using Table = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kBlock, 1>;
    Table m_cos = Table(kBlock);
    Table m_sin = Table(kBlock);
};

TransformEnd endAfter(const Eigen::Ref<const Eigen::VectorXd> &y, Index samples)
{
    constexpr Index kPart = 10;
    if (samples == 0)
        return {};
    const Index averaged = std::max<Index>(1, samples / kPart);
    return {samples, averaged, y.segment(samples - averaged, averaged).mean()};
}

} // namespace

std::vector<TransformEnd> transformEnds(const Eigen::Ref<const Eigen::VectorXd> &y, Index cuts)
{
    std::vector<TransformEnd> ends;
    const Index third = y.size() / 3;
    for (Index k = 0; k < cuts; ++k)
        ends.push_back(endAfter(y, y.size() - third + k * third / cuts));
    ends.push_back(endAfter(y, y.size()));
    return ends;
}

std::vector<std::complex<double>> stepTransforms(const Eigen::Ref<const Eigen::VectorXd> &y,
    double rate_Hz, const std::vector<TransformEnd> &ends, double onset_s, double frequency_Hz)
{
    const double w = kTwoPi * frequency_Hz;
    const double x = w / rate_Hz;
    const Rotation rotation(x);
    const std::complex<double> toStep = sampledStepCorrection(x) * std::polar(1.0, w * onset_s);
    const auto turned = [&](Index n) { return std::polar(1.0, -x * static_cast<double>(n)); };
    std::complex<double> D = y.size() > 0 ? y[0] : 0.0;
    std::vector<std::complex<double>> transforms;
    Index n = 1;
    for (const TransformEnd &end : ends) {
        for (Index count = 0; n < end.samples; n += count) {
            count = std::min(kBlock, end.samples - n);
            D += rotation.sum(y.segment(n, count) - y.segment(n - 1, count)) * turned(n);
        }
        const double last = end.samples > 0 ? y[end.samples - 1] : 0.0;
        transforms.push_back((D + (end.level - last) * turned(end.samples)) * toStep);
    }
    return transforms;
}

double stepTransformVariance(
    const TransformEnd &end, double rate_Hz, double density, double atZero, double frequency_Hz)
{
    const double x = kTwoPi * frequency_Hz / rate_Hz;
    const double ofSamples = 0.5 * density * x * x * static_cast<double>(end.samples);
    if (end.averaged == 0)
        return ofSamples;
    // The level and the samples that it is the mean of vary together.
    const double m = static_cast<double>(end.averaged);
    const double ofLevel = atZero * std::norm(sampledStepCorrection(x))
        * std::max(0.0, 2.0 * std::cos(x * m) - 1.0) / m;
    return ofSamples + ofLevel;
}

double aliasShare(double rate_Hz, double frequency_Hz)
{
    constexpr double kSmall = 1e-3; // below, the difference of the closed form loses its digits
    constexpr double kPi = std::numbers::pi;
    const double r = frequency_Hz / rate_Hz;
    if (r < kSmall)
        return 0.5 * r * kPi * kPi / 3.0;
    // sum over all m of 1/(r + m)^2 is (pi/sin(pi r))^2.
    const double all = kPi / std::sin(kPi * r);
    return 0.5 * r * (all * all - 1.0 / (r * r));
}

} // namespace dyncal
