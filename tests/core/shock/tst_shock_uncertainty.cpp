// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_uncertainty.h"
#include "tests/support/common_covariance.h"
#include "tests/support/test_program.h"

#include "tests/support/velocity_coverage.h"

#include <QtTest>

#include <cmath>

using namespace dyncal;
using testing::commonCovariance;

namespace {

constexpr double kVelocity_m_s = 512.8;
constexpr Index kStep = static_cast<Index>(StepResult::Step);

/// The thesis shot with a typed velocity; uncertainties are the test's business.
StepMeasurement thesisShot()
{
    StepMeasurement m;
    m.state = {101100.0, 294.15, 0.0, 0.0};
    m.velocity.velocity_m_s = kVelocity_m_s;
    return m;
}

/// Two places 0.8 m apart.
StepMeasurement measuredShot(double u_distance_m, double u_time_s)
{
    StepMeasurement m = thesisShot();
    Sighting side, wall;
    side.channel = "side";
    side.distance_m = 0.8;
    side.u_distance_m = u_distance_m;
    side.u_time_s = u_time_s;
    wall.channel = "DUT";
    wall.time_s = 0.8 / kVelocity_m_s;
    wall.u_time_s = 1e-10; // next to nothing
    wall.isDut = true;
    m.velocity.sightings = {side, wall};
    // The closed forms below are those of a constant velocity.
    m.velocity.fit = fitVelocity(m.velocity.sightings, Attenuation::None).value();
    m.velocity.velocity_m_s = m.velocity.fit->velocity_m_s;
    return m;
}

/// The example budget of metrology.md 1.7: 0.4143 % by GUM, 0.4141 % by Monte Carlo.
StepMeasurement exampleShot()
{
    StepMeasurement m = measuredShot(2e-4, 1e-6);
    m.u_p1_Pa = 30.0;
    m.u_T1_K = 0.3;
    return m; // gamma 0.0005 and molar mass 0.01 g/mol are the gas's own
}

UncertaintyRequest request(std::vector<StatedUncertainty> stated = {})
{
    return {true, std::move(stated)};
}

StepMonteCarlo drawn(const StepMeasurement &m, Index trials, const UncertaintyRequest &asked = {})
{
    return simulateStep(m, asked, evaluateStep(m, asked)->budget, {trials, 1, 1, 0.95}).value();
}

const BudgetLine &lineOf(const GumBudget &budget, const char *quantity)
{
    for (const BudgetLine &line : budget.lines) {
        if (line.input.quantity == quantity)
            return line;
    }
    qFatal("no line %s", quantity);
}

} // namespace

class TestShockUncertainty : public QObject
{
    Q_OBJECT

private slots:
    void sensitivities_thesisPoint_asPrinted_data();
    void sensitivities_thesisPoint_asPrinted();
    void exampleBudget_gumAndMonteCarlo_asPrinted();
    void exampleBudget_millionTrials_asPrinted();
    void exampleBudget_linesMatchTable();
    void stated_winsOverRecorded();
    void notStated_isMissingWithReason();
    void scatter_isOneLineWithStudentsDof();
    void commonTerms_makeShotsCorrelated();
    void humidAir_sensitivityToHumidity();
    void variableHeatCapacity_hasNoGammaLine();
    void stepRelative_addsToTheStepOnly();
    void sideWall_usesTheIncidentStep();
    void counters_enterTheBudget();
    void coverage_ofVelocityAndStep_data();
    void coverage_ofVelocityAndStep();
};

void TestShockUncertainty::sensitivities_thesisPoint_asPrinted_data()
{
    QTest::addColumn<QString>("quantity");
    QTest::addColumn<QList<double>>("expected"); // p2, p5, step
    QTest::addRow("W") << "velocity_m_s" << QList<double>{2.13798, 3.77513, 4.65354};
    QTest::addRow("T1") << "t1_k" << QList<double>{-1.06899, -1.88757, -2.32677};
    QTest::addRow("p1") << "p1_pa" << QList<double>{1.0, 1.0, 1.0};
    QTest::addRow("gamma") << "gamma" << QList<double>{-0.82429, -1.68436, -2.07628};
    QTest::addRow("molar mass") << "molar_mass_kg_mol" << QList<double>{1.06899, 1.88757, 2.32677};
}

