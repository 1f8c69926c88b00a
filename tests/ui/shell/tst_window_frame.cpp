// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/sample_results.h"
#include "ui/plot/widget/plot_widget.h"
#include "ui/shell/findings/findings_panel.h"
#include "ui/shell/shortcut_sheet.h"
#include "ui/stages/frame/stage_page.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QScopeGuard>
#include <QToolBar>
#include <QToolButton>
#include <QtTest>

using namespace dyncal;

namespace {

constexpr int kRestarts = 10;
constexpr int kCertificateRow = static_cast<int>(Page::Certificate);
constexpr const char *kDocks[]{"stagesDock", "inspectorDock", "findingsDock"};

struct Bench : test::WindowBench
{
    Bench()
        : WindowBench(test::samplePipeline)
    {
        window->show();
    }

    void openSample() const { open(*window); }
    static void open(MainWindow &window)
    {
        window.session().reset({std::make_shared<const CaptureSet>(test::sampleCaptures()), {}});
        QTRY_VERIFY(!window.session().isComputing());
        settle();
    }
    /// Layouts come by the event loop.
    static void settle()
    {
        for (int i = 0; i < 5; ++i)
            QTest::qWait(10);
    }
    std::unique_ptr<MainWindow> another()
    {
        auto other = std::make_unique<MainWindow>(
            test::samplePipeline, [] { return Result<std::string>("2026-01-31T12:00:00Z"); },
            preferences, prompts, language);
        other->show();
        settle();
        return other;
    }
};

std::vector<QSize> dockSizes(const MainWindow &window)
{
    std::vector<QSize> sizes;
    for (const char *name : kDocks)
        sizes.push_back(window.findChild<QDockWidget *>(name)->size());
    return sizes;
}

QString words(const std::vector<QSize> &sizes)
{
    QStringList texts;
    for (const QSize &size : sizes)
        texts << QString("%1x%2").arg(size.width()).arg(size.height());
    return texts.join(' ');
}

bool isWithinOnePixel(const std::vector<QSize> &a, const std::vector<QSize> &b)
{
    return std::ranges::equal(a, b, [](const QSize &one, const QSize &other) {
        return std::abs(one.width() - other.width()) <= 1
            && std::abs(one.height() - other.height()) <= 1;
    });
}

/// Links of the line "What next" that are on show.
QList<QToolButton *> links(const MainWindow &window)
{
    QList<QToolButton *> shown;
    for (QToolButton *button : window.findChildren<QToolButton *>())
        if (button->objectName().startsWith("nextStep") && button->isVisible())
            shown << button;
    return shown;
}

} // namespace

/// What is around the pages: docks, tool bar, the line "What next", tool tips, keys.
class TestWindowFrame : public QObject
{
    Q_OBJECT

private slots:
    void docks_tenRestarts_keepTheirSizes();
    void docks_restartsWithoutWork_keepTheirSizes();
    void next_emptyField_isALinkToIt();
    void next_stepThatIsGone_leadsNowhere();
    void next_menu_hasWhatIsNotInTheLine();
    void next_narrowWindow_isNotCut();
    void keyResults_areAlwaysInView();
    void everyControl_saysWhatItDoes();
    void markedStretch_opensTheInspectorThatAsksForItsReason();
    void toolBar_hasSignsAndKeys();
    void toolBar_undoAndStages();
    void sheet_isMadeOfTheActions();
};

void TestWindowFrame::docks_tenRestarts_keepTheirSizes()
{
    Bench bench;
    bench.openSample();
    auto *inspector = bench.find<QDockWidget>("inspectorDock");
    auto *findings = bench.find<QDockWidget>("findingsDock");
    bench.window->resizeDocks({inspector, findings}, {420, 260}, Qt::Vertical);
    bench.window->resizeDocks({inspector}, {377}, Qt::Horizontal);
    Bench::settle();
    const std::vector<QSize> first = dockSizes(*bench.window);
    QVERIFY(bench.window->close());
    for (int restart = 1; restart <= kRestarts; ++restart) {
        const auto window = bench.another();
        Bench::open(*window);
        QVERIFY2(isWithinOnePixel(dockSizes(*window), first),
            qPrintable(QString("start %1: %2 instead of %3")
                           .arg(restart)
                           .arg(words(dockSizes(*window)), words(first))));
        QVERIFY(window->close());
    }
}

/// A start in which nothing is opened changes nothing either.
void TestWindowFrame::docks_restartsWithoutWork_keepTheirSizes()
{
    Bench bench;
    bench.openSample();
    bench.window->resizeDocks(
        {bench.find<QDockWidget>("inspectorDock"), bench.find<QDockWidget>("findingsDock")},
        {350, 330}, Qt::Vertical);
    Bench::settle();
    const std::vector<QSize> first = dockSizes(*bench.window);
    QVERIFY(bench.window->close());
    for (int restart = 0; restart < 3; ++restart)
        QVERIFY(bench.another()->close());
    const auto window = bench.another();
    Bench::open(*window);
    QVERIFY2(isWithinOnePixel(dockSizes(*window), first),
        qPrintable(words(dockSizes(*window)) + " instead of " + words(first)));
}

