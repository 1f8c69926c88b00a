// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/certificate/certificate_data.h"
#include "core/uncertainty/reported_value.h"

#include <string>
#include <vector>

namespace dyncal {

/// A quantity that a certificate may state: a result with its complete u, or the words that stand
/// in place of one. Internal to core/certificate.
struct ResultQuantity
{
    Message label;
    double value = kUnknown;
    double u = kUnknown; ///< standard uncertainty, in `unit`
    double k = kUnknown; ///< Student's factor of 95 %
    std::string unit = {}; ///< "" = a number
    Message otherwise = {}; ///< a bound, or why there is no result
    double leastExpanded = 0.0; ///< the CMC: no smaller U is printed, not by rounding either
    std::string of = {}; ///< its name in a template (templateQuantities())
    std::string drawnAs = {}; ///< its name among the values of Monte Carlo, where that is another

    /// Whether value and u can both be printed; a u below what rounding leaves is none.
    bool isResult() const;
};

/// Why a value that exists is no result: what its report says of the missing u.
Message whyNoResult(const ReportedValue *reported);

/// Appends a table of the results (quantity, value, U, k), each rounded to the two digits of its U,
/// and one of the others with what is known of them. A table without rows is left out.
void addQuantityTables(const std::vector<ResultQuantity> &quantities, CertificateSection &section);

} // namespace dyncal
