// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether the second-order sensor takes the place of free poles: where the response does not ring,
// and nowhere else.

#include "core/realization/refinement/draft_fit.h"
#include "core/realization/second_order/second_order_choice.h"
#include "tests/support/damped_shots.h"
#include "tests/support/realized_model.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QTest>

using namespace dyncal;

namespace {

constexpr double kF0_Hz = 318e3;

OrderSuggestion suggestionFor(const ModelInput &input, const HankelDecomposition &hankel)
{
    OrderSuggestion suggestion = suggestOrder(input, hankel);
    considerSecondOrder(input, hankel, suggestion);
    return suggestion;
}

testing::RealizedModel modelOf(const ModelInput &input, Index order)
{
    const auto hankel = decomposeHankel(input, {});
    return testing::realizeModel(input, *hankel, order).value();
}

bool isInside(double value, double truth, double u, double k)
{
    return std::abs(value - truth) <= k * u;
}

double lag(double rate_Hz, double t_s)
{
    return t_s > 0.0 ? 1.0 - std::exp(-2.0 * std::numbers::pi * rate_Hz * t_s) : 0.0;
}

} // namespace

class TestSecondOrderChoice : public QObject
{
    Q_OBJECT

private slots:
    void dampedSensors_areFound_data()
    {
        QTest::addColumn<double>("zeta");
        for (const double zeta : {0.9, 1.0, 1.1, 1.5})
            QTest::addRow("zeta %g", zeta) << zeta;
    }
    /// Of n runs 95 % have order 2, and 91 % each of f0 and zeta within the interval; what is asked
    /// is what 20 runs with these probabilities fail in less than 1 %.
    void dampedSensors_areFound()
    {
        QFETCH(double, zeta);
        const int runs = trials::count(20, 200);
        int two = 0, f0 = 0, damping = 0;
        for (int seed = 1; seed <= runs; ++seed) {
            const ModelInput input
                = testing::dampedShots(kF0_Hz, zeta, static_cast<std::uint64_t>(seed));
            const auto hankel = decomposeHankel(input, {});
            const OrderSuggestion suggestion = suggestionFor(input, *hankel);
            two += suggestion.order == 2;
            const auto result = testing::realizeModel(input, *hankel, 2);
            QVERIFY(result.has_value());
            const auto found = sensorResonance(&result->model, &result->assessment);
            if (!found)
                continue;
            f0 += isInside(
                found->frequency_Hz, kF0_Hz, found->u_frequency_Hz, found->coverageFactor);
            damping += isInside(
                found->dampingRatio, zeta, found->u_dampingRatio, found->coverageFactor);
        }
        qInfo("of %d: order 2 %d, f0 %d, zeta %d", runs, two, f0, damping);
        QVERIFY(two >= (runs == 20 ? 16 : 190));
        QVERIFY(f0 >= (runs == 20 ? 15 : 182));
        QVERIFY(damping >= (runs == 20 ? 15 : 182));
    }

    void noiseFree_theModelIsTheSensor()
    {
        for (const double zeta : {0.9, 0.999, 1.001, 1.1, 3.0}) {
            const ModelInput input = testing::dampedShots(kF0_Hz, zeta, 1, {0.0});
            const auto [model, assessment] = modelOf(input, 2);
            const auto found = sensorResonance(&model, &assessment);
            QVERIFY2(found.has_value(), qPrintable(QString::number(zeta)));
            QVERIFY(std::abs(found->frequency_Hz / kF0_Hz - 1.0) < 1e-6);
            QVERIFY(std::abs(found->dampingRatio / zeta - 1.0) < 1e-6);
        }
    }

    /// Two real poles and their level: amplitudes, onset and level are the sensor's.
    void itsPolesAreTheModels()
    {
        const auto [model, assessment] = modelOf(testing::dampedShots(kF0_Hz, 1.5, 7), 2);
        QVERIFY(model.secondOrder && model.secondOrder->isModel);
        QVERIFY(assessment.secondOrder && assessment.secondOrder->isModel);
        QCOMPARE(std::ssize(model.poles), Index(2));
        const double product = model.poles[0].frequency_Hz * model.poles[1].frequency_Hz;
        QVERIFY(std::abs(std::sqrt(product) / model.secondOrder->f0_Hz - 1.0) < 1e-9);
        for (std::size_t r = 0; r < 3; ++r) {
            const SeriesFit &fit = model.series[r];
            QCOMPARE(fit.onset_s, model.secondOrder->shots[r].onset_s);
            QCOMPARE(fit.u_onset_s, model.secondOrder->shots[r].u_onset_s);
            QVERIFY(std::abs(1.0 + fit.amplitudes.sum() / fit.plateauGain) < 1e-9);
            QVERIFY(std::abs(fit.plateauGain - model.secondOrder->shots[r].plateauGain) < 1e-12);
            QVERIFY(std::abs(fit.u_plateauGain / model.secondOrder->shots[r].u_plateauGain - 1.0)
                < 1e-6);
        }
        for (const Finding &finding : model.findings)
            QVERIFY2(finding.severity == Severity::Info, finding.id.c_str());
    }

