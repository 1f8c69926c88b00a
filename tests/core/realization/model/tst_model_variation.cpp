// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Propagation through moved models: where a formula is known (poles, level, onset) it gives the
// same uncertainty.

#include "core/realization/model/model_variation.h"
#include "core/realization/refinement/pole_uncertainty.h"
#include "tests/support/damped_shots.h"
#include "tests/support/near.h"
#include "tests/support/realized_model.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <functional>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr double kF0_Hz = 318e3;

SensorModel modelOf(const ModelInput &input, Index order)
{
    const auto hankel = decomposeHankel(input, {});
    return testing::realizeModel(input, *hankel, order)->model;
}

double propagated(const std::vector<ModelVariation> &variations,
    const std::function<double(const SensorModel &)> &value)
{
    double sum = 0.0;
    for (const ModelVariation &one : variations)
        sum += std::pow((value(one.up) - value(one.down)) / (2.0 * kVariation), 2);
    return std::sqrt(sum);
}

double lagged(double t_s)
{
    return t_s > 0.0 ? -std::expm1(-t_s / 0.5e-3) : 0.0;
}

} // namespace

class TestModelVariation : public QObject
{
    Q_OBJECT

private slots:
    void poles_haveTheUncertaintyOfTheirCovariance_data()
    {
        QTest::addColumn<double>("zeta");
        for (const double zeta : {0.02, 0.3, 1.1, 1.5})
            QTest::addRow("zeta %g", zeta) << zeta;
    }
    void poles_haveTheUncertaintyOfTheirCovariance()
    {
        QFETCH(double, zeta);
        const ModelInput input = testing::dampedShots(kF0_Hz, zeta, 3);
        const SensorModel model = modelOf(input, 2);
        QVERIFY(model.draft.refinement.has_value());
        const auto variations = modelVariations(input, model);
        for (Index i = 0; i < 2; ++i) {
            const PoleFigures figures = poleFigures(*model.draft.refinement, i);
            const auto at = static_cast<std::size_t>(i);
            const double u = propagated(variations, [&](const SensorModel &moved) {
                return std::abs(moved.poles[at].s_rad_s) / (2.0 * std::numbers::pi);
            });
            QVERIFY(isNear(u, figures.u_frequency_Hz, 1e-3));
        }
    }

    void levelAndOnset_haveTheirOwn()
    {
        const ModelInput input = testing::dampedShots(kF0_Hz, 0.05, 3);
        const SensorModel model = modelOf(input, 2);
        const auto variations = modelVariations(input, model);
        for (std::size_t r = 0; r < 3; ++r) {
            const SeriesFit &fit = model.series[r];
            QVERIFY(
                isNear(propagated(variations,
                           [&](const SensorModel &moved) { return moved.series[r].plateauGain; }),
                    fit.u_plateauGain, 1e-3));
            QVERIFY(isNear(propagated(variations,
                               [&](const SensorModel &moved) { return moved.series[r].onset_s; }),
                fit.u_onset_s, 1e-2));
        }
    }

    void levelBehindADrift_hasItsOwn()
    {
        const ModelInput input = testing::dampedShots(
            [](std::size_t, double t_s) {
                return testing::dampedStep(kF0_Hz, 0.05, t_s) * (1.0 - 0.05 * lagged(t_s));
            },
            2, {0.005, 0.0, 10e6, 4000});
        const SensorModel model = modelOf(input, 3);
        QCOMPARE(std::ssize(model.slowPoles), Index(1));
        const auto variations = modelVariations(input, model);
        for (std::size_t r = 0; r < 3; ++r)
            QVERIFY(isNear(propagated(variations,
                               [&](const SensorModel &moved) { return moved.series[r].level(); }),
                model.series[r].u_level(), 0.02));
    }

    void theMiddle_isTheModel()
    {
        const ModelInput input = testing::dampedShots(kF0_Hz, 0.05, 5);
        const SensorModel model = modelOf(input, 2);
        for (const ModelVariation &one : modelVariations(input, model)) {
            const Eigen::VectorXcd middle = 0.5 * (one.up.amplitudes + one.down.amplitudes);
            QVERIFY((middle - model.amplitudes).norm() < 1e-4 * model.amplitudes.norm());
            QVERIFY(isNear(0.5 * (one.up.level() + one.down.level()), model.level(), 1e-6));
        }
    }

    void withoutACovariance_thereAreNone()
    {
        ModelInput input = testing::dampedShots(kF0_Hz, 0.05, 5);
        SensorModel model = modelOf(input, 2);
        model.diverges = true;
        QVERIFY(modelVariations(input, model).empty());
        model.diverges = false;
        QVERIFY(!modelVariations(input, model).empty());
        input.treatment = ResponseTreatment::Impulse;
        QVERIFY(modelVariations(input, model).empty());
        input.treatment = ResponseTreatment::StepDeflated;
        model.draft.refinement.reset();
        QVERIFY(modelVariations(input, model).empty());
    }
};

DYNCAL_TEST(TestModelVariation)
#include "tst_model_variation.moc"
