// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/baseline_level.h"

#include <cmath>

namespace dyncal {
namespace {

constexpr Index kDriftPieces = 8;
constexpr Index kLeastDriftPiece = 16; ///< samples
constexpr double kSteady = 8.0; ///< u of the slope

bool driftsSteadily(const Eigen::Ref<const Eigen::VectorXd> &quiet)
{
    const Index piece = quiet.size() / kDriftPieces;
    if (piece < kLeastDriftPiece)
        return false;
    const LineFit line = fitLine(meansOf(quiet, piece).head(kDriftPieces));
    return std::abs(line.slope) > kSteady * uOfSlope(line.sd, kDriftPieces);
}

} // namespace

BaselineLevel baselineLevel(const Eigen::Ref<const Eigen::VectorXd> &quiet, Index ahead)
{
    BaselineLevel found;
    found.line = fitLine(quiet);
    found.level = found.line.mean;
    if (ahead < 0 || ahead > quiet.size() || !driftsSteadily(quiet))
        return found;
    const auto n = static_cast<double>(quiet.size());
    const double distance = 0.5 * (n - 1.0) + static_cast<double>(ahead);
    found.level += found.line.slope * distance;
    found.varianceFactor += 12.0 * distance * distance / (n * n);
    return found;
}

} // namespace dyncal
