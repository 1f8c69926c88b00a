// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Monte Carlo of the whole chain on the simulated example.

#include "core/monte_carlo/chain_monte_carlo.h"
#include "tests/support/calibrated_chain.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::CalibratedChain;
using testing::isNear;

namespace {

UncertaintySettings trials(Index count)
{
    UncertaintySettings settings;
    settings.monteCarloTrials = count;
    return settings;
}

/// Everything normal and small: the chain is linear. The front is stated to be sharp.
Recipe linearRecipe()
{
    Recipe recipe;
    recipe.uncertainty.budget = {{"p1_pa", 50.0}, {"t1_k", 0.2}, {"gain_relative", 0.001},
        {"linearity_relative", 0.0005}, {"clock_relative", 1e-6}, {"mounting_relative", 0.001}};
    recipe.shock.frontDuration_s = 1e-12;
    recipe.shock.attenuation_per_m = {0.0, 1e-4};
    return recipe;
}

} // namespace

class TestChainMonteCarlo : public QObject
{
    Q_OBJECT

private:
    std::optional<CalibratedChain> m_chain;
    std::optional<ChainMonteCarlo> m_drawn;

private slots:
    void initTestCase()
    {
        m_chain.emplace();
        m_drawn = *chainMonteCarlo(m_chain->subject(), trials(10000));
    }

    void numberAndSeed_areStated()
    {
        QCOMPARE(m_drawn->trials, Index(10000));
        QCOMPARE(m_drawn->seed, Index(1));
        QVERIFY(!m_drawn->isAdaptive);
        QCOMPARE(m_drawn->refits.refits, Index(0));
        QVERIFY(m_drawn->find("sensitivity") && !m_drawn->find("nothing"));
    }

    /// u by trials is u of the budget where the first order holds: the sensitivity, f0 and damping.
    void u_isThatOfTheBudget()
    {
        for (const char *of : {"sensitivity", "sensitivity.per_level[1]", "shots[0].sensitivity",
                 "f0_hz", "damping_ratio", "q"}) {
            const DrawnValue *one = m_drawn->find(of);
            QVERIFY2(one, of);
            qInfo("%s: u %.4g by trials, %.4g by the budget", of, one->drawn.u, one->gum.u);
            QVERIFY2(isNear(one->drawn.u, one->gum.u, 0.03), of);
            QCOMPARE(one->value, (one->gum.low + one->gum.high) / 2.0);
        }
    }

    /// f0 has the clock's rectangle for nearly all of its u: 95 % lie within 1.645 u, not 1.96.
    void f0_hasTheClocksShape()
    {
        Recipe recipe;
        recipe.uncertainty.budget = {{"clock_relative", 1e-3, "rectangular"}};
        const CalibratedChain chain(recipe);
        const ChainMonteCarlo drawn = *chainMonteCarlo(chain.subject(), trials(2000));
        const DrawnValue &f0 = *drawn.find("f0_hz");
        QVERIFY(isNear(f0.drawn.expanded, std::sqrt(3.0) * 0.95 * 1e-3 * f0.value, 0.02));
        QVERIFY(!f0.gum.validated);
        QCOMPARE(sizeOfGum(f0.gum, f0.drawn), 1);
    }

    /// No front makes the resonance lower than a sharp one shows it: the unknown front is
    /// one-sided.
    void unknownFront_isOneSided()
    {
        const DrawnValue &gain = *m_drawn->find("resonance_gain");
        QVERIFY(gain.drawn.low > gain.value - 0.1 * (gain.drawn.high - gain.value));
        QVERIFY(gain.drawn.mean > gain.value);
    }

    void rows_areDrawn()
    {
        const ResponseResult &response = *m_chain->results.response;
        QCOMPARE(std::ssize(m_drawn->rows), Index(response.frequency_Hz.size()));
        QCOMPARE(std::ssize(m_drawn->rowsAtMarks), Index(response.atMarks->frequency_Hz.size()));
        const DrawnRow &row = m_drawn->rows[3];
        QVERIFY(row.withMagnitude && row.withPhase);
        QVERIFY(isNear(row.magnitude.u, row.gumMagnitude.u, 0.05));
        QVERIFY(isNear(row.phase.u, row.gumPhase.u, 0.05));
    }

    /// A row shares what the sensitivity has but the noise of the levels, which is small.
    void rows_haveTheErrorsOfTheStep()
    {
        const DrawnValue &S = *m_drawn->find("sensitivity");
        const DrawnRow &row = m_drawn->rows[3];
        QVERIFY(isNear(row.magnitude.u / row.magnitude.mean, S.drawn.u / S.drawn.mean, 0.02));
    }

    void sameSeed_sameBytes()
    {
        const auto small = [&](Index seed) {
            UncertaintySettings settings = trials(200);
            settings.seed = seed;
            return *chainMonteCarlo(m_chain->subject(), settings);
        };
        const ChainMonteCarlo a = small(4), b = small(4), c = small(5);
        for (std::size_t i = 0; i < a.values.size(); ++i) {
            QCOMPARE(a.values[i].drawn.u, b.values[i].drawn.u);
            QVERIFY(a.values[i].drawn.u != c.values[i].drawn.u);
        }
        QCOMPARE(a.rows[2].magnitude.high, b.rows[2].magnitude.high);
    }

