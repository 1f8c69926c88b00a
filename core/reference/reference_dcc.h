// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/reference/reference_sensitivity.h"

#include <string>
#include <vector>

namespace dyncal {

/// A reference transducer as its digital calibration certificate has it.
struct CertifiedReference
{
    ReferenceSensitivity sensitivity;
    std::string certificate; ///< its number
};

/// Reads a digital calibration certificate (PTB DCC 3, D-SI 2): the list with the id `quantityId`,
/// or, where that is empty, the only list that has frequencies. Of it the first quantity in hertz,
/// the first in `unit` ("V/Pa", with any prefix), and the first in radian or degree, if there is
/// one. U over its k becomes u. Fails (FileUnreadable) where it is no such certificate; (Usage)
/// where the list is not there, is several, or lacks one of them, and as
/// ReferenceSensitivity::fromTable().
Result<CertifiedReference> readReferenceDcc(
    const std::string &xml, const std::string &quantityId, const std::string &unit);

/// The ids of the lists of a digital calibration certificate that have frequencies, in its order;
/// one without an id is "". Empty where it is no such certificate.
std::vector<std::string> listsOverFrequency(const std::string &xml);

} // namespace dyncal
