// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/second_order/second_order_fit.h"
#include "tests/support/realized_model.h"
#include "tests/support/test_program.h"

#include "tests/support/damped_shots.h"
#include "tests/support/simulated_calibration.h"

#include <QTest>

using namespace dyncal;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr double kExact = 1e-7; ///< noise-free, of the value

/// Two shots of different height and arrival.
ModelInput twoShots(double f0_Hz, double zeta, double noise = 0.0, std::uint64_t seed = 1)
{
    std::vector<ModelSeries> series;
    for (Index shot = 1; shot <= 2; ++shot) {
        RandomStream random(seed, shot, 2);
        const double step = 0.4 * static_cast<double>(shot);
        Eigen::VectorXd y = testing::simulatedNoise(random, 400, noise * step, 0.0);
        for (Index k = 0; k < 400; ++k)
            y[k] += step
                * testing::dampedStep(f0_Hz, zeta,
                    (static_cast<double>(k) + 0.3 * static_cast<double>(shot)) / kRate_Hz);
        series.push_back(testing::makeSeries(shot, y, kRate_Hz,
            testing::simulatedNoise(random, 1000, std::max(1e-9, noise * step), 0.0)));
    }
    return testing::makeInput(ResponseTreatment::StepDeflated, kRate_Hz, std::move(series));
}

/// What the tube adds to the pressure of shot 1 or 2, over its step: 1 + Re(a e^(r t)).
struct TubeMode
{
    std::complex<double> pole_rad_s;
    std::complex<double> pressure;
};

TubeMode modeOfShot(Index shot)
{
    const double f_Hz = 6.8e3 + 400.0 * static_cast<double>(shot - 1);
    const double w = 2.0 * std::numbers::pi * f_Hz;
    return {{-0.02 * w, w}, std::polar(0.04, shot == 1 ? 0.4 : -2.0)};
}

/// Sensor's answer to the step with the mode, by integrating its differential equation (RK4) from
/// the onset on; `first` samples after it the record begins.
Eigen::VectorXd answerToTube(double f0_Hz, double zeta, double first, Index count, TubeMode mode)
{
    constexpr int kStepsPerSample = 100; // (w0 h)^4 is 1e-10
    const double w = 2.0 * std::numbers::pi * f0_Hz;
    using State = Eigen::Vector2d; // y, y'/w
    const auto slope = [&](double t_s, const State &x) {
        const double u = 1.0 + (mode.pressure * std::exp(mode.pole_rad_s * t_s)).real();
        return State(w * x[1], w * (u - x[0] - 2.0 * zeta * x[1]));
    };
    State x = State::Zero();
    double t_s = 0.0;
    const auto advance = [&](double until_s) {
        const double h = (until_s - t_s) / kStepsPerSample;
        for (int i = 0; i < kStepsPerSample; ++i) {
            const State k1 = slope(t_s, x);
            const State k2 = slope(t_s + 0.5 * h, x + 0.5 * h * k1);
            const State k3 = slope(t_s + 0.5 * h, x + 0.5 * h * k2);
            const State k4 = slope(t_s + h, x + h * k3);
            x += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
            t_s += h;
        }
    };
    Eigen::VectorXd y(count);
    for (Index k = 0; k < count; ++k) {
        advance((first + static_cast<double>(k)) / kRate_Hz);
        y[k] = x[0];
    }
    return y;
}

/// As twoShots(), each with its mode of the tube; the terms as a fit of the free model has them.
ModelInput twoShotsInTube(double f0_Hz, double zeta, double noise, std::uint64_t seed)
{
    ModelInput input = twoShots(f0_Hz, zeta, noise, seed);
    for (ModelSeries &series : input.series) {
        const double shot = static_cast<double>(series.shot);
        const TubeMode mode = modeOfShot(series.shot);
        const Eigen::VectorXd clean
            = answerToTube(f0_Hz, zeta, 0.3 * shot, 400, {mode.pole_rad_s, 0.0});
        const Eigen::VectorXd whole = answerToTube(f0_Hz, zeta, 0.3 * shot, 400, mode);
        series.y += 0.4 * shot * (whole - clean);
        series.fullRate = series.y;
        const std::complex<double> s = mode.pole_rad_s / (2.0 * std::numbers::pi * f0_Hz);
        const std::complex<double> gain = 1.0 / (s * s + 2.0 * zeta * s + 1.0);
        series.nuisance = {{0, true, mode.pole_rad_s * 1.01,
            0.4 * shot * mode.pressure * gain * std::polar(0.95, 0.05)}};
    }
    return input;
}

