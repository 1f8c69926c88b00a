// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/model/model_page.h"

#include <QCheckBox>
#include <QTabWidget>
#include <QtTest>

#include <cmath>

using namespace dyncal;
using test::waitComputed;

namespace {

using Assessed = std::optional<ModelAssessment>;

/// The formula results with a model and what is said of it changed by the test.
struct Doctored
{
    using Edit = std::function<void(SensorModel &, Assessed &)>;
    std::shared_ptr<Edit> edit = std::make_shared<Edit>();

    PipelineOutcome operator()(const std::shared_ptr<const CaptureSet> &captures,
        const Recipe &recipe, ResultCache &cache, StageId last, const JobControl &control) const
    {
        PipelineOutcome outcome = test::samplePipeline(captures, recipe, cache, last, control);
        auto model = std::make_shared<SensorModel>(*outcome.results.model);
        Assessed assessed = *outcome.results.assessment;
        if (*edit)
            (*edit)(*model, assessed);
        outcome.results.model = model;
        outcome.results.assessment
            = assessed ? std::make_shared<const ModelAssessment>(*assessed) : nullptr;
        return outcome;
    }
};

struct Bench
{
    Doctored doctored;
    Session session{doctored};
    ModelPage page{session};
    std::unique_ptr<InspectorForm> inspector{page.inspector()};

    explicit Bench(const Doctored::Edit &edit = {})
    {
        *doctored.edit = edit;
        test::open(session, std::make_shared<const CaptureSet>(test::sampleCaptures()));
        page.resize(1000, 800);
        page.show();
        inspector->show();
    }
    void compute(const Doctored::Edit &edit)
    {
        *doctored.edit = edit;
        session.recompute();
        waitComputed(session);
    }
    template <typename T>
    T *control(const QString &name)
    {
        T *found = inspector->findChild<T *>(name);
        return found ? found : page.findChild<T *>(name);
    }
    QString said(const QString &name) { return control<QLabel>(name)->text(); }
    std::size_t curves(const QString &name)
    {
        return control<PlotWidget>(name)->content().curves.size();
    }
    bool hasTab(const QString &table)
    {
        auto *tabs = control<QTabWidget>("modelTabs");
        return tabs->isTabVisible(tabs->indexOf(control<ValueTable>(table)));
    }
};

void makeSecondOrder(SensorModel &model, Assessed &assessed)
{
    SecondOrderModel fit;
    fit.f0_Hz = 1.4e6;
    fit.zeta = 0.05;
    fit.fit_percent = 71.0;
    fit.describes = false;
    for (const SeriesFit &series : model.series) {
        SecondOrderShot &shot = fit.shots.emplace_back();
        shot.shot = series.shot;
        shot.plateauGain = 1.02;
    }
    model.plateauGain = 1.0;
    assessed->secondOrder = fit;
}

void exclude(Session &session, Index shot)
{
    Recipe recipe = session.recipe();
    recipe.import.exclude = {{shot, "tore late"}};
    session.apply(recipe, "exclude");
    waitComputed(session);
}

} // namespace

/// What the model page says of good and of bad models.
class TestModelPage : public QObject
{
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void divergingModel_hasNoNumbers();
    void poorModel_isBelowZero_inWordsNotDigits();
    void unassessedModel_saysWhatIsNotYetThere();
    void listingsFit_isShownWhereThereIsOne();
    void secondOrder_isDrawnByItsClosedForm_andTakenOff();
    void seriesChosen_survivesResults();
    void shotExcluded_seriesShowsNoOther_andUndoBringsItBack();
    void noiseMode_opensItsTab();
    void swedish_numbersAndWords();
    void nothingComputed_showsDashes();
};

