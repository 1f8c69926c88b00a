// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate.h"
#include "core/results/results_json.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/page_bench.h"
#include "ui/plot/widget/plot_widget.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/window/window_page.h"
#include "ui/text/quantity_format.h"

#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

#include <nlohmann/json.hpp>

using namespace dyncal;
using test::PageBench;
using test::waitComputed;

namespace {

constexpr double kRate_Hz = 1e7;
constexpr double kDuration_s = 0.01;
constexpr int kShot1 = 0, kShot2 = 1, kAllShots = 3; ///< choices of the shots

using Bench = PageBench<WindowPage>;

const std::vector<ExcludedStretch> &entriesOf(const Bench &bench)
{
    return bench.recipe().window.excludeStretches;
}

/// As a drag in the plot tells it.
void mark(Bench &bench, double from_s, double to_s)
{
    emit bench.control<PlotWidget>("windowPlot")->spanMarked({from_s, to_s});
}

QString noteOf(Bench &bench)
{
    return bench.control<QLabel>("stretchNote")->text();
}

int rowsOf(Bench &bench)
{
    return bench.control<QListWidget>("stretches")->count();
}

bool hasFinding(const Bench &bench, const std::string &id)
{
    const Findings findings = bench.session.findings();
    return std::ranges::any_of(findings, [&](const Finding &f) { return f.id == id; });
}

} // namespace

/// Stretches left out, from the hand to the recipe and back.
class TestStretchMarking : public QObject
{
    Q_OBJECT

private:
    std::shared_ptr<const CaptureSet> m_set;

private slots:
    void initTestCase() { m_set = testing::simulatedExample(kRate_Hz, kDuration_s); }

    void markedWithoutReason_isShown_notApplied()
    {
        Bench bench;
        bench.choose("startShot", kShot2);
        mark(bench, 2e-5, 4e-5);
        QVERIFY(entriesOf(bench).empty());
        QCOMPARE(bench.session.undoStack().count(), 0);
        QCOMPARE(rowsOf(bench), 1);
        QVERIFY(noteOf(bench).contains("reason"));
        bench.type("stretchReason", "   ");
        QVERIFY(entriesOf(bench).empty());
        bench.control<QPushButton>("stretchRemove")->click();
        QCOMPARE(rowsOf(bench), 0);
    }

    void reasonTyped_appliesItToTheShotChosen_asOneStep()
    {
        Bench bench;
        bench.choose("startShot", kShot2);
        mark(bench, 2e-5, 4e-5);
        bench.type("stretchReason", "knock on the tube");
        const std::vector<ExcludedStretch> expected{{2, 2e-5, 4e-5, "knock on the tube"}};
        QVERIFY(entriesOf(bench) == expected);
        QCOMPARE(bench.session.undoStack().count(), 1);
        QCOMPARE(rowsOf(bench), 1);
        bench.session.undoStack().undo();
        QVERIFY(entriesOf(bench).empty());
        QCOMPARE(rowsOf(bench), 0);
        bench.session.undoStack().redo();
        QVERIFY(entriesOf(bench) == expected);
        bench.control<QListWidget>("stretches")->setCurrentRow(0);
        bench.control<QPushButton>("stretchRemove")->click();
        QVERIFY(entriesOf(bench).empty());
        QCOMPARE(bench.session.undoStack().count(), 2);
    }

    void allShots_haveOneLine_andAnEntryEach()
    {
        Bench bench;
        bench.choose("stretchShot", kAllShots);
        mark(bench, 2e-5, 4e-5);
        bench.type("stretchReason", "mains");
        QCOMPARE(entriesOf(bench).size(), std::size_t(3));
        QCOMPARE(rowsOf(bench), 1);
        // One drag of an edge moves all three, and is one step.
        auto *plot = bench.control<PlotWidget>("windowDetailPlot");
        emit plot->bandMoved("stretch0", {2e-5, 5e-5}, false);
        emit plot->bandMoved("stretch0", {2e-5, 6e-5}, true);
        for (const ExcludedStretch &entry : entriesOf(bench))
            QCOMPARE(entry.to_s, 6e-5);
        QCOMPARE(bench.session.undoStack().count(), 2);
        bench.choose("stretchShot", kShot1);
        QCOMPARE(entriesOf(bench).size(), std::size_t(1));
        QCOMPARE(entriesOf(bench)[0].shot, Index(1));
        bench.session.undoStack().undo();
        bench.session.undoStack().undo();
        QCOMPARE(entriesOf(bench).size(), std::size_t(3));
        QCOMPARE(entriesOf(bench)[2].to_s, 4e-5);
    }

    void typedTwins_makeAndChangeOne()
    {
        Bench bench;
        bench.control<QuantityEdit>("stretchBegin")->setValue(30.0);
        QVERIFY(noteOf(bench).contains("begin")); // the end is still 0
        bench.control<QuantityEdit>("stretchEnd")->setValue(50.0);
        QVERIFY(noteOf(bench).contains("reason"));
        bench.type("stretchReason", "knock");
        QCOMPARE(entriesOf(bench).size(), std::size_t(1));
        bench.control<QuantityEdit>("stretchEnd")->setValue(45.0);
        QCOMPARE(entriesOf(bench)[0].to_s, 45e-6);
        QCOMPARE(entriesOf(bench)[0].from_s, 30e-6);
        // What cannot be is not taken.
        bench.control<QuantityEdit>("stretchEnd")->setValue(10.0);
        QCOMPARE(entriesOf(bench)[0].to_s, 45e-6);
        QCOMPARE(bench.control<QuantityEdit>("stretchEnd")->value(), 45.0);
        bench.type("stretchReason", " ");
        QCOMPARE(entriesOf(bench)[0].reason, std::string("knock"));
        bench.type("stretchReason", "somebody knocked");
        QCOMPARE(entriesOf(bench)[0].reason, std::string("somebody knocked"));
    }

