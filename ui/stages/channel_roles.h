// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"

#include <QString>

#include <string>
#include <vector>

namespace dyncal {

/// The role that the channel of this name has in most of the shots that have it; the first of
/// several as frequent.
ChannelRole usualRole(const std::vector<Shot> &shots, const std::string &channel);

/// In which shots which channels have another role than usually, as a sentence for each shot; empty
/// where there are none.
QString otherRoles(const std::vector<Shot> &shots);

} // namespace dyncal
