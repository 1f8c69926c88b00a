// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Comparison with a reference transducer: constructed truth, its uncertainty against the scatter of
// calibrations, and what it must not depend on.

#include "core/base/constants.h"
#include "core/model_analysis/transducer_response.h"
#include "tests/support/near.h"
#include "tests/support/step_records.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <complex>

using namespace dyncal;
using testing::isNear;
using testing::StepRecords;

namespace {

constexpr double kSpan_s = 200e-6;
constexpr ReferenceModel kReference{3.0, 0.006, 400e3, 400.0, 0.4, 0.002};

/// Shots of a DUT with the reference beside it, which reads 3 for a step of 1.
struct Pair
{
    StepRecords dut, transducer;
    ReferenceRecords reference{ReferenceSensitivity::fromModel(kReference).value()};

    Pair() { transducer.modes = {{kReference.f0_Hz, kReference.zeta, 1.0}}; }

    void add(double fraction, double delay_samples, double noise = 0.0, std::uint64_t seed = 1)
    {
        constexpr double kRate_Hz = 1e7;
        const auto shot = static_cast<Index>(dut.shots.size()) + 1;
        dut.add(kRate_Hz, 8000, fraction, noise, 2 * seed);
        transducer.add(kRate_Hz, 8000, fraction + delay_samples, noise, 2 * seed + 1);
        dut.responses.back().shot = transducer.responses.back().shot = shot;
        dut.responses.back().valueScale = dut.shots.back().scale = 5.0; // the DUT reads 5
        transducer.responses.back().valueScale = kReference.sensitivity;
        reference.responses.push_back(transducer.responses.back());
        reference.delay_s = delay_samples / kRate_Hz;
    }

    std::complex<double> truth(double f_Hz) const { return 5.0 * dut.truth(f_Hz); }
};

double phaseError(const ResponsePoint &point, std::complex<double> S)
{
    return std::remainder(point.phase_rad - std::arg(S), kTwoPi);
}

} // namespace

class TestTransducerResponse : public QObject
{
    Q_OBJECT

private slots:
    void sensor_isFound_withinTheBounds()
    {
        Pair pair;
        for (const double fraction : {0.0, 0.3, 0.6})
            pair.add(fraction, 0.35);
        const TransducerResponse response(pair.dut.shots, kSpan_s, pair.reference);
        for (const double f_Hz : {2e3, 3e4, 2e5, 3e5, 6e5}) {
            const ResponsePoint point = response.at(f_Hz);
            const std::complex<double> S = pair.truth(f_Hz);
            QVERIFY(point.isCalibrated);
            QVERIFY(std::abs(point.magnitude - std::abs(S)) <= point.bound() + 1e-9);
            QVERIFY(std::abs(phaseError(point, S)) * std::abs(S) <= 1.1 * point.bound() + 1e-9);
            const ReferencePoint certified = pair.reference.sensitivity.at(f_Hz).value();
            QVERIFY(isNear(
                point.u_reference / point.magnitude, certified.u_magnitude / certified.magnitude));
            QCOMPARE(point.u_referencePhase_rad, certified.u_phase_rad);
        }
    }

    /// The zero of time, the front and the pressure are the same for both.
    void onsetAndStep_doNotMatter()
    {
        Pair pair;
        pair.add(0.4, 0.0, 1e-3, 3);
        const TransducerResponse one(pair.dut.shots, kSpan_s, pair.reference);
        pair.dut.shots[0].onset_s += 5e-6;
        pair.dut.shots[0].scale *= 1.0;
        const TransducerResponse other(pair.dut.shots, kSpan_s, pair.reference);
        const ResponsePoint a = one.at(1e5), b = other.at(1e5);
        QCOMPARE(a.magnitude, b.magnitude);
        QCOMPARE(a.phase_rad, b.phase_rad);
    }

