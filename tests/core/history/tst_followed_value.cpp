// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/history/followed_value.h"
#include "tests/core/recheck/earlier_results.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr FollowedQuantity kF0{FollowedKind::NaturalFrequency};
constexpr FollowedQuantity kDamping{FollowedKind::DampingRatio};
constexpr FollowedQuantity kSensitivity{FollowedKind::Sensitivity};

FollowedQuantity at(FollowedKind kind, double f_Hz)
{
    return {kind, f_Hz, f_Hz};
}

bool says(const FollowedValue &value, const char *words)
{
    return value.missing.find(words) != std::string::npos;
}

EarlierJson withRows(const std::vector<double> &f_Hz)
{
    EarlierJson root = earlierResults();
    root["response"]["frequency_hz"] = f_Hz;
    root["response"]["magnitude"] = std::vector<double>(f_Hz.size(), 5e-6);
    return root;
}

} // namespace

/// What a history reads from one results.json.
class TestFollowedValue : public QObject
{
    Q_OBJECT

private slots:
    void keyResults_areReadWithTheirU();
    void coverageFactor_isThatOfTheCertificate();
    void rows_areReadWithTheirU();
    void names_areThoseOfTheResults();
    void whatIsNotDetermined_isSaid();
    void resultsWithoutCharacteristics_haveNoCompleteU();
    void magnitudeWithoutTheStep_hasNoCompleteU();
    void valueWithoutU_staysAValue();
    void nothing_isInterpolated();
    void withheldRow_saysWhy();
    void servingRow_isTheNearestWithAMagnitude();
    void servingRow_isOfTheLastAmongEquals();
    void oddResults_stateNothing_data();
    void oddResults_stateNothing();
};

void TestFollowedValue::keyResults_areReadWithTheirU()
{
    const FollowedValue f0 = followedValue(earlierResults(), kF0);
    QCOMPARE(f0.value, 318e3);
    QCOMPARE(f0.u, 10.0);
    QCOMPARE(f0.U(), 20.0);
    QCOMPARE(f0.unit, std::string("Hz"));
    QCOMPARE(f0.missing, std::string());
    QCOMPARE(followedValue(earlierResults(), kDamping).value, 0.02);
    const FollowedValue sensitivity = followedValue(earlierResults(), kSensitivity);
    QCOMPARE(sensitivity.value, 5e-6);
    QCOMPARE(sensitivity.U(), 1e-7);
    QCOMPARE(sensitivity.unit, std::string("V/Pa"));
}

/// 2, or Student's where that is more: never the 1.96 that results.json may state.
void TestFollowedValue::coverageFactor_isThatOfTheCertificate()
{
    QCOMPARE(followedValue(earlierResults(), kDamping).k, 2.0); // 1.96 there
    QCOMPARE(followedValue(earlierResults(), at(FollowedKind::Magnitude, 1e5)).k, 2.5);
    EarlierJson root = earlierResults();
    root["sensitivity"].erase("k");
    QCOMPARE(followedValue(root, kSensitivity).k, 2.0);
}

void TestFollowedValue::rows_areReadWithTheirU()
{
    const FollowedValue magnitude
        = followedValue(earlierResults(), at(FollowedKind::Magnitude, 1e4));
    QCOMPARE(magnitude.value, 5.1e-6);
    QCOMPARE(magnitude.u, 5e-8);
    QCOMPARE(magnitude.unit, std::string("V/Pa"));
    const FollowedValue phase = followedValue(earlierResults(), at(FollowedKind::Phase, 1e5));
    QCOMPARE(phase.value, -3.1);
    QCOMPARE(phase.U(), 0.04);
    QCOMPARE(phase.unit, std::string("rad"));
}

void TestFollowedValue::names_areThoseOfTheResults()
{
    QCOMPARE(kF0.name(), "f0_hz");
    QCOMPARE(kDamping.name(), "damping_ratio");
    QCOMPARE(kSensitivity.name(), "sensitivity");
    QCOMPARE(at(FollowedKind::Magnitude, 1.0).name(), "magnitude");
    QCOMPARE(at(FollowedKind::Phase, 1.0).name(), "phase_rad");
    QVERIFY(at(FollowedKind::Phase, 1.0).isOverFrequency());
    QVERIFY(!kSensitivity.isOverFrequency());
}

void TestFollowedValue::whatIsNotDetermined_isSaid()
{
    EarlierJson root = earlierResults();
    root["characteristics"] = EarlierJson::array();
    root["sensitivity"] = {{"value", nullptr}, {"u", nullptr}, {"unit", "V/Pa"}};
    for (const FollowedQuantity &quantity : {kF0, kDamping, kSensitivity}) {
        const FollowedValue found = followedValue(root, quantity);
        QVERIFY(std::isnan(found.value));
        QVERIFY(std::isnan(found.U()));
        QVERIFY(says(found, "Not determined"));
    }
}

void TestFollowedValue::resultsWithoutCharacteristics_haveNoCompleteU()
{
    EarlierJson root = earlierResults();
    root.erase("characteristics");
    QVERIFY(std::isnan(followedValue(root, kF0).value));
    QVERIFY(says(followedValue(root, kF0), "noise alone"));
}

