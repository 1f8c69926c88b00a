// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc_reading/d_si_unit.h"
#include "core/xml/parsed_xml.h"

#include <optional>
#include <vector>

namespace dyncal {

/// Values of one kind in one unit, as a certificate states them.
struct StatedValues
{
    DSiUnit unit; ///< of the SI without prefix, factor 1
    std::vector<double> values; ///< at least one; NaN: the D-SI's word for none
    std::vector<double> u; ///< k = 1, for each value, NaN without one; empty: none is stated
    /// Of the U that is stated; NaN where the certificate has the standard uncertainty or, of a
    /// complex value, the covariance. As many as u.
    std::vector<double> k;
};

/// A quantity of the D-SI.
struct DSiQuantity
{
    StatedValues values; ///< of complex values their magnitudes
    std::optional<StatedValues> phases_rad = {}; ///< of complex values; empty: they are real
};

/// Whether it is an element of the D-SI that holds values: real, realList, realListXMLList,
/// constant, complex, complexList, complexListXMLList, hybrid.
bool isDSiElement(const ParsedElement &element);

/// Reads such an element (SI_Format.xsd of D-SI 2.0 to 2.2.1, the deprecated elements too). U over
/// k becomes u; the u of a coverage interval is that which it states. Complex values in
/// rectangular form become magnitude and phase with the u that follow from their covariance to
/// first order (toPolar()); their phases are unwrapped, each to the turn nearest to the one before.
/// Of a hybrid the first member counts whose unit is understood. Fails (Usage) with line and
/// element on whatever is not understood: unknown or mixed units, lists that differ in length, U
/// without k or k without U, U below 0, k not above 0, numbers that are none, a covariance that is
/// none, an element twice. NaN in an XML list is an entry that is not stated; NaN elsewhere is
/// refused.
Result<DSiQuantity> readDSiQuantity(const ParsedElement &element);

} // namespace dyncal