    void adaptive_goesOnUntilItIsStable()
    {
        const CalibratedChain linear(linearRecipe());
        ChainSubject subject = linear.subject();
        UncertaintyReport report = *linear.results.uncertainty;
        report.ofModel.clear(); // quick: the sensitivities alone
        ChainSubject quick{subject.input, subject.model, subject.assessment, subject.response,
            subject.shock, report, subject.stated};
        const ChainMonteCarlo drawn = *chainMonteCarlo(quick, trials(0));
        QVERIFY(drawn.isAdaptive);
        QVERIFY(drawn.trials >= 20000 && drawn.trials <= 200000 && drawn.trials % 10000 == 0);
        QVERIFY(drawn.isStable || drawn.trials == 200000);
    }

    /// Where all is nearly linear and normal both propagations agree (JCGM 101, 8).
    void linearChain_isValidated()
    {
        const CalibratedChain linear(linearRecipe());
        const ChainMonteCarlo drawn = *chainMonteCarlo(linear.subject(), trials(20000));
        for (const DrawnValue &one : drawn.values) {
            qInfo("%s: U %.4g by trials, %.4g by the budget", one.of.c_str(), one.drawn.expanded,
                one.gum.expanded());
            QVERIFY2(isNear(one.drawn.expanded, one.gum.expanded(), 0.05), one.of.c_str());
            // It goes with the logarithm of the ringing: the least linear of all.
            QVERIFY2(one.gum.validated || one.of == "settling_time_s", one.of.c_str());
        }
    }

    void correlation_isKept()
    {
        const auto u = [](double r) {
            Recipe recipe = linearRecipe();
            recipe.uncertainty.budget[0].u = 2000.0; // p1 counts
            recipe.uncertainty.budget[2].u = 0.02;
            recipe.uncertainty.correlations = {{"p1_pa", "gain_relative", r}};
            const CalibratedChain chain(recipe);
            const ChainMonteCarlo drawn = *chainMonteCarlo(chain.subject(), trials(4000));
            const DrawnValue &S = *drawn.find("sensitivity");
            return std::pair(S.drawn.u, S.gum.u);
        };
        const auto [drawnUp, gumUp] = u(0.9);
        const auto [drawnDown, gumDown] = u(-0.9);
        QVERIFY(std::abs(gumUp / gumDown - 1.0) > 0.2);
        QVERIFY(isNear(drawnUp, gumUp, 0.06) && isNear(drawnDown, gumDown, 0.06));
    }

    void settingsWithoutSense_areRefused()
    {
        for (const Index count : {Index(5), Index(2000000)}) {
            const auto refused = chainMonteCarlo(m_chain->subject(), trials(count));
            QVERIFY(!refused);
            QCOMPARE(refused.error().kind, ErrorKind::Usage);
        }
        UncertaintySettings settings = trials(200);
        settings.coverage = 1.5;
        QVERIFY(!chainMonteCarlo(m_chain->subject(), settings));
    }

    void stopped_isCancelled_withoutAPartialResult()
    {
        std::stop_source stop;
        Index reports = 0;
        const JobControl control{stop.get_token(), [&](double) {
                                     if (++reports == 3)
                                         stop.request_stop();
                                 }};
        const auto drawn = chainMonteCarlo(m_chain->subject(), trials(10000), {}, control);
        QVERIFY(!drawn);
        QCOMPARE(drawn.error().kind, ErrorKind::Cancelled);
    }

    /// A humidity of any value takes the step beyond nothing: trials whose step leaves the range of
    /// the relations leave no interval, and no finding passes one off.
    void trialsOutsideTheRelations_areCounted()
    {
        Recipe recipe;
        recipe.uncertainty.budget = {{"t1_k", 120.0}};
        const CalibratedChain chain(recipe);
        const auto drawn = chainMonteCarlo(chain.subject(), trials(1000));
        QVERIFY(drawn.has_value());
        const DrawnValue *S = drawn->find("sensitivity");
        QVERIFY(S != nullptr);
        QVERIFY(S->drawn.undefined > 0);
        QVERIFY(std::isnan(S->drawn.u) && !S->gum.validated);
    }

    void freeDecay_andBareModel_haveNoTrials()
    {
        UncertaintyReport empty;
        const ChainSubject subject = m_chain->subject();
        SensorModel bare = subject.model;
        bare.draft.refinement.reset();
        ResponseResult nothing = subject.response;
        nothing.magnitude.resize(0);
        nothing.atMarks.reset();
        const ChainMonteCarlo drawn
            = *chainMonteCarlo({subject.input, bare, subject.assessment, nothing, subject.shock,
                                   empty, subject.stated},
                trials(200));
        QCOMPARE(drawn.trials, Index(0));
        QVERIFY(drawn.values.empty() && !drawn.isValidated() && drawn.findings.empty());
    }
};

DYNCAL_TEST(TestChainMonteCarlo)
#include "tst_chain_monte_carlo.moc"