void TestWindowFrame::next_emptyField_isALinkToIt()
{
    Bench bench;
    bench.window->resize(1400, 900);
    QCOMPARE(bench.find<QLabel>("nextHeading")->text(), QString("What next: open captures."));
    QVERIFY(links(*bench.window).isEmpty());
    bench.openSample();
    const auto linkTo = [&](const QString &text) {
        for (QToolButton *link : links(*bench.window))
            if (link->text() == text)
                return link;
        return static_cast<QToolButton *>(nullptr);
    };
    QToolButton *link = linkTo("Certificate number");
    QVERIFY(link);
    QTest::mouseClick(link, Qt::LeftButton);
    auto *field = bench.find<QLineEdit>("field_certificate_number");
    QVERIFY(field->isVisible());
    QCOMPARE(bench.window->focusWidget(), field);
    QTest::keyClicks(field, "2026-001");
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_VERIFY(!linkTo("Certificate number")); // it is no longer missing
    QVERIFY(linkTo("Laboratory"));
    // The caution that the sample has leads to the list of findings.
    QToolButton *caution = linkTo("▲ reasons for 1 caution");
    QVERIFY(caution);
    QTest::mouseClick(caution, Qt::LeftButton);
    QCOMPARE(bench.window->focusWidget(), bench.find<FindingsPanel>("findingsPanel"));
}

/// A click takes what was typed first: the step that it was meant for may be settled by that.
void TestWindowFrame::next_stepThatIsGone_leadsNowhere()
{
    Bench bench;
    bench.window->resize(1400, 900);
    bench.openSample();
    auto *third = bench.find<QToolButton>("nextStep3");
    QVERIFY(third->isVisible());
    bench.window->showPage(static_cast<int>(Page::Certificate));
    for (QLineEdit *field : bench.window->findChildren<QLineEdit *>())
        if (field->objectName().startsWith("field_")) {
            field->setText(field->objectName().contains("date") ? "2026-01-31" : "something");
            QTest::keyClick(field, Qt::Key_Return);
        }
    QTRY_VERIFY(!third->isVisible());
    third->click();
    QVERIFY(bench.window->pages()[static_cast<std::size_t>(Page::Certificate)]->isVisible());
}

void TestWindowFrame::next_menu_hasWhatIsNotInTheLine()
{
    Bench bench;
    bench.openSample();
    auto *menu = bench.find<QMenu>("nextMenu");
    const auto fields = [&] { return links(*bench.window).size() + menu->actions().size(); };
    const auto before = fields();
    QVERIFY(before > 10);
    QVERIFY(!menu->actions().isEmpty());
    QAction *last = menu->actions().constLast();
    last->trigger();
    QVERIFY(bench.window->pages()[kCertificateRow]->isVisible());
    auto *field = qobject_cast<QLineEdit *>(bench.window->focusWidget());
    QVERIFY(field && field->objectName().startsWith("field_"));
    QTest::keyClicks(field, "given");
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_COMPARE(fields(), before - 1);
}

void TestWindowFrame::next_narrowWindow_isNotCut()
{
    Bench bench;
    bench.openSample();
    const QFont usual = bench.window->font();
    const auto restored = qScopeGuard([&] { QApplication::setFont(usual); });
    for (const int width : {1000, 1280, 1600, -1280}) {
        QFont font = usual;
        if (width < 0) // at twice the size
            font.setPointSizeF(2.0 * usual.pointSizeF());
        QApplication::setFont(font);
        bench.window->resize(std::abs(width), 720);
        Bench::settle();
        const auto *bar = bench.find<QWidget>("nextBar");
        QVERIFY(bar->isVisible());
        for (const QWidget *part : bar->findChildren<QWidget *>(Qt::FindDirectChildrenOnly)) {
            if (!part->isVisible() || part->isWindow())
                continue;
            QVERIFY2(bar->rect().contains(part->geometry()),
                qPrintable(QString("%1 at %2").arg(part->objectName()).arg(width)));
            QVERIFY(part->width() >= part->sizeHint().width());
            for (const QWidget *other : bar->findChildren<QWidget *>(Qt::FindDirectChildrenOnly))
                QVERIFY2(other == part || !other->isVisible() || other->isWindow()
                        || !other->geometry().intersects(part->geometry()),
                    qPrintable(part->objectName() + " " + other->objectName()));
        }
    }
}

void TestWindowFrame::keyResults_areAlwaysInView()
{
    Bench bench;
    bench.openSample();
    for (std::size_t row = 0; row < bench.window->pages().size(); ++row) {
        bench.window->showPage(static_cast<int>(row));
        for (const char *name : {"keySensitivity", "keyFrequency", "keyDamping", "keyStep"}) {
            const auto *label = bench.find<QLabel>(name);
            QVERIFY2(label->isVisible() && label->isEnabled(), name);
            QVERIFY2(!label->toolTip().isEmpty(), name);
        }
    }
    QVERIFY2(bench.find<QLabel>("keyFrequency")->text().startsWith("f₀ 1.5"),
        qPrintable(bench.find<QLabel>("keyFrequency")->text()));
    QVERIFY2(bench.find<QLabel>("keySensitivity")->text().startsWith("S 5.02"),
        qPrintable(bench.find<QLabel>("keySensitivity")->text()));
}

