// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/hankel/order_suggestion.h"
#include "core/realization/hankel/realized_poles.h"
#include "core/realization/model/model_fit.h"
#include "core/realization/model/sensor_model.h"
#include "core/realization/refinement/pole_refinement.h"
#include "tests/support/model_inputs.h"
#include "tests/support/realized_model.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

constexpr double kExact = 1e-8; ///< noise-free data, order 2: what double precision leaves

struct Trial
{
    double f0_Hz = 0.0;
    double zeta = 0.0;
    double u_f0_Hz = 0.0;
    double u_zeta = 0.0;
};

ModelInput threeShots(double f0_Hz, double zeta, double rate_Hz, double noise, std::uint64_t seed)
{
    testing::Noise source(seed);
    std::vector<ModelSeries> series;
    for (Index shot = 1; shot <= 3; ++shot) {
        // Sub-sample arrival: each shot starts at its own fraction of a sample.
        const double first = 0.25 * static_cast<double>(shot);
        const Eigen::VectorXd y
            = testing::sampledStep(f0_Hz, zeta, rate_Hz, 400, first) + source.series(400, noise);
        series.push_back(testing::makeSeries(shot, y, rate_Hz, source.series(2000, noise)));
    }
    return testing::makeInput(ResponseTreatment::StepDeflated, rate_Hz, std::move(series));
}

bool hasFinding(const Findings &findings, const char *id)
{
    return std::any_of(
        findings.begin(), findings.end(), [&](const Finding &f) { return f.id == id; });
}

} // namespace

class TestSensorModel : public QObject
{
    Q_OBJECT

private slots:
    void treatments_recoverANoiseFreeSensor_data()
    {
        QTest::addColumn<int>("treatment");
        QTest::newRow("step-deflated") << int(ResponseTreatment::StepDeflated);
        QTest::newRow("differenced") << int(ResponseTreatment::Differenced);
    }
    void treatments_recoverANoiseFreeSensor()
    {
        QFETCH(int, treatment);
        for (const bool refined : {true, false}) {
            ModelInput input = threeShots(318e3, 0.02, 1e6, 0.0, 1);
            input.treatment = static_cast<ResponseTreatment>(treatment);
            const auto hankel = decomposeHankel(input, {});
            QVERIFY(hankel.has_value());
            QCOMPARE(suggestOrder(input, *hankel).order, Index(2));
            RealizationSettings settings;
            settings.refine = refined;
            const auto model = fitModel(input, *hankel, 2, settings, {});
            QVERIFY(model.has_value());
            const Pole &pole = *mainPole(model->poles, model->series);
            QVERIFY2(std::abs(pole.frequency_Hz / 318e3 - 1.0) < kExact,
                qPrintable(QString::number(pole.frequency_Hz, 'g', 12)));
            QVERIFY(std::abs(pole.dampingRatio / 0.02 - 1.0) < 1e-6);
            QVERIFY(std::abs(model->plateauGain - 1.0) < kExact);
            QVERIFY(model->fit_percent > 99.9999);
            // c0 + sum c_i = 0 at the onset: nothing jumps.
            QVERIFY(std::abs(model->plateauGain + model->amplitudes.sum().real()) < 1e-6);
            for (std::size_t r = 0; r < 3; ++r) {
                const double onset_s = -0.25 * static_cast<double>(r + 1) / 1e6;
                QVERIFY2(std::abs(model->series[r].onset_s - onset_s) < 1e-12,
                    qPrintable(QString::number(model->series[r].onset_s)));
            }
        }
    }

