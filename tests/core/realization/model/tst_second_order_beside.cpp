// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Where the second-order sensor beside a model starts from, and when there is none; the fit itself:
// tst_second_order_fit.cpp.

#include "core/realization/model/second_order_beside.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr double kClosed = 1e-6; ///< noise-free: where the descent stops

/// Step response of two real lags a, b (1/s): 1 + (b e^(-a t) - a e^(-b t))/(a - b).
double lagsStep(double a, double b, double t_s)
{
    return t_s <= 0.0 ? 0.0 : 1.0 + (b * std::exp(-a * t_s) - a * std::exp(-b * t_s)) / (a - b);
}

template <typename Value>
ModelInput inputOf(const Value &value, const std::vector<double> &steps)
{
    std::vector<ModelSeries> series;
    for (const double step : steps) {
        Eigen::VectorXd y(400);
        for (Index k = 0; k < y.size(); ++k)
            y[k] = step * value((static_cast<double>(k) + 0.5) / kRate_Hz);
        series.push_back(testing::makeSeries(std::ssize(series) + 1, y, kRate_Hz));
    }
    return testing::makeInput(ResponseTreatment::StepDeflated, kRate_Hz, series);
}

/// What the model was fitted with: nothing but the sensor in any of `shots` records.
ModelDraft draftOf(std::size_t shots)
{
    ModelDraft draft;
    draft.nuisance.resize(shots);
    return draft;
}

Pole poleAt(std::complex<double> s)
{
    Pole pole;
    pole.s_rad_s = s;
    pole.poleClass = PoleClass::Sensor;
    pole.amplitude = 1.0;
    pole.frequency_Hz = std::abs(s) / (2.0 * M_PI);
    pole.dampingRatio = -s.real() / std::abs(s);
    return pole;
}

SensorModel modelOf(
    const std::vector<std::complex<double>> &poles, const std::vector<double> &plateaus)
{
    SensorModel model;
    model.draft = draftOf(plateaus.size());
    for (const auto &s : poles)
        model.poles.push_back(poleAt(s));
    for (const double plateau : plateaus) {
        SeriesFit fit;
        fit.plateauGain = plateau;
        fit.onset_s = -0.4e-6; // half a sample before the first, nearly
        model.series.push_back(fit);
    }
    model.fit_percent = 100.0;
    return model;
}

} // namespace

class TestSecondOrderBeside : public QObject
{
    Q_OBJECT

private slots:
    void resonance_isFoundFromTheModelsPole()
    {
        const ModelInput input = inputOf(
            [](double t_s) { return testing::secondOrderStep(30e3, 0.05, t_s); }, {0.3, 0.9});
        const std::complex<double> s
            = 2.0 * M_PI * 30.2e3 * std::complex<double>(-0.06, std::sqrt(1.0 - 0.0036));
        // A lag that belongs to nothing must not lead astray.
        const SensorModel model = modelOf({s, std::conj(s), -5e5}, {0.31, 0.88});
        const auto found = fitSecondOrderBeside(input, model, {});
        QVERIFY(found.has_value());
        QVERIFY(std::abs(found->f0_Hz / 30e3 - 1.0) < kClosed);
        QVERIFY(std::abs(found->zeta - 0.05) < kClosed);
        QVERIFY(found->fit_percent > 99.99);
        QVERIFY(found->describes);
    }

    void twoLags_areOneOverdampedSensor_data()
    {
        QTest::addColumn<double>("slow");
        QTest::addColumn<double>("fast");
        QTest::newRow("1 : 4") << 3e4 << 1.2e5;
        QTest::newRow("1 : 9") << 2e4 << 1.8e5;
    }
    void twoLags_areOneOverdampedSensor()
    {
        QFETCH(double, slow);
        QFETCH(double, fast);
        const ModelInput input
            = inputOf([&](double t_s) { return lagsStep(slow, fast, t_s); }, {1.0});
        // In whatever order; found is w0 = sqrt(a b), zeta = (a + b)/(2 w0). One lag alone: the
        // other is taken as nine times as fast.
        for (const std::vector<std::complex<double>> &poles :
            {std::vector<std::complex<double>>{-1.05 * slow, -0.95 * fast}, {-fast, -slow},
                {-slow}}) {
            const auto found = fitSecondOrderBeside(input, modelOf(poles, {1.0}), {});
            QVERIFY(found.has_value());
            const double omega = std::sqrt(slow * fast);
            QVERIFY(std::abs(found->f0_Hz / (omega / (2.0 * M_PI)) - 1.0) < 1e-4);
            QVERIFY(std::abs(found->zeta / (0.5 * (slow + fast) / omega) - 1.0) < 1e-4);
        }
    }

    void oscillationsBeforeTheStep_areNotTheSensors()
    {
        // There before the step: no part of the pressure, so it changes no ringing.
        const NuisanceTerm hum{0, false, {-500.0, 2.0 * M_PI * 9e3}, {0.05, 0.02}};
        const ModelInput input = inputOf(
            [&](double t_s) {
                return testing::secondOrderStep(30e3, 0.05, t_s)
                    + hum.value(t_s - 0.5 / kRate_Hz); // time 0 at the first sample
            },
            {1.0});
        const std::complex<double> s
            = 2.0 * M_PI * 30e3 * std::complex<double>(-0.05, std::sqrt(1.0 - 0.0025));
        SensorModel model = modelOf({s, std::conj(s)}, {1.0});
        const auto without = fitSecondOrderBeside(input, model, {});
        model.draft.nuisance = {{hum}};
        const auto with = fitSecondOrderBeside(input, model, {});
        QVERIFY(std::abs(with->f0_Hz / 30e3 - 1.0) < kClosed);
        QVERIFY(std::abs(with->zeta - 0.05) < kClosed);
        QVERIFY(std::abs(without->zeta - 0.05) > 100.0 * kClosed);
    }

    void whereNoStepResponseIsDescribed_thereIsNone()
    {
        ModelInput input
            = inputOf([](double t_s) { return testing::secondOrderStep(30e3, 0.05, t_s); }, {1.0});
        const std::complex<double> s(-9e3, 1.8e5);
        for (const ResponseTreatment treatment :
            {ResponseTreatment::Impulse, ResponseTreatment::StepAsImpulse}) {
            input.treatment = treatment;
            QVERIFY(!fitSecondOrderBeside(input, modelOf({s, std::conj(s)}, {1.0}), {}));
        }
        input.treatment = ResponseTreatment::StepDeflated;
        SensorModel runaway = modelOf({s, std::conj(s)}, {1.0});
        runaway.diverges = true;
        QVERIFY(!fitSecondOrderBeside(input, runaway, {}));
        const SensorModel none = modelOf({}, {1.0}); // no pole of the sensor to start from
        QVERIFY(!fitSecondOrderBeside(input, none, {}));
    }
};

DYNCAL_TEST(TestSecondOrderBeside)
#include "tst_second_order_beside.moc"
