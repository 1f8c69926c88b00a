// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/ui/scenarios/scenario_bench.h"

#include <QAbstractSpinBox>
#include <QDialog>
#include <QMenu>
#include <QTimer>
#include <QWheelEvent>

#include <functional>
#include <random>
#include <vector>

namespace dyncal::test {

inline constexpr int kAnswers_ms = 40;

inline const QStringList kTexts{"", "0", "1", "-1", "3", "17", "0.5", "1e300", "nan", "inf",
    "banana", "21 °C", "10 MHz", "1,5 ms", "2 psi", "-0,0001", "999999999999", "2026-02-30",
    "<b>x</b>", "µV/Pa", "𝛇 0.02", "a\tb"};

inline constexpr Qt::Key kKeys[] = {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down,
    Qt::Key_Home, Qt::Key_End, Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Return, Qt::Key_Escape,
    Qt::Key_Space, Qt::Key_Tab, Qt::Key_Backtab, Qt::Key_Delete, Qt::Key_Plus, Qt::Key_Minus,
    Qt::Key_A, Qt::Key_M, Qt::Key_G, Qt::Key_Z};

inline constexpr Qt::KeyboardModifiers kModifiers[] = {Qt::NoModifier, Qt::NoModifier,
    Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier};

/// Also letters for which Qt Test knows no key.
inline void typeInto(const QPointer<QLineEdit> &field, const QString &text)
{
    for (const char32_t letter : text.toUcs4()) {
        QKeyEvent press(QEvent::KeyPress, 0, Qt::NoModifier, QString::fromUcs4(&letter, 1));
        if (field)
            QCoreApplication::sendEvent(field, &press);
    }
}

/// Qt Test's own click and key go on with a widget that went away when it was pressed.
inline void click(const QPointer<QWidget> &widget, Qt::MouseButton button, QPoint at)
{
    QTest::mousePress(widget, button, {}, at);
    if (widget)
        QTest::mouseRelease(widget, button, {}, at);
}

/// A field that is disabled by what Return has started gets no key any more either.
inline void strike(
    const QPointer<QWidget> &widget, Qt::Key key, Qt::KeyboardModifiers modifiers = {})
{
    if (widget && widget->isEnabled())
        QTest::keyPress(widget, key, modifiers);
    if (widget && widget->isEnabled())
        QTest::keyRelease(widget, key, modifiers);
}

inline QString nameOf(const QObject *object)
{
    return QString("%1 %2").arg(object->metaObject()->className(), object->objectName());
}

/// Clicks, types, drags, turns the wheel and chooses from menus at random: the same acts for the
/// same seed, as far as the window is the same. Dialogs and menus that open are answered at random.
class Monkey
{
public:
    Monkey(const ScenarioBench &bench, unsigned seed);

    /// One act; what it was, to be told when something broke.
    QString act();

private:
    int draw(int below); ///< 0 to below - 1
    bool chance(int percent) { return draw(100) < percent; }
    QWidget *anyControl();

    QString clickSomething();
    QString typeSomething();
    QString pressSomething();
    QString dragInAPlot();
    QString turnAWheel();
    QString openAMenu();
    QString triggerSomething();
    QString changeTheWindow();
    void answer();

