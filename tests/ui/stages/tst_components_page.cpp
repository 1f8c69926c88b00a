// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "tests/ui/support/kept_bench.h"
#include "ui/plot/widget/overview_strip.h"
#include "ui/stages/components_page.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/model_input_page.h"

#include <QCheckBox>
#include <QtTest>

#include <cmath>

using namespace dyncal;
using test::PageBench;
using test::waitComputed;

namespace {

template <typename Page>
const PlotContent &drawn(PageBench<Page> &bench, const char *plot)
{
    return bench.template control<PlotWidget>(plot)->content();
}

template <typename Page>
void exclude(PageBench<Page> &bench, std::vector<ExcludedShot> shots)
{
    Recipe recipe = bench.recipe();
    recipe.import.exclude = std::move(shots);
    bench.session.apply(recipe, "exclude");
    waitComputed(bench.session);
}

template <typename Page>
void keep(PageBench<Page> &bench, double components)
{
    bench.template control<QuantityEdit>("componentsKept")->setValue(components);
    waitComputed(bench.session);
}

double largest(const std::vector<PlotCurve> &curves)
{
    double most = 0.0;
    for (const PlotCurve &curve : curves)
        for (const double y : curve.y)
            most = std::max(most, std::abs(y));
    return most;
}

} // namespace

/// What the shots share, and what the identification gets of them, over the real pipeline.
class TestComponentsPage : public QObject
{
    Q_OBJECT

private:
    std::shared_ptr<const CaptureSet> m_set;
    test::KeptBench<ComponentsPage> m_components;
    test::KeptBench<ModelInputPage> m_input;

private slots:
    void initTestCase() { m_set = testing::simulatedExample(1e7, 0.004); }
    void init() { QLocale::setDefault(QLocale::c()); }
    void components_allKept_leaveNothing();
    void ringing_isShownLarge();
    void components_fewer_leaveMore_andUndo();
    void components_oneShot_saysSo();
    void lags_areThoseOfThePlot();
    void confidence_widensTheBand_andAForeignOneIsNoChoice();
    void input_rateTyped_givesSamplesPerPeriod();
    void input_samplesTyped_giveTheStretch();
    void input_aliased_isSaid_andUndone();
    void input_fedAsImpulse_needsOneOrderMore();
    void input_swedish();
};

void TestComponentsPage::components_allKept_leaveNothing()
{
    PageBench<ComponentsPage> &bench = m_components.fresh(m_set);
    keep(bench, 3); // as many as shots
    QVERIFY(largest(drawn(bench, "residualPlot").curves) < 1e-9);
    // Of three components the first two leave something, all nothing: no bar. What is left is told
    // apart, however little: 0.007 % is not the height of 0.
    const PlotContent left = drawn(bench, "explainedPlot");
    const auto &explained
        = bench.session.results().components->principal->explainedCumulative_percent;
    QCOMPARE(left.curves.at(0).y.size(), std::size_t(2));
    QVERIFY(left.yAxis.logarithmic);
    for (std::size_t i = 0; i < 2; ++i)
        QCOMPARE(left.curves[0].y[i], 100.0 - explained[static_cast<Index>(i)]);
    QVERIFY(*left.yMin < left.curves[0].y[1]);
    keep(bench, 99); // more than there are: not an error, and not more
    QVERIFY(!bench.session.error());
    QCOMPARE(bench.session.results().components->kept, Index(3));
}

/// On a plateau the ringing is a line of one pixel: it is shown large, the strip has the plateau.
void TestComponentsPage::ringing_isShownLarge()
{
    PageBench<ComponentsPage> &bench = m_components.fresh(m_set);
    const auto *strip = bench.page.findChild<OverviewStrip *>("componentsOverview");
    for (const char *name : {"reconstructionPlot", "residualPlot"}) {
        const auto *plot = bench.page.findChild<PlotWidget *>(name);
        QVERIFY2(strip->whole().length() > 10.0 * plot->xRange().length(), name);
        QVERIFY(plot->xRange().begin == 0.0);
    }
    const auto *plot = bench.page.findChild<PlotWidget *>("residualPlot");
    QCOMPARE(strip->whole().end, plot->content().curves.front().x.back());
}

