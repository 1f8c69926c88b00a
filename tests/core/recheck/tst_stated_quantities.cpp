// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/recheck/stated_quantities.h"
#include "tests/core/recheck/earlier_results.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <set>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

using PairList = std::vector<QuantityPair>;

PairList quantitiesOf(const EarlierJson &issued, const EarlierJson &now)
{
    return statedQuantities(issued, now);
}

/// The pair of that name; an empty one where there is none.
QuantityPair pairOf(const PairList &pairs, const std::string &of)
{
    const auto found = std::ranges::find(pairs, of, &QuantityPair::of);
    return found != pairs.end() ? *found : QuantityPair();
}

/// Results as they were before there was one budget for everything.
EarlierJson olderResults()
{
    EarlierJson root = earlierResults();
    root.erase("characteristics");
    root["response"]["u_contains_step"] = false;
    root["response"].erase("k_magnitude");
    const auto pole = [](double im, double f_Hz, const char *kind) {
        return EarlierJson{{"re", 0.5}, {"im", im}, {"class", kind}, {"frequency_hz", f_Hz},
            {"u_frequency_hz", 3.0}, {"damping_ratio", 0.02}, {"u_damping_ratio", 1e-5}};
    };
    root["model"] = {{"poles",
        {pole(0.0, 100.0, "other"), pole(0.4, 318e3, "sensor"), pole(-0.4, 318e3, "sensor")}}};
    return root;
}

} // namespace

class TestStatedQuantities : public QObject
{
    Q_OBJECT

private slots:
    void everyQuantity_isThereOnce()
    {
        const PairList pairs = quantitiesOf(earlierResults(), earlierResults());
        std::set<std::string> names;
        for (const QuantityPair &pair : pairs) {
            names.insert(pair.of);
            QCOMPARE(pair.now, pair.issued);
            QVERIFY2(pair.u > 0.0, pair.of.c_str());
            QVERIFY2(!pair.unit.empty(), pair.of.c_str());
        }
        const std::set<std::string> needed{"f0_hz", "damping_ratio", "sensitivity",
            "sensitivity.per_level[0]", "sensitivity.linearity_per_pa", "shots[0].sensitivity",
            "shock[0].velocity_m_s", "shock[0].mach", "shock[0].p2_pa", "shock[0].p5_pa",
            "shock[0].step_pa", "response.magnitude[0]", "response.magnitude[1]",
            "response.magnitude[2]", "response.phase_rad[0]", "response.phase_rad[1]",
            "response.phase_rad[2]"};
        QCOMPARE(names, needed);
        QCOMPARE(pairs.size(), needed.size());
    }

