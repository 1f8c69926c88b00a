// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/qcp/qcp_curve.h"

namespace dyncal {

enum class DataAxis { X, Y, SecondY };

/// What an axis has to show of a content, with a margin where points would lie on the edge.
QCPRange dataRange(DataAxis of, const PlotContent &content, const std::vector<DrawnCurve> &curves);

/// `range`, or the next to it that can be drawn and left again: not so narrow, so wide or so far
/// from `home`, which shows all, that the digits of a double no longer tell its pixels apart.
QCPRange drawableRange(const QCPRange &range, const QCPRange &home, bool logarithmic);

} // namespace dyncal
