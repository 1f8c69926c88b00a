// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/page_standing.h"

#include <QString>

#include <vector>

namespace dyncal {

/// One thing that a certificate still lacks, and where it is settled.
struct NextStep
{
    QString text;
    Page page = Page::Captures;
    QString control; ///< object name, as FindingPlace has it; empty = the list of findings
};

/// What is missing for a certificate: what blocks, cautions without a reason, fields to be filled
/// in. Empty = nothing is.
std::vector<NextStep> nextSteps(const WorkState &work);

} // namespace dyncal
