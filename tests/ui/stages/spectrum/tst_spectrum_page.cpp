// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/spectrum/spectrum_page.h"

#include <QListWidget>
#include <QPushButton>
#include <QtTest>

#include <cmath>

using namespace dyncal;
using test::PageBench;
using test::waitComputed;

namespace {

using Bench = PageBench<SpectrumPage>;
enum Source { Search, Given, None };

void click(Bench &bench, double frequency_Hz)
{
    emit bench.control<PlotWidget>("spectrumPlot")->pointPicked(frequency_Hz, 0.0);
    waitComputed(bench.session);
}

const std::vector<NuisanceMode> &modesOf(const Bench &bench)
{
    return bench.recipe().realization.nuisanceModes;
}

void leaveOut(Bench &bench, const QString &reason)
{
    QTest::keyClicks(bench.control<QLineEdit>("nuisanceReason"), reason);
    bench.control<QPushButton>("nuisanceAdd")->click();
    waitComputed(bench.session);
}

std::optional<Interval> bandOf(const Bench &bench)
{
    return bench.recipe().spectrum.resonanceBand_Hz;
}

} // namespace

/// The resonance confirmed, given or looked for, and what is not the sensor's.
class TestSpectrumPage : public QObject
{
    Q_OBJECT

private:
    std::shared_ptr<const CaptureSet> m_set;

private slots:
    void initTestCase() { m_set = testing::simulatedExample(1e7, 0.004); }
    void init() { QLocale::setDefault(QLocale::c()); }
    void found_isTheSensorsResonance_andShownPerShot();
    void found_hasTheDigitsOfTheTable_andAllOfThemOnceGiven();
    void click_whileGiven_takesThePeak_elseMarksIt();
    void given_isUsedAndUndone();
    void band_emptied_isNoLimit();
    void band_reversed_isNotTaken();
    void band_withoutTheResonance_findsItNot_andUndoDoes();
    void mode_leftOut_isOneStep_andTakenBack();
    void mode_withBlankReason_cannotBeAdded();
    void candidate_staysChosenWhenResultsCome();
    void tubeModes_stayOfTheShotChosen();
    void swedish_frequencyTypedWithAComma();
};

void TestSpectrumPage::found_isTheSensorsResonance_andShownPerShot()
{
    Bench bench(m_set);
    auto *table = bench.control<ValueTable>("resonanceTable");
    QVERIFY(table->rowCount() >= 1);
    QCOMPARE(table->columnCount(), 3 + 3);
    const double truth_Hz = sensorPreset("optic3").value().modes.at(0).f0_Hz;
    const double found_Hz = bench.session.results().spectrum->resonances.at(0).frequency_Hz;
    QVERIFY2(std::abs(found_Hz / truth_Hz - 1.0) < 0.01, qPrintable(QString::number(found_Hz)));
    QVERIFY(std::abs(bench.control<QuantityEdit>("resonanceFrequency")->si() - found_Hz) < 1e-2);
    QVERIFY(bench.control<QuantityEdit>("resonanceFrequency")->isReadOnly()); // found, not asked
}

void TestSpectrumPage::found_hasTheDigitsOfTheTable_andAllOfThemOnceGiven()
{
    Bench bench(m_set);
    auto *field = bench.control<QuantityEdit>("resonanceFrequency");
    const double found_Hz = bench.session.results().spectrum->resonances.at(0).frequency_Hz;
    QCOMPARE(field->text(), QString::number(found_Hz / 1e3, 'f', 1) + " kHz");
    bench.choose("resonanceSource", Given);
    QCOMPARE(bench.recipe().spectrum.resonances_Hz, std::vector<double>{field->si()});
    QVERIFY(std::abs(field->si() - found_Hz) < 1e-2);
    QVERIFY2(field->text().size() > 12, qPrintable(field->text()));
}