std::optional<SecondOrderModel> fitted(const ModelInput &input, double f0_Hz, double zeta)
{
    const auto fit
        = fitSecondOrder(input, refinementRecords(input), {{f0_Hz, zeta, {0.5, 0.5}, {0.0, 0.0}}});
    return fit ? std::optional(fit->sensor) : std::nullopt;
}

/// Mean squares of error over stated uncertainty: f0 (60 kHz), zeta, and of the first shot plateau
/// (0.4) and onset (-0.3 us).
struct ErrorsOverU
{
    std::array<double, 4> squares{};

    void add(const SecondOrderModel &fit, double zeta, int trials)
    {
        const SecondOrderShot &shot = fit.shots[0];
        squares[0] += std::pow((fit.f0_Hz - 60e3) / fit.u_f0_Hz, 2) / trials;
        squares[1] += std::pow((fit.zeta - zeta) / fit.u_zeta, 2) / trials;
        squares[2] += std::pow((shot.plateauGain - 0.4) / shot.u_plateauGain, 2) / trials;
        squares[3] += std::pow((shot.onset_s + 0.3e-6) / shot.u_onset_s, 2) / trials;
    }
    void print() const
    {
        qInfo("mean square of error over u: f0 %.2f, zeta %.2f, plateau %.2f, onset %.2f",
            squares[0], squares[1], squares[2], squares[3]);
    }
};

} // namespace

class TestSecondOrderFit : public QObject
{
    Q_OBJECT

private slots:
    void noiseFreeSteps_giveTheirSensor_data()
    {
        QTest::addColumn<double>("zeta");
        for (const double zeta : {0.02, 0.3, 0.7, 0.95, 1.1, 1.5, 3.0})
            QTest::addRow("zeta %g", zeta) << zeta;
    }
    void noiseFreeSteps_giveTheirSensor()
    {
        QFETCH(double, zeta);
        const double f0_Hz = 50e3;
        const auto fit = fitted(twoShots(f0_Hz, zeta), 1.02 * f0_Hz, 1.1 * zeta);
        QVERIFY(fit.has_value());
        QVERIFY2(std::abs(fit->f0_Hz / f0_Hz - 1.0) < kExact,
            qPrintable(QString::number(fit->f0_Hz, 'g', 12)));
        QVERIFY2(std::abs(fit->zeta / zeta - 1.0) < kExact,
            qPrintable(QString::number(fit->zeta, 'g', 12)));
        for (std::size_t r = 0; r < 2; ++r) {
            const double shot = static_cast<double>(r + 1);
            QCOMPARE(fit->shots[r].shot, static_cast<Index>(r) + 1);
            QVERIFY(std::abs(fit->shots[r].plateauGain / (0.4 * shot) - 1.0) < kExact);
            QVERIFY(std::abs(fit->shots[r].onset_s + 0.3e-6 * shot) < 1e-12);
            QVERIFY(fit->shots[r].fit_percent > 99.999);
        }
    }

