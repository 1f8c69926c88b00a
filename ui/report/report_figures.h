// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"
#include "ui/plot/plot_content.h"

#include <string>
#include <vector>

namespace dyncal {

/// One plot of the report under the name that its file and the certificate's figure list use.
struct ReportFigure
{
    std::string id; ///< "singular-values"
    PlotContent content;
};

/// Every plot that these results allow, in the order of the method.
std::vector<ReportFigure> reportFigures(const CalibrationResults &results);

/// The content of one figure, or null.
const PlotContent *findFigure(const std::vector<ReportFigure> &figures, const std::string &id);

} // namespace dyncal