    void marked_isCutToTheWindow_andOutsideItIsSaid()
    {
        Bench bench; // windows of 150 us
        mark(bench, 1.4e-4, 1.9e-4);
        bench.type("stretchReason", "late");
        QCOMPARE(entriesOf(bench)[0].to_s, 1.5e-4);
        mark(bench, 1.6e-4, 1.9e-4);
        bench.type("stretchReason", "later");
        QCOMPARE(entriesOf(bench).size(), std::size_t(1));
        QVERIFY2(noteOf(bench).contains(shownQuantity(1.5e-4, "s")), qPrintable(noteOf(bench)));
    }

    void button_marksWithTheNextDrag_inEitherPlot()
    {
        Bench bench;
        auto *button = bench.control<QPushButton>("stretchMark");
        auto *plot = bench.control<PlotWidget>("windowPlot");
        button->click();
        const QPoint from = plot->pixelOf(3e-5, 0.5);
        QTest::mousePress(plot, Qt::LeftButton, {}, from);
        QTest::mouseMove(plot, from + QPoint(30, 0));
        QTest::mouseRelease(plot, Qt::LeftButton, {}, from + QPoint(30, 0));
        QVERIFY(!button->isChecked());
        QCOMPARE(rowsOf(bench), 1);
        QVERIFY(std::abs(bench.control<QuantityEdit>("stretchBegin")->si() - 3e-5) < 2e-6);
        button->click();
        QVERIFY(button->isChecked());
        button->click(); // again: off
        QVERIFY(!button->isChecked());
        QTest::mouseClick(plot, Qt::LeftButton, {}, from);
        QCOMPARE(rowsOf(bench), 1);
    }

    void startDragged_stretchStaysInTheRecord()
    {
        Bench bench;
        mark(bench, 2e-5, 4e-5);
        bench.type("stretchReason", "knock");
        const double start_s = bench.session.results().window->responses[0].start_s;
        emit bench.control<PlotWidget>("windowPlot")->lineMoved("start", 1e-6, true);
        QVERIFY(std::abs(bench.recipe().window.start_s[0] - start_s - 1e-6) < 1e-12);
        QVERIFY(std::abs(entriesOf(bench)[0].from_s - 1.9e-5) < 1e-12);
        bench.session.undoStack().undo();
        QCOMPARE(entriesOf(bench)[0].from_s, 2e-5);
    }

    void realRun_listResultsAndCertificate_sayTheSame()
    {
        Bench bench(m_set);
        bench.choose("startShot", kShot2);
        mark(bench, 2e-5, 4e-5);
        bench.type("stretchReason", "knock on the tube");
        waitComputed(bench.session);
        QVERIFY(!bench.session.error());
        QVERIFY(hasFinding(bench, "WIN-007"));
        QCOMPARE(noteOf(bench), QString()); // nothing to be said: it is left out
        const PipelineOutcome outcome{bench.session.results(), {}, {}};
        const auto json
            = nlohmann::json::parse(resultsJson(outcome, bench.recipe(), "2026-01-31T12:00:00Z"));
        const auto &stretches = json.at("input").at("excluded_stretches");
        QCOMPARE(stretches.size(), std::size_t(1));
        QCOMPARE(stretches[0].at("shot").get<int>(), 2);
        QCOMPARE(stretches[0].at("from_s").get<double>(), 2e-5);
        QCOMPARE(stretches[0].at("to_s").get<double>(), 4e-5);
        QCOMPARE(stretches[0].at("reason").get<std::string>(), std::string("knock on the tube"));
        const CertificateData data = makeCertificate(bench.session.results(), bench.recipe(), {});
        bool printed = false;
        for (const CertificateSection &section : data.sections)
            for (const CertificateTable &table : section.tables)
                printed = printed || (table.id == "left-out" && table.rows.size() == 1);
        QVERIFY(printed);
    }

    void realRun_excludedShotAverageAndTooMuch_areSaid()
    {
        Bench bench(m_set);
        bench.choose("stretchShot", kAllShots);
        mark(bench, 2e-5, 4e-5);
        bench.type("stretchReason", "mains");
        Recipe recipe = bench.recipe();
        recipe.import.exclude = {{3, "leak"}};
        bench.session.apply(recipe, "exclude");
        waitComputed(bench.session);
        QVERIFY2(noteOf(bench).contains("shot 3 is excluded"), qPrintable(noteOf(bench)));
        recipe.import.exclude.clear();
        recipe.input.combine = CombineMethod::PcaAverage;
        bench.session.apply(recipe, "average");
        waitComputed(bench.session);
        QVERIFY(hasFinding(bench, "WIN-009"));
        QVERIFY2(noteOf(bench).contains("average"), qPrintable(noteOf(bench)));
        recipe.input.combine.reset();
        bench.session.apply(recipe, "stacked");
        waitComputed(bench.session);
        QCOMPARE(noteOf(bench), QString());
        emit bench.control<PlotWidget>("windowPlot")->bandMoved("stretch0", {0.0, 1e-3}, true);
        waitComputed(bench.session);
        QVERIFY(hasFinding(bench, "WIN-008"));
        QVERIFY2(noteOf(bench).contains("at least half"), qPrintable(noteOf(bench)));
    }
};

DYNCAL_TEST(TestStretchMarking)
#include "tst_stretch_marking.moc"
