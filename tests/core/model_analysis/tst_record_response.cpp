// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/constants.h"
#include "core/model_analysis/record_response.h"
#include "tests/support/step_records.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <complex>

using namespace dyncal;
using testing::StepRecords;
using Complex = std::complex<double>;

namespace {

constexpr double kSpan_s = 200e-6;

} // namespace

class TestRecordResponse : public QObject
{
    Q_OBJECT

private slots:
    void sensor_isFound_withinTheBounds()
    {
        StepRecords records;
        for (const double fraction : {0.0, 0.3, 0.9})
            records.add(1e7, 8000, fraction);
        const RecordResponse response(records.shots, kSpan_s);
        for (const double f_Hz : {2e3, 3e4, 2e5, 3e5, 1e6, 3e6}) {
            const RecordResponse::Point point = response.at(f_Hz);
            const Complex S = records.truth(f_Hz);
            QVERIFY(std::abs(point.magnitude - std::abs(S)) <= point.bound() + 1e-9);
            QVERIFY(std::abs(std::remainder(point.phase_rad - std::arg(S), kTwoPi)) * std::abs(S)
                <= 1.1 * point.bound() + 1e-9);
            QCOMPARE(point.u_magnitude, 0.0);
        }
    }

    void onset_turnsThePhaseAlone()
    {
        StepRecords records;
        records.add(1e7, 8000, 0.2, 1e-3, 4);
        records.add(1e7, 8000, 0.7, 1e-3, 5);
        const RecordResponse one(records.shots, kSpan_s);
        records.shots[0].onset_s += 3e-6;
        records.shots[1].onset_s -= 1e-6;
        const RecordResponse other(records.shots, kSpan_s);
        for (const double f_Hz : {2e3, 3e4, 3e5, 1e6}) {
            const RecordResponse::Point a = one.at(f_Hz), b = other.at(f_Hz);
            QVERIFY(std::abs(b.magnitude / a.magnitude - 1.0) < 1e-12);
            QVERIFY(std::abs(b.boundEnd - a.boundEnd) <= 1e-12 * a.magnitude);
            QCOMPARE(b.boundAlias, a.boundAlias);
            // By the mean of the two changes, even where they are turns apart.
            const double turn = b.phase_rad - a.phase_rad - kTwoPi * f_Hz * 1e-6;
            QVERIFY(std::abs(std::remainder(turn, kTwoPi)) < 1e-9);
        }
    }

    void bounds_hold_whereverTheOnsetLies_andWhateverIsLeft()
    {
        // Low rates, windows of 5 to 40 time constants, a mode of 2 % at the rate's half or above.
        int held = 0, all = 0;
        for (int trial = 0; trial < 60; ++trial) {
            const double rate_Hz = trial % 2 ? 1e6 : 3e6;
            const double constants = 5.0 + 35.0 * trial / 59.0;
            StepRecords records;
            records.modes = {{StepRecords::kF0_Hz, 0.02, 1.0},
                {StepRecords::kF0_Hz * (1.5 + 0.075 * trial), 0.03, 0.02}};
            const Index length
                = static_cast<Index>(constants / (kTwoPi * StepRecords::kF0_Hz * 0.02) * rate_Hz);
            records.add(rate_Hz, length, trial / 60.0);
            const RecordResponse response(records.shots, kSpan_s);
            for (double f_Hz = rate_Hz / static_cast<double>(length); f_Hz < 0.4 * rate_Hz;
                 f_Hz *= 1.26) {
                const RecordResponse::Point point = response.at(f_Hz);
                held += std::abs(point.magnitude - std::abs(records.truth(f_Hz))) <= point.bound();
                ++all;
            }
        }
        qInfo("the bounds hold in %d of %d rows", held, all);
        QVERIFY(all > 800);
        QVERIFY(held >= 0.99 * all);
    }

    void longRinging_lengthensWhatIsUsed()
    {
        // 50 kHz rings on for 2 ms; over the span alone nothing could be said there.
        StepRecords records;
        records.modes.push_back({50e3, 0.01, 0.05});
        records.add(1e7, 40000, 0.4);
        const RecordResponse response(records.shots, kSpan_s);
        for (const double f_Hz : {3e4, 5e4, 7e4}) {
            const RecordResponse::Point point = response.at(f_Hz);
            QVERIFY(point.bound() < 0.01 * point.magnitude);
            QVERIFY(std::abs(point.magnitude - std::abs(records.truth(f_Hz))) <= point.bound());
        }
        StepRecords shortOnes; // of which nothing longer is there
        shortOnes.modes = records.modes;
        shortOnes.add(1e7, 4000, 0.4);
        const RecordResponse::Point point = RecordResponse(shortOnes.shots, kSpan_s).at(5e4);
        QVERIFY(point.boundEnd > 0.05 * point.magnitude);
    }