    void sensorBehindADrift_isFound_data() { noiseFreeSteps_giveTheirSensor_data(); }
    /// Pressure 1 - h + h e^(-t/tau) from the onset on; the search starts at half its rate.
    void sensorBehindADrift_isFound()
    {
        QFETCH(double, zeta);
        const double f0_Hz = 50e3, tau_s = 1.1e-3, h = 0.05;
        ModelInput input = twoShots(f0_Hz, zeta);
        for (ModelSeries &series : input.series) {
            const double shot = static_cast<double>(series.shot);
            series.y = 0.4 * shot * (1.0 - h)
                * answerToTube(f0_Hz, zeta, 0.3 * shot, 400, {-1.0 / tau_s, h / (1.0 - h)});
            series.fullRate = series.y;
        }
        SecondOrderStart start{1.02 * f0_Hz, 1.1 * zeta, {0.4, 0.8}, {0.0, 0.0}};
        start.drift = {-0.5 / tau_s, {0.01, 0.02}};
        const auto fit = fitSecondOrder(input, refinementRecords(input), {start});
        QVERIFY(fit.has_value());
        QVERIFY(std::abs(fit->sensor.f0_Hz / f0_Hz - 1.0) < 1e-6);
        QVERIFY(std::abs(fit->sensor.zeta / zeta - 1.0) < 1e-6);
        QCOMPARE(std::ssize(fit->refinement.poles_rad_s), Index(3));
        QVERIFY(std::abs(fit->refinement.poles_rad_s[0].real() * tau_s + 1.0) < 1e-3);
        QCOMPARE(fit->refinement.covariance.rows(), 3 + 2 * Index(4));
        for (std::size_t r = 0; r < 2; ++r) {
            const double shot = static_cast<double>(r + 1);
            QVERIFY(std::abs(fit->sensor.shots[r].onset_s + 0.3e-6 * shot) < 1e-11);
            QVERIFY(
                std::abs(fit->sensor.shots[r].plateauGain / (0.4 * shot * (1.0 - h)) - 1.0) < 1e-4);
        }
    }

    void aDriftAsFastAsTheSensor_isRefused()
    {
        const ModelInput input = twoShots(50e3, 1.5);
        SecondOrderStart start{50e3, 1.5, {0.4, 0.8}, {0.0, 0.0}};
        start.drift = {-1e5, {0.1, 0.2}};
        const auto fit = fitSecondOrder(input, refinementRecords(input), {start});
        QVERIFY(!fit || -fit->refinement.poles_rad_s[0].real() < 0.1 * 2e5);
    }

    void sensorInTheTube_isFound_data() { noiseFreeSteps_giveTheirSensor_data(); }
    /// The step sets off a mode of 4 %: the ringing answers to it too.
    void sensorInTheTube_isFound()
    {
        QFETCH(double, zeta);
        const double f0_Hz = 50e3;
        const auto fit = fitted(twoShotsInTube(f0_Hz, zeta, 0.0, 1), 1.02 * f0_Hz, 1.1 * zeta);
        QVERIFY(fit.has_value());
        QVERIFY2(std::abs(fit->f0_Hz / f0_Hz - 1.0) < kExact,
            qPrintable(QString::number(fit->f0_Hz, 'g', 12)));
        QVERIFY2(std::abs(fit->zeta / zeta - 1.0) < kExact,
            qPrintable(QString::number(fit->zeta, 'g', 12)));
        for (std::size_t r = 0; r < 2; ++r) {
            const double shot = static_cast<double>(r + 1);
            QVERIFY(std::abs(fit->shots[r].plateauGain / (0.4 * shot) - 1.0) < kExact);
            QVERIFY(std::abs(fit->shots[r].onset_s + 0.3e-6 * shot) < 1e-12);
            QVERIFY(fit->shots[r].fit_percent > 99.999);
        }
    }

