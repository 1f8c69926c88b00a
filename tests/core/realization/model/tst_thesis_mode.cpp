// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The thesis's own algorithm (appendix D) against numbers computed from its printed statements in
// Octave and numpy (docs/method/hankel.md, table "thesis mode").

#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/hankel/realized_poles.h"
#include "core/realization/model/model_fit.h"
#include "core/realization/model/sensor_model.h"
#include "tests/support/measured_data.h"
#include "tests/support/model_inputs.h"
#include "tests/support/realized_model.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

constexpr double kSingularValue = 1e-9; ///< relative, above 1e-12 of the first
constexpr double kPole = 1e-9; ///< the oracle prints ten digits
constexpr double kFit = 1e-6; ///< percent points; the oracle prints eight decimals

struct Case
{
    Eigen::VectorXd y;
    Index order;
    std::vector<double> sigma;
    std::vector<std::complex<double>> poles;
    double fitListing;
    double fitAligned;
};

Eigen::VectorXd impulseSeries()
{
    const double w0 = 2.0 * std::numbers::pi * 30e3;
    const double zeta = 0.05;
    const double wd = w0 * std::sqrt(1.0 - zeta * zeta);
    Eigen::VectorXd y(400);
    for (Index k = 0; k < 400; ++k) {
        const double t = static_cast<double>(k + 1) * 1e-6;
        y[k] = 1e-6 * w0 * w0 / wd * std::exp(-zeta * w0 * t) * std::sin(wd * t);
    }
    return y;
}

std::vector<std::complex<double>> withPair(double re, double im, std::vector<double> real)
{
    std::vector<std::complex<double>> poles{{re, im}, {re, -im}};
    for (const double p : real)
        poles.emplace_back(p, 0.0);
    return poles;
}

double relative(double a, double b)
{
    return std::abs(a - b) / std::abs(b);
}

void verify(const Case &c)
{
    const ModelInput input = testing::makeInput(
        ResponseTreatment::StepAsImpulse, 1e6, {testing::makeSeries(1, c.y, 1e6)});
    const auto hankel = decomposeHankel(input, {});
    QVERIFY(hankel.has_value());
    QCOMPARE(hankel->rows, Index(199));
    QCOMPARE(hankel->columns, Index(199));
    for (std::size_t i = 0; i < c.sigma.size(); ++i) {
        const double found = hankel->singularValues[static_cast<Index>(i)];
        QVERIFY2(relative(found, c.sigma[i]) < kSingularValue,
            qPrintable(QString("sigma %1: %2").arg(i + 1).arg(found, 0, 'g', 14)));
    }
    const auto model = fitModel(input, *hankel, c.order, {}, {});
    QVERIFY(model.has_value());
    const auto found = realizedPoles(*hankel, c.order);
    for (const std::complex<double> &expected : c.poles) {
        double nearest = 1.0;
        for (const std::complex<double> &z : found)
            nearest = std::min(nearest, std::abs(z - expected));
        QVERIFY2(nearest < kPole, qPrintable(QString::number(nearest)));
    }
    QVERIFY2(std::abs(*model->fitListing_percent - c.fitListing) < kFit,
        qPrintable(QString::number(*model->fitListing_percent, 'g', 12)));
    QVERIFY2(std::abs(model->fit_percent - c.fitAligned) < kFit,
        qPrintable(QString::number(model->fit_percent, 'g', 12)));
    QCOMPARE(model->stateSpace.D(0, 0), 0.0);
    QCOMPARE(model->stateSpace.order(), c.order);
}

} // namespace

class TestThesisMode : public QObject
{
    Q_OBJECT

private slots:
    void impulse_order2()
    {
        verify({impulseSeries(), 2, {5.134922909707, 4.642215237670},
            withPair(0.9731166382, 0.1853941599, {}), 81.15496884, 100.0});
    }
    void step_order3_keepsThePairAndTheStep()
    {
        verify({testing::sampledStep(30e3, 0.05, 1e6, 400), 3,
            {199.1180283924, 26.01764914415, 25.66825295389},
            withPair(0.9731166382, 0.1853941599, {1.0}), 81.09440329, 100.0});
    }
    void step_order2_losesThePair()
    {
        verify({testing::sampledStep(30e3, 0.05, 1e6, 400), 2, {199.1180283924},
            {0.9644584338, 0.9993280673}, -23.61320720, -22.12321568});
    }
    void piezo_order2_putsAPoleOnTheNegativeAxis()
    {
        verify({testing::sampledStep(318e3, 0.02, 1e6, 400), 2,
            {199.0018320076, 6.250158103723, 6.247317394522}, {-0.4361941026, 0.9999820078},
            -18.75110260, -0.64796417});
    }
    void piezo_order3()
    {
        verify({testing::sampledStep(318e3, 0.02, 1e6, 400), 3, {199.0018320076},
            withPair(-0.3977936781, 0.8746133053, {1.0}), -75.20116714, 100.0});
    }
    void optic2_order3()
    {
        verify({testing::sampledStep(3.11e6, 0.02, 10e6, 400), 3,
            {199.0018860660, 6.392030556520, 6.387844400286},
            withPair(-0.3592776232, 0.8920389121, {1.0}), -72.51504078, 100.0});
    }

