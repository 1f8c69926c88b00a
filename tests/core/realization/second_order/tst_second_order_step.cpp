// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// One record of the second-order sensor as a sum of exponentials: the differential equation that it
// must satisfy, and derivatives that are known in closed form.

#include "core/realization/exponentials/exponential_sum.h"
#include "core/realization/second_order/second_order_step.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

using Complex = std::complex<double>;

SecondOrderStep stepOf(double zeta, int modes = 0)
{
    SecondOrderStep step;
    step.logOmega = std::log(1.3);
    step.logZeta = std::log(zeta);
    step.plateau = -0.7;
    step.onset = 0.21;
    for (int i = 0; i < modes; ++i)
        step.modes.push_back(
            {Complex(-0.01, 0.2 + 0.1 * i), std::polar(0.03, 0.5 + i), i % 2 == 0});
    return step;
}

/// The record without the modes that were there before the step.
ExponentialSum sumOf(const SecondOrderStep &step)
{
    const Eigen::VectorXd x = step.exponentials();
    const auto modes = static_cast<Index>(step.modes.size());
    const Index first = step.drifts();
    const Index gains = first + 2 + 2 * modes;
    std::vector<Complex> poles;
    std::vector<Complex> amplitudes;
    const auto addPair = [&](Index at) {
        const Complex pole(x[at], x[at + 1]);
        const Complex half = 0.5 * Complex(x[gains + at], x[gains + at + 1]);
        poles.insert(poles.end(), {pole, std::conj(pole)});
        amplitudes.insert(amplitudes.end(), {half, std::conj(half)});
    };
    const auto addReal = [&](Index at) {
        poles.push_back(x[at]);
        amplitudes.push_back(x[gains + at]);
    };
    if (step.drift)
        addReal(0);
    if (step.rings()) {
        addPair(first);
    } else {
        addReal(first);
        addReal(first + 1);
    }
    for (Index i = 0; i < modes; ++i) {
        if (step.modes[static_cast<std::size_t>(i)].startsWithStep)
            addPair(first + 2 + 2 * i);
    }
    return {x[x.size() - 1], Eigen::Map<const Eigen::VectorXcd>(poles.data(), std::ssize(poles)),
        Eigen::Map<const Eigen::VectorXcd>(amplitudes.data(), std::ssize(amplitudes))};
}

/// K (1 + what the modes add to the pressure): each term of the record is its pressure times
/// 1/(r^2/w^2 + 2 zeta r/w + 1).
double pressure(const SecondOrderStep &step, double t)
{
    const double omega = std::exp(step.logOmega);
    double sum = step.plateau;
    if (step.drift) {
        const double r = step.drift->rate / omega;
        sum += step.drift->amplitude * std::exp(step.drift->rate * (t - step.onset))
            * (r * r + 2.0 * step.zeta() * r + 1.0);
    }
    for (const SecondOrderStep::Mode &mode : step.modes) {
        const Complex r = mode.pole / omega;
        if (mode.startsWithStep)
            sum += (mode.amplitude * std::exp(mode.pole * t)
                * (r * r + 2.0 * step.zeta() * r + 1.0))
                       .real();
    }
    return sum;
}

} // namespace

class TestSecondOrderStep : public QObject
{
    Q_OBJECT

private slots:
    void record_satisfiesTheSensorsEquation_data()
    {
        QTest::addColumn<double>("zeta");
        QTest::addColumn<int>("modes");
        QTest::addColumn<bool>("drifts");
        for (const double zeta : {1e-3, 0.05, 0.7, 0.99, 1.0, 1.01, 1.5, 30.0}) {
            for (const int modes : {0, 1, 3})
                QTest::addRow("zeta %g, %d modes", zeta, modes) << zeta << modes << false;
            QTest::addRow("zeta %g, a drift", zeta) << zeta << 0 << true;
            QTest::addRow("zeta %g, a drift, 1 mode", zeta) << zeta << 1 << true;
        }
    }
    void record_satisfiesTheSensorsEquation()
    {
        // y''/w^2 + 2 zeta y'/w + y = pressure behind the onset, and rest there.
        QFETCH(double, zeta);
        QFETCH(int, modes);
        QFETCH(bool, drifts);
        SecondOrderStep step = stepOf(zeta, modes);
        if (drifts)
            step.drift = {-0.004, 0.05};
        const ExponentialSum y = sumOf(step);
        const double omega = std::exp(step.logOmega);
        // Near zeta 1 two terms of opposite sign, each 1/distance large, make the record.
        const double exact = 1e-13 * (1.0 + y.amplitudes.cwiseAbs().sum()) * (1.0 + zeta * zeta);
        QVERIFY2(std::abs(y.value(step.onset)) < exact,
            qPrintable(QString::number(y.value(step.onset))));
        QVERIFY(std::abs(y.derivative(step.onset, 1)) < exact * (1.0 + zeta));
        for (const double t : {0.21, 0.5, 1.7, 6.0, 40.0}) {
            const double left = y.derivative(t, 2) / (omega * omega)
                + 2.0 * step.zeta() * y.derivative(t, 1) / omega + y.value(t);
            QVERIFY2(std::abs(left - pressure(step, t)) < 10.0 * exact,
                qPrintable(QString::number(left - pressure(step, t))));
        }
    }

