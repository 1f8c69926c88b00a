// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"

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

} // namespace dyncal
