// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Sections monte_carlo and gum_validated_by_monte_carlo of results.json.

#include "core/results/results_monte_carlo_json.h"
#include "tests/support/made_monte_carlo.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <memory>

using namespace dyncal;
using Json = nlohmann::json;

namespace {

Json written(std::shared_ptr<const ChainMonteCarlo> drawn)
{
    PipelineOutcome outcome;
    outcome.results.chainMonteCarlo = std::move(drawn);
    const Recipe recipe;
    JsonRecord root;
    addChainMonteCarlo(root, {outcome, recipe});
    return root.take();
}

Json writtenOf(ChainMonteCarlo drawn = testing::madeMonteCarlo())
{
    return written(std::make_shared<const ChainMonteCarlo>(std::move(drawn)));
}

} // namespace

class TestResultsMonteCarloJson : public QObject
{
    Q_OBJECT

private slots:
    void head_saysHowItWasMade()
    {
        const Json section = writtenOf()["monte_carlo"];
        QCOMPARE(section["trials"].get<int>(), 10000);
        QCOMPARE(section["seed"].get<int>(), 7);
        QCOMPARE(section["coverage"].get<double>(), 0.95);
        QCOMPARE(section["adaptive"].get<bool>(), false);
        QVERIFY(section["stable"].is_null() && section["stable_reason"].is_string());
        QCOMPARE(section["validated"].get<bool>(), false);
        QCOMPARE(writtenOf()["gum_validated_by_monte_carlo"].get<bool>(), false);
    }

    void quantities_haveBothPropagations()
    {
        const Json list = writtenOf()["monte_carlo"]["quantities"];
        QCOMPARE(list.size(), std::size_t(5));
        const Json &f0 = list[2];
        QCOMPARE(f0["of"].get<std::string>(), std::string("f0_hz"));
        QCOMPARE(f0["unit"].get<std::string>(), std::string("Hz"));
        QCOMPARE(f0["low"].get<double>(), 1e5 - 200.0);
        QCOMPARE(f0["expanded"].get<double>(), 200.0);
        QVERIFY(std::abs(f0["high_gum"].get<double>() - 100200.0) < 1e-3);
        QVERIFY(f0["validated"].get<bool>() && !list[3]["validated"].get<bool>());
        QVERIFY(list[3]["d_high"].get<double>() > list[3]["tolerance"].get<double>());
    }

    void undefinedTrials_leaveNullsWithTheReason()
    {
        const Json one = writtenOf()["monte_carlo"]["quantities"][4];
        QCOMPARE(one["undefined_trials"].get<int>(), 3);
        for (const char *key : {"mean", "u", "low", "high", "shortest_low", "expanded", "d_low"}) {
            QVERIFY2(one[key].is_null(), key);
            QVERIFY2(one[std::string(key) + "_reason"].is_string(), key);
        }
        QVERIFY(!one["validated"].get<bool>());
    }

    void rows_areLists_nullWhereWithheld()
    {
        const Json rows = writtenOf()["monte_carlo"]["rows"];
        QCOMPARE(rows["frequency_hz"].size(), std::size_t(3));
        QCOMPARE(rows["magnitude_high"][0].get<double>(), 5.1e-6);
        QCOMPARE(rows["phase_rad_low"][1].get<double>(), -0.11);
        QVERIFY(rows["magnitude_high"][2].is_null() && rows["magnitude_high_reason"].is_string());
        QCOMPARE(rows["magnitude_validated"], Json({true, true, nullptr}));
        QCOMPARE(rows["phase_rad_validated"], Json({false, false, nullptr}));
        QCOMPARE(rows["bivariate"], Json({false, false, nullptr}));
        QVERIFY(rows["covariance_re_im"][2][0].is_null());
        QVERIFY(rows["covariance_re_im_reason"].is_string());
    }

    void refits_areWritten()
    {
        const Json refits = writtenOf()["monte_carlo"]["refits"];
        QCOMPARE(refits["n"].get<int>(), 50);
        QVERIFY(refits["agree"].get<bool>());
        QCOMPARE(refits["quantities"][0]["u_draws"].get<double>(), 11.0);
        ChainMonteCarlo without = testing::madeMonteCarlo();
        without.refits = {};
        const Json section = writtenOf(without)["monte_carlo"];
        QVERIFY(section["refits"].is_null() && section["refits_reason"].is_string());
    }

    void allThatIsValidated_isTold()
    {
        ChainMonteCarlo made = testing::madeMonteCarlo();
        made.values.resize(3);
        made.rows.clear();
        made.isAdaptive = made.isStable = true;
        const Json root = writtenOf(made);
        QVERIFY(root["gum_validated_by_monte_carlo"].get<bool>());
        QVERIFY(root["monte_carlo"]["stable"].get<bool>());
        QVERIFY(root["monte_carlo"]["rows"]["frequency_hz"].is_null());
    }

    void nothingDrawn_isNullWithTheReason()
    {
        for (const Json &root : {written(nullptr), writtenOf(ChainMonteCarlo())}) {
            for (const char *key : {"monte_carlo", "gum_validated_by_monte_carlo"}) {
                QVERIFY2(root[key].is_null(), key);
                QVERIFY2(root[std::string(key) + "_reason"].is_string(), key);
            }
        }
    }
};

DYNCAL_TEST(TestResultsMonteCarloJson)
#include "tst_results_monte_carlo_json.moc"
