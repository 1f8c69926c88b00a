// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/qcp/qcp_curve.h"

namespace dyncal {

enum class DataAxis { X, Y, SecondY };

/// What an axis has to show of a content, with a margin where points would lie on the edge.
QCPRange dataRange(DataAxis of, const PlotContent &content, const std::vector<DrawnCurve> &curves);

} // namespace dyncal
