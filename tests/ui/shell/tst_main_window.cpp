// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/atomic_file.h"
#include "core/results/results_json.h"
#include "tests/support/test_program.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/sample_results.h"
#include "ui/plot/widget/plot_widget.h"
#include "ui/session/project_file.h"
#include "ui/shell/findings/findings_panel.h"
#include "ui/shell/main_window.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/frame/stage_page.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QtTest>

using namespace dyncal;

namespace {

constexpr int kCapturesRow = 0;
constexpr int kWindowRow = 2;
constexpr int kOrderRow = 6;

/// A window over formula results, with scripted dialogs and its own settings file.
struct Bench : test::WindowBench
{
    explicit Bench(Session::Pipeline pipeline = test::samplePipeline)
        : WindowBench(std::move(pipeline))
    {
        window->resize(1400, 900);
        window->show();
    }

    void openSample()
    {
        window->session().reset({std::make_shared<const CaptureSet>(test::sampleCaptures()), {}});
        QTRY_VERIFY(!window->session().isComputing());
    }

    void show(int row) { window->showPage(row); }
    Index order() const { return window->session().results().model->order; }
    void waitComputed() { QTRY_VERIFY(!window->session().isComputing()); }
};

/// Drags in a plot from one x to another in a few steps, as a hand does.
void drag(PlotWidget *plot, double fromX, double toX, double y)
{
    const QPoint from = plot->pixelOf(fromX, y);
    const QPoint to = plot->pixelOf(toX, y);
    QTest::mouseMove(plot, from);
    QTest::mousePress(plot, Qt::LeftButton, {}, from);
    for (int step = 1; step <= 4; ++step)
        QTest::mouseMove(plot, from + (to - from) * step / 4);
    QTest::mouseRelease(plot, Qt::LeftButton, {}, to);
}

} // namespace

class TestMainWindow : public QObject
{
    Q_OBJECT

private slots:
    void start_nothingOpen_showsThreeButtons();
    void open_sample_goesToTheFirstStage();
    void pages_all_canBeShown();
    void controls_all_haveNames();
    void windowEnd_dragged_changesTheRecipeAsOneStep();
    void windowEnd_typedWithComma_isTaken();
    void order_clicked_isTaken();
    void order_cutDragged_followsAndIsOneStep();
    void order_keys_step();
    void undoRedo_menu_movesTheOrder();
    void shot_excludedWithReason_isInTheRecipe();
    void shot_excludedWithoutReason_staysIncluded();
    void close_unsaved_asks();
    void save_andOpen_givesTheSameRecipe();
    void language_switched_retranslatesEverything();
    void export_withoutResults_saysWhy();
    void caution_reasonGiven_isInTheRecipe();
};

void TestMainWindow::start_nothingOpen_showsThreeButtons()
{
    const Bench bench;
    for (const char *name : {"startOpenCaptures", "startOpenExample", "startOpenProject"})
        QVERIFY(bench.find<QWidget>(name)->isVisible());
}

void TestMainWindow::open_sample_goesToTheFirstStage()
{
    Bench bench;
    bench.openSample();
    QVERIFY(bench.find<QWidget>("capturesPage")->isVisible());
    QCOMPARE(bench.find<QTableWidget>("shotTable")->rowCount(), 3);
}

void TestMainWindow::pages_all_canBeShown()
{
    Bench bench;
    bench.openSample();
    for (std::size_t row = 0; row < bench.window->pages().size(); ++row) {
        bench.show(static_cast<int>(row));
        QVERIFY(bench.window->pages()[row]->isVisible());
        QCoreApplication::processEvents();
        if (const QString folder = qEnvironmentVariable("DYNCAL_SHOTS"); !folder.isEmpty()) {
            QTest::qWait(200);
            bench.window->grab().save(
                folder + "/" + bench.window->pages()[row]->objectName() + ".png");
        }
    }
}

void TestMainWindow::controls_all_haveNames()
{
    Bench bench;
    bench.openSample();
    for (StagePage *page : bench.window->pages()) {
        for (QWidget *root :
            {static_cast<QWidget *>(page), static_cast<QWidget *>(page->inspector())}) {
            for (QWidget *widget : root->findChildren<QWidget *>()) {
                const bool control = qobject_cast<QAbstractSpinBox *>(widget)
                    || qobject_cast<QComboBox *>(widget) || qobject_cast<QAbstractButton *>(widget)
                    || qobject_cast<PlotWidget *>(widget);
                // Parts of Qt's own compound widgets are named by their owner.
                if (!control || widget->objectName().startsWith("qt_")
                    || qobject_cast<QTableWidget *>(widget->parentWidget()))
                    continue;
                const auto *button = qobject_cast<QAbstractButton *>(widget);
                const QString said = button && widget->accessibleName().isEmpty()
                    ? button->text()
                    : widget->accessibleName();
                QVERIFY2(!widget->objectName().isEmpty() && !said.isEmpty(),
                    qPrintable(page->objectName() + ": " + widget->metaObject()->className() + " "
                        + widget->objectName()));
            }
        }
    }
}

