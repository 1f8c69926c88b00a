// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The budget of a whole calibration, end to end: complete or absent, and its lines make its u.

#include "core/pipeline/pipeline.h"
#include "tests/support/near.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::isNear;

namespace {

const Finding *findingOf(const CalibrationResults &results, const std::string &id)
{
    const auto &all = results.uncertainty->findings;
    const auto found = std::ranges::find(all, id, &Finding::id);
    return found == all.end() ? nullptr : &*found;
}

} // namespace

class TestUncertaintyReport : public QObject
{
    Q_OBJECT

private:
    std::shared_ptr<const CaptureSet> m_set;

    CalibrationResults run(const Recipe &recipe, StageId last = StageId::Uncertainty) const
    {
        ResultCache cache;
        return runPipeline(m_set, recipe, cache, last).results;
    }

private slots:
    void initTestCase() { m_set = testing::simulatedExample(2e7); }

    void everythingStated_hasAU_madeOfItsLines()
    {
        const CalibrationResults results = run({});
        const UncertaintyReport &report = *results.uncertainty;
        QVERIFY(report.sensitivity && report.sensitivity->u);
        QVERIFY(report.rows.isComplete());
        QVERIFY(isNear(combined(report.sensitivity->lines).u, *report.sensitivity->u));
        QVERIFY(report.ofModel.size() >= 9);
        for (const ReportedValue &one : report.ofModel) {
            QVERIFY2(one.u && *one.u > 0.0, one.of.c_str());
            double shares = 0.0;
            for (const UncertaintyLine &line : one.lines)
                shares += one.sharePercent(line);
            QVERIFY(isNear(shares, 100.0));
        }
        for (Index row = 0; row < report.rows.u_magnitude.size(); ++row)
            if (std::isfinite(results.response->magnitude[row])) {
                QVERIFY(report.rows.u_magnitude[row]
                    > results.response->magnitude[row] * report.rows.u_common_relative);
                QVERIFY(std::abs(report.rows.e_n[row]) < 1.5);
            }
    }

    /// The sensitivity's own is the summary's and the chain's.
    void chain_joinsStepAndLevel()
    {
        const CalibrationResults results = run({});
        const UncertaintyReport &report = *results.uncertainty;
        const SensitivityMean &mean = *results.response->summary.mean;
        const double chain = combined(report.chain.ofSensitivity).u * mean.value;
        QVERIFY(isNear(*report.sensitivity->u, std::hypot(*mean.u, chain)));
        for (std::size_t i = 0; i < 3; ++i) {
            const ShotSensitivity &shot = results.response->shots[i];
            QVERIFY(isNear(uOfShot(&report, i),
                std::hypot(*shot.u, combined(report.chain.ofSensitivity).u * *shot.sensitivity)));
        }
        QCOMPARE(uOfSensitivity(&report), *report.sensitivity->u);
        QCOMPARE(uOf(&report, "f0_hz"), *report.find("f0_hz")->u);
        QVERIFY(std::isnan(uOfSensitivity(nullptr)) && std::isnan(uOfShot(nullptr, 0))
            && std::isnan(uOf(&report, "nothing")));
    }

    /// Of a level of one shot, mean and shot are the same value.
    void shot_hasTheDegreesOfFreedom_ofItsCompleteU()
    {
        Recipe recipe;
        recipe.uncertainty.budget = {{"t1_k", 3.0, "normal", 2.0}};
        const CalibrationResults results = run(recipe);
        const UncertaintyReport &report = *results.uncertainty;
        QCOMPARE(report.perLevel.size(), 3);
        for (std::size_t i = 0; i < 3; ++i) {
            const double ofStep = results.response->shots[i].k;
            QVERIFY(ofStep > 2.1 && kOfShot(&report, i) < 0.999 * ofStep);
            QVERIFY(isNear(kOfShot(&report, i), report.perLevel[i].k));
            QVERIFY(isNear(uOfShot(&report, i), *report.perLevel[i].u));
        }
        QVERIFY(std::isnan(kOfShot(&report, 3)) && std::isnan(kOfShot(nullptr, 0)));
    }

