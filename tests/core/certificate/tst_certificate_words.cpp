// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The words and numbers that all sections print with.

#include "core/base/constants.h"
#include "core/certificate/certificate_words.h"
#include "core/certificate/result_quantity.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr const char *kDash = "\u2013";

/// The number that a cell begins with.
double numberIn(const Message &cell)
{
    return std::stod(english(cell));
}

ResultQuantity quantity(double value, double u, double k = 2.0, const char *unit = "Hz")
{
    ResultQuantity made;
    made.label = {"what", {}};
    made.value = value;
    made.u = u;
    made.k = k;
    made.unit = unit;
    made.otherwise = {"not known", {}};
    return made;
}

std::vector<std::string> rowOf(const ResultQuantity &of)
{
    CertificateSection section;
    addQuantityTables({of}, section);
    std::vector<std::string> cells{section.tables.at(0).id};
    for (const Message &cell : section.tables.at(0).rows.at(0))
        cells.push_back(english(cell));
    return cells;
}

} // namespace

class TestCertificateWords : public QObject
{
    Q_OBJECT

private slots:
    void blanks_areNothingTyped()
    {
        for (const char *text : {"", " ", "\t", " \r\n\t "})
            QVERIFY(isBlank(text));
        for (const char *text : {"0", " x", ".\n", "\u00a0"})
            QVERIFY(!isBlank(text));
    }

    void listValues_areUnknownPastTheEnd()
    {
        const Eigen::Vector3d values(1.0, 2.0, 3.0);
        QCOMPARE(valueAt(values, 2), 3.0);
        QVERIFY(std::isnan(valueAt(values, 3)));
        QVERIFY(std::isnan(valueAt({}, 0)));
    }

    /// However u is rounded, U as it is printed is not below the CMC and at most a tenth above what
    /// both ask for.
    void printedU_isNeverBelowTheCapability()
    {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> decade(-3.0, 3.0), share(1.0, 1.3);
        for (int trial = 0; trial < 3000; ++trial) {
            const double least = std::pow(10.0, decade(random));
            const double k = trial % 2 == 0 ? 2.0 : 3.18;
            const double u = share(random) * least / k; // not below it before it is printed
            const double printedU = printableU(u, k, least);
            const double U = numberIn(expandedCell(1.0, printedU, "", k));
            QVERIFY2(U >= least * (1.0 - 1e-9), std::to_string(least).c_str());
            QVERIFY2(U <= 1.11 * k * u, std::to_string(u).c_str());
        }
    }

    void withoutCapability_uIsItself()
    {
        QCOMPARE(printableU(0.7, 2.0, 0.0), 0.7);
        QVERIFY(std::isnan(printableU(kUnknown, 2.0, 0.0)));
    }

    /// Value and half width of one quantity: the three ways to print it say the same digits.
    void cells_sayWhatTheWholeTextSays()
    {
        const std::string whole = english(printedWithUncertainty(2.330149e6, 617.0, "Hz"));
        QCOMPARE(whole, std::string("2.3301 MHz \u00b1 0.0012 MHz (k = 2)"));
        QCOMPARE(english(valueCell(2.330149e6, 617.0, "Hz")), std::string("2.3301 MHz"));
        QCOMPARE(english(expandedCell(2.330149e6, 617.0, "Hz")), std::string("0.0012 MHz"));
        QCOMPARE(english(expandedCell(2.330149e6, 1234.0 / 4.3, "Hz", 4.3)),
            std::string("0.0012 MHz (k = 4.30)"));
        QCOMPARE(english(printedWithUncertainty(0.0204, 0.0003, "")),
            std::string("0.02040 \u00b1 0.00060 (k = 2)"));
    }