    void noise_isNoBound()
    {
        StepRecords records;
        records.add(1e7, 20000, 0.4, 0.02, 9);
        records.add(1e7, 20000, 0.1, 0.02, 10);
        const RecordResponse response(records.shots, kSpan_s);
        int beyond = 0, all = 0;
        for (double f_Hz = 1e3; f_Hz < 1e6; f_Hz *= 1.1, ++all) {
            const RecordResponse::Point point = response.at(f_Hz);
            QVERIFY(point.u_magnitude > 0.0);
            beyond += point.bound() > point.u_magnitude;
        }
        QVERIFY2(beyond <= all / 20, qPrintable(QString::number(beyond)));
    }

    void statedUncertainty_isTheScatter()
    {
        constexpr int kTrials = 200;
        const std::vector<double> frequencies_Hz{1e3, 5e3, 5e4, 2.9e5, 4e5};
        std::vector<double> squares(frequencies_Hz.size(), 0.0), phases = squares;
        std::vector<double> mean = squares;
        for (int trial = 0; trial < kTrials; ++trial) {
            StepRecords records;
            records.add(1e7, 10000, 0.4, 0.01, static_cast<std::uint64_t>(2 * trial + 1));
            records.add(1e7, 10000, 0.4, 0.02, static_cast<std::uint64_t>(2 * trial + 2));
            const RecordResponse response(records.shots, kSpan_s);
            for (std::size_t k = 0; k < frequencies_Hz.size(); ++k) {
                const RecordResponse::Point point = response.at(frequencies_Hz[k]);
                const Complex S = records.truth(frequencies_Hz[k]);
                const double z = (point.magnitude - std::abs(S)) / point.u_magnitude;
                const double turn = std::remainder(point.phase_rad - std::arg(S), kTwoPi);
                squares[k] += z * z / kTrials;
                mean[k] += z / kTrials;
                phases[k] += std::pow(turn / point.u_phase_rad, 2) / kTrials;
            }
        }
        for (std::size_t k = 0; k < frequencies_Hz.size(); ++k) {
            qInfo("%g Hz: mean z %.2f, rms z %.2f, of the phase %.2f", frequencies_Hz[k], mean[k],
                std::sqrt(squares[k]), std::sqrt(phases[k]));
            // A mean of 200 squares scatters by 10 %; the level's part counts twice.
            QVERIFY(squares[k] > 0.5 && squares[k] < 1.35);
            QVERIFY(phases[k] > 0.3 && phases[k] < 1.35);
            QVERIFY(std::abs(mean[k]) < 0.25);
        }
    }

    void uncertaintyOfTheOnset_isInThePhase()
    {
        StepRecords records;
        records.add(1e7, 8000, 0.4);
        records.add(1e7, 8000, 0.4);
        for (RecordOfShot &shot : records.shots)
            shot.u_onset_s = 1e-9;
        const double u = RecordResponse(records.shots, kSpan_s).at(2e5).u_phase_rad;
        QVERIFY(std::abs(u / (kTwoPi * 2e5 * 1e-9 / std::sqrt(2.0)) - 1.0) < 1e-9);
    }

    void front_isDividedOut_withItsUncertainty()
    {
        constexpr double duration_s = 310e-9;
        StepRecords sharp;
        sharp.add(1e8, 60000, 0.5);
        const RecordResponse known(sharp.shots, kSpan_s, {duration_s, 10e-9});
        const RecordResponse none(sharp.shots, kSpan_s);
        for (const double f_Hz : {1e4, 3e5, 1e6}) {
            const double x = std::numbers::pi * f_Hz * duration_s;
            const RecordResponse::Point a = known.at(f_Hz), b = none.at(f_Hz);
            QVERIFY(std::abs(a.magnitude / b.magnitude * std::sin(x) / x - 1.0) < 1e-9);
            QVERIFY(std::abs(a.phase_rad - b.phase_rad) < 1e-12);
            // d ln sinc / dT, to first order.
            const double slope = (x / std::tan(x) - 1.0) / duration_s;
            QVERIFY(std::abs(a.u_front / (a.magnitude * std::abs(slope) * 10e-9) - 1.0) < 0.01);
            QCOMPARE(b.u_front, 0.0);
        }
    }

    void scaleAndSign_arePartOfS()
    {
        StepRecords records;
        records.add(1e7, 8000, 0.4);
        records.shots[0].scale = -2e-6;
        const RecordResponse::Point point = RecordResponse(records.shots, kSpan_s).at(1e4);
        QVERIFY(std::abs(point.magnitude / (2e-6 * std::abs(records.truth(1e4))) - 1.0) < 1e-3);
        QVERIFY(std::abs(std::abs(point.phase_rad) - std::numbers::pi) < 0.01);
    }
};

DYNCAL_TEST(TestRecordResponse)
#include "tst_record_response.moc"
