// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_json.h"
#include "tests/support/test_program.h"
#include "ui/plot/widget/plot_widget.h"
#include "ui/session/example.h"
#include "ui/shell/main_window.h"

#include <QLabel>
#include <QTemporaryDir>
#include <QtTest>

using namespace dyncal;

namespace {

/// Long enough for the plateau of every shot, a third of the full example.
constexpr double kDuration_s = 0.006;
constexpr int kPatience_ms = 120'000;
constexpr int kOrderRow = 6;
/// What the example is made with.
constexpr double kTrueResonance_Hz = 2.33e6;
/// The noise moves the resonance by some 1e-6; a wrong pole or rate by far more than this.
constexpr double kResonanceTolerance = 1e-3;

const Pole *strongest(const SensorModel &model)
{
    const Pole *found = nullptr;
    for (const Pole &pole : model.poles)
        if (pole.poleClass == PoleClass::Sensor && (!found || pole.amplitude > found->amplitude))
            found = &pole;
    return found;
}

} // namespace

/// The built-in example through the real pipeline, as an operator meets it.
class TestExampleInWindow : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void example_opened_findsTheResonance();
    void numbers_areThoseOfThePipeline();
    void order_changed_leavesEarlierResultsAlone();
    void undoRedo_everyEdit_givesTheSameResults();

private:
    std::string json(const PipelineOutcome &outcome) const
    {
        return resultsJson(outcome, m_window->session().recipe(), "2026-01-31T12:00:00Z");
    }
    std::string shownJson() const
    {
        const Session &session = m_window->session();
        return json({session.results(), session.error(), session.failedStage()});
    }
    void waitComputed()
    {
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->session().isComputing(), kPatience_ms);
    }

    QTemporaryDir m_folder;
    Preferences m_preferences{m_folder.filePath("settings.ini")};
    Prompts m_prompts;
    Language m_language;
    std::unique_ptr<MainWindow> m_window;
};

void TestExampleInWindow::initTestCase()
{
    m_language.install("en");
    m_prompts.setScripted();
    const auto noon = [] { return Result<std::string>("2026-01-31T12:00:00Z"); };
    m_window
        = std::make_unique<MainWindow>(runPipeline, noon, m_preferences, m_prompts, m_language);
    m_window->show();
    m_window->files().setExampleDuration(kDuration_s);
    m_window->files().openExample();
    QTRY_VERIFY_WITH_TIMEOUT(m_window->session().state().hasShots(), kPatience_ms);
    waitComputed();
}

void TestExampleInWindow::example_opened_findsTheResonance()
{
    const Session &session = m_window->session();
    QVERIFY2(!session.error(), session.error() ? english(session.error()->message).c_str() : "");
    QVERIFY(session.results().response);
    const Pole *pole = strongest(*session.results().model);
    QVERIFY(pole);
    QVERIFY(std::abs(pole->frequency_Hz / kTrueResonance_Hz - 1.0) < kResonanceTolerance);
    m_window->showPage(kOrderRow);
    QVERIFY(m_window->findChild<QLabel *>("resonanceReadout")->text().startsWith("2.33"));
}

void TestExampleInWindow::numbers_areThoseOfThePipeline()
{
    ResultCache cache;
    const PipelineOutcome direct
        = runPipeline(m_window->session().state().captures, m_window->session().recipe(), cache);
    QCOMPARE(QString::fromStdString(shownJson()), QString::fromStdString(json(direct)));
}

void TestExampleInWindow::order_changed_leavesEarlierResultsAlone()
{
    const auto before = m_window->session().results();
    QTest::keyClick(m_window->findChild<PlotWidget *>("singularValuePlot"), Qt::Key_Right);
    waitComputed();
    const auto &after = m_window->session().results();
    QCOMPARE(after.window.get(), before.window.get());
    QCOMPARE(after.spectrum.get(), before.spectrum.get());
    QCOMPARE(after.components.get(), before.components.get());
    QCOMPARE(after.decomposition.get(), before.decomposition.get());
    QCOMPARE(after.model->order, before.model->order + 1);
    m_window->session().undoStack().undo();
    waitComputed();
    QCOMPARE(m_window->session().results().model.get(), before.model.get()); // from the cache
}

void TestExampleInWindow::undoRedo_everyEdit_givesTheSameResults()
{
    Session &session = m_window->session();
    const std::string start = shownJson();
    Recipe recipe = session.recipe();
    recipe.window.end_s = 1e-3;
    session.apply(recipe, "window");
    recipe.input.samples = 300;
    session.apply(recipe, "samples");
    recipe.realization.order = 4;
    session.apply(recipe, "order");
    waitComputed();
    const std::string end = shownJson();
    QVERIFY(end != start);
    for (int i = 0; i < 3; ++i)
        session.undoStack().undo();
    waitComputed();
    QCOMPARE(QString::fromStdString(shownJson()), QString::fromStdString(start));
    for (int i = 0; i < 3; ++i)
        session.undoStack().redo();
    waitComputed();
    QCOMPARE(QString::fromStdString(shownJson()), QString::fromStdString(end));
}

DYNCAL_TEST(TestExampleInWindow)
#include "tst_example_in_window.moc"
