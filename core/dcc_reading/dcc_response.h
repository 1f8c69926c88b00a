// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc_reading/dcc_contents.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// S(f) as a list of a certificate states it: rows in the order of the list, those without a
/// magnitude left out.
struct CertifiedResponse
{
    std::vector<double> frequency_Hz; ///< above 0
    StatedValues magnitude; ///< u empty, or NaN in some rows, where none is stated
    std::optional<StatedValues> phase_rad = {};
    std::vector<double> dof; ///< of the magnitudes; infinite where none are stated
    Index withoutValue = 0; ///< rows that state none
    /// Where a quantity that is not understood may be the phases, so that none are taken: which.
    std::optional<Message> whyNoPhases = {};
    std::vector<Message> notUnderstood = {}; ///< of the list
};

/// Which quantities of a list mean what. Frequencies are in hertz, phases in radian or degree, the
/// magnitudes in `unit`, or, where that is empty, in a unit of a sensitivity (isSensitivity()).
/// Complex values give both. Where several quantities are in such a unit, the only one of them
/// counts that has one of the refTypes dyncal_frequency, vib_frequency, basic_tableIndex0,
/// dyncal_magnitude, vib_magnitude, dyncal_phase, vib_phase, basic_measuredValue (in this order),
/// or else that states an uncertainty; real ones go before complex ones. Errors, limits, nominal
/// values and such (isAboutAValue()) are none of them. Where a quantity that is not understood may
/// be one of them, no other is taken for it without a mark of its own (meantQuantity()). Rows whose
/// k is not stated have Student's factor of 95 % where the list has dyncal_degreesOfFreedom. Fails
/// (Usage) where none or several are left, with the reasons why quantities of the list were not
/// understood, where they differ in length, and on frequencies that are not above 0.
Result<CertifiedResponse> responseOf(const StatedTable &table, const std::optional<DSiUnit> &unit);

/// Whether it would be such a response if what is not understood in it were: something in it is
/// in hertz and something may be the magnitudes, or the other way about. False where responseOf()
/// reads it.
bool mightBeResponse(const StatedTable &table, const std::optional<DSiUnit> &unit);

/// Whether it has a quantity in hertz: other lists are of no response.
bool isOverFrequency(const StatedTable &table);

/// The lists over frequency, in the order of the certificate.
std::vector<const StatedTable *> tablesOverFrequency(const DccContents &contents);

} // namespace dyncal
