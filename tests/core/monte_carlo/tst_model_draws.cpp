// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Values of a model whose parameters are drawn: closed forms of second-order sensors.

#include "core/monte_carlo/coverage_interval.h"
#include "core/monte_carlo/model_draws.h"
#include "core/uncertainty/model_values.h"
#include "tests/support/damped_shots.h"
#include "tests/support/near.h"
#include "tests/support/realized_model.h"
#include "tests/support/stated_chain.h"
#include "tests/support/test_program.h"
#include "tests/support/wide_response.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr double kF0_Hz = 318e3;

struct Fitted
{
    ModelInput input;
    SensorModel model;
    ModelAssessment assessment;
    ResponseResult response;
    ShockConditionsSet shock;
    UncertaintyReport report;
    std::vector<StatedUncertainty> stated;
    ChainInputs inputs;

    explicit Fitted(double zeta, double noise = 0.005)
        : input(testing::dampedShots(kF0_Hz, zeta, 1, {noise}))
    {
        const auto hankel = decomposeHankel(input, {});
        const auto made = testing::realizeModel(input, *hankel, 2);
        model = made->model;
        assessment = made->assessment;
        response = testing::wideOpen(model);
        response.front.u_s = 1e-15; // stated to be sharp
        report.chain = testing::statedChain();
    }

    ChainSubject subject() const
    {
        return {input, model, assessment, response, shock, report, stated};
    }

    std::vector<ReportedValue> reported() const
    {
        return modelValues(model, assessment, response, modelVariations(input, model),
            input.treatment, report.chain);
    }

    std::vector<CharacteristicValues> draw(Index trials) const
    {
        const ChainSubject all = subject();
        const ChainInputs made = chainInputs(all);
        const ModelDraws draws(all, made);
        std::vector<CharacteristicValues> values;
        for (Index i = 0; i < trials; ++i)
            values.push_back(draws.values(1, i, made.sources.probabilities(1, i)));
        return values;
    }
};

DrawnQuantity drawn(const std::vector<CharacteristicValues> &values,
    double CharacteristicValues::*member, double reported)
{
    Eigen::VectorXd list(std::ssize(values));
    for (std::size_t i = 0; i < values.size(); ++i)
        list[static_cast<Index>(i)] = values[i].*member;
    return drawnQuantity(list, reported, 0.95);
}

} // namespace

class TestModelDraws : public QObject
{
    Q_OBJECT

private slots:
    /// Where noise is small the scatter of every value is its linear u.
    void scatter_isTheLinearU_data()
    {
        QTest::addColumn<double>("zeta");
        for (const double zeta : {0.05, 0.2, 0.5})
            QTest::addRow("%g", zeta) << zeta;
    }
    void scatter_isTheLinearU()
    {
        QFETCH(double, zeta);
        const Fitted fitted(zeta);
        const auto reported = fitted.reported();
        const auto values = fitted.draw(1500);
        for (const Characteristic &one : kCharacteristics) {
            const auto found = std::ranges::find(reported, std::string(one.of), &ReportedValue::of);
            if (found == reported.end())
                continue;
            const DrawnQuantity by = drawn(values, one.value, found->value);
            const double u = found->lines[0].u; // of the noise
            qInfo("%s: %.3f of u", one.of, by.u / u);
            if (zeta == 0.05 && one.value == &CharacteristicValues::settlingTime_s) {
                QVERIFY(by.u > 2.0 * u); // it jumps by half periods, which no slope shows
                continue;
            }
            QVERIFY2(isNear(by.u, u, 0.08), one.of);
            QVERIFY2(std::abs(by.mean - found->value) < 0.15 * u, one.of);
        }
    }

    /// f0 and damping of one trial make the resonance of that trial.
    void valuesOfOneTrial_areOneSensors()
    {
        const Fitted fitted(0.2);
        for (const CharacteristicValues &one : fitted.draw(20)) {
            const double zeta = one.zeta;
            QVERIFY(isNear(one.q, 0.5 / zeta));
            QVERIFY(isNear(one.resonance_Hz, one.f0_Hz * std::sqrt(1.0 - 2.0 * zeta * zeta), 5e-3));
            QVERIFY(isNear(one.resonanceGain, 0.5 / (zeta * std::sqrt(1.0 - zeta * zeta)), 0.02));
        }
    }

    void clock_turnsFrequenciesAndTimes()
    {
        Fitted fitted(0.2, 1e-6);
        fitted.report.chain = testing::statedChain(1e-3);
        const auto values = fitted.draw(1500);
        const StepCharacteristics &found = fitted.response.characteristics;
        QVERIFY(isNear(drawn(values, &CharacteristicValues::f0_Hz, kF0_Hz).u, 1e-3 * kF0_Hz, 0.08));
        QVERIFY(isNear(drawn(values, &CharacteristicValues::riseTime_s, *found.riseTime_s).u,
            1e-3 * *found.riseTime_s, 0.08));
        QVERIFY(drawn(values, &CharacteristicValues::overshoot_percent, 0.0).u < 1e-3);
        for (const CharacteristicValues &one : values) // one clock for both
            QVERIFY(isNear(one.f0_Hz * one.riseTime_s, kF0_Hz * *found.riseTime_s, 1e-4));
    }