    void impulseTreatment_recoversAFreeDecay()
    {
        Eigen::VectorXd y(300);
        const std::complex<double> s(-200.0, 5000.0);
        for (Index k = 0; k < 300; ++k)
            y[k] = (std::complex<double>(3.0, 1.0) * std::exp(s * (static_cast<double>(k) / 1e4)))
                       .real();
        const ModelInput input
            = testing::makeInput(ResponseTreatment::Impulse, 1e4, {testing::makeSeries(1, y, 1e4)});
        const auto hankel = decomposeHankel(input, {});
        const auto model = fitModel(input, *hankel, 2, {}, {});
        QVERIFY(model.has_value());
        QVERIFY(std::abs(mainPole(model->poles, model->series)->s_rad_s - s) < 1e-5);
        QCOMPARE(model->stateSpace.D(0, 0), 0.0);
        // D, CB, CAB ...: the Markov parameters are the data.
        const Eigen::VectorXd h = impulseResponse(model->stateSpace, 301);
        QVERIFY((h.tail(300) - y).cwiseAbs().maxCoeff() < 1e-7);
    }

    void zohModel_reproducesTheStepAtSamples()
    {
        // Onset on a sample: the ZOH-equivalent model's step response is the record itself.
        const Eigen::VectorXd y = testing::sampledStep(50e3, 0.1, 1e6, 300, 0.0);
        const ModelInput input = testing::makeInput(
            ResponseTreatment::StepDeflated, 1e6, {testing::makeSeries(1, y, 1e6)});
        const auto hankel = decomposeHankel(input, {});
        const auto model = fitModel(input, *hankel, 2, {}, {});
        QVERIFY(model.has_value());
        const Eigen::VectorXd h = impulseResponse(model->stateSpace, 300);
        double sum = 0.0;
        for (Index k = 0; k < 300; ++k) {
            sum += h[k];
            QVERIFY(std::abs(sum - y[k]) < 1e-7);
        }
    }

    void statedUncertainty_matchesTheScatter()
    {
        // 60 calibrations: the mean square of (estimate - truth)/u is 1 within 5 sigma of a
        // chi-square of 60 (sd sqrt(2/60) = 0.18).
        constexpr int kTrials = 60;
        double zf = 0.0;
        double zz = 0.0;
        double zo = 0.0;
        for (int trial = 0; trial < kTrials; ++trial) {
            const ModelInput input
                = threeShots(200e3, 0.03, 1e6, 0.01, static_cast<std::uint64_t>(100 + trial));
            const auto hankel = decomposeHankel(input, {});
            const auto result = testing::realizeModel(input, *hankel, 2);
            QVERIFY(result.has_value() && result->model.refined);
            const Pole &pole = *result->main();
            zf += std::pow((pole.frequency_Hz - 200e3) / pole.u_frequency_Hz, 2) / kTrials;
            zz += std::pow((pole.dampingRatio - 0.03) / pole.u_dampingRatio, 2) / kTrials;
            const SeriesFit &first = result->model.series.front();
            zo += std::pow((first.onset_s + 0.25e-6) / first.u_onset_s, 2) / kTrials;
        }
        qInfo("mean square of error over u: f0 %.2f, zeta %.2f, onset %.2f", zf, zz, zo);
        for (const double z : {zf, zz, zo})
            QVERIFY2(z > 0.3 && z < 1.95, qPrintable(QString::number(z)));
    }