void TestSpectrumPage::click_whileGiven_takesThePeak_elseMarksIt()
{
    Bench bench;
    click(bench, 6.8e3);
    QVERIFY(bench.recipe().spectrum.searchResonance); // it marked a nuisance
    QCOMPARE(bench.control<QuantityEdit>("nuisanceFrequency")->si(), 6.8e3);
    bench.choose("resonanceSource", Given);
    click(bench, 1.45e6);
    QCOMPARE(bench.recipe().spectrum.resonances_Hz, std::vector<double>{1.45e6});
    QCOMPARE(bench.control<QuantityEdit>("resonanceFrequency")->si(), 1.45e6);
    QCOMPARE(bench.control<QuantityEdit>("nuisanceFrequency")->si(), 6.8e3); // stays
}

void TestSpectrumPage::given_isUsedAndUndone()
{
    Bench bench(m_set);
    bench.choose("resonanceSource", Given);
    bench.control<QuantityEdit>("resonanceFrequency")->setValue(1900.0);
    waitComputed(bench.session);
    const auto used_Hz
        = [&] { return bench.session.results().spectrum->resonances.at(0).frequency_Hz; };
    QVERIFY(std::abs(used_Hz() / 1.9e6 - 1.0) < 0.01); // its highest value close by
    QVERIFY(bench.control<ValueTable>("resonanceTable")->item(0, 0)->text().startsWith("1."));
    bench.session.undoStack().undo();
    bench.session.undoStack().undo();
    waitComputed(bench.session);
    QVERIFY(bench.recipe().spectrum.searchResonance);
    QCOMPARE(bench.control<QComboBox>("resonanceSource")->currentIndex(), int(Search));
    QVERIFY(std::abs(used_Hz() / 2.33e6 - 1.0) < 0.01);
}

void TestSpectrumPage::band_emptied_isNoLimit()
{
    Bench bench;
    bench.type("resonanceBandBeginValue", "100");
    bench.type("resonanceBandEndValue", "5000");
    bench.type("resonanceBandBeginValue", " ");
    QCOMPARE(bandOf(bench)->begin, 0.0);
    QCOMPARE(bandOf(bench)->end, 5e6);
    bench.type("resonanceBandEndValue", " ");
    QVERIFY(!bandOf(bench));
    QCOMPARE(
        bench.control<QLineEdit>("resonanceBandEndValue")->placeholderText(), QString("no limit"));
}

void TestSpectrumPage::band_reversed_isNotTaken()
{
    Bench bench;
    bench.type("resonanceBandBeginValue", "100");
    bench.type("resonanceBandEndValue", "5000");
    const int steps = bench.session.undoStack().count();
    bench.type("resonanceBandBeginValue", "6000"); // a slip of the hand
    QVERIFY(bandOf(bench).has_value()); // the end that was typed is not lost by it
    QCOMPARE(bandOf(bench)->begin, 100e3);
    QCOMPARE(bandOf(bench)->end, 5e6);
    QCOMPARE(bench.control<QLineEdit>("resonanceBandBeginValue")->text(), QString("100"));
    QCOMPARE(bench.control<QLineEdit>("resonanceBandEndValue")->text(), QString("5000"));
    QCOMPARE(bench.session.undoStack().count(), steps);
}

void TestSpectrumPage::band_withoutTheResonance_findsItNot_andUndoDoes()
{
    Bench bench(m_set);
    const auto found = [&] {
        const auto &resonances = bench.session.results().spectrum->resonances;
        return !resonances.empty() && std::abs(resonances[0].frequency_Hz / 2.33e6 - 1.0) < 0.01;
    };
    QVERIFY(found());
    bench.type("resonanceBandEndValue", "1000");
    waitComputed(bench.session);
    QVERIFY(!found());
    bench.session.undoStack().undo();
    waitComputed(bench.session);
    QVERIFY(found());
    QVERIFY(bench.control<QLineEdit>("resonanceBandEndValue")->text().isEmpty());
}

