// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What results.json says of comparisons and of conformity, from results that are written down.

#include "core/certificate/conformity.h"
#include "core/results/results_checks_json.h"
#include "core/results/results_conformity_json.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"
#include "tests/support/writable_result.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <set>

using namespace dyncal;
using testing::isNear;

namespace {

using Json = nlohmann::json;

WayComparison shotsVelocity(double value_a, double value_b, double u)
{
    return {.of = Compared::Velocity,
        .a = Way::Arrivals,
        .b = Way::Counters,
        .shot = 2,
        .value_a = value_a,
        .value_b = value_b,
        .u = u,
        .unit = "m/s"};
}

Json checksOf(std::vector<WayComparison> checks)
{
    PipelineOutcome outcome;
    outcome.results.checks
        = std::make_shared<ConsistencyResult>(ConsistencyResult{std::move(checks), {}});
    const Recipe recipe;
    JsonRecord root;
    addChecks(root, {outcome, recipe});
    return root.take().at("checks");
}

/// Every null has its reason beside it.
void verifyReasons(const Json &record)
{
    for (const auto &[key, value] : record.items())
        if (value.is_null())
            QVERIFY2(!record.value(key + "_reason", "").empty(), key.c_str());
}

ResponseResult flatResponse()
{
    ResponseResult made;
    made.unit = made.sensitivityUnit = "V/Pa";
    made.sensitivity = 2.0;
    made.fLow_Hz = 500.0;
    made.fHigh_Hz = 5e3;
    made.frequency_Hz = Eigen::Vector3d(1000.0, 1250.0, 1500.0);
    made.magnitude = Eigen::Vector3d(2.0, 2.0, 2.06);
    made.u_noiseMagnitude = made.u_magnitude = Eigen::Vector3d::Constant(0.008);
    made.boundEnd = made.boundAlias = made.u_frontMagnitude = Eigen::Vector3d::Zero();
    made.dof = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    made.front = {1e-9, 1e-10};
    ShotSensitivity shot;
    shot.uLevel_relative = 0.0;
    made.shots = {shot};
    return made;
}

Json conformityOf(const PipelineOutcome &outcome, const Recipe &recipe)
{
    JsonRecord root;
    addConformity(root, {outcome, recipe});
    return root.take();
}

Recipe asking(double within_percent, double to_Hz = 1500.0)
{
    Recipe recipe;
    recipe.certificate.decision
        = DecisionSettings{DecisionRule::Simple, within_percent, 1000.0, to_Hz, 5.0};
    return recipe;
}

PipelineOutcome outcomeOf(const ResponseResult &response)
{
    PipelineOutcome outcome;
    testing::writable(outcome.results.response) = response;
    return outcome;
}

} // namespace

class TestChecksJson : public QObject
{
    Q_OBJECT

private slots:
    void comparison_hasItsNumbers()
    {
        const Json one = checksOf({shotsVelocity(512.0, 509.0, 0.75)}).at(0);
        QCOMPARE(one.at("of").get<std::string>(), std::string("velocity"));
        QCOMPARE(one.at("ways").get<std::vector<std::string>>(),
            (std::vector<std::string>{"arrivals", "counters"}));
        QCOMPARE(one.at("shot").get<int>(), 2);
        QCOMPARE(one.at("unit").get<std::string>(), std::string("m/s"));
        QCOMPARE(one.at("difference").get<double>(), 3.0);
        QCOMPARE(one.at("e_n").get<double>(), 2.0); // of U = 2 u
        QVERIFY(isNear(one.at("smallest_detectable").get<double>(), 0.75 * 4.8816, 1e-6));
        QCOMPARE(one.at("agree").get<bool>(), false); // 4 u
        QVERIFY(one.at("channel").is_null());
        verifyReasons(one);
    }

    /// 3.6 u agrees still; the sign says nothing.
    void agreement_endsAtItsLimit()
    {
        for (const double sign : {1.0, -1.0}) {
            const Json checks = checksOf(
                {shotsVelocity(sign * 3.599, 0.0, 1.0), shotsVelocity(sign * 3.601, 0.0, 1.0)});
            QCOMPARE(checks[0].at("agree").get<bool>(), true);
            QCOMPARE(checks[1].at("agree").get<bool>(), false);
        }
    }

