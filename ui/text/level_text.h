// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"

#include <QString>

namespace dyncal {

/// Words of the window for what captures and recipes name in English.
QString levelText(ShotLevel level); ///< "Low", ..., "–" without level
QString roleText(ChannelRole role); ///< "DUT", "Driven side", ...

} // namespace dyncal