    void aSensorThatRings_keepsItsFreePoles()
    {
        for (const double zeta : {0.02, 0.3, 0.6}) {
            const auto [model, assessment] = modelOf(testing::dampedShots(kF0_Hz, zeta, 3), 2);
            QVERIFY(!model.secondOrder);
            QVERIFY(assessment.secondOrder && !assessment.secondOrder->isModel); // beside it
        }
    }

    /// One pole is one pole, in white and in coloured noise: a second one must pay for itself.
    void aLag_staysOne_data()
    {
        QTest::addColumn<double>("ar1");
        QTest::newRow("white") << 0.0;
        QTest::newRow("AR(0.9)") << 0.9;
    }
    void aLag_staysOne()
    {
        QFETCH(double, ar1);
        const int runs = trials::count(20, 200);
        int one = 0;
        for (int seed = 1; seed <= runs; ++seed) {
            const ModelInput input
                = testing::dampedShots([](std::size_t, double t_s) { return lag(100e3, t_s); },
                    static_cast<std::uint64_t>(seed), {0.005, ar1});
            const auto hankel = decomposeHankel(input, {});
            one += suggestionFor(input, *hankel).order == 1;
        }
        qInfo("order 1 in %d of %d", one, runs);
        QVERIFY(one >= 37 * runs / 40);
    }

    /// A slow part that the sensor has not: a drift beside it is a third pole, one too fast for a
    /// drift is described by free poles only.
    void aSlowPart_isADriftOrWinsByFreePoles()
    {
        const auto with = [](double share, double rate_Hz) {
            return testing::dampedShots(
                [=](std::size_t, double t_s) {
                    return testing::dampedStep(kF0_Hz, 1.1, t_s) + share * lag(rate_Hz, t_s);
                },
                5, {0.001});
        };
        const auto [drifting, assessment] = modelOf(with(0.05, 3e3), 3);
        QVERIFY(drifting.secondOrder);
        QVERIFY(isInside(drifting.secondOrder->f0_Hz, kF0_Hz, drifting.secondOrder->u_f0_Hz, 3.0));
        QCOMPARE(std::ssize(drifting.poles), Index(3));
        QCOMPARE(drifting.slowPoles, std::vector<Index>{0});
        QVERIFY(!modelOf(with(0.05, 3e3), 2).model.secondOrder); // three poles were not asked for
        QVERIFY(!modelOf(with(0.2, 30e3), 3).model.secondOrder);
    }

    void nothingCompetes_withoutAPlateauOrBeyondOrder12()
    {
        ModelInput input = testing::dampedShots(kF0_Hz, 1.1, 1);
        const auto hankel = decomposeHankel(input, {});
        QVERIFY(fitModel(input, *hankel, 12, {}, {})->secondOrder.has_value());
        QVERIFY(!fitModel(input, *hankel, 13, {}, {})->secondOrder);
        QVERIFY(!fitModel(input, *hankel, 1, {}, {})->secondOrder); // one pole was asked for
        RealizationSettings unrefined;
        unrefined.refine = false;
        QVERIFY(!fitModel(input, *hankel, 2, unrefined, {})->secondOrder);
        ModelDraft draft = linearDraft(input, {std::complex<double>(0.9)});
        const auto rivals = secondOrderRivals(input, draft);
        QVERIFY(leader(rivals, 2));
        QVERIFY(!leader(rivals, 1));
        input.treatment = ResponseTreatment::Impulse;
        QVERIFY(secondOrderRivals(input, draft).empty());
        input.treatment = ResponseTreatment::StepAsImpulse;
        QVERIFY(secondOrderRivals(input, draft).empty());
    }

    /// Heat of 3 % with 0.5 ms behind a sensor of zeta 1.5: the drift is a third pole beside the
    /// sensor's two. 7 of 10 fails in less than 1 % where 91 % hold.
    void dampedSensorsBehindADrift_areFound()
    {
        constexpr double kTau_s = 0.5e-3, kShare = 0.03;
        const int runs = trials::count(10, 200);
        int three = 0, f0 = 0, level = 0;
        for (int seed = 1; seed <= runs; ++seed) {
            const ModelInput input = testing::dampedShots(
                [&](std::size_t, double t_s) {
                    // The drift is 200 times slower than the sensor: it answers to it at once.
                    return testing::dampedStep(kF0_Hz, 1.5, t_s)
                        * (1.0 - kShare * -std::expm1(-std::max(0.0, t_s) / kTau_s));
                },
                static_cast<std::uint64_t>(seed), {0.005, 0.0, 10e6, 2000});
            const auto hankel = decomposeHankel(input, {});
            const OrderSuggestion suggestion = suggestionFor(input, *hankel);
            three += suggestion.order == 3;
            const auto [model, assessment] = modelOf(input, 3);
            const auto found = sensorResonance(&model, &assessment);
            f0 += model.secondOrder && found
                && isInside(
                    found->frequency_Hz, kF0_Hz, found->u_frequency_Hz, found->coverageFactor);
            level += isInside(model.series[2].level(), 0.9, model.series[2].u_level(), 2.0);
        }
        qInfo("of %d: order 3 %d, f0 %d, level %d", runs, three, f0, level);
        QVERIFY(three >= 0.85 * runs);
        QVERIFY(f0 >= (runs == 10 ? 7 : 182));
        QVERIFY(level >= (runs == 10 ? 7 : 182));
    }

