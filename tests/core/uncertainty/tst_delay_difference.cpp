// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The delay between DUT and reference transducer that the phases show, against the stated one.

#include "core/uncertainty/delay_difference.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr double kUDelay_s = 1e-7;

/// Third octaves from 100 Hz to 400 kHz: a model's phase, and a measured one that is `late_s` off
/// beside noise of 0.1 % and 1 % at the ends.
UncertainResponse phases(double late_s, unsigned seed = 1)
{
    constexpr Index kRows = 37;
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal;
    UncertainResponse one;
    ResponseResult &r = one.response;
    RowUncertainty &rows = one.report.rows;
    for (auto *values : {&r.frequency_Hz, &r.magnitude, &r.u_noiseMagnitude, &r.phase_rad,
             &r.modelPhase_rad, &rows.u_phase_rad, &rows.u_modelPhase_rad})
        values->setConstant(kRows, 0.0);
    for (Index i = 0; i < kRows; ++i) {
        const double f_Hz = std::pow(10.0, 2.0 + 0.1 * static_cast<double>(i));
        const double noise = 1e-3 * std::pow(10.0, static_cast<double>(i) / kRows);
        r.frequency_Hz[i] = f_Hz;
        r.magnitude[i] = 2.0;
        r.u_noiseMagnitude[i] = 2.0 * noise;
        r.modelPhase_rad[i] = -std::atan(f_Hz / 3e5);
        r.phase_rad[i] = r.modelPhase_rad[i]
            + std::remainder(kTwoPi * f_Hz * late_s + noise * normal(engine), kTwoPi);
        rows.u_phase_rad[i] = std::hypot(noise, kTwoPi * f_Hz * kUDelay_s);
        rows.u_modelPhase_rad[i] = noise;
    }
    return one;
}

} // namespace

class TestDelayDifference : public QObject
{
    Q_OBJECT

private slots:
    /// Turns of many times 2 pi at the upper rows are followed from row to row.
    void delay_isFound()
    {
        for (const double late_s : {-5e-5, -6e-6, -3e-7, 0.0, 2e-7, 3e-6, 1e-4}) {
            const DelayDifference found = delayDifference(phases(late_s)).value();
            QVERIFY(std::abs(found.delay_s - late_s) < 2e-8);
            QVERIFY(isNear(found.u_s, kUDelay_s, 0.02)); // the stated one is nearly all
        }
    }

    void onlyBeyondItsUncertainty_itIsTold()
    {
        QVERIFY(judgeDelay({3.5e-7, kUDelay_s}, 0.0).empty());
        const Findings told = judgeDelay({-6e-6, kUDelay_s}, 3e-6);
        QCOMPARE(told.size(), std::size_t(1));
        QCOMPARE(told[0].id, std::string("CMP-005"));
        QCOMPARE(told[0].severity, Severity::Caution);
        const std::vector<std::string> words{
            "-6 \xC2\xB5s", "200 ns", "-3 \xC2\xB5s", "3 \xC2\xB5s"};
        QCOMPARE(told[0].message.arguments, words);
    }

    /// What no delay explains, as a sensor that the model does not describe, is no delay's u.
    void otherDifferences_widenIt()
    {
        UncertainResponse answer = phases(0.0);
        for (Index i = 0; i < answer.response.phase_rad.size(); ++i)
            answer.response.phase_rad[i] += i % 2 == 0 ? 0.5 : -0.5;
        const DelayDifference found = delayDifference(answer).value();
        QVERIFY(found.u_s > 1.5 * kUDelay_s);
        QVERIFY(judgeDelay(found, 0.0).empty());
    }

    void withoutPhases_nothingIsSaid()
    {
        UncertainResponse answer = phases(3e-6);
        answer.response.phase_rad.setConstant(kUnknown);
        QVERIFY(!delayDifference(answer));
        answer = phases(3e-6);
        answer.report.rows.u_phase_rad.setConstant(kUnknown);
        QVERIFY(!delayDifference(answer));
        QVERIFY(!delayDifference({}));
    }

    /// Above a quarter of its rate a model's phase is no measure.
    void onlyWhatTheModelHolds_counts()
    {
        UncertainResponse answer = phases(0.0);
        answer.response.modelLimit_Hz = 1e5;
        for (Index i = 0; i < answer.response.phase_rad.size(); ++i) {
            if (answer.response.frequency_Hz[i] > 5.1e4)
                answer.response.phase_rad[i] += 1.0;
        }
        QVERIFY(std::abs(delayDifference(answer).value().delay_s) < 2e-8);
    }
};

DYNCAL_TEST(TestDelayDifference)
#include "tst_delay_difference.moc"