    void delay_turnsThePhaseAlone_withItsUncertainty()
    {
        Pair pair;
        pair.add(0.4, 0.25);
        pair.reference.u_delay_s = 2e-9;
        const ResponsePoint right
            = TransducerResponse(pair.dut.shots, kSpan_s, pair.reference).at(2e5);
        pair.reference.delay_s = 0.0;
        const ResponsePoint wrong
            = TransducerResponse(pair.dut.shots, kSpan_s, pair.reference).at(2e5);
        QVERIFY(isNear(wrong.magnitude, right.magnitude, 1e-12));
        QVERIFY(isNear(wrong.phase_rad - right.phase_rad, kTwoPi * 2e5 * 0.25e-7, 1e-6));
        QVERIFY(isNear(right.u_phase_rad, kTwoPi * 2e5 * 2e-9, 1e-6)); // no noise
        pair.reference.u_delay_s.reset(); // +-0.5 us
        QVERIFY(isNear(uDelay_s(pair.reference), 0.5e-6 / std::sqrt(3.0)));
    }

    /// An echo that ends the DUT's record is not taken from the reference's either.
    void shorterRecordOfTheDut_endsBoth()
    {
        Pair pair;
        pair.add(0.4, 0.0);
        WindowedResponse &dut = pair.dut.responses.back();
        const ResponsePoint whole
            = TransducerResponse(pair.dut.shots, kSpan_s, pair.reference).at(3e3);
        dut.length = 4000;
        dut.values.conservativeResize(dut.lead + dut.length);
        pair.dut.shots[0].record.values = dut.values;
        WindowedResponse &reference = pair.reference.responses.back();
        reference.values.tail(3000).array() += 0.5; // an echo behind that
        const ResponsePoint cut
            = TransducerResponse(pair.dut.shots, kSpan_s, pair.reference).at(3e3);
        QVERIFY(isNear(cut.magnitude, whole.magnitude, 1e-6));
        QVERIFY(cut.boundEnd < 1e-6 * cut.magnitude);
    }

    void outsideTheTable_nothingIsStated()
    {
        Pair pair;
        pair.add(0.4, 0.0);
        pair.reference.sensitivity
            = ReferenceSensitivity::fromTable({{1e3, 3.0, 0.01}, {1e5, 3.1, 0.01}}).value();
        const TransducerResponse response(pair.dut.shots, kSpan_s, pair.reference);
        for (const double f_Hz : {900.0, 2e5}) {
            QVERIFY(!response.at(f_Hz).isCalibrated);
            QVERIFY(std::isnan(response.at(f_Hz).magnitude));
        }
        const ResponsePoint point = response.at(1e4); // a table without phases gives none
        QVERIFY(point.magnitude > 0.0);
        QVERIFY(std::isnan(point.phase_rad) && std::isnan(point.u_referencePhase_rad));
    }

    void statedUncertainty_isTheScatter()
    {
        constexpr int kTrials = 200;
        const std::vector<double> frequencies_Hz{2e3, 5e4, 2.9e5, 5e5};
        std::vector<double> squares(frequencies_Hz.size(), 0.0), phases = squares;
        for (int trial = 0; trial < kTrials; ++trial) {
            Pair pair;
            pair.reference.u_delay_s = 0.0;
            for (const int shot : {0, 1})
                pair.add(0.4, 0.0, 0.01, static_cast<std::uint64_t>(2 * trial + shot + 1));
            const TransducerResponse response(pair.dut.shots, kSpan_s, pair.reference);
            for (std::size_t k = 0; k < frequencies_Hz.size(); ++k) {
                const ResponsePoint point = response.at(frequencies_Hz[k]);
                const std::complex<double> S = pair.truth(frequencies_Hz[k]);
                squares[k]
                    += std::pow((point.magnitude - std::abs(S)) / point.u_magnitude, 2) / kTrials;
                phases[k] += std::pow(phaseError(point, S) / point.u_phase_rad, 2) / kTrials;
            }
        }
        for (std::size_t k = 0; k < frequencies_Hz.size(); ++k) {
            qInfo("%g Hz: rms z %.2f, of the phase %.2f", frequencies_Hz[k], std::sqrt(squares[k]),
                std::sqrt(phases[k]));
            QVERIFY(
                squares[k] > 0.5 && squares[k] < 1.35); // a mean of 200 squares scatters by 10 %
            QVERIFY(phases[k] > 0.3 && phases[k] < 1.35);
        }
    }
};

DYNCAL_TEST(TestTransducerResponse)
#include "tst_transducer_response.moc"
