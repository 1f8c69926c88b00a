// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_rules.h"

#include "core/base/calendar_date.h"
#include "core/dcc/dcc_list_rules.h"
#include "core/dcc/dcc_tree.h"
#include "core/dcc/iso_codes.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

namespace dyncal {
namespace {

using DccFindings = std::vector<DccFinding>;

/// "v1.2.3"
bool isRelease(std::string_view text)
{
    if (!text.starts_with('v'))
        return false;
    int dots = 0;
    bool isAfterDigit = false;
    for (const char c : text.substr(1)) {
        const bool isDigit = c >= '0' && c <= '9';
        if (!isDigit && (c != '.' || !isAfterDigit))
            return false;
        dots += c == '.' ? 1 : 0;
        isAfterDigit = isDigit;
    }
    return dots == 2 && isAfterDigit;
}

void checkReleases(const DccTree &tree, DccFindings &findings)
{
    for (const DccNode &node : tree.all("release"))
        if (node.parentName() == "software" && !isRelease(node.text()))
            findings.push_back({"release", node.path(), node.text(),
                {DYNCAL_TEXT("core", "A release is written like v1.2.3."), {}}});
}

void checkIds(const DccTree &tree, DccFindings &findings)
{
    std::set<std::string> ids, referred;
    for (const DccNode &node : tree.all()) {
        const std::string id = node.attribute("id");
        if (!id.empty() && !ids.insert(id).second)
            findings.push_back({"id", node.path(), id,
                {DYNCAL_TEXT("core", "An id belongs to one element only."), {}}});
        for (const std::string &one : wordsIn(node.attribute("refId")))
            referred.insert(one);
    }
    for (const DccNode &node : tree.all()) {
        const std::string id = node.attribute("id");
        if (!id.empty() && !referred.contains(id) && !node.isSignature())
            findings.push_back({"id", node.path(), id,
                {DYNCAL_TEXT("core", "Every id is referred to by a refId, or left out."), {}}});
        for (const std::string &one : wordsIn(node.attribute("refId")))
            if (!ids.contains(one))
                findings.push_back({"refId", node.path(), one,
                    {DYNCAL_TEXT("core", "A refId names the id of an element of the document."),
                        {}}});
    }
}

/// Stated for a single result, or for all.
void checkResults(const DccTree &tree, DccFindings &findings)
{
    constexpr std::array kNeeded{
        std::pair{"usedMethods",
            DYNCAL_TEXT("core", "Every measurement result names the methods that were used.")},
        std::pair{"influenceConditions",
            DYNCAL_TEXT(
                "core", "Every measurement result states the conditions that influenced it.")}};
    const std::vector<DccNode> results = tree.all("measurementResult");
    for (const auto &[name, needed] : kNeeded) {
        std::set<DccNode> holders; // found once: each result may stand among many others
        for (const DccNode &stated : tree.all(name))
            holders.insert(stated.parent());
        for (const DccNode &result : results)
            if (!holders.contains(result) && !holders.contains(result.parent()))
                findings.push_back({name, result.path(), "", {needed, {}}});
    }
}

void checkLanguages(const DccTree &tree, DccFindings &findings)
{
    std::set<std::string> used;
    for (const DccNode &node : tree.all("usedLangCodeISO639_1")) {
        used.insert(node.text());
        if (!isLanguageCode(node.text()))
            findings.push_back({"language", node.path(), node.text(),
                {DYNCAL_TEXT("core", "A language is named by its two letters of ISO 639-1."), {}}});
    }
    for (const DccNode &node : tree.all("mandatoryLangCodeISO639_1"))
        if (!used.contains(node.text()))
            findings.push_back({"language", node.path(), node.text(),
                {DYNCAL_TEXT("core", "A mandatory language is one of the used ones."), {}}});
    for (const DccNode &node : tree.all())
        if (const std::string lang = node.attribute("lang"); !lang.empty() && !used.contains(lang))
            findings.push_back({"language", node.path(), lang,
                {DYNCAL_TEXT("core", "The language of a text is one of the used ones."), {}}});
}

void checkCountries(const DccTree &tree, DccFindings &findings)
{
    for (const char *name : {"countryCodeISO3166_1", "countryCode"})
        for (const DccNode &node : tree.all(name))
            if (!isCountryCode(node.text()))
                findings.push_back({"country", node.path(), node.text(),
                    {DYNCAL_TEXT("core",
                         "A country is named by its two letters of ISO 3166-1; type the countries of laboratory and customer into the fields of the certificate."),
                        {}}});
}

void checkDates(const DccTree &tree, DccFindings &findings)
{
    for (const char *name :
        {"receiptDate", "beginPerformanceDate", "endPerformanceDate", "issueDate"})
        for (const DccNode &node : tree.all(name))
            if (!isCalendarDate(node.text()))
                findings.push_back({"date", node.path(), node.text(),
                    {DYNCAL_TEXT("core", "A date is a day of the calendar like 2026-01-31."), {}}});
    const auto begin = tree.all("beginPerformanceDate");
    const auto end = tree.all("endPerformanceDate");
    if (!begin.empty() && !end.empty() && end.front().text() < begin.front().text())
        findings.push_back({"date", end.front().path(), end.front().text(),
            {DYNCAL_TEXT("core", "The calibration does not end before its begin (%1)."),
                {begin.front().text()}}});
}

/// "basic_temperature" is of PTB, as are those of its good practices.
bool isOfPtb(std::string_view refType)
{
    constexpr std::array<std::string_view, 5> kKnown{
        "basic_", "vib_", "temperature_", "humidity_", "math_"};
    return std::ranges::any_of(
        kKnown, [&](std::string_view begin) { return refType.starts_with(begin); });
}

void checkRefTypes(const DccTree &tree, DccFindings &findings)
{
    std::set<std::string> declared;
    for (const DccNode &node : tree.all("refTypeDefinition"))
        declared.insert(node.childText("value"));
    std::set<std::string> told;
    for (const DccNode &node : tree.all())
        for (const std::string &one : wordsIn(node.attribute("refType")))
            if (!isOfPtb(one) && !declared.contains(one) && told.insert(one).second)
                findings.push_back({"refType", node.path(), one,
                    {DYNCAL_TEXT("core",
                         "A refType of one's own is declared in refTypeDefinitions, as a value."),
                        {}}});
}

} // namespace

Result<DccCheck> ruleFindings(const std::string &xml)
{
    const Result<DccTree> tree = DccTree::read(xml);
    if (!tree)
        return tl::unexpected<Error>(tree.error());
    DccCheck check;
    check.version = tree->root().attribute("schemaVersion");
    const auto numbers = tree->all("uniqueIdentifier");
    check.number = numbers.empty() ? std::string() : numbers.front().text();
    for (const auto rule : {checkReleases, checkIds, checkResults, checkLists, checkLengths,
             checkUnits, checkLanguages, checkCountries, checkDates, checkRefTypes})
        rule(*tree, check.findings);
    return check;
}

} // namespace dyncal
