// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/values/plot_content.h"

namespace dyncal {

/// Whether two contents are equal except for the places and words of their marks and levels
/// (without bands) and their summary.
bool isSameButDecorations(const PlotContent &a, const PlotContent &b);

/// Whether their marks and levels are equal, in place, words and role.
bool hasSameDecorations(const PlotContent &a, const PlotContent &b);

} // namespace dyncal
