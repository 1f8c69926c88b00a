// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/selftest_files.h"

#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/selftest/step_words.h"

#include <cmath>

namespace dyncal {
namespace {

using Json = nlohmann::json;

constexpr int kDigitsOfChecks = 10;
constexpr int kDigitsOfTolerances = 2;

bool isSelfTestName(const std::string &name)
{
    return name == kSelfTestJson || name == kSelfTestPdf;
}

/// A number, or null with the reason beside it.
void putNumber(Json &record, const char *key, double value, const char *reason)
{
    record[key] = std::isfinite(value) ? Json(value) : Json(nullptr);
    if (!std::isfinite(value))
        record[std::string(key).append("_reason")] = reason;
}

Json checkJson(const SelfCheck &check)
{
    Json record{{"step", check.step}, {"name", english(check.name)},
        {"source", english(check.source)}, {"expected", check.expected},
        {"tolerance", check.tolerance}, {"holds", check.holds()}};
    putNumber(record, "found", check.found, "could not be computed");
    putNumber(record, "change_for_1e_12", check.sensitivity,
        "of random draws, or of nothing that could be computed");
    return record;
}

Json installationJson(const Installation &installation)
{
    Json libraries = Json::array();
    for (const UsedLibrary &library : installation.libraries)
        libraries.push_back({{"name", library.name}, {"version", library.version}});
    return {{"compiler", installation.compiler}, {"processor", installation.processor},
        {"system", installation.system}, {"libraries", std::move(libraries)}};
}

Message plain(std::string text)
{
    return {"%1", {std::move(text)}};
}

CertificateField installationField(const char *id, const char *label, const std::string &value)
{
    return {id, {label, {}}, plain(value)};
}

CertificateSection resultSection(const SelfTestReport &report, const std::string &createdUtc)
{
    const Installation &made = report.installation;
    CertificateSection section{
        "result", {DYNCAL_TEXT("core", "Result"), {}}, {report.verdict()}, {}, {}, {}, {}};
    section.fields = {installationField("date", DYNCAL_TEXT("core", "Date"), createdUtc),
        {"program", {DYNCAL_TEXT("core", "Program"), {}},
            {DYNCAL_TEXT("core", "Dyncal %V1, build %V2"), {made.version, made.build}}},
        installationField("compiler", DYNCAL_TEXT("core", "Compiler"), made.compiler),
        installationField("processor", DYNCAL_TEXT("core", "Processor"), made.processor),
        installationField("system", DYNCAL_TEXT("core", "System"), made.system),
        {"calibrations", {DYNCAL_TEXT("core", "Coverage study"), {}},
            {DYNCAL_TEXT("core", "%1 virtual calibrations"),
                {std::to_string(report.calibrations)}}}};
    section.notes = {
        {DYNCAL_TEXT("core",
             "The report shows that this installation computes known results within the tolerances stated (ISO/IEC 17025:2017, 7.11.2). It says nothing of the recordings, of the recipe or of the laboratory's references."),
            {}}};
    return section;
}

CertificateTable libraryTable(const Installation &installation)
{
    CertificateTable table{"libraries", {},
        {{{DYNCAL_TEXT("core", "Library"), {}}}, {{DYNCAL_TEXT("core", "Version"), {}}}}, {}};
    for (const UsedLibrary &library : installation.libraries)
        table.rows.push_back({plain(library.name), plain(library.version)});
    return table;
}

CertificateTable methodTable(const MethodVersions &methods)
{
    CertificateTable table{"methods", {},
        {{{DYNCAL_TEXT("core", "Step of the method"), {}}},
            {{DYNCAL_TEXT("core", "Version"), {}}, true}},
        {}};
    for (const auto &[step, version] : methods)
        table.rows.push_back({stepWords(step), plain(std::to_string(version))});
    return table;
}

std::vector<Message> rowOf(const SelfCheck &check)
{
    return {check.name, check.source, plain(numberText(check.expected, kDigitsOfChecks)),
        plain(numberText(check.found, kDigitsOfChecks)),
        plain(numberText(check.tolerance, kDigitsOfTolerances)),
        plain(numberText(check.sensitivity, kDigitsOfTolerances)),
        check.holds() ? Message{DYNCAL_TEXT("core", "holds"), {}}
                      : Message{DYNCAL_TEXT("core", "deviates"), {}}};
}

CertificateTable emptyCheckTable(const std::string &step)
{
    return {step, stepWords(step),
        {{{DYNCAL_TEXT("core", "What"), {}}}, {{DYNCAL_TEXT("core", "Known from"), {}}},
            {{DYNCAL_TEXT("core", "Expected"), {}}, true},
            {{DYNCAL_TEXT("core", "Found"), {}}, true},
            {{DYNCAL_TEXT("core", "Tolerance"), {}}, true},
            {{DYNCAL_TEXT("core", "Change for 1e-12"), {}}, true},
            {{DYNCAL_TEXT("core", "Verdict"), {}}}},
        {}};
}

/// One table for each step.
CertificateSection checkSection(const std::vector<SelfCheck> &checks)
{
    CertificateSection section;
    section.id = "checks";
    section.title = {DYNCAL_TEXT("core", "Checks"), {}};
    for (const SelfCheck &check : checks) {
        if (section.tables.empty() || section.tables.back().id != check.step)
            section.tables.push_back(emptyCheckTable(check.step));
        section.tables.back().rows.push_back(rowOf(check));
    }
    section.notes = {
        {DYNCAL_TEXT("core",
             "A check holds where found and expected differ by no more than the tolerance. The last number is how far the result moves when all data change by a part in 10^12: rounding moves it by less than a thousandth of that."),
            {}}};
    return section;
}

} // namespace

std::string selfTestJson(const SelfTestReport &report, const std::string &createdUtc)
{
    Json checks = Json::array();
    for (const SelfCheck &check : report.checks)
        checks.push_back(checkJson(check));
    return jsonText({{"schema", "dyncal-selftest/1"}, {"created_utc", createdUtc},
        {"software",
            {{"name", "dyncal"}, {"version", report.installation.version},
                {"build", report.installation.build}, {"method", report.methods}}},
        {"installation", installationJson(report.installation)}, {"checks", std::move(checks)},
        {"deviations", report.deviations()}, {"holds", report.deviations() == 0},
        {"verdict", english(report.verdict())}, {"coverage_calibrations", report.calibrations}});
}

CertificateData selfTestDocument(
    const SelfTestReport &report, const std::string &createdUtc, const std::string &language)
{
    CertificateData data;
    data.language = language;
    data.createdUtc = createdUtc;
    data.title = {DYNCAL_TEXT("core", "Self-test of the installation"), {}};
    data.draft = false;
    data.isCertificate = false;
    data.sections = {resultSection(report, createdUtc),
        {"software", {DYNCAL_TEXT("core", "Methods and libraries"), {}}, {}, {},
            {methodTable(report.methods), libraryTable(report.installation)}, {}, {}},
        checkSection(report.checks)};
    return data;
}

FolderRequest selfTestFolder(const std::string &folder)
{
    return {folder, "selftest", isSelfTestName, {kSelfTestJson, kSelfTestPdf}, {}, {}};
}

} // namespace dyncal
