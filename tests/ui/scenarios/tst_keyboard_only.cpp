// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/scenarios/scenario_words.h"
#include "ui/shell/preferences/theme_style.h"
#include "ui/shell/stage_list.h"
#include "ui/stages/frame/cursor_table.h"

#include <QAbstractSpinBox>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>

using namespace dyncal;
using namespace dyncal::test;

/// The example from opening to the draft of the certificate without the mouse, at twice the size of
/// letters and in the dark theme. That both themes have contrast is tested with the themes.
class TestKeyboardOnly : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void s27_everyStage_isReachedAndSettled();
    void s27_everyControl_hasANameForAReader();
    void s27_tab_goesThroughControlsThatAreSeen();
    void s27_numbersOfAPlot_areReadByKeys();
    void cleanupTestCase();

private:
    void press(int key, Qt::KeyboardModifiers modifiers = {})
    {
        QWidget *focused = m_bench->window->focusWidget();
        QTest::keyClick(
            focused ? focused : m_bench->window.get(), static_cast<Qt::Key>(key), modifiers);
        m_bench->settle();
    }
    std::unique_ptr<ScenarioBench> m_bench;
    QFont m_font;
};

void TestKeyboardOnly::initTestCase()
{
    m_font = QApplication::font();
    QFont large = m_font;
    large.setPointSizeF(2.0 * m_font.pointSizeF());
    QApplication::setFont(large);
    useTheme(ThemeKind::Dark);
    m_bench = std::make_unique<ScenarioBench>();
    m_bench->window->activateWindow();
    m_bench->window->files().setExampleDuration(0.006);
    QWidget *start = m_bench->find<QPushButton>("startOpenExample");
    for (int i = 0; i < 20 && m_bench->window->focusWidget() != start; ++i)
        QTest::keyClick(m_bench->window.get(), Qt::Key_Tab);
    QCOMPARE(m_bench->window->focusWidget(), start);
    QVERIFY(m_bench->window->palette().window().color().lightness() < 100);
    press(Qt::Key_Space);
    QTRY_VERIFY(m_bench->session().state().hasShots());
    m_bench->settle();
}

void TestKeyboardOnly::cleanupTestCase()
{
    m_bench.reset();
    QApplication::setFont(m_font);
    useTheme(ThemeKind::Light);
}

void TestKeyboardOnly::s27_everyStage_isReachedAndSettled()
{
    for (int page = 0; page < kPageCount; ++page) {
        const QKeyCombination keys = stageKeys(static_cast<Page>(page))[0];
        press(keys.key(), keys.keyboardModifiers());
        QVERIFY2(m_bench->window->pages()[static_cast<std::size_t>(page)]->isVisible(),
            qPrintable(QString::number(page)));
    }
    press(Qt::Key_1 + static_cast<int>(Page::Order), Qt::AltModifier);
    m_bench->find<PlotWidget>("singularValuePlot")->setFocus(Qt::TabFocusReason);
    press(Qt::Key_Right);
    press(Qt::Key_Home);
    press(Qt::Key_Return); // adopts
    DYNCAL_SAYS(m_bench->text("adoption"), "adopted");
    m_bench->prompts.setNextFile(m_bench->folder.filePath("draft.pdf"));
    press(Qt::Key_P, Qt::ControlModifier);
    QTRY_VERIFY(QFile::exists(m_bench->folder.filePath("draft.pdf")));
}

void TestKeyboardOnly::s27_everyControl_hasANameForAReader()
{
    for (int page = 0; page < kPageCount; ++page) {
        m_bench->window->showPage(page);
        for (const QWidget *control : m_bench->window->findChildren<QWidget *>()) {
            const auto *button = qobject_cast<const QAbstractButton *>(control);
            const bool isField = qobject_cast<const QComboBox *>(control)
                || qobject_cast<const QAbstractSpinBox *>(control)
                || qobject_cast<const PlotWidget *>(control)
                || qobject_cast<const QTableWidget *>(control)
                || (qobject_cast<const QLineEdit *>(control)
                    && !qobject_cast<const QAbstractSpinBox *>(control->parent())
                    && !qobject_cast<const QComboBox *>(control->parent()));
            if (!control->isVisible() || !control->isEnabled()
                || control->focusPolicy() == Qt::NoFocus || (!button && !isField))
                continue;
            const bool isNamed
                = !control->accessibleName().isEmpty() || (button && !button->text().isEmpty());
            QVERIFY2(isNamed,
                qPrintable(QString("page %1: %2 %3")
                               .arg(page)
                               .arg(control->metaObject()->className(), control->objectName())));
        }
    }
}

/// Once round every page: the focus is always on something that is on the screen, and no table
/// keeps it.
void TestKeyboardOnly::s27_tab_goesThroughControlsThatAreSeen()
{
    for (int page = 0; page < kPageCount; ++page) {
        m_bench->window->showPage(page);
        QSet<QWidget *> reached;
        for (int i = 0; i < 150; ++i) {
            QWidget *from = m_bench->window->focusWidget();
            QTest::keyClick(from ? from : m_bench->window.get(), Qt::Key_Tab);
            QWidget *focused = m_bench->window->focusWidget();
            QVERIFY(focused && focused->isVisible());
            QVERIFY2(!focused->visibleRegion().isEmpty(),
                qPrintable(QString("%1 after %2")
                               .arg(focused->objectName(), from ? from->objectName() : QString())));
            reached.insert(focused);
        }
        QVERIFY2(
            reached.size() > 5, qPrintable(QString("page %1: %2").arg(page).arg(reached.size())));
    }
}

/// The menu key offers the values at the cursors as a table, and all data of the plot to copy.
void TestKeyboardOnly::s27_numbersOfAPlot_areReadByKeys()
{
    m_bench->window->showPage(static_cast<int>(Page::Order));
    auto *plot = m_bench->find<PlotWidget>("singularValuePlot");
    plot->setFocus(Qt::TabFocusReason);
    const auto choose = [plot](const QString &words) {
        const QPoint middle = plot->rect().center();
        QContextMenuEvent event(QContextMenuEvent::Keyboard, middle, plot->mapToGlobal(middle));
        QApplication::sendEvent(plot, &event);
        auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
        for (QAction *action : menu->actions()) {
            if (action->text() != words)
                continue;
            while (menu->activeAction() != action)
                QTest::keyClick(menu, Qt::Key_Down);
            QTest::keyClick(menu, Qt::Key_Return);
            return true;
        }
        return false;
    };
    QVERIFY(choose("Copy data"));
    const QStringList rows = QApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
    QVERIFY2(rows.size() > 20 && rows[1].contains('\t'), qPrintable(rows.value(0)));
    QVERIFY(choose("Values at the cursors"));
    QVERIFY(m_bench->window->findChild<CursorTable *>()->isVisible());
}

DYNCAL_TEST(TestKeyboardOnly)
#include "tst_keyboard_only.moc"
