// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether the beginning of the records fits the rest.

#include "core/realization/model/early_samples.h"
#include "tests/support/front_shots.h"
#include "tests/support/realized_model.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace dyncal;

namespace {

/// Three decays of a sensor that a force of this duration (half a sine) has excited; the records
/// begin with it.
ModelInput decayBehindContact(double f0_Hz, double zeta, double contact_s, std::uint64_t seed)
{
    constexpr int kParts = 64;
    ModelInput input = testing::dampedShots(
        [=](std::size_t, double t_s) {
            const double w = 2.0 * std::numbers::pi * f0_Hz;
            double sum = 0.0;
            for (int i = 0; i < kParts; ++i) {
                const double share = (i + 0.5) / kParts;
                const double since_s = t_s - contact_s * share;
                if (since_s > 0.0)
                    sum += 0.5 * std::numbers::pi / kParts * std::sin(std::numbers::pi * share)
                        * std::exp(-zeta * w * since_s)
                        * std::sin(w * std::sqrt(1.0 - zeta * zeta) * since_s);
            }
            return sum;
        },
        seed, {0.003, 0.0, 1e6, 2000, 2000});
    input.treatment = ResponseTreatment::Impulse;
    return input;
}

bool isTold(const ModelInput &input)
{
    const auto hankel = decomposeHankel(input, {});
    const auto result = testing::realizeModel(input, *hankel, 2);
    if (!result)
        return false;
    const Findings findings = judgeEarlySamples(input, result->model, result->assessment.poles);
    return std::ranges::any_of(findings, [](const Finding &finding) {
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
            QVERIFY(isTold(testing::shotsBehindFront(400e3, 0.7, 600e-9, seed)));
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
        const int runs = trials::count(20, 1000);
        int told = 0;
        for (int seed = 1; seed <= runs; ++seed)
            told += isTold(
                testing::shotsBehindFront(400e3, zeta, 0.0, static_cast<std::uint64_t>(seed)));
        QVERIFY2(told <= (runs == 20 ? 0 : 2), qPrintable(QString::number(told)));
    }

    void aContact_isTold_data()
    {
        QTest::addColumn<double>("contact_us");
        QTest::addColumn<double>("zeta");
        QTest::addColumn<bool>("isTold");
        QTest::newRow("instant") << 0.0 << 0.02 << false;
        QTest::newRow("instant, damped") << 0.0 << 0.2 << false;
        QTest::newRow("10 us") << 10.0 << 0.02 << true;
        QTest::newRow("30 us") << 30.0 << 0.02 << true;
        QTest::newRow("30 us, weakly damped") << 30.0 << 0.005 << true;
    }
    /// 20 kHz at 1 MS/s: a half sine of force.
    void aContact_isTold()
    {
        QFETCH(double, contact_us);
        QFETCH(double, zeta);
        QFETCH(bool, isTold);
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            const ModelInput input = decayBehindContact(20e3, zeta, contact_us * 1e-6, seed);
            const auto hankel = decomposeHankel(input, {});
            const auto result = testing::realizeModel(input, *hankel, 2);
            const Findings findings
                = judgeEarlySamples(input, result->model, result->assessment.poles);
            QCOMPARE(!findings.empty(), isTold);
            QVERIFY(!isTold || findings[0].id == "MOD-020");
        }
    }

    void aStatedFront_isNoNews()
    {
        ModelInput input = testing::shotsBehindFront(400e3, 0.7, 600e-9, 1);
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
        const ModelInput front = testing::shotsBehindFront(400e3, 0.7, 600e-9, 1);
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
