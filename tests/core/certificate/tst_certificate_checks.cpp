// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_checks.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <memory>

using namespace dyncal;

namespace {

WayComparison mach(Way a, double value_a, double value_b, double u)
{
    return {.of = Compared::Mach,
        .a = a,
        .b = Way::SoundSpeed,
        .shot = 1,
        .value_a = value_a,
        .value_b = value_b,
        .u = u,
        .unit = "1"};
}

CertificateSection sectionOf(std::vector<WayComparison> checks)
{
    CalibrationResults results;
    results.checks = std::make_shared<ConsistencyResult>(ConsistencyResult{std::move(checks), {}});
    CertificateSection section;
    addCheckTable(results, section);
    return section;
}

std::string cell(const CertificateSection &section, std::size_t row, std::size_t column)
{
    return english(section.tables.at(0).rows.at(row).at(column));
}

} // namespace

class TestCertificateChecks : public QObject
{
    Q_OBJECT

private slots:
    void sameWays_areOneRow_ofTheWorst()
    {
        const CertificateSection section = sectionOf({mach(Way::StepRatio, 1.51, 1.5, 0.01),
            mach(Way::StepRatio, 1.52, 1.5, 0.01), mach(Way::StepRatio, 1.50, 1.5, 0.02)});
        QCOMPARE(section.tables.at(0).rows.size(), std::size_t(1));
        QCOMPARE(cell(section, 0, 0), std::string("Mach number"));
        QCOMPARE(cell(section, 0, 1), std::string("ratio of the steps"));
        QCOMPARE(cell(section, 0, 3), std::string("3"));
        QCOMPARE(cell(section, 0, 4), std::string("2"));
        QCOMPARE(cell(section, 0, 5), std::string("6.5\u00a0%")); // 4.88 x 0.02/1.5
        QCOMPARE(cell(section, 0, 6), std::string("agree"));
    }

    void contradictions_areCounted()
    {
        const CertificateSection section = sectionOf({mach(Way::StepRatio, 1.6, 1.5, 0.01),
            mach(Way::VelocityRatio, 1.5, 1.5, 0.01), mach(Way::StepRatio, 1.5, 1.5, 0.01)});
        QCOMPARE(section.tables.at(0).rows.size(), std::size_t(2));
        QCOMPARE(cell(section, 0, 6), std::string("1 contradict each other"));
        QCOMPARE(cell(section, 1, 6), std::string("agree"));
    }

    void whatCouldNotBeMade_isSaid()
    {
        WayComparison check = mach(Way::StepRatio, kUnknown, kUnknown, kUnknown);
        check.missing = Message{"no reading", {}};
        const CertificateSection section = sectionOf({check});
        QCOMPARE(cell(section, 0, 3), std::string("0"));
        QCOMPARE(
            cell(section, 0, 6), std::string("no reading")); // the reason, in place of a verdict
        QCOMPARE(cell(section, 0, 5), cell(section, 0, 4)); // dashes
    }

    void noComparison_isASentence_neverPraise()
    {
        for (const CertificateSection &section : {sectionOf({}), [] {
                                                      CertificateSection none;
                                                      addCheckTable({}, none);
                                                      return none;
                                                  }()}) {
            QVERIFY(section.tables.empty());
            QCOMPARE(english(section.paragraphs.at(0)),
                std::string("No quantity was known in two independent ways."));
        }
    }
};

DYNCAL_TEST(TestCertificateChecks)
#include "tst_certificate_checks.moc"
