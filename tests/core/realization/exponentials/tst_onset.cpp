// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Where a step response begins, from the exponentials that describe it: sensors whose transfer
// function is written down, moved by a known time.

#include "core/base/constants.h"
#include "core/realization/exponentials/onset.h"
#include "tests/support/cascade_model.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using testing::Gaussian;
using testing::modelOfPoles;
using Complex = std::complex<double>;

namespace {

/// The model's step response as a sum of exponentials whose step comes at `onset_s`.
ExponentialSum stepAt(const SensorModel &model, double onset_s)
{
    ExponentialSum sum{model.plateauGain, Eigen::VectorXcd(model.order), model.amplitudes};
    for (Index i = 0; i < model.order; ++i) {
        sum.poles_rad_s[i] = model.poles[static_cast<std::size_t>(i)].s_rad_s;
        sum.amplitudes[i] *= std::exp(-sum.poles_rad_s[i] * onset_s);
    }
    return sum;
}

double fastest(const SensorModel &model)
{
    double rate = 0.0;
    for (const Pole &pole : model.poles)
        rate = std::max(rate, std::abs(pole.s_rad_s));
    return rate;
}

/// What docs/method/model.md searches: 0.6 of the period of the fastest pole.
double searchOf(const SensorModel &model)
{
    return 0.6 * kTwoPi / fastest(model);
}

/// Root of the k-th derivative nearest to 0 where the response is low: every stretch of the scan
/// looked at, in their order.
std::optional<double> rootOfWholeScan(const ExponentialSum &response, int k, double search_s)
{
    std::optional<double> nearest;
    const double step = 2.0 * search_s / 600;
    double left = -search_s;
    for (int i = 0; i < 600; ++i, left += step) {
        const bool isNegative = response.derivative(left, k) < 0.0;
        if (isNegative == (response.derivative(left + step, k) < 0.0))
            continue;
        double a = left;
        double b = left + step;
        for (int halving = 0; halving < 60; ++halving) {
            const double middle = 0.5 * (a + b);
            ((response.derivative(middle, k) < 0.0) == isNegative ? a : b) = middle;
        }
        const bool isLow = std::abs(response.value(a)) <= 0.25 * std::abs(response.constant);
        if (isLow && (!nearest || std::abs(a) < std::abs(*nearest)))
            nearest = a;
    }
    return nearest;
}

Complex pole(double f0_Hz, double zeta)
{
    return kTwoPi * f0_Hz * Complex(-zeta, std::sqrt(1.0 - zeta * zeta));
}

} // namespace

class TestOnset : public QObject
{
    Q_OBJECT

private slots:
    void sensorsOfEveryKind_beginWhereTheirStepCame_data()
    {
        QTest::addColumn<QList<double>>("re");
        QTest::addColumn<QList<double>>("im");
        QTest::addColumn<double>("exact"); ///< of the fastest period
        const auto row = [](const char *name, const std::vector<Complex> &poles, double exact) {
            QList<double> re;
            QList<double> im;
            for (const Complex &s : poles) {
                re += s.real();
                im += s.imag();
            }
            QTest::newRow(name) << re << im << exact;
        };
        const Complex s = pole(50e3, 0.05);
        const Complex damped = pole(50e3, 0.8);
        row("lag", {-2e5}, 1e-9);
        row("ringing", {s, std::conj(s)}, 1e-9);
        row("well damped", {damped, std::conj(damped)}, 1e-9);
        row("two lags", {-1e5, -4e5}, 1e-9);
        row("two lags far apart", {-1e4, -4e6}, 1e-9);
        // y and y' vanish together with y'': its simple root is what is found.
        row("ringing behind a lag", {s, std::conj(s), -6e5}, 1e-9);
        row("three lags", {-1e5, -2e5, -3e5}, 1e-9);
    }
    void sensorsOfEveryKind_beginWhereTheirStepCame()
    {
        QFETCH(QList<double>, re);
        QFETCH(QList<double>, im);
        QFETCH(double, exact);
        std::vector<Complex> poles;
        for (int i = 0; i < re.size(); ++i)
            poles.emplace_back(re[i], im[i]);
        const SensorModel model = modelOfPoles(poles);
        const double period_s = kTwoPi / fastest(model);
        for (const double share : {-0.3, -0.021, 0.0, 0.0173, 0.2}) {
            const double onset_s = share * period_s;
            const auto found = findOnset_s(stepAt(model, onset_s), searchOf(model));
            QVERIFY2(found.has_value(), qPrintable(QString::number(share)));
            QVERIFY2(std::abs(*found - onset_s) < exact * period_s,
                qPrintable(QString("%1: %2").arg(share).arg((*found - onset_s) / period_s)));
        }
    }

