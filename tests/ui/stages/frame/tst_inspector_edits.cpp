// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/stages/frame/optional_edit.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/frame/refusal_note.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/window/interval_edit.h"
#include "ui/text/quantity_format.h"

#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSignalSpy>
#include <QToolButton>
#include <QWheelEvent>
#include <QtTest>

using namespace dyncal;

class TestInspectorEdits : public QObject
{
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }

    void quantity_typed_isSi_data();
    void quantity_typed_isSi();
    void quantity_shownInSwedish_hasComma();
    void quantity_outOfRange_isNotTaken();
    void quantity_setSi_isSilent();
    void quantity_setWhileTyping_keepsTheText();
    void auto_unticked_takesTheShownValue();
    void auto_ticked_showsWhatWasUsed();
    void auto_typed_unticksAtTheFirstKey();
    void auto_typedAsItStands_isThatValue();
    void auto_typedNonsenseOrEscape_staysAuto();
    void interval_typed_unticks();
    void wheel_withoutFocus_changesNothing();
    void refusal_standsBelowTheField_untilTheNextKey();
    void refusal_isNotPutIntoAWindowThatCloses();
    void recorded_isAValueWithItsOrigin();
    void optional_emptied_isUnknown();
    void optional_nonsense_isNotTaken();
    void interval_reversed_isNotHandedOn();
    void table_copied_isTabSeparated();
    void shown_quantities_data();
    void shown_quantities();
    void shown_besideAnother_hasItsPrefix();
    void shown_result_hasTheDigitsOfItsUncertainty();
};

void TestInspectorEdits::quantity_typed_isSi_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<double>("si");
    QTest::newRow("point") << "120.5" << 120.5e-6;
    QTest::newRow("comma") << "120,5" << 120.5e-6;
    QTest::newRow("unit") << "120.5 µs" << 120.5e-6;
    QTest::newRow("blank") << " 7 " << 7e-6;
    QTest::newRow("negative") << "-3,25" << -3.25e-6;
    QTest::newRow("exponent") << "1e2" << 100e-6;
}

void TestInspectorEdits::quantity_typed_isSi()
{
    QFETCH(QString, typed);
    QFETCH(double, si);
    QuantityEdit edit({"µs", 1e-6}, -1.0, 1.0, 6);
    QSignalSpy edited(&edit, &QuantityEdit::edited);
    edit.selectAll();
    edit.findChild<QLineEdit *>()->insert(typed); // key clicks know no 'µ'
    QTest::keyClick(&edit, Qt::Key_Return);
    QCOMPARE(edit.si(), si);
    QCOMPARE(edited.count(), 1);
}

void TestInspectorEdits::quantity_shownInSwedish_hasComma()
{
    QLocale::setDefault(QLocale(QLocale::Swedish));
    QuantityEdit edit({"kHz", 1e3}, 0.0, 1e9, 6);
    edit.setSi(2330.5e3);
    QCOMPARE(edit.text(), QString("2330,5 kHz"));
    QLocale::setDefault(QLocale::c());
}

void TestInspectorEdits::quantity_outOfRange_isNotTaken()
{
    QuantityEdit edit({"µs", 1e-6}, 0.0, 1e-3, 6);
    edit.setSi(5e-6);
    QSignalSpy edited(&edit, &QuantityEdit::edited);
    edit.selectAll();
    QTest::keyClicks(&edit, "abc");
    QTest::keyClick(&edit, Qt::Key_Return);
    QCOMPARE(edit.si(), 5e-6);
    QCOMPARE(edited.count(), 0);
}

void TestInspectorEdits::quantity_setSi_isSilent()
{
    QuantityEdit edit({"µs", 1e-6}, 0.0, 1e-3, 6);
    QSignalSpy edited(&edit, &QuantityEdit::edited);
    edit.setSi(3e-6);
    QCOMPARE(edited.count(), 0);
    QCOMPARE(edit.si(), 3e-6);
}

