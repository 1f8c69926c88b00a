// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/writing/folder_contents.h"
#include "core/certificate/certificate_data.h"
#include "core/selftest/selftest.h"

#include <string>

namespace dyncal {

inline constexpr const char *kSelfTestJson = "selftest.json";
inline constexpr const char *kSelfTestPdf = "selftest.pdf";

/// The report as JSON, schema "dyncal-selftest/1" (docs/selftest.md). `createdUtc` ISO 8601 with Z.
/// The same report gives the same bytes.
std::string selfTestJson(const SelfTestReport &report, const std::string &createdUtc);

/// The report as words and numbers for paper. `language`: "en", "sv".
CertificateData selfTestDocument(
    const SelfTestReport &report, const std::string &createdUtc, const std::string &language);

/// The folder that both are written to.
FolderRequest selfTestFolder(const std::string &folder);

} // namespace dyncal
