// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Trials of the whole chain: the same bytes however they are split, and what they are made of.

#include "core/base/allowed_threads.h"
#include "core/monte_carlo/trial_blocks.h"
#include "tests/support/calibrated_chain.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
#include <QTest>

#include <cmath>
#include <stop_token>
#include <thread>

using namespace dyncal;
using testing::isNear;

namespace {

bool areSame(const TrialBlock &a, const TrialBlock &b)
{
    return a.begin == b.begin && a.values == b.values && a.common == b.common
        && a.front_s == b.front_s && a.drift == b.drift;
}

} // namespace

class TestTrialBlocks : public QObject
{
    Q_OBJECT

private:
    std::optional<testing::CalibratedChain> m_chain;
    std::optional<TrialPlan> m_plan;

    TrialBlock split(Index count, Index blocks) const
    {
        std::vector<TrialBlock> list;
        for (Index i = 0; i < blocks; ++i) {
            const Index begin = count * i / blocks;
            list.push_back(*runTrials(*m_plan, begin, count * (i + 1) / blocks - begin));
        }
        return *mergedBlocks(list);
    }

    Eigen::VectorXd column(const TrialBlock &block, const std::string &of) const
    {
        for (std::size_t i = 0; i < m_plan->quantities.size(); ++i)
            if (m_plan->quantities[i].of == of)
                return block.values.col(static_cast<Index>(i));
        return {};
    }

private slots:
    void initTestCase()
    {
        m_chain.emplace();
        QVERIFY(m_chain->results.uncertainty);
        m_plan.emplace(trialPlan(m_chain->subject(), 7));
    }

    void plan_hasEveryValueWithAnUncertainty()
    {
        QStringList names;
        for (const TrialQuantity &quantity : m_plan->quantities)
            names << QString::fromStdString(quantity.of);
        for (const char *of : {"sensitivity", "sensitivity.per_level[0]", "shots[2].sensitivity",
                 "f0_hz", "damping_ratio", "q", "resonance_gain", "settling_time_s"})
            QVERIFY2(names.contains(of), of);
        for (const TrialQuantity &quantity : m_plan->quantities)
            QVERIFY(quantity.reported.u && *quantity.reported.u > 0.0);
    }

    void anySplit_hasTheSameBytes()
    {
        const TrialBlock whole = split(301, 1);
        QVERIFY(areSame(whole, split(301, 2)));
        QVERIFY(areSame(whole, split(301, 7)));
        const TrialBlock part = *runTrials(*m_plan, 100, 50);
        QCOMPARE(part.begin, Index(100));
        QVERIFY(part.values == whole.values.middleRows(100, 50));
    }

    void seed_makesOthers()
    {
        TrialPlan other = *m_plan;
        other.seed = 8;
        QVERIFY(!areSame(*runTrials(*m_plan, 0, 20), *runTrials(other, 0, 20)));
    }

    void blocksThatDoNotFollow_areRefused()
    {
        const TrialBlock first = *runTrials(*m_plan, 0, 10);
        const TrialBlock third = *runTrials(*m_plan, 20, 10);
        const auto gap = mergedBlocks({first, third});
        QVERIFY(!gap);
        QCOMPARE(gap.error().kind, ErrorKind::Usage);
        QVERIFY(english(gap.error().message).find("begins with trial 20, expected is 10")
            != std::string::npos);
        QVERIFY(!mergedBlocks({third, first}));
        TrialBlock narrow = *runTrials(*m_plan, 10, 10);
        narrow.values.conservativeResize(Eigen::NoChange, 1);
        QVERIFY(!mergedBlocks({first, narrow}));
        QCOMPARE(mergedBlocks({})->count(), Index(0));
    }

    /// f0, damping and Q of one trial belong to one model.
    void quantitiesOfATrial_belongTogether()
    {
        const TrialBlock block = *runTrials(*m_plan, 0, 50);
        const Eigen::VectorXd zeta = column(block, "damping_ratio"), q = column(block, "q");
        for (Index i = 0; i < zeta.size(); ++i)
            QVERIFY(isNear(q[i], 0.5 / zeta[i]));
        const Eigen::VectorXd mean = column(block, "sensitivity");
        const Eigen::VectorXd low = column(block, "shots[0].sensitivity");
        const Eigen::VectorXd level = column(block, "sensitivity.per_level[0]");
        QVERIFY(level.isApprox(low, 1e-12)); // one shot of that level
        QVERIFY(!mean.isApprox(low, 1e-6));
    }

    /// The front lies between nothing and the longest that nobody states, evenly.
    void unknownFront_isARectangle()
    {
        const TrialBlock block = *runTrials(*m_plan, 0, 2000);
        QVERIFY(block.front_s.minCoeff() >= 0.0 && block.front_s.maxCoeff() <= 100e-9);
        QVERIFY(isNear(block.front_s.mean(), 50e-9, 0.04));
        QVERIFY(std::abs(block.drift.mean()) < 0.1);
    }

    void stopped_isCancelled_within100ms()
    {
        std::stop_source stop;
        QElapsedTimer timer;
        std::jthread stopper([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            timer.start();
            stop.request_stop();
        });
        const auto block = runTrials(*m_plan, 0, 1000000, {stop.get_token(), {}});
        const qint64 late_ms = timer.elapsed();
        QVERIFY(!block);
        QCOMPARE(block.error().kind, ErrorKind::Cancelled);
        QVERIFY2(late_ms < 300, qPrintable(QString::number(late_ms))); // 100 ms, threefold slack
    }

    /// Last: from here on this process has one thread.
    void oneThread_hasTheSameBytes()
    {
        const TrialBlock before = split(301, 2);
        useOneThread();
        QVERIFY(areSame(before, split(301, 2)));
    }
};

DYNCAL_TEST(TestTrialBlocks)
#include "tst_trial_blocks.moc"
