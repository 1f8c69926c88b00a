// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Progress of a run only rises and ends at 1, whatever the recipe and wherever the run ends.

#include "core/pipeline/pipeline.h"
#include "core/pipeline/stage_table.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

struct Watched
{
    std::vector<double> fractions;
    bool ended = false; ///< without an error

    bool onlyRises() const
    {
        return std::is_sorted(fractions.begin(), fractions.end(), std::less_equal<>());
    }
};

} // namespace

class TestProgress : public QObject
{
    Q_OBJECT

private:
    std::shared_ptr<const CaptureSet> m_example = testing::simulatedExample(5e6, 0.003);

    Watched watch(const Recipe &recipe, ResultCache &cache, StageId last = kLastStage) const
    {
        Watched watched;
        const JobControl control{
            {}, [&watched](double fraction) { watched.fractions.push_back(fraction); }};
        watched.ended = !runPipeline(m_example, recipe, cache, last, control).error;
        return watched;
    }

private slots:
    void everyRecipe_progressOnlyRises_data()
    {
        QTest::addColumn<Recipe>("recipe");
        QTest::newRow("default") << Recipe();
        Recipe thesis;
        thesis.input.treatment = ResponseTreatment::StepAsImpulse;
        thesis.realization.refine = false;
        QTest::newRow("thesis") << thesis;
        Recipe nuisance;
        nuisance.realization.nuisanceModes = {{{60e3}, 0, false, "mount", "a loose mount"}};
        QTest::newRow("nuisance mode") << nuisance;
        Recipe wide;
        wide.realization.maxOrder = 60;
        wide.realization.order = Auto<Index>(Index(20));
        QTest::newRow("high order") << wide;
        Recipe one;
        one.import.exclude = {{2, "alone"}, {3, "alone"}};
        QTest::newRow("one shot") << one;
    }

    void everyRecipe_progressOnlyRises()
    {
        QFETCH(Recipe, recipe);
        ResultCache cache;
        const Watched first = watch(recipe, cache);
        QVERIFY(first.ended);
        QVERIFY(first.onlyRises());
        QCOMPARE(first.fractions.back(), 1.0);
        QVERIFY(first.fractions.front() > 0.0);
        QVERIFY(first.fractions.size() > std::size_t(kStageCount)); // within the stages too

        const Watched again = watch(recipe, cache); // all from the cache
        QVERIFY(again.onlyRises());
        QCOMPARE(again.fractions.size(), std::size_t(kStageCount));
        QCOMPARE(again.fractions.back(), 1.0);
    }

    void everyLastStage_endsAtOne()
    {
        ResultCache cache;
        for (int last = 0; last < kStageCount; ++last) {
            const Watched watched = watch({}, cache, static_cast<StageId>(last));
            QVERIFY(watched.ended && watched.onlyRises());
            QCOMPARE(watched.fractions.back(), 1.0);
        }
    }

    /// The part of a stage is what it costs, so a cheap one moves the bar but little.
    void progressAfter_isTheShareOfTheCost()
    {
        double sum = 0.0;
        for (int i = 0; i < kStageCount; ++i)
            sum += stageOf(static_cast<StageId>(i)).cost_ms;
        double before = 0.0;
        for (int i = 0; i < kStageCount; ++i) {
            const StageId id = static_cast<StageId>(i);
            const double after = progressAfter(id, kLastStage);
            QVERIFY(qFuzzyCompare(after - before, stageOf(id).cost_ms / sum)
                || std::abs(after - before - stageOf(id).cost_ms / sum) < 1e-12);
            before = after;
        }
        QCOMPARE(before, 1.0);
    }

    void failingStage_neverSaysOne()
    {
        Recipe recipe;
        recipe.realization.order = Auto<Index>(Index(5000));
        ResultCache cache;
        const Watched watched = watch(recipe, cache);
        QVERIFY(!watched.ended);
        QVERIFY(watched.onlyRises());
        QVERIFY(watched.fractions.back() < 1.0);
    }
};

DYNCAL_TEST(TestProgress)
#include "tst_progress.moc"
