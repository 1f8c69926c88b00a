// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_conditions.h"

#include <algorithm>

namespace dyncal {

const ShockConditions *ShockConditionsSet::ofShot(Index shot) const
{
    const auto found = std::find_if(
        shots.begin(), shots.end(), [&](const ShockConditions &s) { return s.shot == shot; });
    return found != shots.end() ? &*found : nullptr;
}

} // namespace dyncal
