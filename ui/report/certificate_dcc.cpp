// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/certificate_dcc.h"

#include "core/dcc/dcc_check.h"
#include "core/dcc/dcc_document.h"
#include "ui/report/report_language.h"
#include "ui/text/filled_words.h"

#include <map>

namespace dyncal {

std::string certificateDcc(const CertificateData &certificate, const CalibrationResults &results,
    const Recipe &recipe, const std::optional<CertificateIssue> &issue)
{
    std::map<std::string, ReportLanguage> languages;
    return dccText(
        certificate, results, recipe, issue, [&](const Message &message, const std::string &code) {
            const ReportLanguage &language = languages.try_emplace(code, code).first->second;
            const auto own = [&](const char *text) { return language.translate("core", text); };
            const QString said
                = filledWords(message, own, language.numbers().decimalPoint().front());
            return said.toStdString();
        });
}

Result<DccCheck> draftDccCheck(const CalibrationResults &results, const Recipe &recipe,
    const std::string &createdUtc, const ChosenTemplate &chosen)
{
    return checkDcc(certificateDcc(
        certificateOf(results, recipe, createdUtc, chosen, {}), results, recipe, {}));
}

} // namespace dyncal
