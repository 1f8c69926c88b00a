// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/page_standing.h"

#include <optional>
#include <string>
#include <string_view>

namespace dyncal {

/// Where a finding is settled: a page, and the control or view on it that the eye should go to.
struct FindingPlace
{
    Page page;
    const char *control; ///< object name; one that ends in '*' is the first that begins so
};

/// Of every id of docs/findings.md that blocks or is a caution; for others their page, if they
/// have one.
std::optional<FindingPlace> placeOfFinding(const std::string &id);

} // namespace dyncal
