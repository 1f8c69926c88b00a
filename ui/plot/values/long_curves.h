// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "ui/plot/values/plot_content.h"

namespace dyncal {

/// A plot of more points than this is not made while the window waits.
inline constexpr Index kManyPoints = 600'000;
/// A curve of such a plot with more points than this is condensed.
inline constexpr Index kLongCurve = 20'000;

/// The same plot with each curve of more than `most` points behind a record of its own
/// (PlotCurve::record), so that a view costs what its pixels cost: x and y then hold the extremes
/// of some thousand columns, even on the scale of the x axis. Points that the axes cannot show (x
/// not finite, x or y not above zero on a logarithmic axis) are left out, as a plot leaves them
/// out. A curve whose x does not ascend, or that is no line, stays as it is.
PlotContent condensed(PlotContent content, Index most = kLongCurve);

} // namespace dyncal