void TestComponentsPage::components_fewer_leaveMore_andUndo()
{
    PageBench<ComponentsPage> &bench = m_components.fresh(m_set);
    const double one = largest(drawn(bench, "residualPlot").curves);
    keep(bench, 2);
    const double two = largest(drawn(bench, "residualPlot").curves);
    QVERIFY(two < one && two > 0.0);
    // Reconstruction and residual together are the response itself, sample by sample.
    const auto &whole = bench.session.results().components->responses;
    const auto &parts = drawn(bench, "reconstructionPlot").curves;
    const auto &rest = drawn(bench, "residualPlot").curves;
    QCOMPARE(parts.size(), std::size_t(3));
    for (std::size_t shot = 0; shot < 3; ++shot)
        for (std::size_t k = 0; k < parts[shot].y.size(); k += 97)
            QVERIFY(std::abs(parts[shot].y[k] + rest[shot].y[k]
                        - whole(static_cast<Index>(k), static_cast<Index>(shot)))
                < 1e-12);
    bench.session.undoStack().undo();
    waitComputed(bench.session);
    QCOMPARE(largest(drawn(bench, "residualPlot").curves), one);
}

void TestComponentsPage::components_oneShot_saysSo()
{
    PageBench<ComponentsPage> &bench = m_components.fresh(m_set);
    QVERIFY(bench.control<QLabel>("firstExplains")->text().endsWith("%"));
    exclude(bench, {{1, "tore late"}, {3, "tore late"}});
    QCOMPARE(bench.control<QLabel>("firstExplains")->text(), QString("– (one shot)"));
    QCOMPARE(bench.control<ValueTable>("residualTable")->rowCount(), 0);
    QVERIFY(drawn(bench, "explainedPlot").curves.empty());
    exclude(bench, {});
    QCOMPARE(bench.control<ValueTable>("residualTable")->rowCount(), 3);
}

void TestComponentsPage::lags_areThoseOfThePlot()
{
    PageBench<ComponentsPage> &bench = m_components.fresh(m_set);
    bench.control<QuantityEdit>("residualLags")->setValue(37);
    waitComputed(bench.session);
    const PlotCurve &curve = drawn(bench, "autocovariancePlot").curves.at(0);
    QCOMPARE(curve.x.back(), 37.0);
    QCOMPARE(curve.y.front(), 1.0); // at no lag
    bench.control<QuantityEdit>("residualLags")->setValue(100000); // more than there are samples
    waitComputed(bench.session);
    QVERIFY(!bench.session.error());
    QVERIFY(drawn(bench, "autocovariancePlot").curves.at(0).x.back()
        < static_cast<double>(bench.session.results().components->responses.rows()));
}

void TestComponentsPage::confidence_widensTheBand_andAForeignOneIsNoChoice()
{
    PageBench<ComponentsPage> &bench = m_components.fresh(m_set);
    bench.choose("residualConfidence", 1); // 95 %
    waitComputed(bench.session);
    const double narrow = drawn(bench, "autocovariancePlot").levels.at(0).y;
    bench.choose("residualConfidence", 3); // 99.9 %
    waitComputed(bench.session);
    const double wide = drawn(bench, "autocovariancePlot").levels.at(0).y;
    QVERIFY2(std::abs(wide / narrow - 3.2905 / 1.9600) < 0.002, // quantiles of the normal
        qPrintable(QString::number(wide / narrow)));
    Recipe recipe = bench.recipe(); // typed into a recipe by hand
    recipe.pca.residualConfidence = 0.97;
    bench.session.apply(recipe, "confidence");
    waitComputed(bench.session);
    QCOMPARE(bench.control<QComboBox>("residualConfidence")->currentIndex(), -1);
}

