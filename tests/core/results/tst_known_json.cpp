// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Values of other calibrations in results.json: every number, or null and why.

#include "core/results/results_known_json.h"
#include "tests/support/made_known.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <nlohmann/json.hpp>

using namespace dyncal;

class TestKnownJson : public QObject
{
    Q_OBJECT

private slots:
    void none_isAnEmptyList() { QCOMPARE(knownJson({}).dump(), std::string("[]")); }

    void compared_hasBothValues()
    {
        const auto one = knownJson({testing::madeKnown(0.93)}).at(0);
        QCOMPARE(one.at("label").get<std::string>(), std::string("works"));
        QCOMPARE(one.at("certificate").get<std::string>(), std::string("K 7"));
        QCOMPARE(one.at("frequency_hz").get<double>(), 0.0);
        QCOMPARE(one.at("unit").get<std::string>(), std::string("V/Pa"));
        QCOMPARE(one.at("magnitude").get<double>(), 2e-6);
        QCOMPARE(one.at("u_magnitude").get<double>(), 4e-9);
        QCOMPARE(one.at("magnitude_here").get<double>(), 2.02e-6);
        QCOMPARE(one.at("u_magnitude_here").get<double>(), 1e-8);
        QCOMPARE(one.at("k").get<double>(), 2.0); // that E_n is of
        QCOMPARE(one.at("against").get<std::string>(), std::string("sensitivity"));
        QVERIFY(std::abs(one.at("difference_relative").get<double>() - 0.01) < 1e-12);
        QCOMPARE(one.at("e_n").get<double>(), 0.93);
        QVERIFY(one.at("joined").get<bool>());
    }

    void notCompared_isNull_withTheReason()
    {
        const auto one = knownJson({testing::madeUncompared()}).at(0);
        for (const char *key : {"magnitude_here", "u_magnitude_here", "k_here", "against",
                 "difference_relative", "e_n"}) {
            QVERIFY2(one.at(key).is_null(), key);
            QCOMPARE(one.at(std::string(key) + "_reason").get<std::string>(),
                std::string("2 MHz is above the band, which ends at 1 MHz"));
        }
        QVERIFY(one.at("certificate").is_null());
        QVERIFY(!one.at("joined").get<bool>());
    }

    void row_isNamed_andWhatDiffersIsNotJoined()
    {
        KnownValue row = testing::madeKnown(1.01);
        row.against = KnownAgainst::Row;
        const auto one = knownJson({row, row}).at(1);
        QCOMPARE(one.at("against").get<std::string>(), std::string("row"));
        QVERIFY(!one.at("joined").get<bool>());
    }
};

DYNCAL_TEST(TestKnownJson)
#include "tst_known_json.moc"
