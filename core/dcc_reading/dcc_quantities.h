// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc_reading/dcc_contents.h"
#include "core/xml/parsed_xml.h"

namespace dyncal {

/// Adds the lists and single quantities of a dcc:result to `contents` (readDcc()).
void readResult(const ParsedElement &result, DccContents &contents);

} // namespace dyncal
