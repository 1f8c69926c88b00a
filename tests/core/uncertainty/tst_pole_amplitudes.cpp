// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The uncertainty of a pole's amplitude: the closed form of a second-order sensor, the scatter of
// many calibrations against the stated u, and the front.

#include "core/uncertainty/model_noise.h"
#include "core/uncertainty/pole_amplitudes.h"
#include "tests/support/damped_shots.h"
#include "tests/support/realized_model.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QTest>

#include <cmath>

using namespace dyncal;

namespace {

constexpr double kF0OfAmplitude_Hz = 318e3;

/// |c| of w0^2/(s^2 + 2 zeta w0 s + w0^2) answering a step of 1.
double amplitudeOfTruth(double zeta)
{
    return 0.5 / std::sqrt(1.0 - zeta * zeta);
}

/// Three shots whose step is 1, so that the amplitude of the mean is that of each.
ModelInput unitSteps(double zeta, int seed, double noise)
{
    return testing::dampedShots(
        [zeta](std::size_t shot, double t_s) {
            return testing::dampedStep(kF0OfAmplitude_Hz, zeta, t_s)
                / (0.3 * static_cast<double>(shot + 1));
        },
        static_cast<std::uint64_t>(seed), {noise});
}

std::vector<ReportedValue> amplitudesOf(
    double zeta, int seed, double noise, const FrontDuration &front = {})
{
    const ModelInput input = unitSteps(zeta, seed, noise);
    const auto hankel = decomposeHankel(input, {});
    const testing::RealizedModel made = *testing::realizeModel(input, *hankel, 2);
    return poleAmplitudes(made.model, made.assessment, modelVariations(input, made.model), front);
}

} // namespace

class TestPoleAmplitudes : public QObject
{
    Q_OBJECT

private slots:
    void pair_hasTheAmplitudeOfTheClosedForm_once()
    {
        for (const double zeta : {0.02, 0.2, 0.7}) {
            const auto found = amplitudesOf(zeta, 1, 0.0);
            QCOMPARE(found.size(), std::size_t(2));
            QVERIFY(std::abs(found[0].value / amplitudeOfTruth(zeta) - 1.0) < 1e-5);
            QCOMPARE(found[0].value, found[1].value);
        }
    }

    void u_isTheScatter_data()
    {
        QTest::addColumn<double>("zeta");
        for (const double zeta : {0.05, 0.2, 0.5})
            QTest::addRow("zeta %g", zeta) << zeta;
    }
    /// Mean square of error over u: 60 runs lie within 0.59 to 1.53 in 99 %.
    void u_isTheScatter()
    {
        QFETCH(double, zeta);
        const int runs = trials::count(60, 1000);
        double squares = 0.0;
        for (int seed = 1; seed <= runs; ++seed) {
            const auto found = amplitudesOf(zeta, seed, 0.005);
            QVERIFY(found[0].u);
            QCOMPARE(found[0].lines[0].quantity, std::string("noise"));
            squares += std::pow((found[0].value - amplitudeOfTruth(zeta)) / found[0].lines[0].u, 2)
                / runs;
        }
        const double reach = 4.0 * std::sqrt(2.0 / runs);
        QVERIFY2(
            squares > 1.0 - reach && squares < 1.0 + reach, qPrintable(QString::number(squares)));
    }

    /// A front of T takes |1 - e^(-sT)|/|sT| of what rings: to first order (w0 T)^2/24 of it.
    void statedFront_isALine()
    {
        const double T_s = 1e-7, u_s = 2e-8;
        const auto found = amplitudesOf(0.02, 1, 0.001, {T_s, u_s});
        QCOMPARE(found[0].lines[1].quantity, std::string("front_duration_s"));
        const double w0 = 2.0 * M_PI * kF0OfAmplitude_Hz;
        const double expected = found[0].value * w0 * w0 * T_s * u_s / 12.0;
        QVERIFY2(std::abs(found[0].lines[1].u / expected - 1.0) < 0.05,
            qPrintable(QString::number(found[0].lines[1].u / expected)));
    }

    void withoutVariations_uIsAbsent()
    {
        const ModelInput input = unitSteps(0.1, 1, 0.001);
        const auto hankel = decomposeHankel(input, {});
        const testing::RealizedModel made = *testing::realizeModel(input, *hankel, 2);
        for (const ReportedValue &one : poleAmplitudes(made.model, made.assessment, {}, {})) {
            QVERIFY(!one.u);
            QVERIFY(!english(one.missing).empty());
        }
    }

    void widening_isAtLeastOne()
    {
        QCOMPARE(widening(3.0, 1.0, 2.0, 1.0), 3.0);
        QCOMPARE(widening(0.5, 1.0, 0.2, 1.0), 1.0);
        QCOMPARE(widening(0.5, 0.0, 0.2, 1.0), 1.0);
        QVERIFY(std::isnan(spreadOver({}, [](const SensorModel &) { return 1.0; })));
    }
};

DYNCAL_TEST(TestPoleAmplitudes)
#include "tst_pole_amplitudes.moc"
