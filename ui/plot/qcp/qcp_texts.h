// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/qcp/qcp_scene.h"
#include "ui/plot/values/plot_text.h"

#include <vector>

namespace dyncal {

/// All texts of a plot that was drawn: title, legend, axes, ticks, and what stands inside.
std::vector<PlotText> textsOf(const QCustomPlot &plot, const PlotScene &scene);

} // namespace dyncal