void TestSpectrumPage::mode_leftOut_isOneStep_andTakenBack()
{
    Bench bench;
    click(bench, 300e3);
    bench.control<QComboBox>("nuisanceShot")->setCurrentIndex(1);
    leaveOut(bench, "the mount rings");
    QCOMPARE(modesOf(bench).size(), std::size_t(1));
    QCOMPARE(modesOf(bench)[0].shot, Index(2));
    QCOMPARE(modesOf(bench)[0].reason, std::string("the mount rings"));
    click(bench, 400e3);
    leaveOut(bench, "so does the table");
    QCOMPARE(bench.session.undoStack().count(), 2);
    auto *list = bench.control<QListWidget>("nuisanceModes");
    QCOMPARE(list->count(), 2);
    list->setCurrentRow(0); // the first goes, the second stays
    bench.control<QPushButton>("nuisanceRemove")->click();
    waitComputed(bench.session);
    QCOMPARE(modesOf(bench).size(), std::size_t(1));
    QCOMPARE(modesOf(bench)[0].frequency_Hz, std::vector<double>{400e3});
    bench.session.undoStack().undo();
    QCOMPARE(modesOf(bench).size(), std::size_t(2));
    QVERIFY(list->item(0)->text().contains("300 kHz"));
}

void TestSpectrumPage::mode_withBlankReason_cannotBeAdded()
{
    Bench bench;
    click(bench, 300e3);
    QTest::keyClicks(bench.control<QLineEdit>("nuisanceReason"), "   ");
    QVERIFY(!bench.control<QPushButton>("nuisanceAdd")->isEnabled());
    bench.control<QPushButton>("nuisanceAdd")->click();
    QVERIFY(modesOf(bench).empty());
}

void TestSpectrumPage::candidate_staysChosenWhenResultsCome()
{
    Bench bench(m_set);
    auto *candidates = bench.control<QComboBox>("nuisanceCandidates");
    QVERIFY(candidates->count() > 2);
    bench.choose("nuisanceCandidates", 1);
    const QString chosen = candidates->currentText();
    QTest::keyClicks(bench.control<QLineEdit>("nuisanceReason"), "moves with the gas");
    bench.session.recompute(); // as when the rest of a run comes in while one types
    waitComputed(bench.session);
    QCOMPARE(candidates->currentText(), chosen);
    bench.control<QPushButton>("nuisanceAdd")->click();
    QVERIFY(!modesOf(bench).at(0).label.empty()); // its name goes into the certificate
    QVERIFY(chosen.startsWith(QString::fromStdString(modesOf(bench).at(0).label)));
    waitComputed(bench.session);
}

void TestSpectrumPage::tubeModes_stayOfTheShotChosen()
{
    Bench bench(m_set);
    auto *choice = bench.control<QComboBox>("tubeModes");
    QCOMPARE(choice->currentText(), QString("of shot 3")); // the last one, unasked
    bench.choose("tubeModes", 1);
    const auto marks = bench.control<PlotWidget>("spectrumPlot")->content().marks.size();
    Recipe recipe = bench.recipe();
    recipe.import.exclude = {{2, "tore late"}};
    bench.session.apply(recipe, "exclude");
    waitComputed(bench.session);
    QCOMPARE(choice->count(), 3); // none, and two shots
    QCOMPARE(choice->currentText(), QString("of shot 1"));
    QVERIFY(bench.control<PlotWidget>("spectrumPlot")->content().marks.size() + 3 > marks);
    recipe.import.exclude = {{1, "tore late"}}; // now the one that was looked at
    bench.session.apply(recipe, "exclude");
    waitComputed(bench.session);
    QCOMPARE(choice->currentText(), QString("of shot 3"));
}

void TestSpectrumPage::swedish_frequencyTypedWithAComma()
{
    const test::InSwedish swedish;
    Bench bench;
    bench.choose("resonanceSource", Given);
    auto *field = bench.control<QuantityEdit>("resonanceFrequency");
    field->selectAll();
    QTest::keyClicks(field, "1501,25");
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(bench.recipe().spectrum.resonances_Hz, std::vector<double>{1501.25e3});
    QVERIFY2(field->text().startsWith("1501,25"), qPrintable(field->text()));
    bench.type("resonanceBandBeginValue", "0,5");
    QCOMPARE(bandOf(bench)->begin, 500.0);
    QCOMPARE(bench.control<QLineEdit>("resonanceBandBeginValue")->text(), QString("0,5"));
    waitComputed(bench.session);
}

DYNCAL_TEST(TestSpectrumPage)
#include "tst_spectrum_page.moc"
