// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Rise, overshoot, settling and bands of models that are not the plain second-order sensor (that
// one: tst_model_curves.cpp): closed forms, the differential equation integrated, and the defining
// properties.

#include "core/base/constants.h"
#include "core/model_analysis/model_characteristics.h"
#include "core/model_analysis/model_curves.h"
#include "core/model_analysis/model_response.h"
#include "core/model_analysis/unwrapped_phase.h"
#include "tests/support/cascade_model.h"
#include "tests/support/second_order_model.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
#include <QTest>

#include <functional>
#include <numbers>

using namespace dyncal;
using testing::cascadeModel;
using testing::modelOfPoles;

namespace {

constexpr ResponseTreatment kStep = ResponseTreatment::StepDeflated;
/// Crossings are bisected to the last digit; what remains is rounding of the sum of exponentials.
constexpr double kExact = 1e-9;

/// c0 + sum c_i e^(s_i t) over c0, straight from the definition.
double stepOf(const SensorModel &model, double t_s)
{
    std::complex<double> y = model.plateauGain;
    for (Index i = 0; i < model.amplitudes.size(); ++i)
        y += model.amplitudes[i] * std::exp(model.poles[static_cast<std::size_t>(i)].s_rad_s * t_s);
    return y.real() / model.plateauGain;
}

/// First t beyond `from` at which f becomes positive, on a grid of `step`, then bisected.
double firstPositive(const std::function<double(double)> &f, double from, double step)
{
    double right = from + step;
    while (f(right) <= 0.0)
        right += step;
    double left = right - step;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (left + right);
        (f(middle) > 0.0 ? right : left) = middle;
    }
    return 0.5 * (left + right);
}

bool near(const std::optional<double> &found, double expected, double tolerance = kExact)
{
    if (found && std::abs(*found - expected) <= tolerance * std::abs(expected))
        return true;
    qWarning("found %.12g, expected %.12g", found ? *found : std::nan(""), expected);
    return false;
}

/// x' = (previous - x) rate of lags one behind the other, a unit step at the first; RK4.
std::vector<double> chainOfLags(const std::vector<double> &rates, double dt_s, int steps)
{
    std::vector<double> x(rates.size(), 0.0);
    std::vector<double> y{0.0};
    const auto slope = [&](const std::vector<double> &at) {
        std::vector<double> d(at.size());
        for (std::size_t i = 0; i < at.size(); ++i)
            d[i] = rates[i] * ((i == 0 ? 1.0 : at[i - 1]) - at[i]);
        return d;
    };
    const auto moved = [&](const std::vector<double> &k, double h) {
        std::vector<double> at = x;
        for (std::size_t i = 0; i < at.size(); ++i)
            at[i] += h * k[i];
        return at;
    };
    for (int n = 0; n < steps; ++n) {
        const auto k1 = slope(x);
        const auto k2 = slope(moved(k1, 0.5 * dt_s));
        const auto k3 = slope(moved(k2, 0.5 * dt_s));
        const auto k4 = slope(moved(k3, dt_s));
        for (std::size_t i = 0; i < x.size(); ++i)
            x[i] += dt_s / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
        y.push_back(x.back());
    }
    return y;
}

/// Where samples of a rising curve first reach `level`, linear between them.
double reached(const std::vector<double> &y, double level, double dt_s)
{
    std::size_t k = 1;
    while (y.at(k) < level)
        ++k;
    return (static_cast<double>(k - 1) + (level - y[k - 1]) / (y[k] - y[k - 1])) * dt_s;
}

} // namespace

class TestModelCharacteristics : public QObject
{
    Q_OBJECT

private slots:
    void firstOrderLag_hasItsClosedForm()
    {
        for (const double a : {3e-2, 1.0, 4e7}) {
            const StepCharacteristics c = stepCharacteristics(modelOfPoles({-a}), kStep);
            QVERIFY(near(c.riseTime_s, std::log(9.0) / a));
            QVERIFY(near(c.settlingTime_s, std::log(20.0) / a));
            QCOMPARE(*c.overshoot_percent, 0.0);
            // 1/sqrt(1 + x^2) = r at x = sqrt(1/r^2 - 1)
            QVERIFY(near(c.minus3dB_Hz, a / kTwoPi));
            QVERIFY(near(c.within5percent_Hz, a / kTwoPi * std::sqrt(1.0 / 0.9025 - 1.0)));
            QVERIFY(near(c.within10percent_Hz, a / kTwoPi * std::sqrt(1.0 / 0.81 - 1.0)));
        }
    }