void TestMainWindow::windowEnd_dragged_changesTheRecipeAsOneStep()
{
    Bench bench;
    bench.openSample();
    bench.show(kWindowRow);
    auto *plot = bench.find<PlotWidget>("windowPlot");
    QTest::qWait(50);
    const Interval y = plot->yRange();
    drag(plot, 1.5e-4, 1.3e-4, y.begin + 0.9 * y.length());
    const auto &end_s = bench.window->session().recipe().window.end_s;
    QVERIFY(end_s.value);
    // One pixel of the plot is about 0.3 µs.
    QVERIFY2(std::abs(*end_s.value - 1.3e-4) < 2e-6, qPrintable(QString::number(*end_s.value)));
    QCOMPARE(bench.window->session().undoStack().count(), 1);
    bench.waitComputed();
    QCOMPARE(bench.window->session().results().window->responses[0].end_s, *end_s.value);
    bench.window->session().undoStack().undo();
    QVERIFY(bench.window->session().recipe().window.end_s.isAuto());
}

void TestMainWindow::windowEnd_typedWithComma_isTaken()
{
    Bench bench;
    bench.openSample();
    bench.show(kWindowRow);
    QTest::mouseClick(bench.find<QCheckBox>("windowEndAuto"), Qt::LeftButton);
    auto *edit = bench.find<QuantityEdit>("windowEndValue");
    QVERIFY(!edit->isReadOnly());
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, "120,5");
    QTest::keyClick(edit, Qt::Key_Return);
    QCOMPARE(*bench.window->session().recipe().window.end_s.value, 120.5e-6);
}

void TestMainWindow::order_clicked_isTaken()
{
    Bench bench;
    bench.openSample();
    bench.show(kOrderRow);
    auto *plot = bench.find<PlotWidget>("singularValuePlot");
    QTest::qWait(50);
    const double value = bench.window->session().results().decomposition->hankel.singularValues[6];
    QTest::mouseClick(plot, Qt::LeftButton, {}, plot->pixelOf(7, value));
    QTRY_COMPARE(bench.order(), Index(7));
}

void TestMainWindow::order_cutDragged_followsAndIsOneStep()
{
    Bench bench;
    bench.openSample();
    bench.show(kOrderRow);
    auto *plot = bench.find<PlotWidget>("singularValuePlot");
    QTest::qWait(50);
    const auto &values = bench.window->session().results().decomposition->hankel.singularValues;
    // The cut for order n lies between n and n + 1.
    drag(plot, 2.5, 10.5, std::sqrt(values[1] * values[3]));
    QTRY_COMPARE(bench.order(), Index(10));
    QCOMPARE(bench.window->session().undoStack().count(), 1);
}

void TestMainWindow::order_keys_step()
{
    Bench bench;
    bench.openSample();
    bench.show(kOrderRow);
    auto *plot = bench.find<PlotWidget>("singularValuePlot");
    QTest::keyClick(plot, Qt::Key_Right);
    QTRY_COMPARE(bench.order(), Index(3));
    QTest::keyClick(plot, Qt::Key_PageUp);
    QTRY_COMPARE(bench.order(), Index(13));
    QTest::keyClick(plot, Qt::Key_Left);
    QTRY_COMPARE(bench.order(), Index(12));
    QTest::keyClick(plot, Qt::Key_Home);
    QTRY_COMPARE(bench.order(), Index(2));
}

void TestMainWindow::undoRedo_menu_movesTheOrder()
{
    Bench bench;
    bench.openSample();
    bench.show(kOrderRow);
    auto *order = bench.find<QuantityEdit>("orderValue");
    QTest::mouseClick(bench.find<QCheckBox>("orderAuto"), Qt::LeftButton);
    order->setValue(5);
    QTRY_COMPARE(bench.order(), Index(5));
    bench.find<QAction>("undoAction")->trigger();
    QTRY_COMPARE(bench.order(), Index(2));
    bench.find<QAction>("redoAction")->trigger();
    QTRY_COMPARE(bench.order(), Index(5));
    QCOMPARE(order->value(), 5.0);
}

void TestMainWindow::shot_excludedWithReason_isInTheRecipe()
{
    Bench bench;
    bench.openSample();
    bench.show(kCapturesRow);
    bench.prompts.setNextSentence("diaphragm held");
    bench.find<QTableWidget>("shotTable")->item(1, 0)->setCheckState(Qt::Unchecked);
    const auto &out = bench.window->session().recipe().import.exclude;
    QCOMPARE(out.size(), std::size_t(1));
    QCOMPARE(out[0].shot, Index(2));
    QCOMPARE(out[0].reason, std::string("diaphragm held"));
    bench.waitComputed();
    QCOMPARE(bench.window->session().results().window->responses.size(), std::size_t(2));
}

