// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/known_inputs.h"
#include "core/selftest/second_order_truth.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

class TestKnownInputs : public QObject
{
    Q_OBJECT

private slots:
    void series_isTakenAsItIs()
    {
        const Eigen::VectorXd y = SecondOrderTruth{30e3, 0.1}.sampled(kModelRate_Hz, 100, 0.5);
        const ModelInput input = inputOf(y, ResponseTreatment::Differenced);
        QCOMPARE(input.series.size(), std::size_t(1));
        QCOMPARE(input.series.front().y, y);
        QCOMPARE(input.series.front().fullRate, y);
        QCOMPARE(input.series.front().filter.taps.size(), Index(1));
        QCOMPARE(input.samples, Index(100));
        QCOMPARE(input.sampleRate_Hz, kModelRate_Hz);
        QCOMPARE(input.series.front().noiseSd, 0.0);
        QVERIFY(input.treatment == ResponseTreatment::Differenced);
    }

    void decomposition_hasTheSensorsTwo()
    {
        const Eigen::VectorXd y = SecondOrderTruth{30e3, 0.1}.sampled(kModelRate_Hz, 100, 0.5);
        const auto hankel = decomposed(inputOf(y, ResponseTreatment::StepDeflated));
        QVERIFY(hankel.has_value());
        QCOMPARE(hankel->rows, Index(49));
        QVERIFY(hankel->singularValues[2] < 1e-12 * hankel->singularValues[1]);
    }

    void model_isOfOrderTwo()
    {
        const SecondOrderTruth sensor{30e3, 0.1};
        const auto model = modelOf(
            inputOf(sensor.sampled(kModelRate_Hz, 200, 0.5), ResponseTreatment::StepDeflated));
        QVERIFY(model && model->order == 2);
        QVERIFY(std::abs(model->poles.front().s_rad_s - sensor.pole_rad_s()) < 1e-6 * sensor.f0_Hz);
    }

    /// Where nothing can be made of it the result is empty.
    void tooShort_isEmpty()
    {
        const ModelInput input = inputOf(Eigen::VectorXd::Ones(4), ResponseTreatment::StepDeflated);
        QVERIFY(!decomposed(input));
        QVERIFY(!modelOf(input));
    }
};

DYNCAL_TEST(TestKnownInputs)
#include "tst_known_inputs.moc"