    void suggestion_isTheTrueOrder_inNoise()
    {
        int right = 0;
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            const ModelInput input = threeShots(30e3, 0.05, 1e6, 0.01, seed);
            const auto hankel = decomposeHankel(input, {});
            right += suggestOrder(input, *hankel).order == 2;
        }
        qInfo("%d of 30 right", right);
        QVERIFY(right >= 28);
    }

    void order_outsideTheData_isRefused()
    {
        const ModelInput input = threeShots(200e3, 0.03, 1e6, 0.01, 1);
        const auto hankel = decomposeHankel(input, {});
        for (const Index order : {Index(0), Index(-3), Index(121), Index(100000)}) {
            const auto model = fitModel(input, *hankel, order, {}, {});
            QVERIFY(!model.has_value());
            QCOMPARE(model.error().kind, ErrorKind::Usage);
            QVERIFY(english(model.error().message).find("1 to 120") != std::string::npos);
        }
    }

    void order100_neitherCrashesNorPrintsNonsense()
    {
        const ModelInput input = threeShots(318e3, 0.02, 1e6, 0.05, 4);
        const auto hankel = decomposeHankel(input, {});
        for (const Index order : {Index(1), Index(3), Index(50), Index(100), Index(120)}) {
            const auto result = testing::realizeModel(input, *hankel, order);
            QVERIFY(result.has_value());
            const SensorModel &model = result->model;
            QCOMPARE(Index(model.poles.size()), order);
            QCOMPARE(Index(result->assessment.poles.size()), order);
            if (!model.diverges) {
                QVERIFY(std::isfinite(model.fit_percent));
                QVERIFY(model.fit_percent <= 100.0);
            }
        }
    }

    void splitPair_isSaid()
    {
        ModelInput input = threeShots(200e3, 0.002, 1e6, 1e-4, 4);
        input.treatment = ResponseTreatment::StepAsImpulse;
        input.series.resize(1);
        const auto hankel = decomposeHankel(input, {});
        const auto model = fitModel(input, *hankel, 2, {}, {});
        QVERIFY(hasFinding(model->findings, "ORD-001"));
        QVERIFY(!hasFinding(fitModel(input, *hankel, 3, {}, {})->findings, "ORD-001"));
    }

    void ordersAboveTheNoise_areSaid()
    {
        const ModelInput input = threeShots(200e3, 0.03, 1e6, 0.01, 4);
        const auto hankel = decomposeHankel(input, {});
        QVERIFY(hankel->singularValues[1] > hankel->noiseFloor_p95);
        QVERIFY(hankel->singularValues[2] < hankel->noiseFloor_p95 * 1.3);
        QVERIFY(hasFinding(fitModel(input, *hankel, 60, {}, {})->findings, "ORD-003"));
        QVERIFY(!hasFinding(fitModel(input, *hankel, 2, {}, {})->findings, "ORD-003"));
    }

    void missingFastPart_isSaid()
    {
        // A real pole that has decayed before the input starts leaves a model that begins with a
        // jump.
        Eigen::VectorXd y = testing::sampledStep(20e3, 0.3, 1e6, 400, 40.0);
        const ModelInput input = testing::makeInput(
            ResponseTreatment::StepDeflated, 1e6, {testing::makeSeries(1, y.array() + 0.5, 1e6)});
        const auto hankel = decomposeHankel(input, {});
        const auto model = fitModel(input, *hankel, 2, {}, {});
        QVERIFY(hasFinding(model->findings, "MOD-009"));
    }

    void refinement_giveUp_keepsTheRealization()
    {
        // Pure noise has no decaying pole to converge to; whatever happens must stay finite.
        testing::Noise noise(2);
        const ModelInput input = testing::makeInput(ResponseTreatment::StepDeflated, 1.0,
            {testing::makeSeries(1, noise.series(200, 1.0), 1.0, noise.series(1000, 1.0))});
        const auto hankel = decomposeHankel(input, {});
        for (Index order = 1; order <= 12; ++order) {
            const auto result = testing::realizeModel(input, *hankel, order);
            QVERIFY(result.has_value());
            for (const Pole &pole : result->assessment.poles)
                QVERIFY(std::isfinite(pole.frequency_Hz) && std::isfinite(pole.dampingRatio));
        }
    }

    void rows_thatDoNotFit_areRefused()
    {
        const ModelInput input = threeShots(200e3, 0.03, 1e6, 0.01, 1);
        RealizationSettings settings;
        settings.rows = Index(399);
        const auto hankel = decomposeHankel(input, settings);
        QVERIFY(!hankel.has_value());
        QVERIFY(english(hankel.error().message).find("2 to 398") != std::string::npos);
    }
};

DYNCAL_TEST(TestSensorModel)
#include "tst_sensor_model.moc"