    void sensorInTheTube_uncertaintiesMatchTheScatter_data()
    {
        QTest::addColumn<double>("zeta");
        QTest::addColumn<double>("ar1");
        QTest::newRow("zeta 0.05") << 0.05 << 0.0;
        QTest::newRow("zeta 0.3") << 0.3 << 0.0;
        QTest::newRow("zeta 0.05, AR(0.9)") << 0.05 << 0.9;
    }
    void sensorInTheTube_uncertaintiesMatchTheScatter()
    {
        QFETCH(double, zeta);
        QFETCH(double, ar1);
        constexpr int kTrials = 100; // as above
        ErrorsOverU scatter;
        ModelInput clean = twoShotsInTube(60e3, zeta, 0.0, 1);
        for (std::uint64_t trial = 0; trial < kTrials; ++trial) {
            ModelInput input = clean;
            for (ModelSeries &series : input.series) {
                RandomStream random(trial, series.shot, 3);
                const Eigen::VectorXd noise = testing::simulatedNoise(
                    random, 3400, 0.008 * static_cast<double>(series.shot), ar1);
                const auto terms = series.nuisance;
                series = testing::makeSeries(
                    series.shot, series.y + noise.tail(400), kRate_Hz, noise.head(3000));
                series.nuisance = terms;
            }
            const auto fit = fitted(input, 60e3, zeta);
            QVERIFY(fit.has_value());
            scatter.add(*fit, zeta, kTrials);
        }
        scatter.print();
        for (const double square : scatter.squares)
            QVERIFY(square > 0.3 && square < 1.7);
    }

    void modeThatWasThereBefore_changesNoRinging()
    {
        // A vibration, say: in the record, but not in the pressure step.
        ModelInput input = twoShots(50e3, 0.05);
        for (ModelSeries &series : input.series) {
            const NuisanceTerm term{0, false, modeOfShot(1).pole_rad_s, {0.02, 0.01}};
            for (Index k = 0; k < series.y.size(); ++k)
                series.y[k] += term.value(static_cast<double>(k) / kRate_Hz);
            series.fullRate = series.y;
            series.nuisance = {term};
            series.nuisance.front().amplitude *= 0.9;
        }
        const auto fit = fitted(input, 51e3, 0.06);
        QVERIFY(fit.has_value());
        QVERIFY(std::abs(fit->f0_Hz / 50e3 - 1.0) < kExact);
        QVERIFY(std::abs(fit->zeta / 0.05 - 1.0) < kExact);
    }

    void criticalDamping_isReachedFromBothSides()
    {
        // Where the poles meet the sums of exponentials are singular; zeta is kept 1e-4 away.
        for (const double start : {0.8, 1.3}) {
            const auto fit = fitted(twoShots(50e3, 1.0), 48e3, start);
            QVERIFY(fit.has_value());
            QVERIFY2(
                std::abs(fit->zeta - 1.0) < 5e-3, qPrintable(QString::number(fit->zeta, 'g', 8)));
            QVERIFY(fit->fit_percent > 99.9);
        }
    }

    void statedUncertainties_matchTheScatter()
    {
        // Mean squares of 100 standard normal errors: 1 with sd 0.14; five of them.
        constexpr int kTrials = 100;
        ErrorsOverU scatter;
        for (int trial = 0; trial < kTrials; ++trial) {
            const auto fit
                = fitted(twoShots(60e3, 0.2, 0.02, static_cast<std::uint64_t>(trial)), 60e3, 0.2);
            QVERIFY(fit.has_value());
            scatter.add(*fit, 0.2, kTrials);
        }
        scatter.print();
        for (const double square : scatter.squares)
            QVERIFY(square > 0.3 && square < 1.7);
    }

    void colouredNoise_widensTheIntervals()
    {
        double squares = 0.0;
        constexpr int kTrials = 100;
        for (std::uint64_t seed = 1; seed <= kTrials; ++seed) {
            const ModelInput input
                = testing::simulateCalibration({{{1.0, 30e3, 0.05}}, 30.0, 0.9}, seed);
            const auto fit = fitSecondOrder(
                input, refinementRecords(input), {{30e3, 0.05, {0.33, 0.6, 0.9}, {0.0, 0.0, 0.0}}});
            QVERIFY(fit.has_value());
            QVERIFY(fit->sensor.uncertaintyMethod.starts_with("AR("));
            squares += std::pow((fit->sensor.f0_Hz - 30e3) / fit->sensor.u_f0_Hz, 2) / kTrials;
        }
        qInfo("mean square of error over u: %.2f", squares);
        QVERIFY(squares > 0.3 && squares < 1.7);
    }

