// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/order_evidence.h"
#include "tests/support/model_inputs.h"

#include <QElapsedTimer>
#include <QTest>

using namespace dyncal;

namespace {

ModelInput threeShots(Index samples, double noise, std::uint64_t seed)
{
    testing::Noise source(seed);
    std::vector<ModelSeries> series;
    for (Index shot = 1; shot <= 3; ++shot) {
        const double first = 0.25 * static_cast<double>(shot);
        const Eigen::VectorXd y
            = testing::sampledStep(30e3, 0.05, 1e6, samples, first) + source.series(samples, noise);
        series.push_back(testing::makeSeries(shot, y, 1e6, source.series(6000, noise)));
    }
    return testing::makeInput(ResponseTreatment::StepDeflated, 1e6, std::move(series));
}

} // namespace

class TestOrderEvidence : public QObject
{
    Q_OBJECT

private slots:
    void duration()
    {
        for (const Index samples : {400, 1000, 4000}) {
            const ModelInput input = threeShots(samples, 0.01, 1);
            QElapsedTimer timer;
            timer.start();
            const auto hankel = decomposeHankel(input, {});
            const double decomposition = double(timer.nsecsElapsed()) * 1e-6;
            timer.restart();
            const auto suggestion = suggestOrder(input, *hankel);
            const double suggest = double(timer.nsecsElapsed()) * 1e-6;
            timer.restart();
            const auto evidence = gatherOrderEvidence(input, *hankel, suggestion, {});
            qInfo("%td: decomposition %.0f ms, suggestion %.0f ms, evidence %.0f ms", samples,
                decomposition, suggest, double(timer.nsecsElapsed()) * 1e-6);
            QVERIFY(evidence.has_value());
            QVERIFY(!evidence->words.empty());
        }
    }
};

QTEST_APPLESS_MAIN(TestOrderEvidence)
#include "tst_order_evidence.moc"