    /// A front of T takes (w0 T)^2/24 off the ringing: the resonance is as much higher.
    void unknownFront_raisesTheResonance()
    {
        Fitted fitted(0.02, 1e-6);
        fitted.response.front = {};
        const auto values = fitted.draw(1000);
        const double most = std::pow(kTwoPi * kF0_Hz * 100e-9, 2) / 24.0;
        const DrawnQuantity gain = drawn(values, &CharacteristicValues::resonanceGain, 25.0);
        QVERIFY(isNear(gain.low / 25.005 - 1.0, most * 0.025 * 0.025, 1.0));
        QVERIFY(isNear(gain.high / 25.005 - 1.0, most * 0.975 * 0.975, 0.05));
    }

    /// What is drawn of the mounting is what the budget has of it, in every value.
    void mounting_changesTheShape()
    {
        Fitted fitted(0.2, 1e-6);
        fitted.report.chain = testing::statedChain(0.0, 1e-3);
        const auto reported = fitted.reported();
        const auto values = fitted.draw(1500);
        for (const Characteristic &one : kCharacteristics) {
            const auto found = std::ranges::find(reported, std::string(one.of), &ReportedValue::of);
            if (found == reported.end() || one.value == &CharacteristicValues::settlingTime_s)
                continue;
            const double u = drawn(values, one.value, found->value).u;
            qInfo("%s: %.3f of u", one.of, u / *found->u);
            QVERIFY2(isNear(u, *found->u, 0.08), one.of);
        }
    }

    void noise_alone_hasNoneOfTheOthers()
    {
        Fitted fitted(0.2, 1e-6);
        fitted.report.chain = testing::statedChain(0.1, 0.1);
        fitted.response.front = {};
        const ChainSubject subject = fitted.subject();
        const ChainInputs inputs = chainInputs(subject);
        const ModelDraws draws(subject, inputs);
        for (Index i = 0; i < 20; ++i)
            QVERIFY(isNear(draws.valuesByNoise(1, i).f0_Hz, kF0_Hz, 1e-4));
    }

    /// Shots that disagree: f0 scatters as they do, with few degrees of freedom.
    void scatterOfShots_widensEachByItsOwn()
    {
        Fitted fitted(0.2);
        const double u_f0 = fitted.assessment.poles[0].u_frequency_Hz;
        const double u_zeta = fitted.assessment.poles[0].u_dampingRatio;
        fitted.assessment.homogeneity = Homogeneity{kF0_Hz, 100.0, 4.0, 1e-9, false};
        if (fitted.assessment.secondOrder) {
            fitted.assessment.secondOrder->u_f0_Hz = 8.0 * u_f0;
            fitted.assessment.secondOrder->u_zeta = 3.0 * u_zeta;
        }
        for (Pole &pole : fitted.assessment.poles) {
            pole.u_frequency_Hz = 8.0 * u_f0;
            pole.u_dampingRatio = 3.0 * u_zeta;
        }
        const auto values = fitted.draw(3000);
        const double k = coverageFactor(2.0, 0.95); // three shots
        const auto U = [&](double CharacteristicValues::*member, double fittedValue) {
            return drawn(values, member, fittedValue).expanded / k;
        };
        const auto resonance = sensorResonance(&fitted.model, &fitted.assessment);
        QVERIFY(isNear(U(&CharacteristicValues::f0_Hz, resonance->frequency_Hz), 8.0 * u_f0, 0.12));
        QVERIFY(
            isNear(U(&CharacteristicValues::zeta, resonance->dampingRatio), 3.0 * u_zeta, 0.12));
    }

    void modelWithoutRefinement_cannotBeDrawn()
    {
        Fitted fitted(0.2);
        QVERIFY(ModelDraws::canDraw(fitted.subject()));
        fitted.model.diverges = true;
        QVERIFY(!ModelDraws::canDraw(fitted.subject()));
        fitted.model.diverges = false;
        fitted.input.treatment = ResponseTreatment::Impulse;
        QVERIFY(!ModelDraws::canDraw(fitted.subject()));
        fitted.input.treatment = ResponseTreatment::StepDeflated;
        fitted.model.draft.refinement.reset();
        QVERIFY(!ModelDraws::canDraw(fitted.subject()));
    }
};

DYNCAL_TEST(TestModelDraws)
#include "tst_model_draws.moc"
