// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/response_result.h"
#include "core/uncertainty/row_uncertainty.h"

namespace dyncal {

/// A complex value with its complete covariance, for an elliptic region (JCGM 102).
struct ComplexRegion
{
    double re = kUnknown;
    double im = kUnknown;
    double varRe = kUnknown;
    double covReIm = kUnknown;
    double varIm = kUnknown;
    double k = kUnknown; ///< of the ellipse that holds 95 %
};

/// Radius of the ellipse that holds 95 % of a plane, over the standard uncertainties of its axes:
/// k^2 = 2 dof / (dof - 1) F_0.95(2, dof - 1) = dof (0.05^(-2 / (dof - 1)) - 1), and -2 ln 0.05
/// where dof is infinite (JCGM 102:2011, 6.5.2.3 and note). NaN where dof is not above 1.
double ellipseFactor(double dof);

/// A row of S(f), from magnitude and phase in rad, with all of its uncertainty: the covariance of
/// its own part, and what u(magnitude) has beyond it along the value, u(phase) across it: the step,
/// the chain, the laboratory's least U. So the standard deviation along the value is u_magnitude.
/// Unknown where the row is withheld or a part of its u is not known; the value alone where only
/// the covariance is not known.
ComplexRegion complexRegion(const ResponseResult &response, const RowUncertainty &rows, Index row);

} // namespace dyncal
