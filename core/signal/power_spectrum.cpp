// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/power_spectrum.h"

#include "core/base/number_text.h"
#include "core/signal/fft.h"
#include "core/signal/level_statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace dyncal {
namespace {

constexpr Index kLeastSegment = 8;

/// Periodic Hann, or ones.
Eigen::ArrayXd taperOf(Taper taper, Index length)
{
    if (taper == Taper::Rectangular)
        return Eigen::ArrayXd::Ones(length);
    return Eigen::ArrayXd::NullaryExpr(length, [&](Index i) {
        const double turn = static_cast<double>(i) / static_cast<double>(length);
        return 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * turn);
    });
}

Eigen::VectorXd detrended(const Eigen::Ref<const Eigen::VectorXd> &values, Detrend detrend)
{
    switch (detrend) {
    case Detrend::None:
        break;
    case Detrend::Mean:
        return (values.array() - values.mean()).matrix();
    case Detrend::Linear:
        return withoutLine(values);
    }
    return values;
}

} // namespace

SpectrumSegments segmentsOf(Index size, const SpectrumSettings &settings)
{
    if (settings.method == SpectrumMethod::Periodogram)
        return {size, size, 1};
    const Index wanted = settings.segment.value_or(size / 8);
    const Index length = std::clamp(wanted, kLeastSegment, size);
    const Index hop = std::max<Index>(length / 2, 1);
    return {length, hop, (size - length) / hop + 1};
}

Eigen::VectorXd asOneSegment(
    const Eigen::Ref<const Eigen::VectorXd> &values, const SpectrumSettings &settings)
{
    return detrended(values, settings.detrend).array() * taperOf(settings.taper, values.size());
}

Result<PowerSpectrum> computePowerSpectrum(const Eigen::Ref<const Eigen::VectorXd> &values,
    double rate_Hz, const SpectrumSettings &settings)
{
    const bool isRate = rate_Hz > 0.0 && std::isfinite(rate_Hz);
    if (values.size() < kLeastSegment || !values.allFinite() || !isRate)
        return fail(ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "A power spectrum needs at least %1 valid samples at a known rate; there are %2 samples at %3."),
                {std::to_string(kLeastSegment), std::to_string(values.size()),
                    numberWithUnit(rate_Hz, "Hz")}});
    const SpectrumSegments segments = segmentsOf(values.size(), settings);
    const Eigen::ArrayXd taper = taperOf(settings.taper, segments.length);
    const RealFft fft(segments.length);
    Eigen::VectorXd power = Eigen::VectorXd::Zero(segments.length / 2 + 1);
    for (Index i = 0; i < segments.count; ++i) {
        const Eigen::VectorXd segment
            = detrended(values.segment(i * segments.hop, segments.length), settings.detrend).array()
            * taper;
        power += fft.forward(segment).cwiseAbs2();
    }
    power *= 2.0 / (rate_Hz * taper.square().sum() * static_cast<double>(segments.count));
    power[0] *= 0.5; // these two have no partner at the negative frequency
    if (segments.length % 2 == 0)
        power[power.size() - 1] *= 0.5;
    if (!power.allFinite())
        return fail(ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "The power spectrum exceeds the range of numbers: the largest value is %1; check the scale of the channel."),
                {numberText(values.cwiseAbs().maxCoeff(), 3)}});
    const double df_Hz = rate_Hz / static_cast<double>(segments.length);
    const auto last = static_cast<double>(power.size() - 1);
    return PowerSpectrum{
        Eigen::VectorXd::LinSpaced(power.size(), 0.0, last) * df_Hz, std::move(power)};
}

} // namespace dyncal