void TestShockUncertainty::sensitivities_thesisPoint_asPrinted()
{
    constexpr double kRequired = 1e-4;
    QFETCH(QString, quantity);
    QFETCH(QList<double>, expected);
    StepMeasurement m = thesisShot();
    m.u_p1_Pa = 1.0;
    m.u_T1_K = 0.003;
    const auto found = evaluateStep(m,
        request({{"velocity_m_s", 0.005, Distribution::Normal, {}},
            {"gamma", 1e-5, Distribution::Normal, {}},
            {"molar_mass_kg_mol", 3e-7, Distribution::Normal, {}}}));
    QVERIFY(found.has_value());
    const BudgetLine &line = lineOf(found->budget, quantity.toStdString().c_str());
    const StepResult results[] = {StepResult::P2, StepResult::P5, StepResult::Step};
    for (qsizetype i = 0; i < 3; ++i) {
        const auto r = static_cast<Index>(results[i]);
        const double relative = line.sensitivity[r] * line.input.value / found->budget.value[r];
        qInfo("%s, result %td: %.5f (oracle %.5f)", qPrintable(quantity), r, relative, expected[i]);
        QVERIFY(std::abs(relative - expected[i]) < kRequired);
    }
}

void TestShockUncertainty::exampleBudget_gumAndMonteCarlo_asPrinted()
{
    const auto found = evaluateStep(exampleShot(), request()).value();
    const StepMonteCarlo simulated = drawn(exampleShot(), 20000);
    const double gum = 100.0 * found.budget.u[kStep] / found.budget.value[kStep];
    const double monteCarlo = 100.0 * simulated.result.u[kStep] / simulated.result.mean[kStep];
    qInfo("GUM %.4f %% (oracle 0.4143), Monte Carlo of 20000 %.4f %% (0.4141)", gum, monteCarlo);
    QVERIFY(std::abs(gum - 0.4143) < 6e-5);
    QVERIFY(std::abs(monteCarlo - 0.4141) < 4.0 * 0.4141 / std::sqrt(2.0 * 20000.0));
    QVERIFY(simulated.validated);
    QVERIFY(!found.stepMissing && !found.velocityMissing);
    QVERIFY(std::abs(*found.u(StepResult::Velocity) - 0.3529) < 1e-3); // 0.0688 %
}

void TestShockUncertainty::exampleBudget_millionTrials_asPrinted()
{
    const MonteCarloResult mc = drawn(exampleShot(), 1000000).result;
    const double relative = 100.0 * mc.u[kStep] / mc.mean[kStep];
    qInfo(
        "Monte Carlo of 1e6: %.4f %% (oracle 0.4141), mean %.0f Pa (434 499), 95 %% [%.0f, %.0f] ([430 982, 438 032])",
        relative, mc.mean[kStep], mc.low[kStep], mc.high[kStep]);
    // Both draw a million: 0.0003 % on u, 2.5 Pa on the mean, some 8 Pa on the ends; four sigma of
    // the difference of two such runs.
    QVERIFY(std::abs(relative - 0.4141) < 0.0017);
    QVERIFY(std::abs(mc.mean[kStep] - 434499.0) < 11.0);
    QVERIFY(std::abs(mc.low[kStep] - 430982.0) < 30.0);
    QVERIFY(std::abs(mc.high[kStep] - 438032.0) < 30.0);
}

void TestShockUncertainty::exampleBudget_linesMatchTable()
{
    const auto found = evaluateStep(exampleShot(), request()).value();
    const std::pair<const char *, double> table[]
        = {{"distance_m[side]", 0.116}, {"arrival_s[side]", 0.298}, {"t1_k", 0.237},
            {"p1_pa", 0.030}, {"gamma", 0.074}, {"molar_mass_kg_mol", 0.080}};
    double squares = 0.0;
    for (const auto &[quantity, percent] : table) {
        const BudgetLine &line = lineOf(found.budget, quantity);
        const double share = 100.0 * std::abs(line.contribution[kStep]) / found.budget.value[kStep];
        QVERIFY2(std::abs(share - percent) < 6e-4,
            qPrintable(QString("%1: %2").arg(quantity).arg(share)));
        squares += share * share;
    }
    QVERIFY(std::abs(std::sqrt(squares) - 0.4143) < 1e-4); // nothing else counts
}

void TestShockUncertainty::stated_winsOverRecorded()
{
    const auto found = evaluateStep(exampleShot(),
        request({{"t1_k", 0.6, Distribution::Rectangular, 8.0},
            {"gamma", 0.0, Distribution::Normal,
                {}}})).value();
    const BudgetLine &line = lineOf(found.budget, "t1_k");
    QCOMPARE(line.input.u, 0.6);
    QCOMPARE(line.input.distribution, Distribution::Rectangular);
    QCOMPARE(line.input.dof, 8.0);
    QVERIFY(std::isfinite(found.budget.dof[kStep]));
    for (const BudgetLine &other : found.budget.lines)
        QVERIFY(other.input.quantity != "gamma"); // stated as exact
}