    void besideTheModel_theSensorIsTheSame()
    {
        const ModelInput input = testing::simulateCalibration({{{1.0, 30e3, 0.05}}, 40.0}, 5);
        const auto hankel = decomposeHankel(input, {});
        const auto result = testing::realizeModel(input, *hankel, 2);
        QVERIFY(result && result->assessment.secondOrder);
        const SecondOrderModel &beside = *result->assessment.secondOrder;
        QVERIFY(beside.describes);
        QCOMPARE(beside.shots.size(), std::size_t(3));
        const double u_Hz = result->main()->u_frequency_Hz;
        QVERIFY(std::abs(beside.f0_Hz - result->main()->frequency_Hz) < 4.0 * u_Hz);
        // Fewer parameters: never less certain than the free model.
        QVERIFY(beside.u_f0_Hz < 1.05 * u_Hz);
    }

    void sensorOfTwoModes_isNotDescribed()
    {
        const ModelInput input
            = testing::simulateCalibration({{{0.8, 30e3, 0.05}, {0.2, 110e3, 0.02}}, 40.0}, 5);
        const auto hankel = decomposeHankel(input, {});
        const auto result = testing::realizeModel(input, *hankel, 4);
        QVERIFY(result && result->assessment.secondOrder);
        const SecondOrderModel &beside = *result->assessment.secondOrder;
        QVERIFY(!beside.describes);
        QVERIFY(beside.residualToNoise > 2.0);
        const Findings &findings = result->assessment.findings;
        QVERIFY(std::any_of(findings.begin(), findings.end(),
            [](const Finding &finding) { return finding.id == "MOD-011"; }));
        // The main resonance is still near.
        QVERIFY(std::abs(beside.f0_Hz / 30e3 - 1.0) < 0.05);
    }

    void everyOrder_reachesTheSameFit()
    {
        const ModelInput input = testing::simulateCalibration({{{1.0, 30e3, 0.05}}, 40.0}, 5);
        const auto hankel = decomposeHankel(input, {});
        const double f0_Hz
            = testing::realizeModel(input, *hankel, 2)->assessment.secondOrder->f0_Hz;
        for (const Index order : {Index(3), Index(6), Index(20)}) {
            const auto result = testing::realizeModel(input, *hankel, order);
            if (const auto &beside = result->assessment.secondOrder)
                QVERIFY(std::abs(beside->f0_Hz / f0_Hz - 1.0) < 1e-5);
        }
    }

    void otherTreatments_haveNone()
    {
        for (const ResponseTreatment treatment :
            {ResponseTreatment::StepAsImpulse, ResponseTreatment::Impulse}) {
            ModelInput input = testing::simulateCalibration({{{1.0, 30e3, 0.05}}, 40.0}, 5);
            input.treatment = treatment;
            input.series.resize(1);
            const auto hankel = decomposeHankel(input, {});
            const auto result = testing::realizeModel(input, *hankel, 3);
            QVERIFY(result && !result->assessment.secondOrder);
        }
    }

    void nonsense_isRefusedOrFinite()
    {
        const ModelInput input = twoShots(50e3, 0.3, 0.01);
        QVERIFY(!fitted(input, 0.0, 0.3));
        QVERIFY(!fitted(input, 50e3, 0.0));
        QVERIFY(!fitted(input, 50e3, -0.3));
        QVERIFY(!fitted(input, std::nan(""), 0.3));
        ModelInput flat = input;
        for (ModelSeries &series : flat.series) {
            series.y.setZero();
            series.fullRate.setZero();
        }
        const auto fit = fitted(flat, 50e3, 0.3);
        if (fit)
            QVERIFY(std::isfinite(fit->f0_Hz) && std::isfinite(fit->zeta));
    }
};

DYNCAL_TEST(TestSecondOrderFit)
#include "tst_second_order_fit.moc"
