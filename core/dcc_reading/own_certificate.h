// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc_reading/dcc_contents.h"

#include <string>
#include <vector>

namespace dyncal {

// Certificates of this program, which name everything by refTypes of their own: dyncal_...

bool isOwnCertificate(const DccContents &contents);

/// The only single quantity with no refType but this one, so that levels, which have a second one,
/// are none; null where there is none.
const StatedQuantity *ownValue(const DccContents &contents, const char *refType);

/// The lists that are the response: in all its digits, else as printed. More than one in a damaged
/// file only.
std::vector<const StatedTable *> ownResponses(const DccContents &contents);

/// SHA-256 of the recordings, sorted; empty where not all of them are stated.
std::vector<std::string> ownRecordings(const DccContents &contents);

} // namespace dyncal