    /// Pressure 1 - h + h e^(a t) on a lag: the slope vanishes nowhere near the onset.
    void aLagBehindADrift_beginsWhereItIsZero()
    {
        constexpr double kLag = -2e5, kDrift = -2e3;
        for (const double h : {0.03, -0.03, 0.3}) {
            for (const double onset_s : {-2e-6, 0.0, 0.7e-6}) {
                const double drift = h / (1.0 - kDrift / kLag);
                ExponentialSum sum{1.0 - h, Eigen::Vector2cd(kDrift, kLag),
                    Eigen::Vector2cd(drift, -(1.0 - h) - drift)};
                sum.amplitudes.array() *= (-sum.poles_rad_s.array() * onset_s).exp();
                const auto found = findOnset_s(sum, 0.6 * kTwoPi / -kLag);
                QVERIFY(found && std::abs(*found - onset_s) < 1e-12);
            }
        }
    }

    /// Modes of any size beside the main one: many roots, some of them low; to the last bit.
    void searchFromTheMiddle_findsTheRootOfTheWholeScan()
    {
        Gaussian random(20261);
        int found = 0;
        for (int trial = 0; trial < 300; ++trial) {
            const double zeta = 0.01 + 0.1 * std::abs(random());
            const Complex s = pole(1e5, std::min(zeta, 0.9));
            const Complex weak = pole(1e5 * (1.0 + 3.0 * std::abs(random())), 0.02);
            ExponentialSum sum
                = stepAt(modelOfPoles({s, std::conj(s), weak, std::conj(weak)}), 2e-6 * random());
            sum.amplitudes.tail(2) *= random();
            const double search_s = 8e-6 * std::abs(random());
            const auto expected = rootOfWholeScan(sum, 1, search_s);
            QCOMPARE(findOnset_s(sum, search_s), expected);
            found += expected.has_value();
        }
        QVERIFY2(found > 150 && found < 300, qPrintable(QString::number(found)));
    }

    void sizeAndDirection_changeNothing()
    {
        const Complex s = pole(3e5, 0.03);
        const SensorModel model = modelOfPoles({s, std::conj(s)});
        const ExponentialSum one = stepAt(model, 0.2e-6);
        const double search_s = searchOf(model);
        for (const double factor : {-1.0, 1e-12, -3e9}) {
            ExponentialSum other = one;
            other.constant *= factor;
            other.amplitudes *= factor;
            QVERIFY(std::abs(*findOnset_s(other, search_s) - *findOnset_s(one, search_s))
                < 1e-12 * search_s);
        }
    }

    void unitOfTime_stretchesTheOnset()
    {
        const Complex s = pole(3e5, 0.03);
        const double onset_s = -0.3e-6;
        for (const double time : {1e-6, 1e5}) {
            const SensorModel model = modelOfPoles({s / time, std::conj(s) / time});
            const auto found = findOnset_s(stepAt(model, onset_s * time), searchOf(model));
            QVERIFY(found && std::abs(*found / time - onset_s) < 1e-9 * std::abs(onset_s));
        }
    }

    void firstPeak_isNotTakenForTheOnset()
    {
        // The slope vanishes at the first peak too, half a period behind the onset, and there it
        // is nearer to a start that was detected late; but the response is at 1.9 of its plateau.
        const double f0_Hz = 1e5;
        const Complex s = pole(f0_Hz, 0.03);
        const SensorModel model = modelOfPoles({s, std::conj(s)});
        const double onset_s = -0.45 / f0_Hz;
        const auto found = findOnset_s(stepAt(model, onset_s), searchOf(model));
        QVERIFY(found && std::abs(*found - onset_s) < 1e-9 / f0_Hz);
    }

    void startFarFromTheOnset_findsNone()
    {
        // A lag has but one zero; beyond the search there is nothing.
        const SensorModel lag = modelOfPoles({-1e5});
        QVERIFY(!findOnset_s(stepAt(lag, 2.0 * searchOf(lag)), searchOf(lag)));
        QVERIFY(!findOnset_s(stepAt(lag, -2.0 * searchOf(lag)), searchOf(lag)));
        // Two lags: their slope has one zero.
        const SensorModel two = modelOfPoles({-1e5, -4e5});
        QVERIFY(!findOnset_s(stepAt(two, 1.5 * searchOf(two)), searchOf(two)));
    }

    void nonsense_findsNoneAndEnds()
    {
        const Complex s = pole(1e5, 0.03);
        const SensorModel model = modelOfPoles({s, std::conj(s)});
        ExponentialSum broken = stepAt(model, 0.0);
        broken.amplitudes[0] = std::nan("");
        QVERIFY(!findOnset_s(broken, searchOf(model)));
        ExponentialSum still = stepAt(model, 0.0);
        still.amplitudes.setZero();
        QVERIFY(!findOnset_s(still, searchOf(model))); // a constant begins nowhere
        QVERIFY(!findOnset_s({}, 1e-6));
        QVERIFY(!findOnset_s(stepAt(model, 1e-7), 0.0)); // nowhere to look
    }
};

DYNCAL_TEST(TestOnset)
#include "tst_onset.moc"
