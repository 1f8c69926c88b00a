// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"

namespace dyncal {

/// The shock of the last run. Where that did not come to the model, whose onset makes it final:
/// what the run knows of the shock before any model, from the detected starts. Where that is
/// nothing, the last good one; null without any. Valid until the session's results change.
const ShockConditionsSet *shockOnShow(const Session &session);
/// Whether it is the last good one, of an older recipe.
bool isOldShockOnShow(const Session &session);

} // namespace dyncal
