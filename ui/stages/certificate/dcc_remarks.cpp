// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/certificate/dcc_remarks.h"

#include "ui/stages/certificate/field_labels.h"
#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <string_view>

namespace dyncal {

namespace {

struct Place
{
    std::string_view part; ///< of the path in the document
    const char *field;
};

/// The first that fits: a customer's address is below the administrative data, too.
constexpr std::array<Place, 7> kPlaces{{
    {"customer/", "customer_country"},
    {"calibrationLaboratory/", "laboratory_country"},
    {"countryCodeISO3166_1", "laboratory_country"},
    {"receiptDate", "date_received"},
    {"beginPerformanceDate", "date_performed"},
    {"endPerformanceDate", "date_performed"},
    {"issueDate", "date_issued"},
}};

QString words(const char *text)
{
    return QCoreApplication::translate("dyncal::DccRemarks", text);
}

QString sentenceOf(const DccFinding &finding, const std::string &field)
{
    if (finding.rule == "country" && !field.empty())
        return words(QT_TRANSLATE_NOOP("dyncal::DccRemarks",
                         "%1: none is known, and a DCC must have one. Type its two letters."))
            .arg(fieldLabel(field));
    const QString needed = translated(finding.needed);
    return finding.found.empty() ? needed
                                 : words(QT_TRANSLATE_NOOP("dyncal::DccRemarks", "%1 Found: %2."))
                                       .arg(needed, shownText(finding.found));
}

} // namespace

std::string fieldOfFinding(const DccFinding &finding)
{
    if (finding.rule != "country" && finding.rule != "date")
        return {};
    const auto place = std::ranges::find_if(kPlaces,
        [&](const Place &one) { return finding.where.find(one.part) != std::string::npos; });
    return place == kPlaces.end() ? std::string() : place->field;
}

std::vector<DccRemark> dccRemarks(const DccCheck &check)
{
    std::vector<DccRemark> remarks;
    for (const DccFinding &finding : check.findings) {
        const std::string field = fieldOfFinding(finding);
        const DccRemark remark{sentenceOf(finding, field), field};
        if (std::ranges::find(remarks, remark) == remarks.end())
            remarks.push_back(remark);
    }
    return remarks;
}

} // namespace dyncal