    void valuesUAndK_areThoseOfTheEarlierResults_data()
    {
        QTest::addColumn<QString>("of");
        QTest::addColumn<double>("issued");
        QTest::addColumn<double>("u");
        QTest::addColumn<double>("k"); // 0 = none stated
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("where");
        const auto row = [](const char *of, double issued, double u, double k, const char *unit,
                             const char *where) {
            QTest::newRow(of) << QString(of) << issued << u << k << QString(unit) << QString(where);
        };
        row("f0_hz", 318e3, 10.0, 2.0, "Hz", "");
        row("damping_ratio", 0.02, 1e-4, 1.96, "1", "");
        row("sensitivity", 5e-6, 5e-8, 2.0, "V/Pa", "");
        row("sensitivity.per_level[0]", 5.1e-6, 6e-8, 2.1, "V/Pa", "low");
        row("sensitivity.linearity_per_pa", 1e-9, 2e-9, 0.0, "1/Pa", "");
        row("shots[0].sensitivity", 5.1e-6, 6e-8, 2.2, "V/Pa", "shot 1");
        row("shock[0].velocity_m_s", 430.0, 0.8, 2.0, "m/s", "shot 1");
        row("shock[0].mach", 1.25, 0.002, 0.0, "1", "shot 1");
        row("shock[0].step_pa", 168e3, 2e3, 2.3, "Pa", "shot 1");
        row("response.magnitude[2]", 5.5e-6, 6e-8, 2.5, "V/Pa", "100 kHz");
        row("response.phase_rad[1]", -0.1, 0.01, 2.0, "rad", "10 kHz");
    }
    void valuesUAndK_areThoseOfTheEarlierResults()
    {
        QFETCH(QString, of);
        QFETCH(double, issued);
        QFETCH(double, u);
        QFETCH(double, k);
        QFETCH(QString, unit);
        QFETCH(QString, where);
        EarlierJson now = earlierResults(); // of which only the values count
        now["characteristics"][0]["u"] = 99.0;
        now["sensitivity"]["k"] = 99.0;
        const QuantityPair pair = pairOf(quantitiesOf(earlierResults(), now), of.toStdString());
        QCOMPARE(pair.issued, issued);
        QCOMPARE(pair.u, u);
        QVERIFY(k == 0.0 ? std::isnan(pair.k) : pair.k == k);
        QCOMPARE(pair.unit, unit.toStdString());
        QCOMPARE(pair.where, where.toStdString());
        QVERIFY(!pair.isOfNoiseAlone);
        QCOMPARE(pair.isAngle, of.contains("phase"));
    }

    /// Every quantity, wherever its unit and u stand.
    void unitAndUOfTheLaterResults_areThere()
    {
        for (const QuantityPair &pair : quantitiesOf(earlierResults(), earlierResults())) {
            QVERIFY2(pair.unitNow == pair.unit, pair.of.c_str());
            QVERIFY2(pair.uNow == pair.u, pair.of.c_str());
        }
        EarlierJson now = earlierResults();
        now["characteristics"][0]["unit"] = "kHz";
        now["characteristics"][0]["u"] = 0.5;
        now["sensitivity"]["unit"] = "1/s";
        now["shots"][0]["sensitivity_unit"] = "2/s";
        now["response"]["unit"] = "3/s";
        now["response"]["u_magnitude"][1] = 4.0;
        const PairList pairs = quantitiesOf(earlierResults(), now);
        QCOMPARE(pairOf(pairs, "f0_hz").unitNow, std::string("kHz"));
        QCOMPARE(pairOf(pairs, "f0_hz").unit, std::string("Hz"));
        QCOMPARE(pairOf(pairs, "f0_hz").uNow, 0.5);
        QCOMPARE(pairOf(pairs, "damping_ratio").unitNow, std::string("1"));
        QCOMPARE(pairOf(pairs, "sensitivity").unitNow, std::string("1/s"));
        QCOMPARE(pairOf(pairs, "sensitivity.per_level[0]").unitNow, std::string("1/s"));
        QCOMPARE(pairOf(pairs, "shots[0].sensitivity").unitNow, std::string("2/s"));
        QCOMPARE(pairOf(pairs, "response.magnitude[1]").unitNow, std::string("3/s"));
        QCOMPARE(pairOf(pairs, "response.magnitude[1]").uNow, 4.0);
        QCOMPARE(pairOf(pairs, "response.phase_rad[1]").unitNow, std::string("rad"));
    }

    void entries_areMatchedByWhatTheyAre_notByPlace()
    {
        EarlierJson now = earlierResults();
        std::swap(now["characteristics"][0], now["characteristics"][1]);
        EarlierJson other = now["shots"][0];
        other["shot"] = 2;
        other["sensitivity"] = 9e-6;
        now["shots"].insert(now["shots"].begin(), other);
        EarlierJson level = now["sensitivity"]["per_level"][0];
        level["level"] = "high";
        now["sensitivity"]["per_level"] = {level};
        const PairList pairs = quantitiesOf(earlierResults(), now);
        QCOMPARE(pairOf(pairs, "f0_hz").now, 318e3);
        QCOMPARE(pairOf(pairs, "shots[0].sensitivity").now, 5.1e-6);
        QVERIFY(std::isnan(pairOf(pairs, "sensitivity.per_level[0]").now));
    }

