// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc_reading/d_si_quantity.h"

#include <Eigen/Core>

namespace dyncal {

/// u and k of real values, for each of `count`, in the unit of the element.
struct DSiUncertainty
{
    std::vector<double> u; ///< empty: none is stated
    std::vector<double> k; ///< NaN where u itself is stated
};

/// What the element of real values states of its uncertainty, of one value or of an XML list: as
/// expanded or standard uncertainty or as coverage interval, in today's and in the deprecated
/// elements. Fails (Usage) as readDSiQuantity().
Result<DSiUncertainty> uncertaintyOf(const ParsedElement &element, std::size_t count);

/// Covariance of both parts of each of `count` complex values: of its ellipsoidal or rectangular
/// region, of one value or of an XML list; empty where none is stated. Its units are held against
/// those of the parts. Fails (Usage) as readDSiQuantity().
Result<std::vector<Eigen::Matrix2d>> covariancesOf(
    const ParsedElement &element, std::size_t count, const DSiUnit &first, const DSiUnit &second);

} // namespace dyncal