void TestInspectorEdits::quantity_setWhileTyping_keepsTheText()
{
    QuantityEdit edit({"µs", 1e-6}, 0.0, 1e-3, 6);
    edit.show();
    edit.setFocus();
    edit.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&edit));
    edit.selectAll();
    QTest::keyClicks(&edit, "12");
    edit.setSi(99e-6); // a result that arrives meanwhile
    QTest::keyClick(&edit, Qt::Key_Return);
    QCOMPARE(edit.si(), 12e-6);
}

void TestInspectorEdits::auto_unticked_takesTheShownValue()
{
    AutoEdit edit({"µs", 1e-6}, 0.0, 1.0, 6);
    edit.setNames("end", "End");
    edit.set({}, 1.5e-3);
    std::optional<Auto<double>> got;
    connect(&edit, &AutoEdit::edited, this, [&](const Auto<double> &value) { got = value; });
    edit.findChild<QCheckBox *>("endAuto")->click();
    QVERIFY(got && got->value);
    QCOMPARE(*got->value, 1.5e-3);
    edit.set(*got, {});
    edit.findChild<QCheckBox *>("endAuto")->click();
    QVERIFY(got->isAuto());
}

void TestInspectorEdits::auto_ticked_showsWhatWasUsed()
{
    AutoEdit edit({"µs", 1e-6}, 0.0, 1.0, 6);
    edit.setNames("end", "End");
    edit.set({}, 2e-3);
    const auto *value = edit.findChild<QuantityEdit *>("endValue");
    QCOMPARE(value->text(), QString("2000 µs"));
    edit.set(Auto<double>(1e-3), 2e-3);
    QCOMPARE(value->text(), QString("1000 µs"));
}

void TestInspectorEdits::auto_typed_unticksAtTheFirstKey()
{
    AutoEdit edit({"µs", 1e-6}, 0.0, 1.0, 6);
    edit.setNames("end", "End");
    edit.set({}, 2e-3);
    auto *value = edit.findChild<QuantityEdit *>("endValue");
    auto *box = edit.findChild<QCheckBox *>("endAuto");
    QVector<Auto<double>> got;
    connect(&edit, &AutoEdit::edited, this, [&](const Auto<double> &one) { got << one; });
    value->selectAll();
    QTest::keyClicks(value, "1,5 ");
    QVERIFY(!box->isChecked());
    QVERIFY(got.empty());
    edit.set({}, 3e-3); // results arrive meanwhile
    QVERIFY(!box->isChecked());
    QTest::keyClicks(value, "ms");
    QTest::keyClick(value, Qt::Key_Return);
    QCOMPARE(got.size(), 1);
    QVERIFY(std::abs(*got[0].value - 1.5e-3) < 1e-15);
    QVERIFY(!box->isChecked());
}

void TestInspectorEdits::auto_typedAsItStands_isThatValue()
{
    AutoEdit edit({"µs", 1e-6}, 0.0, 1.0, 6);
    edit.setNames("end", "End");
    edit.set({}, 2e-3);
    auto *value = edit.findChild<QuantityEdit *>("endValue");
    QVector<Auto<double>> got;
    connect(&edit, &AutoEdit::edited, this, [&](const Auto<double> &one) { got << one; });
    value->selectAll();
    QTest::keyClicks(value, "2 ms"); // what the rule decided, from now on by hand
    QTest::keyClick(value, Qt::Key_Return);
    QCOMPARE(got.size(), 1);
    QCOMPARE(*got[0].value, 2e-3);
}