    void overdampedPair_hasItsClosedForm_data()
    {
        QTest::addColumn<double>("zeta");
        for (const double zeta : {1.0001, 1.2, 3.0, 40.0})
            QTest::newRow(qPrintable(QString::number(zeta))) << zeta;
    }
    void overdampedPair_hasItsClosedForm()
    {
        QFETCH(double, zeta);
        const double w0 = 2e5;
        const double root = std::sqrt(zeta * zeta - 1.0);
        const StepCharacteristics c
            = stepCharacteristics(modelOfPoles({-w0 * (zeta - root), -w0 * (zeta + root)}), kStep);
        // |G|^2 = 1/((1-x)^2 + 4 zeta^2 x), x = (w/w0)^2, equals r^2 at the root of a quadratic.
        const auto limit_Hz = [&](double r) {
            const double b = 2.0 * zeta * zeta - 1.0;
            const double q = 1.0 / (r * r) - 1.0;
            return w0 / kTwoPi * std::sqrt(q / (b + std::sqrt(b * b + q)));
        };
        QVERIFY(near(c.minus3dB_Hz, limit_Hz(std::sqrt(0.5))));
        QVERIFY(near(c.within5percent_Hz, limit_Hz(0.95)));
        QVERIFY(near(c.within10percent_Hz, limit_Hz(0.9)));
        const auto y = [&](double t) { // cosh and sinh written out so that nothing overflows
            const double slow = std::exp(-w0 * (zeta - root) * t);
            const double fast = std::exp(-w0 * (zeta + root) * t);
            return 1.0 - 0.5 * ((slow + fast) + zeta / root * (slow - fast));
        };
        const double step_s = 0.01 / (w0 * (zeta + root));
        const auto crossing = [&](double level) {
            return firstPositive([&](double t) { return y(t) - level; }, 0.0, step_s);
        };
        constexpr double kNearlyDouble = 1e-7; ///< poles 3 % apart cancel two digits
        QVERIFY(near(c.riseTime_s, crossing(0.9) - crossing(0.1), kNearlyDouble));
        QVERIFY(near(c.settlingTime_s, crossing(0.95), kNearlyDouble));
        QVERIFY(*c.overshoot_percent < 1e-6);
    }

    void chainOfNearlyEqualLags_settlesLaterThanItsSlowestPole()
    {
        // Six lags of nearly one rate: amplitudes of 1e8 cancel, and 5 % are left at 10.5 time
        // constants, where e^-8 of the slowest would be long gone.
        const std::vector<double> rates{1.0, 1.03, 1.06, 1.1, 1.13, 1.17};
        const double dt = 1e-3;
        const std::vector<double> y = chainOfLags(rates, dt, 20000);
        std::vector<std::complex<double>> poles;
        for (const double rate : rates)
            poles.emplace_back(-rate);
        const StepCharacteristics c = stepCharacteristics(modelOfPoles(poles), kStep);
        constexpr double kOfIntegration = 1e-6; // linear between samples, rounding of the sum
        QVERIFY(near(c.settlingTime_s, reached(y, 0.95, dt), kOfIntegration));
        QVERIFY(near(c.riseTime_s, reached(y, 0.9, dt) - reached(y, 0.1, dt), kOfIntegration));
    }