    void rows_areMatchedByFrequency()
    {
        EarlierJson now = earlierResults();
        now["response"]["frequency_hz"] = {500.0, 1e4 * (1.0 + 1e-12), 2e5};
        now["response"]["magnitude"] = {1.0, 2.0, 3.0};
        now["response"]["phase_rad"] = {4.0, 5.0, 6.0};
        const PairList pairs = quantitiesOf(earlierResults(), now);
        QVERIFY(std::isnan(pairOf(pairs, "response.magnitude[0]").now));
        QCOMPARE(pairOf(pairs, "response.magnitude[1]").now, 2.0);
        QCOMPARE(pairOf(pairs, "response.phase_rad[1]").now, 5.0);
        QVERIFY(std::isnan(pairOf(pairs, "response.magnitude[2]").now));
        QCOMPARE(pairs.size(), quantitiesOf(earlierResults(), earlierResults()).size());
    }

    void quantityThatHadNoPlace_isNotStated()
    {
        EarlierJson issued = earlierResults();
        issued["sensitivity"].erase("linearity_per_pa");
        issued.erase("shock");
        const PairList pairs = quantitiesOf(issued, earlierResults());
        QVERIFY(pairOf(pairs, "sensitivity.linearity_per_pa").of.empty());
        QVERIFY(pairOf(pairs, "shock[0].step_pa").of.empty());
    }

    /// Characteristics are a list of what could be determined.
    void characteristicThatIsNew_wasNotDeterminedThen()
    {
        EarlierJson issued = earlierResults();
        issued["characteristics"].erase(0);
        const QuantityPair f0 = pairOf(quantitiesOf(issued, earlierResults()), "f0_hz");
        QVERIFY(std::isnan(f0.issued) && std::isnan(f0.u));
        QCOMPARE(f0.now, 318e3);
        QCOMPARE(f0.unit, std::string("Hz"));
    }

    void nullThen_hasAPair()
    {
        EarlierJson issued = earlierResults();
        issued["shock"][0]["step_pa"] = nullptr;
        const QuantityPair pair
            = pairOf(quantitiesOf(issued, earlierResults()), "shock[0].step_pa");
        QVERIFY(std::isnan(pair.issued));
        QCOMPARE(pair.now, 168e3);
    }

    void olderResults_haveThePolesOfTheSensor_andSayThatUIsOfTheNoise()
    {
        EarlierJson now = earlierResults();
        now["model"] = olderResults()["model"];
        now["model"]["poles"][1]["frequency_hz"] = 318.2e3;
        EarlierJson far = now["model"]["poles"][1];
        far["frequency_hz"] = 900e3;
        now["model"]["poles"].insert(now["model"]["poles"].begin(), far);
        const PairList pairs = quantitiesOf(olderResults(), now);
        const QuantityPair f0 = pairOf(pairs, "model.poles[1].frequency_hz");
        QCOMPARE(f0.now, 318.2e3); // the nearest one
        QCOMPARE(f0.where, std::string("pole at 318 kHz"));
        QVERIFY(f0.isOfNoiseAlone);
        QVERIFY(std::isnan(f0.k));
        QCOMPARE(pairOf(pairs, "model.poles[1].damping_ratio").u, 1e-5);
        QVERIFY(pairOf(pairs, "model.poles[0].frequency_hz").of.empty()); // no sensor's
        QVERIFY(pairOf(pairs, "model.poles[2].frequency_hz").of.empty()); // the same pair
        QVERIFY(pairOf(pairs, "response.magnitude[0]").isOfNoiseAlone);
        QVERIFY(!pairOf(pairs, "response.phase_rad[0]").isOfNoiseAlone);
        QVERIFY(!pairOf(pairs, "sensitivity").isOfNoiseAlone);
    }