    /// Not made: no number, no verdict, the reason everywhere.
    void comparisonThatWasNotMade_saysWhy()
    {
        WayComparison check = shotsVelocity(kUnknown, 500.0, kUnknown);
        check.missing = Message{"one sensor only", {}};
        check.shot = 0;
        const Json one = checksOf({check}).at(0);
        for (const char *key :
            {"value_a", "difference", "u", "e_n", "smallest_detectable", "agree"}) {
            QVERIFY2(one.at(key).is_null(), key);
            QCOMPARE(one.at(std::string(key) + "_reason").get<std::string>(),
                std::string("one sensor only"));
        }
        QVERIFY(one.at("shot").is_null());
        verifyReasons(one);
    }

    /// Levels are names: their verdict is known without a number.
    void levels_haveAVerdictWithoutNumbers()
    {
        WayComparison levels;
        levels.of = Compared::Levels;
        levels.a = Way::Names;
        levels.b = Way::Steps;
        for (const bool isInOrder : {true, false}) {
            levels.isInOrder = isInOrder;
            const Json one = checksOf({levels}).at(0);
            QCOMPARE(one.at("agree").get<bool>(), isInOrder);
            QVERIFY(one.at("value_a").is_null() && one.at("unit").is_null());
            verifyReasons(one);
        }
    }

    /// Words of a file that programs read: one for each way, none twice.
    void words_areDifferent()
    {
        std::set<std::string> compared, ways;
        for (int i = 0; i <= static_cast<int>(Compared::Levels); ++i)
            QVERIFY(compared.insert(comparedName(static_cast<Compared>(i))).second);
        for (int i = 0; i <= static_cast<int>(Way::Steps); ++i)
            QVERIFY(ways.insert(wayName(static_cast<Way>(i))).second);
    }

    void notComputed_saysWhyForTheWhole()
    {
        PipelineOutcome outcome;
        outcome.error = Error{ErrorKind::DataBlocked, {"no start", {}}, {}, 0};
        const Recipe recipe = asking(5.0);
        JsonRecord root;
        addChecks(root, {outcome, recipe});
        const Json json = root.take();
        QVERIFY(json.at("checks").is_null());
        QVERIFY(json.at("checks_reason").get<std::string>().find("no start") != std::string::npos);
        const Json judged = conformityOf(outcome, recipe);
        QVERIFY(judged.at("conformity_reason").get<std::string>().find("no start")
            != std::string::npos);
    }

    void conformity_isJudgedOnlyWhereAsked()
    {
        const Json json = conformityOf(outcomeOf(flatResponse()), {});
        QVERIFY(json.at("conformity").is_null());
        QVERIFY(json.at("conformity_reason").get<std::string>().find("certificate.decision")
            != std::string::npos);
    }

    void conformity_hasVerdictAndWorstRow()
    {
        const PipelineOutcome outcome = outcomeOf(flatResponse());
        const Json kept = conformityOf(outcome, asking(3.5)).at("conformity");
        QCOMPARE(kept.at("verdict").get<std::string>(), std::string("conforms"));
        QCOMPARE(kept.at("rows").get<int>(), 3);
        const Json &worst = kept.at("worst");
        QCOMPARE(worst.at("frequency_hz").get<double>(), 1500.0);
        QVERIFY(isNear(worst.at("deviation_percent").get<double>(), 3.0));
        QVERIFY(isNear(worst.at("u_percent").get<double>(), 0.4));
        QCOMPARE(worst.at("k").get<double>(), 2.0);
        // 0.5 % inside at u = 0.4 %: 1.25 u.
        const double beyond = 50.0 * std::erfc(1.25 / std::sqrt(2.0));
        QVERIFY(isNear(worst.at("risk_percent").get<double>(), beyond, 1e-6));
        verifyReasons(worst);
        const Json broken = conformityOf(outcome, asking(2.5)).at("conformity");
        QCOMPARE(broken.at("verdict").get<std::string>(), std::string("does-not-conform"));
    }

    /// No statement is neither of both: null, and why.
    void noStatement_isNullWithItsReason()
    {
        const Json section
            = conformityOf(outcomeOf(flatResponse()), asking(5.0, 9e3)).at("conformity");
        QVERIFY(section.at("verdict").is_null() && section.at("worst").is_null());
        QVERIFY(section.at("verdict_reason").get<std::string>().starts_with("no statement"));
        QCOMPARE(section.at("rows").get<int>(), 0);
        verifyReasons(section);
    }
};

DYNCAL_TEST(TestChecksJson)
#include "tst_checks_json.moc"