    void slowPartBesideAFastResonance_hidesNothing_data()
    {
        QTest::addColumn<double>("slow_rad_s");
        for (const double slow : {1e4, 1e3, 100.0, 1.0})
            QTest::newRow(qPrintable(QString::number(slow))) << slow;
    }
    void slowPartBesideAFastResonance_hidesNothing()
    {
        // A sensor of 1 MHz whose last 8 % creep in: the ringing must be looked at as closely as
        // without the creep.
        QFETCH(double, slow_rad_s);
        const double f0_Hz = 1e6;
        SensorModel model = testing::secondOrderModel(f0_Hz, 0.3, 0.92);
        Pole creep;
        creep.s_rad_s = -slow_rad_s;
        model.poles.push_back(creep);
        model.amplitudes.conservativeResize(3);
        model.amplitudes[2] = -0.08;
        model.plateauGain = 1.0;
        const StepCharacteristics c = stepCharacteristics(model, kStep);
        const auto crossing = [&](double level) {
            return firstPositive(
                [&](double t) { return stepOf(model, t) - level; }, 0.0, 1e-4 / f0_Hz);
        };
        QVERIFY(near(c.riseTime_s, crossing(0.9) - crossing(0.1)));
        double top = 0.0;
        for (int k = 0; k < 20000; ++k)
            top = std::max(top, stepOf(model, 1e-4 * k / f0_Hz));
        QVERIFY(std::abs(*c.overshoot_percent - 100.0 * std::max(0.0, top - 1.0)) < 1e-4);
        // Settled when the creep is within 5 %: by then nothing of the ringing is left.
        QVERIFY(near(c.settlingTime_s, std::log(0.08 / 0.05) / slow_rad_s, 1e-6));
    }

    void responseThatStartsHigh_overshootsAtTheStart()
    {
        // c0 + 0.3 e^(-a t): largest at once, 1.3 at t = 0.
        const double a = 500.0;
        SensorModel model = modelOfPoles({-a});
        model.amplitudes[0] = 0.3;
        const StepCharacteristics c = stepCharacteristics(model, kStep);
        QVERIFY(near(c.overshoot_percent, 30.0));
        QVERIFY(near(c.settlingTime_s, std::log(6.0) / a));
        QVERIFY(c.riseTime_s && *c.riseTime_s == 0.0); // it never was below
    }

    void narrowWeakMode_endsTheBandWhereItLeavesIt()
    {
        // A mode 2e-4 wide whose 12 % stand out of an otherwise flat band, on and off any grid.
        for (const double f1_Hz : {2e4, 2.0173e4, 2.0311e4}) {
            const double zeta = 2e-4;
            SensorModel model = testing::secondOrderModel(1e6, 0.6);
            const SensorModel weak = testing::secondOrderModel(f1_Hz, zeta);
            const double share = 0.12 * 2.0 * zeta; // |G| of the mode is share/(2 zeta) at f1
            model.poles.insert(model.poles.end(), weak.poles.begin(), weak.poles.end());
            model.amplitudes.conservativeResize(4);
            model.amplitudes.tail(2) = share * weak.amplitudes;
            model.amplitudes.head(2) *= 1.0 - share;
            const auto excess = [&](double limit) {
                return firstPositive(
                    [&](double f_Hz) {
                        return std::abs(std::abs(modelResponse(model, kStep, f_Hz)) - 1.0) - limit;
                    },
                    0.99 * f1_Hz, 1e-6 * f1_Hz);
            };
            const StepCharacteristics c = stepCharacteristics(model, kStep);
            QVERIFY(near(c.within5percent_Hz, excess(0.05)));
            // Where 10 % are not left at the mode, the sensor itself must end the band.
            QVERIFY(*c.within10percent_Hz >= excess(0.05));
        }
    }

    void unitsOfTimeAndValue_changeNothingElse()
    {
        const SensorModel model = cascadeModel({{30e3, 0.03}, {110e3, 0.2}});
        const StepCharacteristics one = stepCharacteristics(model, kStep);
        for (const double time : {1e-3, 7.0, 1e6}) {
            SensorModel scaled = model;
            for (Pole &pole : scaled.poles)
                pole.s_rad_s /= time;
            for (const double gain : {1e-9, -40.0}) {
                SensorModel other = scaled;
                other.plateauGain *= gain;
                other.amplitudes *= gain;
                const StepCharacteristics c = stepCharacteristics(other, kStep);
                QVERIFY(near(c.riseTime_s, time * *one.riseTime_s));
                QVERIFY(near(c.settlingTime_s, time * *one.settlingTime_s));
                QVERIFY(near(c.overshoot_percent, *one.overshoot_percent));
                QVERIFY(near(c.within5percent_Hz, *one.within5percent_Hz / time));
                QVERIFY(near(c.within10percent_Hz, *one.within10percent_Hz / time));
                QVERIFY(near(c.minus3dB_Hz, *one.minus3dB_Hz / time));
            }
        }
    }