    void recordedSeries_agree()
    {
        const auto folder = testing::dataFolder() / "synthetic";
        if (!testing::textColumn(folder / "syn_imp2.csv", 0))
            DYNCAL_SKIP_WITHOUT_DATA(
                "The folder of measured data is missing: 0 of 4 series covered.");
        const auto read = [&](const char *name) { return *testing::textColumn(folder / name, 0); };
        verify({read("syn_imp2.csv"), 2, {5.134922909707, 4.642215237670},
            withPair(0.9731166382, 0.1853941599, {}), 81.15496884, 100.0});
        verify({read("syn_step2.csv"), 3, {199.1180283924, 26.01764914415, 25.66825295389},
            withPair(0.9731166382, 0.1853941599, {1.0}), 81.09440329, 100.0});
        verify({read("syn_step3.csv"), 4,
            {198.6937935629, 20.83344781999, 20.40542558763, 1.439464842220},
            withPair(0.9731166382, 0.1853941599, {0.9509769233, 1.0}), 81.26225426, 100.0});
        verify({read("syn_piezo318k.csv"), 3, {199.0018320076},
            withPair(-0.3977936781, 0.8746133053, {1.0}), -75.20116714, 100.0});
        qInfo("4 of 4 series covered");
    }

    /// As a window may hold them for a moment, when the treatment was changed.
    void decompositionOfAnotherTreatment_isRefused()
    {
        const Eigen::VectorXd y = testing::sampledStep(30e3, 0.05, 1e6, 400);
        const auto inputOf = [&](ResponseTreatment treatment) {
            return testing::makeInput(treatment, 1e6, {testing::makeSeries(1, y, 1e6)});
        };
        const ModelInput thesis = inputOf(ResponseTreatment::StepAsImpulse);
        const ModelInput step = inputOf(ResponseTreatment::StepDeflated);
        QVERIFY(fitModel(thesis, *decomposeHankel(thesis, {}), 3, {}, {}));
        QVERIFY(fitModel(step, *decomposeHankel(step, {}), 2, {}, {}));
        for (const auto &model : {fitModel(thesis, *decomposeHankel(step, {}), 2, {}, {}),
                 fitModel(step, *decomposeHankel(thesis, {}), 3, {}, {})}) {
            QVERIFY(!model);
            QCOMPARE(model.error().kind, ErrorKind::Usage);
        }
    }

    void stepPole_isClassedAndNotCounted()
    {
        const Eigen::VectorXd y = testing::sampledStep(30e3, 0.05, 1e6, 400);
        const ModelInput input = testing::makeInput(
            ResponseTreatment::StepAsImpulse, 1e6, {testing::makeSeries(1, y, 1e6)});
        const auto hankel = decomposeHankel(input, {});
        const auto model = fitModel(input, *hankel, 3, {}, {});
        QVERIFY(model.has_value());
        QCOMPARE(model->poles.size(), std::size_t(3));
        QCOMPARE(model->poles.back().poleClass, PoleClass::Step);
        QCOMPARE(model->poles.front().poleClass, PoleClass::Sensor);
        QVERIFY(std::abs(model->poles.front().frequency_Hz - 30e3) < 1e-4);
        QVERIFY(std::abs(model->poles.front().dampingRatio - 0.05) < 1e-9);
        // c0 is the plateau of the sensor, whatever the listing's own matrices say.
        QVERIFY(std::abs(model->plateauGain - 1.0) < 1e-9);
    }

    void order100_ofNoisyData_printsNoNonsense()
    {
        testing::Noise noise(5);
        const Eigen::VectorXd y
            = testing::sampledStep(318e3, 0.02, 1e6, 400) + noise.series(400, 0.05);
        const ModelInput input = testing::makeInput(ResponseTreatment::StepAsImpulse, 1e6,
            {testing::makeSeries(1, y, 1e6, noise.series(2000, 0.05))});
        const auto hankel = decomposeHankel(input, {});
        const auto result = testing::realizeModel(input, *hankel, 100);
        QVERIFY(result.has_value());
        QVERIFY(result->model.diverges || std::isfinite(result->model.fit_percent));
    }
};

DYNCAL_TEST(TestThesisMode)
#include "tst_thesis_mode.moc"
