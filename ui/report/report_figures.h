// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"
#include "ui/plot/values/plot_content.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// One plot of the report under the name that its file and the certificate's figure list use.
struct ReportFigure
{
    std::string id; ///< "singular-values"
    PlotContent content;
};

/// Makes one plot; empty where the recordings lack the channel. It holds what it needs of the
/// results.
using FigureMaker = std::function<std::optional<ReportFigure>()>;

/// One for every plot that these results allow, in the order of the method: making them one by one
/// leaves the window time to answer.
std::vector<FigureMaker> figureMakers(const CalibrationResults &results);

/// The content of one figure, or null.
const PlotContent *findFigure(const std::vector<ReportFigure> &figures, const std::string &id);

} // namespace dyncal
