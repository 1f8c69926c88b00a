// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/channel.h"

#include <array>
#include <limits>
#include <utility>

namespace dyncal {
namespace {

constexpr std::array<std::pair<const char *, ChannelRole>, 8> kRoles{
    {{"dut", ChannelRole::Dut}, {"driven_side", ChannelRole::DrivenSide},
        {"driver", ChannelRole::Driver}, {"trigger", ChannelRole::Trigger},
        {"reference", ChannelRole::Reference}, {"other", ChannelRole::Other},
        {"velocity", ChannelRole::DrivenSide}, {"driver_static", ChannelRole::Driver}}};

} // namespace

const char *channelRoleName(ChannelRole role)
{
    for (const auto &[name, value] : kRoles) {
        if (value == role)
            return name;
    }
    return "other";
}

ChannelRole channelRoleFromName(std::string_view name)
{
    for (const auto &[known, value] : kRoles) {
        if (name == known)
            return value;
    }
    return ChannelRole::Other;
}

const char *pressureReferenceName(PressureReference reference)
{
    switch (reference) {
    case PressureReference::Gauge:
        return "gauge";
    case PressureReference::Absolute:
        return "absolute";
    case PressureReference::Unknown:
        break;
    }
    return "";
}

double physicalValue(const Channel &channel, double raw)
{
    double value = 0.0; // Horner
    for (auto c = channel.polynomial.rbegin(); c != channel.polynomial.rend(); ++c)
        value = value * raw + *c;
    return channel.polarity * channel.userScale * value;
}

Eigen::VectorXd physicalValues(const Channel &channel, Index begin, Index count)
{
    Eigen::VectorXd values(count);
    const bool complete
        = channel.samples.visitBlocks(begin, begin + count, [&](auto counts, Index first) {
              double *target = values.data() + (first - begin);
              for (const auto raw : counts)
                  *target++ = physicalValue(channel, static_cast<double>(raw));
          });
    if (!complete)
        values.setConstant(std::numeric_limits<double>::quiet_NaN());
    return values;
}

} // namespace dyncal