    void orderOfThePoles_changesNothing()
    {
        const SensorModel model = cascadeModel({{30e3, 0.03}, {110e3, 0.2}});
        SensorModel turned = model;
        for (const Index i : {0, 1}) {
            std::swap(turned.poles[static_cast<std::size_t>(i)],
                turned.poles[static_cast<std::size_t>(i + 2)]);
            std::swap(turned.amplitudes[i], turned.amplitudes[i + 2]);
        }
        const StepCharacteristics a = stepCharacteristics(model, kStep);
        const StepCharacteristics b = stepCharacteristics(turned, kStep);
        QVERIFY(near(b.riseTime_s, *a.riseTime_s));
        QVERIFY(near(b.settlingTime_s, *a.settlingTime_s));
        QVERIFY(near(b.overshoot_percent, *a.overshoot_percent));
        QVERIFY(near(b.minus3dB_Hz, *a.minus3dB_Hz));
    }

    void polesThatDoNotDecay_haveNone()
    {
        for (const std::complex<double> s : {std::complex<double>(0.0, 1e3), {50.0, 1e3}}) {
            SensorModel model = testing::secondOrderModel(1e3, 0.1);
            model.poles[0].s_rad_s = s;
            model.poles[1].s_rad_s = std::conj(s);
            QVERIFY(!stepCharacteristics(model, kStep).settlingTime_s);
        }
        SensorModel flat = testing::secondOrderModel(1e3, 0.1);
        flat.plateauGain = 0.0;
        QVERIFY(!stepCharacteristics(flat, kStep).riseTime_s);
        QVERIFY(!stepCharacteristics({}, kStep).riseTime_s);
    }

    void phase_isThatOfTheFactors_howeverNarrowTheModes_data()
    {
        QTest::addColumn<double>("zeta");
        QTest::addColumn<double>("apart");
        QTest::addColumn<int>("count");
        for (const double zeta : {0.05, 2e-3, 1e-4}) {
            for (const double apart : {1.001, 1.01, 1.3}) {
                for (const int count : {600, 20, 2}) {
                    QTest::addRow("zeta %g, %g, %d points", zeta, apart, count)
                        << zeta << apart << count;
                }
            }
        }
    }
    void phase_isThatOfTheFactors_howeverNarrowTheModes()
    {
        QFETCH(double, zeta);
        QFETCH(double, apart);
        QFETCH(int, count);
        // Two sensors one behind the other: each turns from 0 to -pi and never further.
        const std::vector<std::pair<double, double>> modes{{1e5, zeta}, {1e5 * apart, zeta}};
        const ResponseCurve curve = modelCurve(cascadeModel(modes), kStep, 1e3, 1e6, count);
        for (Index k = 0; k < count; ++k) {
            double truth = 0.0;
            for (const auto &[f0_Hz, damping] : modes) {
                const double r = curve.frequency_Hz[k] / f0_Hz;
                truth -= std::atan2(2.0 * damping * r, 1.0 - r * r);
            }
            // Residues of poles 1e-3 apart cancel three digits of them.
            QVERIFY2(std::abs(curve.phase_rad[k] - truth) < 1e-6,
                qPrintable(QString("%1 Hz: %2, %3")
                               .arg(curve.frequency_Hz[k])
                               .arg(curve.phase_rad[k])
                               .arg(truth)));
        }
    }