void TestModelPage::divergingModel_hasNoNumbers()
{
    Bench bench([](SensorModel &model, Assessed &) {
        model.diverges = true;
        model.fit_percent = -1e53;
        model.series[0].fit_percent = -1e53;
    });
    QCOMPARE(bench.said("modelFit"), QString("diverges"));
    QCOMPARE(bench.said("modelFitPerShot"), QString("–"));
    QVERIFY(!bench.said("modelFit").contains('5'));
    QCOMPARE(bench.curves("modelResidualPlot"), std::size_t(0));
    bench.compute({});
    QCOMPARE(bench.said("modelFit"), QString("89.4 % of attainable 89.9 %"));
    QCOMPARE(bench.said("modelFitPerShot").count('\n'), 2); // three shots
}

void TestModelPage::poorModel_isBelowZero_inWordsNotDigits()
{
    Bench bench([](SensorModel &model, Assessed &) { model.fit_percent = -312.0; });
    QCOMPARE(bench.said("modelFit"), QString("< 0 % of attainable 89.9 %"));
}

void TestModelPage::unassessedModel_saysWhatIsNotYetThere()
{
    Bench bench(makeSecondOrder);
    QVERIFY(bench.hasTab("secondOrderTable"));
    QVERIFY(bench.control<ValueTable>("secondOrderTable")->isEnabled());
    QVERIFY(bench.said("modelSecondOrder").contains("does not describe the data"));
    const int rows = bench.control<ValueTable>("secondOrderTable")->rowCount();
    bench.compute([](SensorModel &, Assessed &assessed) { assessed.reset(); });
    // What an earlier assessment said stays there, greyed; the read-outs do not speak of it.
    QVERIFY(!bench.control<ValueTable>("secondOrderTable")->isEnabled());
    QCOMPARE(bench.control<ValueTable>("secondOrderTable")->rowCount(), rows);
    QCOMPARE(bench.said("modelSecondOrder"), QString("not yet"));
    QVERIFY(bench.said("modelHomogeneity").contains("not yet"));
    bench.compute({});
    QVERIFY(bench.control<ValueTable>("trendTable")->isEnabled());
    QVERIFY(!bench.hasTab("secondOrderTable"));
    QCOMPARE(bench.said("modelSecondOrder"), QString("–"));
}

void TestModelPage::listingsFit_isShownWhereThereIsOne()
{
    Bench bench;
    QCOMPARE(bench.said("modelFitListing"), QString("–"));
    bench.compute([](SensorModel &model, Assessed &) { model.fitListing_percent = -29.8; });
    QVERIFY2(bench.said("modelFitListing").startsWith("-29.8 %"),
        qPrintable(bench.said("modelFitListing")));
}

void TestModelPage::secondOrder_isDrawnByItsClosedForm_andTakenOff()
{
    Bench bench(makeSecondOrder);
    const std::size_t before = bench.curves("magnitudePlot");
    auto *box = bench.control<QCheckBox>("drawSecondOrder");
    QVERIFY(box->isEnabled() && !box->isChecked());
    box->click();
    const auto &curves = bench.control<PlotWidget>("magnitudePlot")->content().curves;
    QCOMPARE(curves.size(), before + 1);
    const PlotCurve &drawn = curves.back();
    constexpr double kAtZero = 5.02e-6 * 1.02; // sensitivity, times its plateau against the model's
    for (std::size_t i = 0; i < drawn.x.size(); ++i) {
        const double x = drawn.x[i] / 1.4e6;
        const double expected = kAtZero / std::hypot(1.0 - x * x, 2.0 * 0.05 * x);
        QVERIFY(std::abs(drawn.y[i] - expected) < 1e-9 * expected);
    }
    box->click();
    QCOMPARE(bench.curves("magnitudePlot"), before);
    bench.compute({}); // no such fit any more
    QVERIFY(!box->isEnabled());
}

void TestModelPage::seriesChosen_survivesResults()
{
    Bench bench;
    auto *series = bench.control<QComboBox>("modelSeries");
    QCOMPARE(series->count(), 4);
    QCOMPARE(bench.curves("modelErrorPlot"), std::size_t(3));
    series->setCurrentIndex(2);
    emit series->activated(2);
    QCOMPARE(bench.curves("modelErrorPlot"), std::size_t(1));
    bench.compute({});
    QCOMPARE(series->currentText(), QString("Shot 2"));
    QCOMPARE(bench.curves("modelErrorPlot"), std::size_t(1));
}

