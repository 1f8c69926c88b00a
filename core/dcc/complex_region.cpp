// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/complex_region.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kOutside = 0.05;

double at(const Eigen::VectorXd &values, Index row)
{
    return row < values.size() ? values[row] : kUnknown;
}

/// Adds what a direction (a unit vector) lacks to `variance`.
void widen(double x, double y, double variance, ComplexRegion &region)
{
    const double there = x * x * region.varRe + 2.0 * x * y * region.covReIm + y * y * region.varIm;
    const double missing = std::max(variance - there, 0.0);
    region.varRe += missing * x * x;
    region.covReIm += missing * x * y;
    region.varIm += missing * y * y;
}

} // namespace

double ellipseFactor(double dof)
{
    if (std::isinf(dof) && dof > 0.0)
        return std::sqrt(-2.0 * std::log(kOutside));
    if (!(dof > 1.0))
        return kUnknown;
    return std::sqrt(dof * std::expm1(-2.0 / (dof - 1.0) * std::log(kOutside)));
}

ComplexRegion complexRegion(const ResponseResult &response, const RowUncertainty &rows, Index row)
{
    const double magnitude = at(response.magnitude, row);
    const double phase_rad = at(response.phase_rad, row);
    if (!std::isfinite(magnitude) || !std::isfinite(phase_rad))
        return {};
    const double x = std::cos(phase_rad);
    const double y = std::sin(phase_rad);
    ComplexRegion region{magnitude * x, magnitude * y};
    const double u = at(rows.u_magnitude, row);
    const double u_phase_rad = at(rows.u_phase_rad, row);
    if (row >= rows.covarianceReIm.rows() || !rows.covarianceReIm.row(row).allFinite()
        || !std::isfinite(u) || !std::isfinite(u_phase_rad))
        return region;
    region.varRe = rows.covarianceReIm(row, 0);
    region.covReIm = rows.covarianceReIm(row, 1);
    region.varIm = rows.covarianceReIm(row, 2);
    widen(x, y, u * u, region);
    widen(-y, x, std::pow(magnitude * u_phase_rad, 2), region);
    region.k = ellipseFactor(std::min(at(rows.dof_magnitude, row), at(rows.dof_phase, row)));
    return region;
}

} // namespace dyncal