    void parameters_comeBackAsTheyWereSet()
    {
        SecondOrderStep step = stepOf(0.3, 2);
        const Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(12, -1.0, 2.3);
        QCOMPARE(step.parameters(), values.size());
        step.setParameters(values);
        QVERIFY(step.parameterValues() == values);
        QCOMPARE(step.modes[1].amplitude, Complex(values[10], values[11]));
        step.drift.emplace();
        const Eigen::VectorXd more = Eigen::VectorXd::LinSpaced(14, -1.0, 2.3);
        step.setParameters(more);
        QVERIFY(step.parameterValues() == more);
        QCOMPARE(step.drift->rate, more[2]);
        QCOMPARE(step.drift->amplitude, more[5]);
    }

    void derivatives_areThoseOfTheClosedForm_data()
    {
        QTest::addColumn<double>("zeta");
        for (const double zeta : {0.02, 0.5, 1.7})
            QTest::addRow("zeta %g", zeta) << zeta;
    }
    void derivatives_areThoseOfTheClosedForm()
    {
        QFETCH(double, zeta);
        constexpr double kExact = 1e-8; // of central differences
        const SecondOrderStep step = stepOf(zeta);
        const Eigen::VectorXd x = step.exponentials();
        const Eigen::MatrixXd J = step.derivatives();
        QVERIFY((J.col(0).head(2) - x.head(2)).norm() < kExact * x.head(2).norm()); // s ~ w
        QVERIFY(J.col(2).head(2).norm() < kExact); // no pole depends on K or on the onset
        QVERIFY(J.col(3).head(2).norm() < kExact);
        const Eigen::Vector2d ofGain = x.segment(2, 2) / step.plateau; // linear in K
        QVERIFY((J.col(2).segment(2, 2) - ofGain).norm() < kExact * ofGain.norm());
        QVERIFY(std::abs(J(4, 2) - 1.0) < kExact);
        // g ~ e^(-s onset)
        Eigen::Vector2d ofOnset = -x.head(2).cwiseProduct(x.segment(2, 2));
        if (step.rings()) {
            const Complex moved = -Complex(x[0], x[1]) * Complex(x[2], x[3]);
            ofOnset = {moved.real(), moved.imag()};
        }
        QVERIFY((J.col(3).segment(2, 2) - ofOnset).norm() < kExact * ofOnset.norm());
        // s1 s2 = w^2 and s1 + s2 = -2 zeta w: their derivatives by ln zeta are 0 and the sum.
        if (step.rings()) {
            QVERIFY(std::abs(x.head(2).dot(J.col(1).head(2))) < kExact);
            QVERIFY(std::abs(J(0, 1) - x[0]) < kExact);
        } else {
            QVERIFY(std::abs(x[0] * J(1, 1) + x[1] * J(0, 1)) < kExact * x.squaredNorm());
            QVERIFY(std::abs(J(0, 1) + J(1, 1) - x[0] - x[1]) < kExact * x.norm());
        }
    }

    void criticalDamping_isKeptAwayFrom()
    {
        for (const double away : {0.0, 1e-9, -1e-9, 9e-5, -9e-5}) {
            SecondOrderStep step = stepOf(1.0);
            step.logZeta = std::log1p(away);
            QVERIFY(std::abs(step.zeta() - 1.0) > 0.99e-4);
            QVERIFY(step.exponentials().allFinite() && step.derivatives().allFinite());
        }
        QVERIFY(stepOf(0.9999).rings() && !stepOf(1.0001).rings());
    }

    void noStep_isFiniteAndStill()
    {
        // Gain 0: no pressure can be told from a mode's size; the record is flat where none is.
        SecondOrderStep step = stepOf(0.3);
        step.plateau = 0.0;
        QCOMPARE(step.exponentials().tail(3).norm(), 0.0);
        QVERIFY(step.derivatives().allFinite());
    }
};

DYNCAL_TEST(TestSecondOrderStep)
#include "tst_second_order_step.moc"