void TestInspectorEdits::auto_typedNonsenseOrEscape_staysAuto()
{
    AutoEdit edit({"µs", 1e-6}, 0.0, 1.0, 6);
    edit.setNames("end", "End");
    edit.set({}, 2e-3);
    auto *value = edit.findChild<QuantityEdit *>("endValue");
    auto *box = edit.findChild<QCheckBox *>("endAuto");
    int edits = 0;
    connect(&edit, &AutoEdit::edited, this, [&] { ++edits; });
    for (const Qt::Key end : {Qt::Key_Return, Qt::Key_Escape}) {
        value->selectAll();
        QTest::keyClicks(value, "12 furlong");
        QVERIFY(!box->isChecked());
        QTest::keyClick(value, end);
        QVERIFY(box->isChecked());
        QCOMPARE(value->text(), QString("2000 µs"));
    }
    QCOMPARE(edits, 0);
}

void TestInspectorEdits::interval_typed_unticks()
{
    IntervalEdit edit({"µs", 1e-6}, -1.0, 1.0);
    edit.setNames("band", "Band");
    edit.set({}, Interval{1e-5, 2e-5});
    std::optional<Interval> got;
    connect(&edit, &IntervalEdit::edited, this, [&](const Auto<Interval> &b) { got = b.value; });
    auto *end = edit.findChild<QuantityEdit *>("bandEnd");
    end->selectAll();
    QTest::keyClicks(end, "0,05 ms");
    QVERIFY(!edit.findChild<QCheckBox *>("bandAuto")->isChecked());
    QTest::keyClick(end, Qt::Key_Return);
    QVERIFY(got);
    QCOMPARE(got->begin, 1e-5);
    QVERIFY(std::abs(got->end - 5e-5) < 1e-15);
}

void TestInspectorEdits::wheel_withoutFocus_changesNothing()
{
    AutoEdit edit({"µs", 1e-6}, 0.0, 1.0, 6);
    edit.setNames("end", "End");
    edit.set({}, 2e-3);
    edit.show();
    auto *value = edit.findChild<QuantityEdit *>("endValue");
    edit.findChild<QCheckBox *>("endAuto")->setFocus();
    QWheelEvent wheel(QPointF(5, 5), value->mapToGlobal(QPointF(5, 5)), {}, {0, 120}, Qt::NoButton,
        Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(value, &wheel);
    QCOMPARE(value->si(), 2e-3);
    QVERIFY(!wheel.isAccepted()); // the page scrolls
}

void TestInspectorEdits::refusal_standsBelowTheField_untilTheNextKey()
{
    QWidget window;
    window.resize(400, 200);
    auto *edit = new OptionalEdit({"K", 1.0}, 1.0, 5000.0, &window);
    edit->setNames("T1", "T1");
    auto *spin = new QuantityEdit({"kHz", 1e3}, 0.0, 1e9, 6, &window);
    spin->move(0, 60);
    window.show();
    auto *text = edit->findChild<QLineEdit *>("T1Value");
    QTest::keyClicks(text, "21 furlong");
    QTest::keyClick(text, Qt::Key_Return);
    QVERIFY2(refusalOnShow(edit).contains("°C"), qPrintable(refusalOnShow(edit)));
    QTest::keyClicks(text, "9000"); // the field's range
    QVERIFY(refusalOnShow(edit).isEmpty());
    QTest::keyClick(text, Qt::Key_Return);
    QVERIFY2(refusalOnShow(edit).contains("5000 K"), qPrintable(refusalOnShow(edit)));
    spin->selectAll();
    QTest::keyClicks(spin, "1,234");
    QTest::keyClick(spin, Qt::Key_Return);
    QVERIFY2(refusalOnShow(spin).contains("1234"), qPrintable(refusalOnShow(spin)));
    const auto *note = window.findChild<QLabel *>("refusalNote");
    QVERIFY(window.rect().contains(note->geometry()));
    QVERIFY(!note->geometry().intersects(spin->geometry()));
}

void TestInspectorEdits::refusal_isNotPutIntoAWindowThatCloses()
{
    auto window = std::make_unique<QWidget>();
    auto *other = new QLineEdit(window.get());
    auto *edit = new QuantityEdit({"kHz", 1e3}, 0.0, 1e6, 3, window.get());
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window.get()));
    other->setFocus();
    QTest::keyClicks(edit->findChild<QLineEdit *>(), "banana"); // by a program that needs no focus
    window->close();
    QVERIFY(!window->findChild<QLabel *>("refusalNote"));
    window.reset(); // the focus chain of its children is whole
}

