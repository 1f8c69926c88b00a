// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"
#include "core/consistency/way_comparison.h"

namespace dyncal {

Message comparedText(Compared of); ///< "Mach number"
Message wayText(Way way); ///< "arrivals"

} // namespace dyncal