    void statedGain_isThatLine()
    {
        Recipe recipe;
        recipe.uncertainty.budget = {{"gain_relative", 0.05, "normal", {}}};
        const CalibrationResults results = run(recipe);
        QVERIFY(
            *results.uncertainty->sensitivity->u > 0.05 * results.uncertainty->sensitivity->value);
        const Finding *dominant = findingOf(results, "UNC-002");
        QVERIFY(dominant);
        QVERIFY(english(dominant->message).find("one source, gain of the measuring chain:")
            != std::string::npos);
        QVERIFY(!findingOf(results, "UNC-001"));
    }

    void withoutADominantLine_nothingIsSaid()
    {
        Recipe recipe;
        for (const char *quantity : {"gain_relative", "mounting_relative", "linearity_relative"})
            recipe.uncertainty.budget.push_back({quantity, 0.05, "normal", {}});
        QVERIFY(!findingOf(run(recipe), "UNC-002"));
    }

    void stepOfUnknownUncertainty_leavesTheSensitivityWithoutOne()
    {
        Recipe recipe;
        recipe.shock.step_Pa = 4e5;
        const CalibrationResults results = run(recipe);
        const UncertaintyReport &report = *results.uncertainty;
        QVERIFY(results.response->sensitivity);
        QVERIFY(report.sensitivity && !report.sensitivity->u);
        QVERIFY(!report.rows.isComplete() && report.rows.u_magnitude.array().isNaN().all());
        QVERIFY(report.find("f0_hz")->u.has_value()); // needs no step
        QVERIFY(std::isfinite(report.rows.u_phase_rad[0]));
        const Finding *missing = findingOf(results, "UNC-001");
        QVERIFY(missing && missing->severity == Severity::Caution);
        recipe.uncertainty.budget = {{"step_relative", 0.005, "normal", {}}};
        QVERIFY(!findingOf(run(recipe), "UNC-001"));
    }

    void unitStep_needsNoPressure()
    {
        Recipe recipe;
        recipe.response.reference = "unit-step";
        const CalibrationResults results = run(recipe);
        QCOMPARE(results.response->unit, std::string("1"));
        const UncertaintyReport &report = *results.uncertainty;
        QVERIFY(report.rows.isComplete());
        QVERIFY(report.rows.u_common_relative < 1e-3); // the noise of the levels
        QVERIFY(!findingOf(results, "UNC-001"));
    }

    /// The noise of a level needs no pressure: the same u whether the shock is evaluated or not.
    void unitStep_isTheSameWithoutAShock()
    {
        Recipe recipe;
        recipe.response.reference = "unit-step";
        const CalibrationResults with = run(recipe);
        recipe.shock.enabled = false;
        const CalibrationResults without = run(recipe);
        QCOMPARE(without.response->unit, std::string("1"));
        QVERIFY(!without.response->sensitivity && !without.response->shots[0].step_Pa);
        QVERIFY(without.uncertainty->rows.isComplete());
        QCOMPARE(without.uncertainty->rows.u_magnitude, with.uncertainty->rows.u_magnitude);
        QCOMPARE(
            without.uncertainty->rows.u_common_relative, with.uncertainty->rows.u_common_relative);
        QVERIFY(!findingOf(without, "UNC-001"));
    }

    /// These steps are none, and not refined as one: what there is of a resonance has no u.
    void freeDecay_hasItsFrequencies()
    {
        Recipe recipe;
        recipe.input.treatment = ResponseTreatment::Impulse;
        const CalibrationResults results = run(recipe);
        QVERIFY(results.uncertainty);
        QVERIFY(!results.uncertainty->sensitivity);
        const auto assessed = sensorResonance(results.model.get(), results.assessment.get());
        QVERIFY(assessed);
        QCOMPARE(std::isfinite(uOf(results.uncertainty.get(), "f0_hz")),
            std::isfinite(assessed->u_frequency_Hz));
        QVERIFY(!results.uncertainty->find("resonance_hz"));
        const Finding *missing = findingOf(results, "UNC-001");
        QCOMPARE(missing == nullptr, std::isfinite(assessed->u_frequency_Hz));
        QVERIFY(missing && missing->severity == Severity::Caution);
    }
};

DYNCAL_TEST(TestUncertaintyReport)
#include "tst_uncertainty_report.moc"