void TestInspectorEdits::recorded_isAValueWithItsOrigin()
{
    OptionalEdit edit({"K", 1.0}, 1.0, 5000.0);
    edit.setNames("T1", "T1");
    edit.set({}, 294.15);
    edit.show();
    auto *text = edit.findChild<QLineEdit *>("T1Value");
    const auto *origin = edit.findChild<QLabel *>("T1Origin");
    auto *back = edit.findChild<QToolButton *>("T1UseRecorded");
    QVector<std::optional<double>> got;
    connect(&edit, &OptionalEdit::edited, this, [&](const auto &value) { got << value; });
    const auto holdsRecorded = [&] {
        return text->text() == "294.15" && origin->isVisible() && origin->text() == "recorded"
            && !back->isVisible();
    };
    QVERIFY(holdsRecorded());
    for (const bool byButton : {true, false}) {
        text->selectAll();
        QTest::keyClicks(text, "20 C");
        QTest::keyClick(text, Qt::Key_Return);
        QCOMPARE(*got.last(), 293.15);
        QVERIFY(!origin->isVisible() && back->isVisible());
        if (byButton) {
            QTest::mouseClick(back, Qt::LeftButton);
        } else {
            text->selectAll();
            QTest::keyClick(text, Qt::Key_Delete);
            QTest::keyClick(text, Qt::Key_Return);
        }
        QVERIFY(!got.last());
        QVERIFY(holdsRecorded());
    }
    QCOMPARE(got.size(), 4);
}

void TestInspectorEdits::optional_emptied_isUnknown()
{
    OptionalEdit edit({"kPa", 1e3}, 1.0, 1e9);
    edit.setNames("p1", "p1");
    edit.set(101.1e3, 100e3);
    auto *text = edit.findChild<QLineEdit *>("p1Value");
    QCOMPARE(text->text(), QString("101.1"));
    int signalled = 0;
    std::optional<double> got = 1.0;
    connect(&edit, &OptionalEdit::edited, this, [&](const std::optional<double> &value) {
        got = value;
        ++signalled;
    });
    text->selectAll();
    QTest::keyClick(text, Qt::Key_Delete);
    QTest::keyClick(text, Qt::Key_Return);
    QCOMPARE(signalled, 1);
    QVERIFY(!got);
    QCOMPARE(text->text(), QString("100")); // the recorded one
    text->selectAll();
    QTest::keyClicks(text, "99,5");
    QTest::keyClick(text, Qt::Key_Return);
    QCOMPARE(*got, 99.5e3);
}

void TestInspectorEdits::optional_nonsense_isNotTaken()
{
    OptionalEdit edit({"kPa", 1e3}, 1.0, 1e9);
    edit.setNames("p1", "p1");
    edit.set(101.1e3);
    auto *text = edit.findChild<QLineEdit *>("p1Value");
    int signalled = 0;
    connect(&edit, &OptionalEdit::edited, this, [&] { ++signalled; });
    for (const char *typed : {"abc", "-5", "1.2.3", "nan"}) {
        text->selectAll();
        QTest::keyClicks(text, typed);
        QTest::keyClick(text, Qt::Key_Return);
        QCOMPARE(text->text(), QString("101.1"));
    }
    QCOMPARE(signalled, 0);
}

void TestInspectorEdits::interval_reversed_isNotHandedOn()
{
    IntervalEdit edit({"µs", 1e-6}, -1.0, 1.0);
    edit.setNames("band", "Band");
    edit.set(Auto<Interval>(Interval{1e-5, 2e-5}), {});
    int signalled = 0;
    std::optional<Interval> got;
    connect(&edit, &IntervalEdit::edited, this, [&](const Auto<Interval> &band) {
        ++signalled;
        got = band.value;
    });
    edit.findChild<QuantityEdit *>("bandBegin")->setValue(50.0);
    QCOMPARE(signalled, 0);
    edit.findChild<QuantityEdit *>("bandEnd")->setValue(60.0);
    QCOMPARE(signalled, 1);
    QCOMPARE(got->begin, 50e-6);
    QCOMPARE(got->end, 60e-6);
}