void TestMainWindow::shot_excludedWithoutReason_staysIncluded()
{
    Bench bench;
    bench.openSample();
    bench.show(kCapturesRow);
    auto *table = bench.find<QTableWidget>("shotTable");
    table->item(1, 0)->setCheckState(Qt::Unchecked);
    QVERIFY(bench.window->session().recipe().import.exclude.empty());
    QCOMPARE(table->item(1, 0)->checkState(), Qt::Checked);
}

void TestMainWindow::close_unsaved_asks()
{
    Bench bench;
    bench.openSample();
    QTest::keyClick(bench.window.get(), Qt::Key_A); // nothing happens by stray keys
    bench.show(kOrderRow);
    QTest::keyClick(bench.find<PlotWidget>("singularValuePlot"), Qt::Key_Right);
    QVERIFY(bench.window->isWindowModified());
    bench.prompts.setNextAnswer(dyncal::Answer::Cancel);
    QVERIFY(!bench.window->close());
    QVERIFY(bench.window->isVisible());
    bench.prompts.setNextAnswer(dyncal::Answer::Save);
    const QString path = bench.folder.filePath("saved.dyncal");
    bench.prompts.setNextFile(path);
    QVERIFY(bench.window->close());
    QVERIFY(QFile::exists(path));
}

void TestMainWindow::save_andOpen_givesTheSameRecipe()
{
    Bench bench;
    // A project of recordings that do not exist any more says which; the job on show stays.
    bench.openSample();
    Recipe next = bench.window->session().recipe();
    next.realization.order = 4;
    next.certificate.fields["customer"] = "Åsa & Co";
    bench.window->session().apply(next, "change");
    const QString path = bench.folder.filePath("job");
    bench.prompts.setNextFile(path);
    QVERIFY(bench.window->files().save());
    QVERIFY(QFile::exists(path + ".dyncal"));
    QVERIFY(!bench.window->isWindowModified());
    bench.window->files().openProjectFile(path + ".dyncal");
    QTRY_COMPARE(bench.prompts.shownProblems().size(), 1);
    QVERIFY(bench.prompts.shownProblems()[0].contains("low.h5"));
    QVERIFY(bench.window->session().recipe() == next);
}

void TestMainWindow::language_switched_retranslatesEverything()
{
    Bench bench;
    bench.openSample();
    bench.show(kOrderRow);
    QTest::keyClick(bench.find<PlotWidget>("singularValuePlot"), Qt::Key_Right);
    QTRY_COMPARE(bench.order(), Index(3));
    bench.find<QAction>("languageAction_sv")->trigger();
    QTRY_COMPARE(bench.language.code(), QString("sv"));
    QCoreApplication::processEvents();
    QCOMPARE(bench.preferences.language(), QString("sv"));
    QVERIFY(bench.find<QWidget>("orderPage")->isVisible()); // still on the same page
    QCOMPARE(bench.order(), Index(3));
    QVERIFY(bench.find<QAction>("languageAction_sv")->isChecked());
    bench.find<QAction>("languageAction_sv")->trigger(); // once more: it stays the one
    QVERIFY(bench.find<QAction>("languageAction_sv")->isChecked());
    QVERIFY(!bench.find<QAction>("languageAction_en")->isChecked());
    bench.find<QAction>("languageAction_en")->trigger();
    QCoreApplication::processEvents();
}

void TestMainWindow::export_withoutResults_saysWhy()
{
    Bench bench;
    bench.window->files().exportResults();
    QCOMPARE(bench.prompts.shownProblems().size(), 1);
}

void TestMainWindow::caution_reasonGiven_isInTheRecipe()
{
    Bench bench;
    bench.openSample();
    auto *panel = bench.find<FindingsPanel>("findingsPanel");
    bench.prompts.setNextSentence("distance measured twice");
    const Findings findings = bench.window->session().findings();
    const auto caution = std::ranges::find(findings, Severity::Caution, &Finding::severity);
    QVERIFY(caution != findings.end());
    emit panel->reasonRequested({*caution});
    const auto &given = bench.window->session().recipe().acknowledge;
    QCOMPARE(given.size(), std::size_t(1));
    QCOMPARE(given[0].finding, caution->id);
    QVERIFY(panel->item(0)->text().contains("distance measured twice"));
    bench.window->session().undoStack().undo();
    QVERIFY(bench.window->session().recipe().acknowledge.empty());
}

DYNCAL_TEST(TestMainWindow)
#include "tst_main_window.moc"
