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

/// Reads a digital calibration certificate (readDcc()): the list with the id `quantityId`, or,
/// where that is empty, the only list that has frequencies, of several the only one that is a
/// response in `unit` ("V/Pa", "pC/Pa"), where no other might be one (mightBeResponse()). What in
/// it means what: responseOf(); where a quantity that is not understood may be the phases, nothing
/// is taken. Magnitudes, real or complex, come in `unit`; rows without a magnitude are left out,
/// and each other one must have its u. Fails (FileUnreadable) as readDcc(); (Usage) where the list
/// is not there, is several, or lacks one of them, and as responseOf() and
/// ReferenceSensitivity::fromTable().
Result<CertifiedReference> readReferenceDcc(
    const std::string &xml, const std::string &quantityId, const std::string &unit);

/// The ids of the lists of a digital calibration certificate that have frequencies, in its order;
/// one without an id is "". Empty where it is no such certificate.
std::vector<std::string> listsOverFrequency(const std::string &xml);

} // namespace dyncal