void TestShockUncertainty::notStated_isMissingWithReason()
{
    StepMeasurement m = exampleShot();
    m.u_T1_K = std::nan("");
    const auto noT1 = evaluateStep(m, request()).value();
    QVERIFY(noT1.u(StepResult::Velocity).has_value());
    QVERIFY(!noT1.u(StepResult::Step).has_value());
    QVERIFY(english(*noT1.stepMissing).find("'t1_k'") != std::string::npos);
    const auto noVelocity = evaluateStep(thesisShot(), request()).value();
    QVERIFY(!noVelocity.u(StepResult::Velocity).has_value());
    QVERIFY(english(*noVelocity.velocityMissing).find("'velocity_m_s'") != std::string::npos);
    StepMeasurement noPlace = measuredShot(0.0, 1e-6);
    QVERIFY(!evaluateStep(noPlace, request())->u(StepResult::Velocity).has_value());
    QVERIFY(evaluateStep(noPlace, request({{"distance_m", 1e-4, Distribution::Normal, {}}}))
                ->u(StepResult::Velocity)
                .has_value());
}

void TestShockUncertainty::scatter_isOneLineWithStudentsDof()
{
    StepMeasurement m = exampleShot();
    Sighting middle = m.velocity.sightings[0];
    middle.channel = "middle";
    middle.distance_m = 0.4;
    middle.time_s = 0.4 / kVelocity_m_s + 1e-6;
    m.velocity.sightings.insert(m.velocity.sightings.begin() + 1, middle);
    for (Sighting &s : m.velocity.sightings)
        s.u_distance_m = 0.0;
    m.velocity.fit = fitVelocity(m.velocity.sightings, Attenuation::None).value();
    m.velocity.velocity_m_s = m.velocity.fit->velocity_m_s;
    const auto found = evaluateStep(m, request()).value();
    const BudgetLine &line = lineOf(found.budget, "velocity_scatter");
    QCOMPARE(line.input.dof, 1.0);
    QVERIFY(!line.input.common);
    const double k = coverageFactor(found.budget.dof[0], 0.95);
    QVERIFY(std::abs(k - 12.7062) < 1e-3);
}

void TestShockUncertainty::commonTerms_makeShotsCorrelated()
{
    const GumBudget one = evaluateStep(exampleShot(), request())->budget;
    const double common = commonCovariance(one, one, kStep);
    const double own = std::pow(lineOf(one, "arrival_s[side]").contribution[kStep], 2)
        + std::pow(lineOf(one, "arrival_s[DUT]").contribution[kStep], 2);
    QVERIFY(std::abs(common + own - one.u[kStep] * one.u[kStep]) < 1e-6 * common);
    QVERIFY(common > 0.4 * one.u[kStep] * one.u[kStep]); // T1, place, gas: not averaged away
}

void TestShockUncertainty::humidAir_sensitivityToHumidity()
{
    StepMeasurement m = thesisShot();
    m.gas.substance = "humid-air";
    m.state.relativeHumidity = 0.5;
    m.state.carbonDioxide = 4e-4;
    m.u_p1_Pa = 30.0;
    m.u_T1_K = 0.3;
    const auto found = evaluateStep(m,
        request({{"velocity_m_s", 0.3, Distribution::Normal, {}},
            {"relative_humidity", 0.05, Distribution::Normal,
                {}}})).value();
    const BudgetLine &line = lineOf(found.budget, "relative_humidity");
    // metrology.md: -0.45 % of the step per 25 % of humidity (gamma kept; Cramer's moves it a
    // little).
    const double perQuarter = 100.0 * 0.25 * line.sensitivity[kStep] / found.budget.value[kStep];
    QVERIFY2(std::abs(perQuarter + 0.45) < 0.03, qPrintable(QString::number(perQuarter)));
    QVERIFY(found.u(StepResult::Step).has_value());
    QVERIFY(!evaluateStep(m, request({{"velocity_m_s", 0.3, Distribution::Normal, {}}}))
                 ->u(StepResult::Step)
                 .has_value());
}

void TestShockUncertainty::variableHeatCapacity_hasNoGammaLine()
{
    StepMeasurement m = exampleShot();
    m.gas.heatCapacity = kVariableHeatCapacity;
    const auto found = evaluateStep(m, request()).value();
    for (const BudgetLine &line : found.budget.lines)
        QVERIFY(line.input.quantity != "gamma");
    QVERIFY(found.u(StepResult::Step).has_value());
}

void TestShockUncertainty::stepRelative_addsToTheStepOnly()
{
    const auto found = evaluateStep(exampleShot(),
        request({{"step_relative", 0.003, Distribution::Normal,
            {}}})).value();
    QVERIFY(std::abs(
                100.0 * found.budget.u[kStep] / found.budget.value[kStep] - std::hypot(0.4143, 0.3))
        < 1e-4);
    QCOMPARE(lineOf(found.budget, "step_relative").contribution[0], 0.0);
}

