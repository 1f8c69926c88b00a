// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/channel.h"

#include <array>

namespace dyncal {

/// What a channel or dataset can be imported as, in the order in which it is offered.
inline constexpr std::array kOfferedRoles{ChannelRole::Dut, ChannelRole::DrivenSide,
    ChannelRole::Driver, ChannelRole::Trigger, ChannelRole::Reference, ChannelRole::Other};

} // namespace dyncal
