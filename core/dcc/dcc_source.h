// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/certificate/certificate_issue.h"
#include "core/dcc/dcc_words.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// What a DCC is made from: the certificate as its pages have it, and the results behind it.
struct DccSource
{
    const CertificateData &certificate;
    const CalibrationResults &results;
    const Recipe &recipe;
    std::optional<CertificateIssue> issue = {}; ///< empty: a draft
    DccWords words = {};

    /// A field of a section; null without it.
    const CertificateField *field(const std::string &section, const std::string &id) const;
    /// The response of a comparison beside that by the step; against a transducer it is the
    /// response itself. Null where there is none.
    const UncertainResponse *comparisonBeside() const;
    /// What somebody typed, or a card knew, as one line; "" where nobody did.
    std::string typed(const std::string &section, const std::string &id) const;
};

} // namespace dyncal
