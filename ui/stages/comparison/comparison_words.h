// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/calibration_results.h"
#include "core/reference/reference_dcc.h"
#include "ui/stages/frame/shown_table.h"

#include <QString>

#include <string>

namespace dyncal {

/// What a file states: number of the certificate, from where to where, the value at the lowest
/// frequency. `unit` of the magnitudes.
QString sourceSentence(const CertifiedReference &source, const std::string &unit);

/// Whether step and transducer agree, and by how much. `results` may lack anything.
QString comparisonVerdict(const CalibrationResults &results);

/// What to do next; empty where nothing is to be done.
QString comparisonAdvice(const CalibrationResults &results);

/// One row for each frequency of the transducer's response, and the mean.
ShownTable comparisonTable(const ComparisonResult *comparison);

} // namespace dyncal
