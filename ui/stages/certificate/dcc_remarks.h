// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc/dcc_finding.h"

#include <QString>

#include <string>
#include <vector>

namespace dyncal {

/// One thing that a reader of the DCC would miss.
struct DccRemark
{
    QString text; ///< a sentence in the language of the window, fit to show
    std::string field; ///< of certificate.fields, which settles it; empty: none does

    bool operator==(const DccRemark &) const = default;
};

/// What was found, once each: what one field settles is one remark, however often the document
/// states it.
std::vector<DccRemark> dccRemarks(const DccCheck &check);

/// Field that settles what was found there; empty: none.
std::string fieldOfFinding(const DccFinding &finding);

} // namespace dyncal
