// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/uncertainty/reported_value.h"

#include <optional>

namespace dyncal {

/// What the uncertainty of the sensitivity is made of, as a reader of the certificate needs it:
/// sources from the largest share on, those of single shots together, each with its contribution (k
/// = 1) in percent of the value; below 0.1 % of the variance all in one line. Empty without u.
std::optional<CertificateTable> budgetTable(const ReportedValue &sensitivity);

} // namespace dyncal