/// Every control that a hand can reach says what it does.
void TestWindowFrame::everyControl_saysWhatItDoes()
{
    Bench bench;
    bench.openSample();
    QStringList silent;
    const auto look = [&](const QWidget &root) {
        for (const QWidget *widget : root.findChildren<QWidget *>()) {
            const bool control = qobject_cast<const QAbstractButton *>(widget)
                || qobject_cast<const QLineEdit *>(widget)
                || qobject_cast<const QAbstractSpinBox *>(widget)
                || qobject_cast<const QComboBox *>(widget)
                || qobject_cast<const QPlainTextEdit *>(widget);
            // The buttons that Qt puts into its own widgets are theirs.
            if (control && widget->isVisible() && !widget->objectName().startsWith("qt_")
                && !qobject_cast<const QDockWidget *>(widget->parentWidget())
                && !widget->inherits("QTableCornerButton") && widget->toolTip().isEmpty())
                silent << QString(widget->metaObject()->className()) + ' ' + widget->objectName();
        }
    };
    for (std::size_t row = 0; row < bench.window->pages().size(); ++row) {
        bench.window->showPage(static_cast<int>(row));
        Bench::settle();
        look(*bench.window);
    }
    silent.removeDuplicates();
    QVERIFY2(silent.isEmpty(), qPrintable(silent.join(", ")));
}

/// Where the inspector was put away, the keyboard went to a field that nobody sees.
void TestWindowFrame::markedStretch_opensTheInspectorThatAsksForItsReason()
{
    Bench bench;
    bench.openSample();
    bench.window->showPage(static_cast<int>(Page::Window));
    auto *inspector = bench.find<QDockWidget>("inspectorDock");
    inspector->hide();
    emit bench.find<PlotWidget>("windowPlot")->spanMarked({2e-5, 4e-5});
    QVERIFY(inspector->isVisible());
    QVERIFY(bench.find<QLineEdit>("stretchReason")->isVisible());
    QCOMPARE(QApplication::focusWidget(), bench.find<QLineEdit>("stretchReason"));
}

void TestWindowFrame::toolBar_hasSignsAndKeys()
{
    const Bench bench;
    const auto *bar = bench.find<QToolBar>("toolBar");
    int signs = 0;
    for (const QAction *action : bar->actions()) {
        if (action->isSeparator())
            continue;
        ++signs;
        QVERIFY2(!action->icon().isNull(), qPrintable(action->objectName()));
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        QVERIFY2(!keys.isEmpty() && action->toolTip().endsWith("(" + keys + ")"),
            qPrintable(action->objectName() + ": " + action->toolTip()));
    }
    QCOMPARE(signs, 9);
}

void TestWindowFrame::toolBar_undoAndStages()
{
    Bench bench;
    bench.openSample();
    const auto press = [&](const char *name) {
        auto *bar = bench.find<QToolBar>("toolBar");
        QTest::mouseClick(bar->widgetForAction(bench.find<QAction>(name)), Qt::LeftButton);
    };
    press("nextStageAction");
    QVERIFY(bench.window->pages()[1]->isVisible());
    press("previousStageAction");
    press("previousStageAction"); // there is none before the first
    QVERIFY(bench.window->pages()[0]->isVisible());
    Recipe recipe = bench.window->session().recipe();
    recipe.realization.order = Index(5);
    bench.window->session().apply(recipe, "Change the order");
    press("undoAction");
    QVERIFY(bench.window->session().recipe().realization.order.isAuto());
    press("redoAction");
    QCOMPARE(bench.window->session().recipe().realization.order.value, std::optional<Index>(5));
}

void TestWindowFrame::sheet_isMadeOfTheActions()
{
    const Bench bench;
    const auto rows = shortcutsOf(*bench.window);
    const auto has = [&](const QString &keys, const QString &what) {
        return std::ranges::find(rows, std::pair(keys, what)) != rows.end();
    };
    QVERIFY(has("Ctrl+S", "Save"));
    QVERIFY(has("Alt+9", "Checks"));
    QVERIFY(has("Alt+Y", "Uncertainty"));
    QVERIFY(has("Alt+J", "Comparison"));
    QVERIFY(has("Alt+0", "Certificate"));
    QVERIFY(has("F6", "Findings"));
    QVERIFY(has("Alt+Right", "Next stage"));
    for (const QMenu *menu : bench.window->menuBar()->findChildren<QMenu *>())
        for (const QAction *action : menu->actions())
            for (const QKeySequence &keys : action->shortcuts())
                QVERIFY2(std::ranges::any_of(rows,
                             [&](const auto &row) {
                                 return row.first.split(", ").contains(
                                     keys.toString(QKeySequence::NativeText));
                             }),
                    qPrintable(action->objectName()));
    QVERIFY(bench.find<QAction>("shortcutsAction")->shortcuts().contains(QKeySequence("?")));
}

DYNCAL_TEST(TestWindowFrame)
#include "tst_window_frame.moc"
