// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"

#include <QJsonObject>

#include <memory>
#include <optional>
#include <set>
#include <string>

namespace dyncal {

/// What a project keeps of its results, to be looked at where its recordings are missing: the
/// words and rounded numbers of the certificate as it stood. Nothing is computed or issued from it.
struct KeptResults
{
    std::string savedUtc; ///< ISO 8601 with Z
    CertificateData certificate; ///< title and sections, without figures
    std::shared_ptr<const std::set<std::string>> texts = {}; ///< that its messages point to
};

/// The key of a project's content that keeps results.
inline constexpr const char *kKeptResults = "kept_results";

/// The value of that key.
QJsonObject keptResultsJson(const CertificateData &certificate, const std::string &savedUtc);

/// What the content of a project keeps; empty if it keeps nothing, or not in this form.
std::optional<KeptResults> keptResults(const QJsonObject &project);

} // namespace dyncal
