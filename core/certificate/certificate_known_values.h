// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/uncertainty/uncertainty_report.h"

#include <vector>

namespace dyncal {

/// Values of other calibrations beside this one's, with E_n and whether they are joined; without
/// rows where the recipe has none.
CertificateTable knownValuesTable(const UncertaintyReport &report);

/// A value that is joined, as a line of the table of S(f); by frequency.
struct JoinedLine
{
    double frequency_Hz;
    Message name; ///< "static: works calibration"
    Message magnitude;
    Message expanded;
};
std::vector<JoinedLine> joinedLines(const UncertaintyReport &report);

} // namespace dyncal