    void phase_throughANarrowZero_turnsTheRightWay()
    {
        // Two sensors in series and (s^2 + 2 zeta w s + w^2)/w^2: the zeros turn the phase back by
        // pi, or on by pi where they lie in the right half plane. No pole marks the place.
        const std::vector<std::pair<double, double>> modes{{1e5, 0.05}, {9e5, 0.05}};
        for (const double zeroFrequency_Hz : {2e5, 3.1e5, 5.55e5}) {
            for (const double zeta : {0.02, 1e-4, -1e-4, -0.02}) {
                const double w = kTwoPi * zeroFrequency_Hz;
                SensorModel model = cascadeModel(modes);
                for (Index i = 0; i < model.order; ++i) {
                    const std::complex<double> s = model.poles[static_cast<std::size_t>(i)].s_rad_s;
                    model.amplitudes[i] *= (s * s + 2.0 * zeta * w * s + w * w) / (w * w);
                }
                for (const int count : {2, 30, 601}) {
                    const ResponseCurve curve = modelCurve(model, kStep, 1e4, 4e6, count);
                    for (Index k = 0; k < count; ++k) {
                        const double r = curve.frequency_Hz[k] / zeroFrequency_Hz;
                        double truth = std::atan2(2.0 * zeta * r, 1.0 - r * r);
                        for (const auto &[f0_Hz, damping] : modes) {
                            const double q = curve.frequency_Hz[k] / f0_Hz;
                            truth -= std::atan2(2.0 * damping * q, 1.0 - q * q);
                        }
                        QVERIFY(std::abs(curve.phase_rad[k] - truth) < 1e-6);
                    }
                }
            }
        }
    }

    void phase_inAnyOrder_andAtNonsense()
    {
        const SensorModel model = cascadeModel({{1e3, 1e-3}, {1.001e3, 1e-3}, {5e3, 0.4}});
        const std::vector<double> frequencies_Hz{4e4, 900.0, 1e3, 1e-7, 1e6, 1.0005e3, 1e3};
        UnwrappedPhase oneByOne(model, kStep);
        for (const double f_Hz : frequencies_Hz) {
            UnwrappedPhase fresh(model, kStep);
            QVERIFY(std::abs(oneByOne.at(f_Hz) - fresh.at(f_Hz)) < kExact);
        }
        QVERIFY(std::isnan(oneByOne.at(std::nan(""))));
        QVERIFY(std::abs(oneByOne.at(0.0)) < kExact);
        QVERIFY(std::abs(oneByOne.at(900.0) - UnwrappedPhase(model, kStep).at(900.0)) < kExact);
    }

    void manyWeaklyDampedPoles_areNoMatterOfSeconds()
    {
        // What order 120 of a noisy record looks like: rings of all frequencies and durations.
        std::vector<std::pair<double, double>> modes;
        for (int i = 0; i < 60; ++i)
            modes.emplace_back(1e3 * std::pow(1.1, i), 2e-4 * (1 + i % 7));
        SensorModel model = testing::secondOrderModel(5e3, 0.3);
        for (const auto &[f0_Hz, zeta] : modes) {
            const SensorModel weak = testing::secondOrderModel(f0_Hz, zeta, 1e-4);
            model.poles.insert(model.poles.end(), weak.poles.begin(), weak.poles.end());
            model.amplitudes.conservativeResize(model.amplitudes.size() + 2);
            model.amplitudes.tail(2) = weak.amplitudes;
        }
        QElapsedTimer timer;
        timer.start();
        QVERIFY(stepCharacteristics(model, kStep).riseTime_s);
        QVERIFY(modelCurve(model, kStep, 10.0, 1e6, 600).phase_rad.allFinite());
        constexpr qint64 kPatience_ms = 3000; // 0.4 s on an idle machine
        QVERIFY2(timer.elapsed() < kPatience_ms, qPrintable(QString::number(timer.elapsed())));
        qInfo("%lld ms", timer.elapsed());
    }

    void phase_countsFromZeroFrequency_whereverTheCurveBegins()
    {
        const SensorModel model = cascadeModel({{1e3, 0.02}, {3e3, 0.02}});
        for (const double gain : {1.0, -2.0}) {
            SensorModel scaled = model;
            scaled.plateauGain *= gain;
            scaled.amplitudes *= gain;
            const ResponseCurve above = modelCurve(scaled, kStep, 1e6, 1e7, 3);
            const double start = gain < 0.0 ? std::numbers::pi : 0.0;
            // Far above both: two half turns, less 2 zeta f0/f of each.
            QVERIFY(std::abs(above.phase_rad[2] - (start - kTwoPi)) < 1e-3);
            const ResponseCurve between = modelCurve(scaled, kStep, 1.7e3, 1.8e3, 2);
            QVERIFY(std::abs(between.phase_rad[0] - (start - std::numbers::pi)) < 0.1);
        }
    }
};

DYNCAL_TEST(TestModelCharacteristics)
#include "tst_model_characteristics.moc"