    void olderResults_haveBandsWithoutU()
    {
        EarlierJson issued = olderResults();
        issued["bands"] = {{"within_5_percent_hz", 70e3}, {"minus_3_db_hz", nullptr}};
        EarlierJson now = earlierResults();
        now["bands"] = {{"within_5_percent_hz", 71e3}, {"minus_3_db_hz", 500e3}};
        const PairList pairs = quantitiesOf(issued, now);
        const QuantityPair edge = pairOf(pairs, "bands.within_5_percent_hz");
        QVERIFY(edge.issued == 70e3 && edge.now == 71e3 && std::isnan(edge.u));
        QVERIFY(std::isnan(pairOf(pairs, "bands.minus_3_db_hz").issued));
        QVERIFY(pairOf(pairs, "bands.within_10_percent_hz").of.empty());
        issued = earlierResults(); // where the characteristics state them with u
        issued["bands"] = now["bands"];
        QVERIFY(pairOf(quantitiesOf(issued, now), "bands.within_5_percent_hz").of.empty());
    }

    void pureRatio_hasACompleteUWithoutTheStep()
    {
        EarlierJson issued = earlierResults();
        issued["response"]["unit"] = "1";
        issued["response"]["u_contains_step"] = false;
        QVERIFY(!pairOf(quantitiesOf(issued, issued), "response.magnitude[0]").isOfNoiseAlone);
    }

    void comparison_hasItsRows()
    {
        EarlierJson issued = earlierResults();
        issued["comparison"] = issued["response"];
        issued["comparison"]["difference_relative"] = 0.01;
        issued["comparison"]["u_difference_relative"] = 0.004;
        EarlierJson now = issued;
        now["comparison"]["magnitude"][0] = 7e-6;
        QCOMPARE(pairOf(quantitiesOf(issued, now), "comparison.magnitude[0]").now, 7e-6);
        QCOMPARE(pairOf(quantitiesOf(issued, now), "response.magnitude[0]").now, 5e-6);
        QCOMPARE(pairOf(quantitiesOf(issued, now), "comparison.difference_relative").u, 0.004);
    }

    void nothingNow_leavesEverythingStated()
    {
        const PairList pairs = quantitiesOf(earlierResults(), nullptr);
        QCOMPARE(pairs.size(), quantitiesOf(earlierResults(), earlierResults()).size());
        QVERIFY(std::ranges::all_of(
            pairs, [](const QuantityPair &pair) { return std::isnan(pair.now); }));
    }

    void oddForms_stateNothing_data()
    {
        QTest::addColumn<QByteArray>("json");
        for (const char *json : {"[]", "{}", "7", R"({"characteristics": 3, "shots": {}})",
                 R"({"characteristics": [1, null], "shots": [[]], "shock": ["x"]})",
                 R"({"response": {"frequency_hz": "x", "magnitude": 3}})",
                 R"({"response": {"frequency_hz": [1, 2], "magnitude": []}})",
                 R"({"model": {"poles": {"class": "sensor"}}, "sensitivity": []})",
                 R"({"model": {"poles": [[], 1, {"class": "sensor", "frequency_hz": 0}]}})"})
            QTest::newRow(json) << QByteArray(json);
    }
    void oddForms_stateNothing()
    {
        QFETCH(QByteArray, json);
        const EarlierJson odd = EarlierJson::parse(json.toStdString());
        for (const QuantityPair &pair : quantitiesOf(odd, earlierResults()))
            QVERIFY2(std::isnan(pair.issued), pair.of.c_str());
        const PairList pairs = quantitiesOf(earlierResults(), odd);
        QVERIFY(std::ranges::all_of(
            pairs, [](const QuantityPair &pair) { return std::isnan(pair.now); }));
    }
};

DYNCAL_TEST(TestStatedQuantities)
#include "tst_stated_quantities.moc"