void TestFollowedValue::magnitudeWithoutTheStep_hasNoCompleteU()
{
    EarlierJson root = earlierResults();
    root["response"]["u_contains_step"] = false;
    const FollowedValue magnitude = followedValue(root, at(FollowedKind::Magnitude, 1e4));
    QCOMPARE(magnitude.value, 5.1e-6);
    QVERIFY(std::isnan(magnitude.u));
    QVERIFY(says(magnitude, "noise alone"));
    QVERIFY(std::isfinite(followedValue(root, at(FollowedKind::Phase, 1e4)).u));
    root["response"]["unit"] = "V"; // of a unit step there is none
    QCOMPARE(followedValue(root, at(FollowedKind::Magnitude, 1e4)).u, 5e-8);
}

void TestFollowedValue::valueWithoutU_staysAValue()
{
    EarlierJson root = earlierResults();
    for (const EarlierJson &u : {EarlierJson(), EarlierJson(-1.0), EarlierJson("much")}) {
        root["sensitivity"]["u"] = u;
        const FollowedValue found = followedValue(root, kSensitivity);
        QCOMPARE(found.value, 5e-6);
        QVERIFY(std::isnan(found.u) && std::isnan(found.k) && std::isnan(found.U()));
        QVERIFY(says(found, "no uncertainty"));
    }
}

void TestFollowedValue::nothing_isInterpolated()
{
    const EarlierJson root = earlierResults();
    QCOMPARE(followedValue(root, at(FollowedKind::Magnitude, 1e4 * (1.0 + 5e-7))).value, 5.1e-6);
    for (const double f_Hz : {1e4 * (1.0 + 2e-6), 3e4, 10.0, 1e7}) {
        const FollowedValue none = followedValue(root, at(FollowedKind::Magnitude, f_Hz));
        QVERIFY(std::isnan(none.value));
        QVERIFY(says(none, "no row at") && says(none, "nothing is interpolated"));
    }
    const FollowedValue nowhere = followedValue(root, {FollowedKind::Magnitude, 2e4, kUnknown});
    QVERIFY(std::isnan(nowhere.value));
    QVERIFY2(says(nowhere, "within 3 % of 20 kHz"), nowhere.missing.c_str());
}

void TestFollowedValue::withheldRow_saysWhy()
{
    EarlierJson root = earlierResults();
    root["response"]["magnitude"][1] = nullptr;
    QVERIFY(says(followedValue(root, at(FollowedKind::Magnitude, 1e4)), "Not determined"));
    root["response"]["withheld_reason"] = {nullptr, "The record ends.", nullptr};
    const FollowedValue withheld = followedValue(root, at(FollowedKind::Magnitude, 1e4));
    QCOMPARE(withheld.missing, std::string("The record ends."));
    QVERIFY(std::isnan(withheld.value) && std::isnan(withheld.u));
    QCOMPARE(followedValue(root, at(FollowedKind::Magnitude, 1e5)).missing, std::string());
}

void TestFollowedValue::servingRow_isTheNearestWithAMagnitude()
{
    EarlierJson a = withRows({1000.0, 1258.925, 1584.893});
    const EarlierJson b = withRows({1249.0, 2000.0});
    QCOMPARE(servingRow_Hz({&a}, 1250.0), 1258.925);
    QCOMPARE(servingRow_Hz({&a, &b}, 1250.0), 1249.0);
    QCOMPARE(servingRow_Hz({&b, &a}, 1250.0), 1249.0);
    QCOMPARE(servingRow_Hz({&a, &b}, 2059.0), 2000.0);
    QVERIFY(std::isnan(servingRow_Hz({&a, &b}, 1400.0)));
    QVERIFY(std::isnan(servingRow_Hz({&a, &b}, 2070.0))); // 3.4 %
    QVERIFY(std::isnan(servingRow_Hz({}, 1000.0)));
    a["response"]["magnitude"][1] = nullptr;
    QVERIFY(std::isnan(servingRow_Hz({&a}, 1250.0)));
}

void TestFollowedValue::servingRow_isOfTheLastAmongEquals()
{
    const EarlierJson a = withRows({9900.0}), b = withRows({10100.0});
    QCOMPARE(servingRow_Hz({&a, &b}, 1e4), 10100.0);
    QCOMPARE(servingRow_Hz({&b, &a}, 1e4), 9900.0);
}

void TestFollowedValue::oddResults_stateNothing_data()
{
    QTest::addColumn<QByteArray>("text");
    for (const char *text : {"{}", "[]", "null", R"({"response": 3, "sensitivity": [1]})",
             R"({"characteristics": [1, null, "f0_hz", {"quantity": "f0_hz", "value": "x"}]})",
             R"({"characteristics": {"f0_hz": 1}, "response": {"frequency_hz": "10000"}})",
             R"({"response": {"frequency_hz": [10000], "magnitude": "much"}})",
             R"({"response": {"frequency_hz": [null, 10000], "magnitude": [1]}})",
             R"({"response": {"frequency_hz": [10000], "magnitude": [], "phase_rad": {}}})"})
        QTest::newRow(text) << QByteArray(text);
}

void TestFollowedValue::oddResults_stateNothing()
{
    QFETCH(QByteArray, text);
    const EarlierJson root = EarlierJson::parse(text.toStdString());
    for (const FollowedQuantity &quantity : {kF0, kDamping, kSensitivity,
             at(FollowedKind::Magnitude, 1e4), at(FollowedKind::Phase, 1e4)}) {
        const FollowedValue found = followedValue(root, quantity);
        QVERIFY(std::isnan(found.value));
        QVERIFY(!found.missing.empty());
    }
    QVERIFY(std::isnan(servingRow_Hz({&root}, 1e4)));
}

DYNCAL_TEST(TestFollowedValue)
#include "tst_followed_value.moc"
