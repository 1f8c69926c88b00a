// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/pipeline/pipeline.h"
#include "core/project/recipe.h"

#include <string>
#include <vector>

namespace dyncal {

/// Draws the certificate and every plot of the results: `directory`/certificate.pdf and
/// `directory`/plots/*.svg, written through temporary files. Returns the paths written, in the
/// order in which they are to be shown. `createdUtc` is ISO 8601 with Z; the same arguments give
/// the same bytes. Needs a QGuiApplication (the offscreen platform will do) and an existing
/// `directory`. Results that are missing leave out what they would have shown.
Result<std::vector<std::string>> writeReport(const CalibrationResults &results,
    const Recipe &recipe, const std::string &createdUtc, const std::string &directory);

} // namespace dyncal
