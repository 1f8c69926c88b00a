// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/dcc/dcc_finding.h"

#include <string>

namespace dyncal {

/// What the XML schema of the DCC's version says, at most 50 sentences of libxml2, which are
/// English. `folder` has the schemas by their addresses (ptb.de/dcc/v3.3.0/dcc.xsd, ptb.de/si/...,
/// ptb.de/dcc/d-sig/...): nothing else is opened, and nothing is fetched. Fails (Usage) where the
/// folder has no schema of that version, or it is none; (FileUnreadable) where the text is no XML.
Result<std::vector<DccFinding>> schemaFindings(
    const std::string &xml, const std::string &version, const std::string &folder);

} // namespace dyncal