void TestShockUncertainty::sideWall_usesTheIncidentStep()
{
    StepMeasurement m = exampleShot();
    m.atEndWall = false;
    const auto found = evaluateStep(m, request()).value();
    QVERIFY(std::abs(found.budget.value[kStep] - (245253.880 - 101100.0)) < 2e-2);
    QVERIFY(found.budget.value[static_cast<Index>(StepResult::P5)] > 5e5);
}

void TestShockUncertainty::counters_enterTheBudget()
{
    StepMeasurement m = thesisShot();
    m.u_p1_Pa = 30.0;
    m.u_T1_K = 0.3;
    m.counters = {{0.9, 0.5, 0.4 / 512.8, 2e-4, 1e-7}, {0.5, 0.1, 0.4 / 512.8, 2e-4, 1e-7}};
    m.velocity.fit = fitCounters(m.counters, Attenuation::None).value();
    m.velocity.velocity_m_s = m.velocity.fit->velocity_m_s;
    const auto found = evaluateStep(m, request()).value();
    const double each = std::hypot(2e-4 / 0.4, 1e-7 / (0.4 / 512.8));
    QVERIFY(std::abs(*found.u(StepResult::Velocity) / 512.8 - each / std::sqrt(2.0)) < 1e-8);
}

// The figure itself scatters by 1 % in 500 runs. Truths drawn from the prior must be held in 95 %
// of runs. One fixed attenuation near the middle of its prior is held more often, because the
// interval also has room for those at its ends: by linear theory in 99.8 % of runs at 0.2 %/m where
// unknown delays of 0 to 2.6 us hide the curvature, in 98.2 % where there are none.
void TestShockUncertainty::coverage_ofVelocityAndStep_data()
{
    QTest::addColumn<CoverageCase>("which");
    QTest::addColumn<double>("least");
    QTest::addColumn<double>("most");
    QTest::addColumn<bool>("unbiased");
    const std::vector<double> three{0.8, 0.5, 0.2, 0.0};
    constexpr double kRise_s = 3e-6;
    const auto row
        = [](const char *name, const CoverageCase &which, double least, double most,
              bool unbiased) { QTest::newRow(name) << which << least << most << unbiased; };
    row("one sensor", {{0.8, 0.0}, true, {}, kRise_s}, 93.0, 100.0, false);
    row("three sensors", {three, true, {}}, 92.0, 98.0, true);
    row("three sensors, 0 %/m", {three, true, 0.0}, 92.0, 99.5, false);
    row("three sensors, 0.2 %/m", {three, true, 0.002}, 92.0, 99.5, false);
    row("three sensors, 0.4 %/m", {three, true, 0.004}, 92.0, 99.5, false);
    row("three sensors, 0.8 %/m", {three, true, 0.008}, 92.0, 99.5, false);
    row("late sensors", {three, true, {}, kRise_s}, 92.0, 98.0, true);
    row("late sensors, 0 %/m", {three, true, 0.0, kRise_s}, 92.0, 100.0, false);
    row("late sensors, 0.2 %/m", {three, true, 0.002, kRise_s}, 92.0, 100.0, false);
    row("late sensors, 0.4 %/m", {three, true, 0.004, kRise_s}, 92.0, 100.0, false);
    row("late sensors, 0.8 %/m", {three, true, 0.008, kRise_s}, 92.0, 100.0, false);
    // Only the rectangle of the attenuation is left: 1.96 standard deviations hold all of it.
    row("two sensors, DUT elsewhere", {{0.9, 0.1}, true, {}}, 93.0, 100.0, true);
    row("three sensors, DUT elsewhere", {{0.9, 0.5, 0.1}, true, {}}, 93.0, 97.0, true);
    row("five sensors, scatter estimated", {{0.9, 0.7, 0.5, 0.3, 0.1}, false, {}}, 92.0, 98.0,
        true);
}

void TestShockUncertainty::coverage_ofVelocityAndStep()
{
    QFETCH(CoverageCase, which);
    QFETCH(double, least);
    QFETCH(double, most);
    QFETCH(bool, unbiased);
    const StepCoverage c = stepCoverage(which, 500);
    for (const Coverage &found : {c.velocity, c.step}) {
        const QString text = QString("%1 %, mean z %2").arg(found.percent()).arg(found.meanZ());
        qInfo("%s: %s", QTest::currentDataTag(), qPrintable(text));
        QCOMPARE(found.runs, Index(500));
        QVERIFY2(found.percent() >= least && found.percent() <= most, qPrintable(text));
        QVERIFY2(!unbiased || std::abs(found.meanZ()) < 0.15, qPrintable(text));
    }
}

DYNCAL_TEST(TestShockUncertainty)
#include "tst_shock_uncertainty.moc"
