// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The pressure steps that a reference transducer saw.

#include "core/model_analysis/transducer_steps.h"
#include "core/signal/window_cutting.h"
#include "tests/support/near.h"
#include "tests/support/reference_capture.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::isNear;

class TestTransducerSteps : public QObject
{
    Q_OBJECT

private:
    std::optional<ReferenceRecords> m_reference;

    const GumBudget &budgetOf(const ShockConditionsSet &steps, std::size_t shot) const
    {
        return steps.shots[shot].uncertainty->budget;
    }

private slots:
    void initTestCase()
    {
        const auto set = testing::referenceCapture();
        const auto duts = cutWindows(*set, {}, {}).value().responses;
        m_reference = referenceRecords(*set, duts, testing::referenceComparison(), {}).value();
    }

    void step_isTheLevelOverTheSensitivity()
    {
        const ShockConditionsSet steps = stepsByTransducer(*m_reference, {}, {});
        QCOMPARE(steps.shots.size(), std::size_t(3));
        for (std::size_t i = 0; i < 3; ++i) {
            const WindowedResponse &response = m_reference->responses[i];
            QVERIFY(isNear(*steps.shots[i].step_Pa,
                std::abs(response.step) / testing::referenceTruth().sensitivity, 1e-12));
            QCOMPARE(steps.shots[i].shot, response.shot);
        }
        QVERIFY(*steps.shots[0].step_Pa < *steps.shots[2].step_Pa);
    }

    void uncertainty_isOfCertificateChainAndLevel()
    {
        const ShockConditionsSet steps = stepsByTransducer(*m_reference, {}, {});
        const auto step = static_cast<Index>(StepResult::Step);
        for (std::size_t i = 0; i < 3; ++i) {
            const GumBudget &budget = budgetOf(steps, i);
            QCOMPARE(budget.lines.size(), std::size_t(3));
            const double value = *steps.shots[i].step_Pa;
            QVERIFY(isNear(std::abs(budget.lines[0].contribution[step]), 0.003 * value, 1e-4));
            QVERIFY(isNear(std::abs(budget.lines[1].contribution[step]),
                0.005 / std::sqrt(3.0) * value, 1e-4));
            QVERIFY(budget.lines[0].input.common && budget.lines[1].input.common);
            QVERIFY(!budget.lines[2].input.common);
            QVERIFY(budget.lines[2].input.u > 0.0 && budget.lines[2].input.u < 1e-3);
            QVERIFY(isNear(*steps.shots[i].uncertainty->u(StepResult::Step), budget.u[step]));
        }
    }

    /// A table that begins at 60 kHz, a seventh of the transducer's resonance: the step is off by
    /// what the sensitivity has changed from 0 to there, and u knows it.
    void calibrationThatBeginsAboveTheLevel_isInTheU()
    {
        ReferenceRecords records = *m_reference;
        const auto model
            = ReferenceSensitivity::fromModel({2e-8, 6e-11, 450e3, 1e3, 0.2, 0.002}).value();
        const auto stepsFrom = [&](std::vector<double> frequencies_Hz) {
            std::vector<ReferencePoint> rows;
            for (const double f_Hz : frequencies_Hz)
                rows.push_back(model.at(f_Hz).value());
            records.sensitivity = ReferenceSensitivity::fromTable(rows).value();
            return stepsByTransducer(records, {}, {});
        };
        const ShockConditionsSet whole = stepsFrom({100.0, 60e3, 120e3});
        const ShockConditionsSet above = stepsFrom({60e3, 120e3});
        const double off = std::abs(*above.shots[0].step_Pa / *whole.shots[0].step_Pa - 1.0);
        const double u_whole = budgetOf(whole, 0).lines[0].input.u;
        const double u_above = budgetOf(above, 0).lines[0].input.u;
        QVERIFY(off > 3.0 * u_whole);
        QVERIFY2(off < u_above && u_above < 2.0 * off,
            qPrintable(QString("off by %1, u %2").arg(off).arg(u_above)));
        QVERIFY(!stepsFrom({60e3}).shots[0].uncertainty);
        QVERIFY(stepsFrom({100.0}).shots[0].uncertainty);
    }

    void statedChain_wins()
    {
        const ShockConditionsSet steps = stepsByTransducer(
            *m_reference, {}, {{kReferenceGain, 1e-4, Distribution::Normal, 7.0}});
        const UncertainInput &gain = budgetOf(steps, 0).lines[1].input;
        QCOMPARE(gain.u, 1e-4);
        QCOMPARE(gain.dof, 7.0);
        QVERIFY(gain.distribution == Distribution::Normal);
    }

    void whatElseIsKnown_isKept()
    {
        ShockConditionsSet shock;
        shock.shots.emplace_back();
        shock.shots.back().shot = 2;
        shock.shots.back().step_Pa = 1.0;
        shock.shots.back().plateau_s = 0.002;
        const ShockConditionsSet steps = stepsByTransducer(*m_reference, shock, {});
        QCOMPARE(steps.ofShot(2)->plateau_s.value(), 0.002);
        QVERIFY(*steps.ofShot(2)->step_Pa > 1.0);
    }
};

DYNCAL_TEST(TestTransducerSteps)
#include "tst_transducer_steps.moc"
