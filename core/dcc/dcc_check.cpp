// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_check.h"

#include "core/dcc/dcc_rules.h"
#include "core/dcc/dcc_schema.h"

#include <utility>

namespace dyncal {

Result<DccCheck> checkDcc(const std::string &xml, const std::string &schemas)
{
    Result<DccCheck> check = ruleFindings(xml);
    if (!check || schemas.empty())
        return check;
    Result<std::vector<DccFinding>> found = schemaFindings(xml, check->version, schemas);
    if (!found)
        return tl::unexpected<Error>(found.error());
    check->isSchemaChecked = true;
    check->findings.insert(check->findings.begin(), found->begin(), found->end());
    return check;
}

} // namespace dyncal
