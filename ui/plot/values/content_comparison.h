// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/values/plot_content.h"

namespace dyncal {

/// Whether two contents differ by the places and words of their marks and levels (without bands)
/// and by their summary at most.
bool isSameButDecorations(const PlotContent &a, const PlotContent &b);

} // namespace dyncal