void TestComponentsPage::input_rateTyped_givesSamplesPerPeriod()
{
    PageBench<ModelInputPage> &bench = m_input.fresh(m_set);
    const double resonance_Hz = bench.session.results().spectrum->resonances.at(0).frequency_Hz;
    bench.control<QCheckBox>("modelRateAuto")->click();
    bench.control<QuantityEdit>("modelRateValue")->setValue(10000.0); // as recorded
    waitComputed(bench.session);
    QCOMPARE(bench.session.results().input->sampleRate_Hz, 10e6);
    const QString text = bench.control<QLabel>("samplesPerPeriod")->text();
    QVERIFY2(std::abs(text.section(' ', 0, 0).toDouble() - 10e6 / resonance_Hz) < 0.01,
        qPrintable(text));
    QVERIFY2(text.contains("enough"), qPrintable(text)); // 4.3: between 4 and 10
    bench.session.undoStack().undo();
    waitComputed(bench.session);
    bench.session.undoStack().undo();
    waitComputed(bench.session);
    QVERIFY(bench.control<QCheckBox>("modelRateAuto")->isChecked());
}

void TestComponentsPage::input_samplesTyped_giveTheStretch()
{
    PageBench<ModelInputPage> &bench = m_input.fresh(m_set);
    bench.control<QCheckBox>("modelSamplesAuto")->click();
    bench.control<QuantityEdit>("modelSamplesValue")->setValue(250);
    waitComputed(bench.session);
    const ModelInput &input = *bench.session.results().input;
    QCOMPARE(input.samples, Index(250));
    for (const PlotCurve &curve : drawn(bench, "modelInputPlot").curves)
        QVERIFY(curve.style != CurveStyle::Markers || curve.x.size() == 250);
    const QString stretch = bench.control<QLabel>("modelStretch")->text();
    const double stretch_us = stretch.section(' ', 0, 0).toDouble();
    QVERIFY2(std::abs(stretch_us - 250e6 / input.sampleRate_Hz) < 0.01, qPrintable(stretch));
    QVERIFY(stretch.endsWith("µs"));
}

void TestComponentsPage::input_aliased_isSaid_andUndone()
{
    PageBench<ModelInputPage> &bench = m_input.fresh(m_set);
    bench.control<QCheckBox>("modelRateAuto")->click();
    waitComputed(bench.session);
    bench.control<QuantityEdit>("modelRateValue")->setValue(2000.0); // below 2 x 2.33 MHz
    waitComputed(bench.session);
    const QString text = bench.control<QLabel>("samplesPerPeriod")->text();
    const Findings findings = bench.session.findings();
    QVERIFY2(text.contains("too few") || bench.session.error(), qPrintable(text));
    QVERIFY(std::ranges::any_of(
        findings, [](const Finding &finding) { return finding.severity != Severity::Info; }));
    bench.session.undoStack().undo();
    waitComputed(bench.session);
    QVERIFY(!bench.session.error());
    QVERIFY(!bench.control<QLabel>("samplesPerPeriod")->text().contains("too few"));
}

void TestComponentsPage::input_fedAsImpulse_needsOneOrderMore()
{
    PageBench<ModelInputPage> &bench = m_input.fresh(m_set);
    const auto suggested = [&] { return bench.session.results().decomposition->suggestion.order; };
    const Index deflated = suggested();
    bench.choose("treatment", 1); // as the thesis feeds it: the step itself takes a state
    waitComputed(bench.session);
    QCOMPARE(suggested(), deflated + 1);
    bench.session.undoStack().undo();
    waitComputed(bench.session);
    QCOMPARE(suggested(), deflated);
    QCOMPARE(bench.control<QComboBox>("treatment")->currentIndex(), 0);
}

void TestComponentsPage::input_swedish()
{
    const test::InSwedish swedish;
    PageBench<ModelInputPage> bench(m_set);
    bench.control<QCheckBox>("modelRateAuto")->click();
    auto *rate = bench.control<QuantityEdit>("modelRateValue");
    rate->selectAll();
    QTest::keyClicks(rate, "5000,5"); // no whole part of the record's rate
    QTest::keyClick(rate, Qt::Key_Return);
    QCOMPARE(*bench.recipe().input.sampleRate_Hz.value, 5000.5e3);
    QVERIFY2(rate->text().startsWith("5000,5"), qPrintable(rate->text()));
    waitComputed(bench.session);
}

DYNCAL_TEST(TestComponentsPage)
#include "tst_components_page.moc"
