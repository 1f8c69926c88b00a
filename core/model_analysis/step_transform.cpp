// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/step_transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

} // namespace

std::complex<double> stepTransform(const Eigen::Ref<const Eigen::VectorXd> &y, double rate_Hz,
    double endLevel, double onset_s, double frequency_Hz)
{
    const double w = 2.0 * std::numbers::pi * frequency_Hz;
    const double x = w / rate_Hz;
    const Rotation rotation(x);
    std::complex<double> D = y.size() > 0 ? y[0] : 0.0;
    for (Index n = 1; n < y.size(); n += kBlock) {
        const Index count = std::min(kBlock, y.size() - n);
        D += rotation.sum(y.segment(n, count) - y.segment(n - 1, count))
            * std::polar(1.0, -x * static_cast<double>(n));
    }
    const double previous = y.size() > 0 ? y[y.size() - 1] : 0.0;
    D += (endLevel - previous) * std::polar(1.0, -x * static_cast<double>(y.size()));
    return D * sampledStepCorrection(x) * std::polar(1.0, w * onset_s);
}

std::complex<double> stepTransformError(
    const ExponentialSum &sum, Index samples, double rate_Hz, double onset_s, double frequency_Hz)
{
    if (frequency_Hz == 0.0)
        return 0.0; // at frequency 0 stepTransform() gives the plateau exactly
    const std::complex<double> jw(0.0, 2.0 * std::numbers::pi * frequency_Hz);
    const double first
        = std::clamp(std::ceil(onset_s * rate_Hz - 1e-9), 0.0, static_cast<double>(samples));
    const double end = static_cast<double>(samples);
    // Sum over the samples from the onset on of e^(s (t - onset)) e^(-jwt).
    const auto spectrum = [&](std::complex<double> s) {
        const std::complex<double> perSample = (s - jw) / rate_Hz;
        return std::exp(-s * onset_s) * (std::exp(perSample * first) - std::exp(perSample * end))
            / (1.0 - std::exp(perSample));
    };
    std::complex<double> Y = sum.constant * spectrum(0.0);
    std::complex<double> G = sum.constant;
    for (Index i = 0; i < sum.poles_rad_s.size(); ++i) {
        const std::complex<double> s = sum.poles_rad_s[i];
        Y += sum.amplitudes[i] * spectrum(s);
        G += sum.amplitudes[i] * jw / (jw - s);
    }
    const double x = jw.imag() / rate_Hz;
    const std::complex<double> D
        = (1.0 - std::polar(1.0, -x)) * Y + sum.constant * std::polar(1.0, -x * end);
    return D * sampledStepCorrection(x) * std::exp(jw * onset_s) - G;
}

double stepTransformNoise(Index samples, double rate_Hz, double noiseSd, double frequency_Hz)
{
    const double x = 2.0 * std::numbers::pi * frequency_Hz / rate_Hz;
    return noiseSd * std::abs(1.0 - std::polar(1.0, -x))
        * std::sqrt(static_cast<double>(samples) / 2.0) * std::abs(sampledStepCorrection(x));
}

} // namespace dyncal