void TestModelPage::shotExcluded_seriesShowsNoOther_andUndoBringsItBack()
{
    Bench bench;
    auto *series = bench.control<QComboBox>("modelSeries");
    series->setCurrentIndex(2);
    emit series->activated(2);
    exclude(bench.session, 2);
    // Never another shot under the same choice: all, or the one asked for.
    QVERIFY(series->findText("Shot 2") < 0);
    QCOMPARE(series->currentText(), QString("all"));
    QCOMPARE(bench.curves("modelErrorPlot"), std::size_t(2));
    QVERIFY(!bench.said("modelFitPerShot").contains("Shot 2"));
    bench.session.undoStack().undo();
    waitComputed(bench.session);
    QVERIFY(series->findText("Shot 2") > 0);
    QVERIFY(bench.said("modelFitPerShot").contains("Shot 2"));
}

void TestModelPage::noiseMode_opensItsTab()
{
    Bench bench;
    QVERIFY(!bench.hasTab("nuisanceTable"));
    bench.compute([](SensorModel &model, Assessed &) {
        NuisanceResult mode;
        mode.mode.label = "transverse (1,0)";
        NuisanceOfShot shot;
        shot.shot = 2;
        shot.term.pole_rad_s = {-50.0, 2.0 * M_PI * 6.8e3};
        shot.relativeAmplitude = 0.031;
        mode.perShot = {shot};
        model.nuisance = {mode};
    });
    QVERIFY(bench.hasTab("nuisanceTable"));
    auto *table = bench.control<ValueTable>("nuisanceTable");
    QCOMPARE(table->rowCount(), 1);
    QCOMPARE(table->item(0, 1)->text(), QString("Shot 2"));
    QCOMPARE(table->item(0, 2)->text(), QString("6.8000 kHz"));
    QCOMPARE(table->item(0, 4)->text(), QString("3.1 %"));
}

void TestModelPage::swedish_numbersAndWords()
{
    const test::InSwedish swedish;
    Bench bench([](SensorModel &model, Assessed &assessed) {
        assessed->homogeneity = Homogeneity{1.5e6, 40.0, 4.0, 1e-6, false};
        model.uncertaintyMethod = "AR(3) of the residual";
    });
    QVERIFY2(bench.said("modelFit").startsWith("89,4 %"), qPrintable(bench.said("modelFit")));
    QVERIFY(bench.said("modelHomogeneity").contains("1,5 MHz"));
    QVERIFY(bench.said("modelHomogeneity").contains("< 0,001"));
    QVERIFY(bench.said("modelFitPerShot").contains("Skott 1: 89,4 %"));
    QVERIFY(bench.said("modelUncertainty").startsWith("AR(3)"));
    QVERIFY(!bench.said("modelUncertainty").contains("of the residual"));
    QCOMPARE(bench.control<ValueTable>("poleTable")->item(0, 0)->text(), QString("1,5000 MHz"));
    QVERIFY(bench.control<ValueTable>("poleTable")->item(0, 8)->text().startsWith("givare"));
}

void TestModelPage::nothingComputed_showsDashes()
{
    Session session(test::formulaPipeline());
    ModelPage page(session);
    const std::unique_ptr<InspectorForm> inspector(page.inspector());
    page.show();
    for (const char *name : {"modelOrder", "modelFit", "modelFitPerShot", "modelRise",
             "modelOvershoot", "modelMinus3", "usableBand", "modelUncertainty"})
        QCOMPARE(inspector->findChild<QLabel *>(name)->text(), QString("–"));
    QCOMPARE(page.findChild<ValueTable *>("poleTable")->rowCount(), 0);
    for (const PlotWidget *plot : page.findChildren<PlotWidget *>())
        QVERIFY(plot->content().curves.empty());
}

DYNCAL_TEST(TestModelPage)
#include "tst_model_page.moc"
