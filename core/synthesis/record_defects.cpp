// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/record_defects.h"

#include "core/capture/channel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

constexpr double kPascalPerPsi = 6894.757293168361;
constexpr Index kInvalidSamples = 3;

} // namespace

void spoilWithInvalidSamples(Channel &channel, double time_s)
{
    const Index count = channel.samples.size();
    const Eigen::VectorXd volts = physicalValues(channel, 0, count);
    std::vector<double> values(volts.begin(), volts.end());
    const double position = std::ceil((time_s - channel.t0_s) * channel.sampleRate_Hz);
    const Index first = std::clamp<Index>(
        static_cast<Index>(position), 0, std::max<Index>(count - kInvalidSamples, 0));
    for (Index i = first; i < std::min(count, first + kInvalidSamples); ++i)
        values[static_cast<std::size_t>(i)] = std::numeric_limits<double>::quiet_NaN();
    channel.adcMin = physicalValue(channel, *channel.adcMin);
    channel.adcMax = physicalValue(channel, *channel.adcMax);
    channel.polynomial = {0.0, 1.0};
    channel.samples = RawSamples(std::move(values));
}

void mislabelAsBar(Channel &channel, double sensitivity_V_Pa)
{
    for (double &coefficient : channel.polynomial)
        coefficient /= sensitivity_V_Pa * kPascalPerPsi;
    channel.unit = "bar";
    channel.quantity = "pressure";
    channel.reference = PressureReference::Gauge;
}

void swapRoles(Shot &shot)
{
    for (Channel &channel : shot.channels) {
        if (channel.role == ChannelRole::Dut)
            channel.role = ChannelRole::DrivenSide;
        else if (channel.role == ChannelRole::DrivenSide)
            channel.role = ChannelRole::Dut;
    }
}

void misstateScale(Channel &channel, double factor)
{
    for (double &coefficient : channel.polynomial)
        coefficient *= factor;
}

} // namespace dyncal
