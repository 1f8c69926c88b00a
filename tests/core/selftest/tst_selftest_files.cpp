// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/constants.h"
#include "core/selftest/selftest_files.h"
#include "tests/support/test_program.h"

#include <nlohmann/json.hpp>

#include <QTest>

using namespace dyncal;

namespace {

constexpr const char *kUtc = "2026-01-31T12:00:00Z";

SelfTestReport madeReport()
{
    SelfTestReport report;
    report.checks = {{"window", {"first", {}}, {"by hand", {}}, 1.0, 1.25, 0.5, 2e-12},
        {"window", {"second", {}}, {"by hand", {}}, 1.0, kUnknown, 0.5, kUnknown},
        {"model", {"third", {}}, {"a \"book\"", {}}, -3.0, -3.0, 1e-9, 0.0}};
    report.methods = methodVersions();
    report.installation
        = {"1.0", "abc", "g++ 12", "a processor", "a system", {{"Eigen", "3.4"}, {"Qt", "6.4"}}};
    report.calibrations = 7;
    return report;
}

nlohmann::json parsed()
{
    return nlohmann::json::parse(selfTestJson(madeReport(), kUtc));
}

const CertificateSection &sectionOf(const CertificateData &data, const char *id)
{
    return *data.section(id);
}

} // namespace

class TestSelftestFiles : public QObject
{
    Q_OBJECT

private slots:
    void json_hasDateAndSoftware()
    {
        const auto json = parsed();
        QCOMPARE(json.at("schema").get<std::string>(), std::string("dyncal-selftest/1"));
        QCOMPARE(json.at("created_utc").get<std::string>(), std::string(kUtc));
        QCOMPARE(json.at("software").at("build").get<std::string>(), std::string("abc"));
        QCOMPARE(json.at("software").at("method").get<MethodVersions>(), methodVersions());
        QCOMPARE(json.at("installation").at("libraries").size(), std::size_t(2));
        QCOMPARE(
            json.at("installation").at("processor").get<std::string>(), std::string("a processor"));
        QCOMPARE(json.at("coverage_calibrations").get<int>(), 7);
    }

    void json_saysWhatDeviates()
    {
        const auto json = parsed();
        QCOMPARE(json.at("holds").get<bool>(), false);
        QCOMPARE(json.at("deviations").get<int>(), 1);
        QVERIFY(json.at("verdict").get<std::string>().find("\"window\"") != std::string::npos);
    }

    /// Never NaN: null with the reason beside it.
    void json_hasEveryCheck()
    {
        const auto checks = parsed().at("checks");
        QCOMPARE(checks.size(), std::size_t(3));
        QCOMPARE(checks[0].at("found").get<double>(), 1.25);
        QCOMPARE(checks[0].at("change_for_1e_12").get<double>(), 2e-12);
        QCOMPARE(checks[0].at("holds").get<bool>(), true);
        QVERIFY(checks[1].at("found").is_null() && checks[1].contains("found_reason"));
        QVERIFY(checks[1].at("change_for_1e_12").is_null());
        QVERIFY(checks[1].contains("change_for_1e_12_reason"));
        QCOMPARE(checks[1].at("holds").get<bool>(), false);
        QCOMPARE(checks[2].at("source").get<std::string>(), std::string("a \"book\""));
    }

    void document_isAReport()
    {
        const CertificateData data = selfTestDocument(madeReport(), kUtc, "sv");
        QVERIFY(!data.isCertificate && !data.draft);
        QCOMPARE(data.language, std::string("sv"));
        QCOMPARE(data.createdUtc, std::string(kUtc));
        QVERIFY(data.missingFields().empty());
        const CertificateSection &result = sectionOf(data, "result");
        QCOMPARE(result.paragraphs, std::vector<Message>{madeReport().verdict()});
        QCOMPARE(result.fields.size(), std::size_t(6));
        QCOMPARE(english(result.fields[0].value), std::string(kUtc));
        QCOMPARE(english(result.fields[1].value), std::string("Dyncal 1.0, build abc"));
    }

    void document_hasMethodsAndLibraries()
    {
        const CertificateData data = selfTestDocument(madeReport(), kUtc, "en");
        const auto &tables = sectionOf(data, "software").tables;
        QCOMPARE(tables.size(), std::size_t(2));
        QCOMPARE(tables[0].rows.size(), methodVersions().size());
        QCOMPARE(english(tables[1].rows[1][1]), std::string("6.4"));
    }

    void document_hasATableForEachStep()
    {
        const CertificateData data = selfTestDocument(madeReport(), kUtc, "en");
        const auto &tables = sectionOf(data, "checks").tables;
        QCOMPARE(tables.size(), std::size_t(2));
        QCOMPARE(tables[0].id, std::string("window"));
        QCOMPARE(tables[0].rows.size(), std::size_t(2));
        for (const CertificateTable &table : tables)
            for (const auto &row : table.rows)
                QCOMPARE(row.size(), table.columns.size());
        QCOMPARE(english(tables[0].rows[0].back()), std::string("holds"));
        QCOMPARE(english(tables[0].rows[1].back()), std::string("deviates"));
        QCOMPARE(english(tables[0].rows[0][3]), std::string("1.25"));
    }

    void folder_takesItsTwoFilesOnly()
    {
        const FolderRequest request = selfTestFolder("evidence");
        QCOMPARE(request.folder, std::string("evidence"));
        QVERIFY(request.mayWrite(kSelfTestJson) && request.mayWrite(kSelfTestPdf));
        QVERIFY(!request.mayWrite("results.json"));
        QCOMPARE(request.names.size(), std::size_t(2));
    }
};

DYNCAL_TEST(TestSelftestFiles)
#include "tst_selftest_files.moc"
