// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/window/interval_edit.h"
#include "ui/text/quantity_format.h"

#include <QCheckBox>
#include <QLineEdit>
#include <QLocale>
#include <QSignalSpy>
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
    void auto_ticked_isReadOnlyAndShowsWhatWasUsed();
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

void TestInspectorEdits::auto_ticked_isReadOnlyAndShowsWhatWasUsed()
{
    AutoEdit edit({"µs", 1e-6}, 0.0, 1.0, 6);
    edit.setNames("end", "End");
    edit.set({}, 2e-3);
    const auto *value = edit.findChild<QuantityEdit *>("endValue");
    QVERIFY(value->isReadOnly());
    QCOMPARE(value->text(), QString("2000 µs"));
    edit.set(Auto<double>(1e-3), 2e-3);
    QVERIFY(!value->isReadOnly());
    QCOMPARE(value->text(), QString("1000 µs"));
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
