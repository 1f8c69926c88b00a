// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"
#include "core/base/result.h"

#include <string>
#include <vector>

namespace dyncal {

/// What of a DCC is not as it must be.
struct DccFinding
{
    std::string rule; ///< "schema", "release", "id", "conditions", "list", "length", "unit", ...
    std::string where; ///< "measurementResults/measurementResult/results/result[2]/data/list"
    std::string found;
    Message needed; ///< one sentence

    bool operator==(const DccFinding &) const = default;
};

struct DccCheck
{
    std::string version; ///< "3.3.0"
    std::string number; ///< its unique identifier
    bool isSchemaChecked = false;
    std::vector<DccFinding> findings; ///< empty: everything holds
};

/// Holds a digital calibration certificate against the rules that its schema does not know
/// (dcc_rules.h) and, where `schemas` names a folder, against the schema of its version
/// (dcc_schema.h). Fails (FileUnreadable) where it is no DCC, has a document type or entities of
/// its own, is larger than 64 MiB or nested deeper than 100 elements; and as schemaFindings() does.
Result<DccCheck> checkDcc(const std::string &xml, const std::string &schemas = {});

} // namespace dyncal
