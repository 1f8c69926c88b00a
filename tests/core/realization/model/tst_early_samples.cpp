// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether the beginning of the records fits the rest.

#include "core/realization/model/early_samples.h"
#include "tests/support/damped_shots.h"
#include "tests/support/ramp_response.h"
#include "tests/support/realized_model.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QTest>

#include <algorithm>

using namespace dyncal;

namespace {

constexpr testing::DampedShots kFast{0.003, 0.0, 50e6, 600, 2000};

/// Records that begin a quarter of the front after it begins, as they are detected.
ModelInput behindFront(double f0_Hz, double zeta, double front_s, std::uint64_t seed)
{
    return testing::dampedShots(
        [=](std::size_t, double t_s) {
            return front_s > 0.0 ? testing::rampResponse(f0_Hz, zeta, front_s, t_s - 0.25 * front_s)
                                 : testing::dampedStep(f0_Hz, zeta, t_s);
        },
        seed, kFast);
}

bool isTold(const ModelInput &input)
{
    const auto hankel = decomposeHankel(input, {});
    const auto result = testing::realizeModel(input, *hankel, 2);
    return result && std::ranges::any_of(result->assessment.findings, [](const Finding &finding) {
        return finding.id == "MOD-017"
            && finding.causes == std::vector{FindingCause::Front, FindingCause::Order};
    });
}

} // namespace

class TestEarlySamples : public QObject
{
    Q_OBJECT

private slots:
    void aFront_isTold()
    {
        for (std::uint64_t seed = 1; seed <= 10; ++seed)
            QVERIFY(isTold(behindFront(400e3, 0.7, 600e-9, seed)));
    }

    void aSharpStep_isNot_data()
    {
        QTest::addColumn<double>("zeta");
        for (const double zeta : {0.02, 0.3, 0.7})
            QTest::addRow("zeta %g", zeta) << zeta;
    }
    /// One of 1e4 by chance.
    void aSharpStep_isNot()
    {
        QFETCH(double, zeta);
        const int runs = trials::count(40, 1000);
        int told = 0;
        for (int seed = 1; seed <= runs; ++seed)
            told += isTold(behindFront(400e3, zeta, 0.0, static_cast<std::uint64_t>(seed)));
        QVERIFY2(told <= (runs == 40 ? 0 : 2), qPrintable(QString::number(told)));
    }

    void aStatedFront_isNoNews()
    {
        ModelInput input = behindFront(400e3, 0.7, 600e-9, 1);
        const auto hankel = decomposeHankel(input, {});
        const auto result = testing::realizeModel(input, *hankel, 2);
        QVERIFY(!judgeEarlySamples(input, result->model, result->assessment.poles).empty());
        input.front.duration_s = 600e-9;
        QVERIFY(judgeEarlySamples(input, result->model, result->assessment.poles).empty());
    }

    void withoutAPair_nothingIsAsked()
    {
        const ModelInput input = testing::dampedShots(318e3, 1.5, 1);
        const auto hankel = decomposeHankel(input, {});
        const auto result = testing::realizeModel(input, *hankel, 2);
        QVERIFY(judgeEarlySamples(input, result->model, result->assessment.poles).empty());
        RealizationSettings settings;
        settings.refine = false;
        const ModelInput front = behindFront(400e3, 0.7, 600e-9, 1);
        const auto decomposed = decomposeHankel(front, settings);
        const auto plain = testing::realizeModel(front, *decomposed, 2, settings);
        QVERIFY(judgeEarlySamples(front, plain->model, plain->assessment.poles).empty());
    }

    void usedBehind_cutsTheBeginning()
    {
        RefinementRecord record;
        record.rate_Hz = 1e6;
        record.y = Eigen::VectorXd::Zero(100);
        QCOMPARE(usedBehind(record, 9.5e-6).front().begin, Index(10));
        QCOMPARE(usedBehind(record, 9.5e-6).front().end, Index(100));
        record.used = {{0, 5}, {8, 20}, {30, 40}};
        const auto used = usedBehind(record, 9.5e-6);
        QCOMPARE(used.size(), std::size_t(2));
        QCOMPARE(used.front().begin, Index(10));
        QVERIFY(usedBehind(record, 1.0).empty());
    }
};

DYNCAL_TEST(TestEarlySamples)
#include "tst_early_samples.moc"
