// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/dcc/dcc_finding.h"

#include <string>

namespace dyncal {

/// Holds a digital calibration certificate against the rules that its schema does not know
/// (dcc_rules.h) and, where `schemas` names a folder, against the schema of its version
/// (dcc_schema.h). Fails (FileUnreadable) where it is no DCC, has a document type or entities of
/// its own, is larger than 64 MiB or nested deeper than 100 elements; and as schemaFindings() does.
Result<DccCheck> checkDcc(const std::string &xml, const std::string &schemas = {});

} // namespace dyncal