    void unknownNumbers_areDashesOrThreeDigits()
    {
        for (const double value : {kUnknown, kInf, -kInf}) {
            QCOMPARE(english(printedWithUncertainty(value, 1.0, "Hz")), std::string(kDash));
            QCOMPARE(english(printed(value, "Hz", {"none", {}})), std::string("none"));
            QCOMPARE(english(setting(value, "Hz")), std::string(kDash));
        }
        QCOMPARE(english(printed(std::nullopt, "Hz", {"none", {}})), std::string("none"));
        for (const double u : {kUnknown, 0.0, -1.0, kInf}) {
            QCOMPARE(english(expandedCell(2.330149e6, u, "Hz")), std::string(kDash));
            QCOMPARE(english(printedWithUncertainty(2.330149e6, u, "Hz")), std::string("2.33 MHz"));
            QCOMPARE(english(valueCell(2.330149e6, u, "Hz")), std::string("2.33 MHz"));
        }
    }

    void levels_haveTheirWords()
    {
        QCOMPARE(english(levelWord(ShotLevel::Low)), std::string("low"));
        QCOMPARE(english(levelWord(ShotLevel::Medium)), std::string("medium"));
        QCOMPARE(english(levelWord(ShotLevel::High)), std::string("high"));
        QCOMPARE(english(levelWord(ShotLevel::None)), std::string(kDash));
    }

    /// A value with its u, U of two digits, in one unit.
    void result_hasValueUAndK()
    {
        QCOMPARE(rowOf(quantity(2.330149e6, 617.0)),
            (std::vector<std::string>{"key-results", "what", "2.3301 MHz", "0.0012 MHz", "2"}));
        QCOMPARE(rowOf(quantity(0.02, 0.0001, 4.302653, "")),
            (std::vector<std::string>{"key-results", "what", "0.02000", "0.00043", "4.30"}));
        // k below 2 is not printed: the interval would hold less than 95 % of a normal error.
        QCOMPARE(rowOf(quantity(100.0, 1.0, 1.9)).at(3), std::string("2.0 Hz"));
    }

    /// Without u, without value, or with a u that rounding would make of nothing: no result.
    void others_standInASecondTable()
    {
        for (const ResultQuantity &none : {quantity(1e6, kUnknown), quantity(1e6, 0.0),
                 quantity(kUnknown, 1.0), quantity(1e6, 1e-9), quantity(1e6, kInf)}) {
            QVERIFY(!none.isResult());
            QCOMPARE(rowOf(none), (std::vector<std::string>{"not-reported", "what", "not known"}));
        }
    }

    void resultBelowTheCapability_isBroughtUpToIt()
    {
        ResultQuantity of = quantity(500.0, 1.0);
        of.leastExpanded = 2.04; // two digits: 2.1 is the least that is not below it
        QCOMPARE(rowOf(of).at(3), std::string("2.1 Hz"));
        of.leastExpanded = 2.0;
        QCOMPARE(rowOf(of).at(3), std::string("2.0 Hz"));
    }

    /// In their order, each in its table; an empty table is none.
    void tables_keepTheOrder()
    {
        std::vector<ResultQuantity> all{quantity(1.0, 0.1), quantity(2.0, kUnknown),
            quantity(3.0, 0.1), quantity(4.0, kUnknown)};
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i].label = {"%1", {std::to_string(i)}};
        CertificateSection section;
        addQuantityTables(all, section);
        QCOMPARE(section.tables.size(), std::size_t(2));
        for (std::size_t table = 0; table < 2; ++table) {
            const auto &rows = section.tables[table].rows;
            QCOMPARE(rows.size(), std::size_t(2));
            for (std::size_t i = 0; i < 2; ++i) {
                QCOMPARE(english(rows[i][0]), std::to_string(2 * i + table));
                QCOMPARE(rows[i].size(), section.tables[table].columns.size());
            }
        }
        CertificateSection empty;
        addQuantityTables({}, empty);
        QVERIFY(empty.tables.empty());
    }
};

DYNCAL_TEST(TestCertificateWords)
#include "tst_certificate_words.moc"