    const ScenarioBench &m_bench;
    std::mt19937 m_random;
    QTimer m_answers;
    std::vector<std::function<QString()>> m_acts;
};

inline Monkey::Monkey(const ScenarioBench &bench, unsigned seed)
    : m_bench(bench)
    , m_random(seed)
    , m_acts{[this] { return clickSomething(); }, [this] { return clickSomething(); },
          [this] { return typeSomething(); }, [this] { return pressSomething(); },
          [this] { return dragInAPlot(); }, [this] { return turnAWheel(); },
          [this] { return openAMenu(); }, [this] { return triggerSomething(); },
          [this] { return changeTheWindow(); }}
{
    QObject::connect(&m_answers, &QTimer::timeout, &m_answers, [this] { answer(); });
    m_answers.start(kAnswers_ms);
}

inline QString Monkey::act()
{
    return m_acts[static_cast<std::size_t>(draw(static_cast<int>(m_acts.size())))]();
}

inline int Monkey::draw(int below)
{
    // Not std::uniform_int_distribution, which differs from library to library.
    return static_cast<int>(m_random() % static_cast<unsigned>(below));
}

inline QWidget *Monkey::anyControl()
{
    QList<QWidget *> seen;
    for (QWidget *widget : m_bench.window->findChildren<QWidget *>())
        if (widget->isVisible() && widget->isEnabled() && widget->focusPolicy() != Qt::NoFocus
            && !widget->visibleRegion().isEmpty())
            seen << widget;
    return seen.isEmpty() ? nullptr : seen[draw(static_cast<int>(seen.size()))];
}

inline QString Monkey::clickSomething()
{
    QPointer<QWidget> control = anyControl();
    if (!control)
        return {};
    const QString name = nameOf(control);
    const QPoint at(draw(std::max(1, control->width())), draw(std::max(1, control->height())));
    if (auto *table = qobject_cast<QAbstractItemView *>(control.data()))
        control = table->viewport();
    const bool isDouble = chance(10);
    const Qt::MouseButton button = isDouble || chance(85) ? Qt::LeftButton : Qt::RightButton;
    click(control, button, at);
    if (isDouble && control)
        QTest::mouseEvent(QTest::MouseDClick, control, button, {}, at);
    if (isDouble && control)
        QTest::mouseRelease(control, button, {}, at);
    return "click " + name;
}

inline QString Monkey::typeSomething()
{
    QList<QLineEdit *> fields;
    for (QLineEdit *field : m_bench.window->findChildren<QLineEdit *>())
        if (field->isVisible() && field->isEnabled() && !field->isReadOnly())
            fields << field;
    if (fields.isEmpty())
        return {};
    const QPointer<QLineEdit> field = fields[draw(static_cast<int>(fields.size()))];
    const QString text = kTexts[draw(static_cast<int>(kTexts.size()))];
    const QString name = nameOf(field) + " of " + nameOf(field->parentWidget());
    const QPointer<QWidget> owner = qobject_cast<QAbstractSpinBox *>(field->parentWidget());
    field->setFocus(Qt::MouseFocusReason);
    if (field)
        field->selectAll();
    if (text.isEmpty())
        strike(field.data(), Qt::Key_Delete);
    else
        typeInto(field, text);
    if (chance(70))
        strike(owner ? owner : QPointer<QWidget>(field.data()),
            chance(80) ? Qt::Key_Return : Qt::Key_Escape);
    return QString("type \"%1\" into %2").arg(text, name);
}

inline QString Monkey::pressSomething()
{
    QWidget *focused = m_bench.window->focusWidget();
    const Qt::Key key = kKeys[draw(static_cast<int>(std::size(kKeys)))];
    const Qt::KeyboardModifiers modifiers
        = kModifiers[draw(static_cast<int>(std::size(kModifiers)))];
    const QString name = focused ? nameOf(focused) : QString("no focus");
    strike(focused ? focused : m_bench.window.get(), key, modifiers);
    return QString("key %1 %2 to %3").arg(int(key), 0, 16).arg(modifiers.toInt(), 0, 16).arg(name);
}

inline QString Monkey::dragInAPlot()
{
    QList<PlotWidget *> plots;
    for (PlotWidget *plot : m_bench.window->findChildren<PlotWidget *>())
        if (plot->isVisible() && !plot->visibleRegion().isEmpty())
            plots << plot;
    if (plots.isEmpty())
        return {};
    const QPointer<PlotWidget> plot = plots[draw(static_cast<int>(plots.size()))];
    const QString name = nameOf(plot);
    const auto point = [&] { return QPoint(draw(plot->width() + 40) - 20, draw(plot->height())); };
    QPoint from = point();
    if (!plot->handles().empty() && chance(70)) {
        const HandleState &handle = plot->handles()[static_cast<std::size_t>(
            draw(static_cast<int>(plot->handles().size())))];
        from = plot->pixelOf(handle.x.begin, 0.5 * (plot->yRange().begin + plot->yRange().end));
    }
    const Qt::MouseButton button = chance(80) ? Qt::LeftButton : Qt::RightButton;
    QTest::mousePress(plot, button, kModifiers[draw(6)], from);
    for (int i = draw(5); i >= 0 && plot; --i)
        QTest::mouseMove(plot, point());
    if (chance(10))
        strike(plot.data(), Qt::Key_Escape);
    if (plot)
        QTest::mouseRelease(plot, button, {}, point());
    return "drag in " + name;
}

inline QString Monkey::turnAWheel()
{
    QWidget *control = anyControl();
    if (!control)
        return {};
    const QString name = nameOf(control);
    const QPointF at = control->rect().center();
    QWheelEvent event(at, control->mapToGlobal(at), {}, {0, chance(50) ? 120 : -120}, Qt::NoButton,
        kModifiers[draw(6)], Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(control, &event);
    return "wheel over " + name;
}

inline QString Monkey::openAMenu()
{
    QWidget *control = anyControl();
    if (!control)
        return {};
    const QString name = nameOf(control);
    const QPoint middle = control->rect().center();
    QContextMenuEvent event(QContextMenuEvent::Keyboard, middle, control->mapToGlobal(middle));
    QCoreApplication::sendEvent(control, &event);
    return "menu of " + name;
}

/// Any command of the menus but the last one.
inline QString Monkey::triggerSomething()
{
    QList<QAction *> actions;
    for (QAction *action : m_bench.window->findChildren<QAction *>())
        if (action->isEnabled() && !action->menu() && !action->isSeparator()
            && action->objectName() != "quitAction")
            actions << action;
    if (actions.isEmpty())
        return {};
    const QPointer<QAction> action = actions[draw(static_cast<int>(actions.size()))];
    const QString name = QString("%1 \"%2\"").arg(action->objectName(), action->text());
    const_cast<ScenarioBench &>(m_bench).prompts.dropAnswers();
    if (chance(40)) {
        const QStringList files{"some.dyncal", "some.pdf", "some.svg", "missing.h5", "shots.h5"};
        const_cast<ScenarioBench &>(m_bench).prompts.setNextFile(
            m_bench.folder.filePath(files[draw(static_cast<int>(files.size()))]));
    }
    action->trigger();
    return "trigger " + name;
}

inline QString Monkey::changeTheWindow()
{
    if (chance(60)) {
        m_bench.window->showPage(draw(kPageCount));
        return "another page";
    }
    const QSize size(900 + draw(900), 600 + draw(500));
    m_bench.window->resize(size);
    return QString("resize to %1 x %2").arg(size.width()).arg(size.height());
}

/// What is open over the window would keep it for ever.
inline void Monkey::answer()
{
    if (auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget())) {
        const Qt::Key keys[] = {Qt::Key_Down, Qt::Key_Down, Qt::Key_Return, Qt::Key_Escape};
        strike(menu, keys[draw(4)]);
    } else if (const QPointer<QWidget> popup = QApplication::activePopupWidget()) {
        strike(popup, chance(50) ? Qt::Key_Down : Qt::Key_Return);
        if (chance(50) && popup)
            popup->close();
    } else if (auto *dialog = qobject_cast<QDialog *>(QApplication::activeModalWidget())) {
        dialog->reject();
    }
}

} // namespace dyncal::test