void TestInspectorEdits::table_copied_isTabSeparated()
{
    ValueTable table("t", "t");
    table.setValues({"a", "b"}, {{"1", "2"}, {"3", "4"}});
    QCOMPARE(table.selectedText(), QString("1\t2\n3\t4"));
    table.item(1, 1)->setSelected(true);
    QCOMPARE(table.selectedText(), QString("4"));
    table.setValues({"a"}, {{"5"}});
    QCOMPARE(table.rowCount(), 1);
    QCOMPARE(table.item(0, 0)->text(), QString("5"));
}

void TestInspectorEdits::shown_quantities_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QString>("shown");
    QTest::newRow("prefix") << 2.33e6 << "Hz"
                            << "2,33 MHz";
    QTest::newRow("compound unit") << 5.02e-6 << "V/Pa"
                                   << "5,02 µV/Pa";
    QTest::newRow("no unit") << 0.0225 << ""
                             << "0,0225";
    QTest::newRow("unknown") << std::nan("") << "Hz"
                             << "–";
}

void TestInspectorEdits::shown_quantities()
{
    QFETCH(double, value);
    QFETCH(QString, unit);
    QFETCH(QString, shown);
    QLocale::setDefault(QLocale(QLocale::Swedish));
    QCOMPARE(shownQuantity(value, unit), shown);
    QLocale::setDefault(QLocale::c());
}

void TestInspectorEdits::shown_besideAnother_hasItsPrefix()
{
    QCOMPARE(shownQuantityBeside(720.0, 169.68e3, "Pa", 2), QString("0.72 kPa"));
    QCOMPARE(shownQuantityBeside(1.3e3, 434.36e3, "Pa", 2), QString("1.3 kPa"));
    QCOMPARE(shownQuantityBeside(0.141, 431.2, "m/s", 3), QString("0.141 m/s"));
    QCOMPARE(shownQuantityBeside(2e-4, -0.8, "m", 2), QString("0.2 mm"));
    QCOMPARE(shownQuantityBeside(3.9e-7, 0.0, "s", 2), QString("390 ns")); // nothing to go by
    QCOMPARE(shownQuantityBeside(0.0008, 1.25, "", 2), QString("0.0008"));
}

void TestInspectorEdits::shown_result_hasTheDigitsOfItsUncertainty()
{
    const ShownResult f0 = shownResult(2.33e6, 130.0, "Hz");
    QCOMPARE(f0.value, QString("2.33000 MHz"));
    QCOMPARE(f0.u, QString("0.00013 MHz"));
    QCOMPARE(shownWithU(2.33e6, 130.0, "Hz"), QString("2.33000 MHz ± 0.00013 MHz"));
    QCOMPARE(shownWithU(0.02, 9.3e-5, {}), QString("0.020000 ± 0.000093"));
    QCOMPARE(shownWithU(1.0, 0.012, "1"), QString("1.000 ± 0.012"));
    QCOMPARE(shownWithU(2.33e6, std::nan(""), "Hz"), QString("2.3300 MHz"));
    QCOMPARE(shownResult(2.33e6, 0.0, "Hz").u, QString("–"));
    QCOMPARE(shownWithU(std::nan(""), 1.0, "Hz"), QString("–"));
    QLocale::setDefault(QLocale(QLocale::Swedish));
    QCOMPARE(shownWithU(2.33e6, 130.0, "Hz"), QString("2,33000 MHz ± 0,00013 MHz"));
    QLocale::setDefault(QLocale::c());
}

DYNCAL_TEST(TestInspectorEdits)
#include "tst_inspector_edits.moc"