    /// zeta 3: the fast pole, 1.85 MHz, delays the response by 86 ns, which one pole alone takes
    /// for a later onset. Its u holds the true one all the same.
    void anOnsetThatASecondPoleMayMove_isUncertainByThat()
    {
        const int runs = trials::count(20, 200);
        int onset = 0, pole = 0, alone = 0;
        for (int seed = 1; seed <= runs; ++seed) {
            const auto [model, assessment]
                = modelOf(testing::dampedShots(kF0_Hz, 3.0, static_cast<std::uint64_t>(seed)), 1);
            QVERIFY(!model.secondOrder);
            QCOMPARE(std::ssize(model.draft.onsetsOfSecondPole_s), Index(3));
            RandomStream random(static_cast<std::uint64_t>(seed), 0, 16);
            const double truth_s = -random.nextUniform() / 10e6;
            const SeriesFit &fit = model.series[0];
            onset += isInside(fit.onset_s, truth_s, fit.u_onset_s, 2.0);
            alone += isInside(fit.onset_s, truth_s,
                std::sqrt(std::pow(fit.u_onset_s, 2)
                    - std::pow(fit.onset_s - model.draft.onsetsOfSecondPole_s[0], 2)),
                2.0);
            const double slow_Hz = kF0_Hz / (3.0 + std::sqrt(8.0));
            pole += isInside(
                assessment.poles[0].frequency_Hz, slow_Hz, assessment.poles[0].u_frequency_Hz, 2.0);
        }
        qInfo("of %d: onset %d (%d by noise alone), pole %d", runs, onset, alone, pole);
        QVERIFY(onset >= (runs == 20 ? 15 : 182));
        QVERIFY(pole >= (runs == 20 ? 15 : 182));
        QVERIFY(alone < onset);
    }

    void leader_ofAPoleMoreNeedsVeryStrongEvidence()
    {
        const auto rival = [](double lead, bool addsPole) {
            SecondOrderRival one{{}, lead, addsPole};
            one.fit.refinement.poles_rad_s = {-1e5, -1e6};
            return one;
        };
        const auto leads = [&](double lead, bool addsPole) {
            return leader({rival(lead, addsPole)}, 2) != nullptr;
        };
        QVERIFY(leads(0.1, false));
        QVERIFY(!leads(-0.1, false));
        QVERIFY(!leads(9.9, true));
        QVERIFY(leads(10.1, true));
        QVERIFY(!leads(-HUGE_VAL, false)); // too fast for the records
        const std::vector<SecondOrderRival> two{rival(8.0, false), rival(12.0, true)};
        QCOMPARE(leader(two, 2), &two[1]);
        QCOMPARE(leader(two, 1), nullptr);
    }

    void driftOf_isASlowPoleBesideTheOthers()
    {
        const auto draftOf = [](std::vector<std::complex<double>> poles) {
            ModelDraft draft;
            draft.series.push_back(
                {1.0, Eigen::Map<Eigen::VectorXcd>(poles.data(), std::ssize(poles)),
                    Eigen::VectorXcd::LinSpaced(std::ssize(poles), 0.1, 0.3)});
            draft.poles_rad_s = std::move(poles);
            return draft;
        };
        const auto drift = driftOf(draftOf({-1e3, {-2e4, 1e5}, {-2e4, -1e5}}));
        QVERIFY(drift.has_value());
        QCOMPARE(drift->rate_rad_s, -1e3);
        QCOMPARE(drift->amplitude, std::vector<double>{0.1});
        QVERIFY(!driftOf(draftOf({-1e3})));
        QVERIFY(!driftOf(draftOf({-1e3, -9e3})));
        QVERIFY(!driftOf(draftOf({{-1e3, 1e3}, {-1e3, -1e3}, -1e6})));
        QVERIFY(!driftOf({}));
    }

    void theReason_namesBoth()
    {
        const ModelInput input = testing::dampedShots(kF0_Hz, 1.5, 11);
        const auto hankel = decomposeHankel(input, {});
        OrderSuggestion suggestion;
        suggestion.order = 1;
        considerSecondOrder(input, *hankel, suggestion);
        QCOMPARE(suggestion.order, Index(2));
        const std::string words = english(suggestion.reason);
        QVERIFY2(words.find("than order 1") != std::string::npos, words.c_str());
        suggestion.order = 2; // nothing to suggest
        suggestion.reason = {};
        considerSecondOrder(input, *hankel, suggestion);
        QVERIFY(english(suggestion.reason).empty());
    }
};

DYNCAL_TEST(TestSecondOrderChoice)
#include "tst_second_order_choice.moc"
