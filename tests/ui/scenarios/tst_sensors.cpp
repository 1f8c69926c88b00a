// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/scenarios/scenario_words.h"
#include "ui/stages/frame/value_table.h"

#include <QClipboard>

using namespace dyncal;
using namespace dyncal::test;

/// Sensors of different kinds, and the example, from opening to the certificate.
class TestSensors : public QObject
{
    Q_OBJECT

private slots:
    void s02_exampleInOneClick_givesADraft();
    void s16_thesisNumbers_giveTheTablesOfTheThesis();
    void s19_noisySensor_isAtTheNoiseLimit();
    void s20_withoutResonance_isConfirmedOnce();
    void s21_oneShotUnlikeTheOthers_isNamed();
};

void TestSensors::s02_exampleInOneClick_givesADraft()
{
    ScenarioBench bench;
    bench.window->files().setExampleDuration(0.006); // its 0.02 s only make it wait
    QElapsedTimer waited;
    waited.start();
    QTest::mouseClick(bench.find<QPushButton>("startOpenExample"), Qt::LeftButton);
    QTRY_VERIFY(bench.session().state().hasShots());
    qInfo("shots are there after %lld ms (limit 5 s)", waited.elapsed());
    QTRY_VERIFY_WITH_TIMEOUT(bench.session().resultsOnShow().evidence, 60000);
    qInfo("stages 1 to 8 are computed after %lld ms (limit 10 s)", waited.elapsed());
    QVERIFY(waited.elapsed() < 10'000);
    bench.settle(); // the Monte Carlo of the chain, which nothing waits for
    QCOMPARE(bench.session().state().captures->shots.size(), std::size_t(3));
    for (const QString &row : bench.findings())
        QVERIFY2(!row.startsWith("■"), qPrintable(row));
    bench.show(Page::Order);
    // Order 3 in the thesis, where the step takes a pole of its own.
    DYNCAL_SAYS(bench.text("orderSuggestion"), "Suggested: order 2.");
    bench.show(Page::Model);
    const QStringList pole = bench.row("poleTable", "2.3");
    QVERIFY2(std::abs(number(pole.value(0)) / 2.33 - 1.0) < 0.002, qPrintable(pole.join('|')));
    QVERIFY2(std::abs(number(pole.value(3)) / 0.02 - 1.0) < 0.05, qPrintable(pole.join('|')));
    QVERIFY2(number(bench.text("modelFit")) > 95.0, qPrintable(bench.text("modelFit"))); // aligned
    bench.prompts.setNextFile(bench.folder.filePath("draft.pdf"));
    QTest::keyClick(bench.window.get(), Qt::Key_P, Qt::ControlModifier);
    QTRY_VERIFY(
        !bench.window->files().isBusy() && QFile::exists(bench.folder.filePath("draft.pdf")));
    QVERIFY(makeCertificate(bench.session().results(), bench.recipe(), {}).draft);
}

void TestSensors::s16_thesisNumbers_giveTheTablesOfTheThesis()
{
    const ScenarioBench bench;
    SimulationSettings settings = threeShots();
    settings.shots = {ShotLevel::High};
    bench.open({bench.record(settings)});
    bench.show(Page::Shock);
    bench.type("shockVelocityValue", "512.8");
    bench.type("p1Value", "101.1");
    bench.type("T1Value", "294.15");
    const auto isIn = [&](const char *row, double lowest, double highest) {
        const QString cell = bench.row("stateTable", row).value(1);
        const bool in = number(cell) >= lowest && number(cell) <= highest;
        if (!in)
            qWarning("%s: %s", row, qPrintable(cell));
        return in;
    };
    QVERIFY(isIn("p2", 244.5, 245.5));
    QVERIFY(isIn("p5", 534.5, 536.5));
    QVERIFY(isIn("T2", 386.75, 386.95));
    QVERIFY(isIn("T5", 490.55, 490.75));
    QVERIFY(isIn("Gas velocity u2", 234.65, 234.85));
    QVERIFY(isIn("Plateau lasts", 1.625, 1.635));
    auto *table = bench.find<QTableWidget>("stateTable");
    table->setFocus();
    table->selectAll();
    QTest::keySequence(table, QKeySequence::Copy);
    const QString copied = QGuiApplication::clipboard()->text();
    DYNCAL_SAYS(copied, "p5\t" + bench.row("stateTable", "p5").value(1));
}

void TestSensors::s19_noisySensor_isAtTheNoiseLimit()
{
    const ScenarioBench bench;
    SimulationSettings settings = threeShots();
    settings.sensor = sensorPreset("piezo").value();
    settings.noise = 0.24; // much more would hide the step
    bench.open({bench.record(settings)});
    // The automatic stretch is only as long as the sensor rings. The whole plateau, as in the
    // thesis, is nearly all noise.
    bench.show(Page::Window);
    bench.type("windowEndValue", "1600 µs");
    bench.show(Page::ModelInput);
    bench.type("modelRateValue", "10 MHz");
    bench.type("modelSamplesValue", "10000");
    bench.show(Page::Model);
    const QString fit = bench.text("modelFit");
    DYNCAL_SAYS(fit, "at the noise limit");
    QVERIFY2(number(fit) > 1.0 && number(fit) < 10.0, qPrintable(fit));
    for (const char *id : {"MOD-004", "MOD-008"}) // the model is not called bad
        QVERIFY2(bench.finding(id).isEmpty(), qPrintable(bench.finding(id)));
    DYNCAL_SAYS(bench.finding("WIN-006"), "even a perfect model would score a FIT of about");
}

void TestSensors::s20_withoutResonance_isConfirmedOnce()
{
    const ScenarioBench bench;
    SimulationSettings settings = threeShots();
    settings.sensor = sensorPreset("optic1").value();
    settings.sampleRate_Hz = 1e8;
    settings.duration_s = 0.003;
    bench.open({bench.record(settings)});
    DYNCAL_SAYS(bench.finding("SPC-001"), "No resonance found below 50 MHz");
    bench.show(Page::Spectrum);
    bench.choose("resonanceSource", 2); // none
    QVERIFY2(bench.finding("SPC-001").isEmpty(), qPrintable(bench.findings().join('\n')));
    QVERIFY(!bench.session().error());
    bench.show(Page::ModelInput);
    DYNCAL_SAYS(bench.text("samplesPerPeriod"), "no resonance");
    // The rate follows the rise of the response instead: half of the record's 100 MHz.
    const QString rate = bench.find<QAbstractSpinBox>("modelRateValue")->text();
    QVERIFY2(rate.startsWith("50000 kHz"), qPrintable(rate));
}

void TestSensors::s21_oneShotUnlikeTheOthers_isNamed()
{
    ScenarioBench bench;
    bench.open({bench.record(threeShots({{DefectKind::RingVar, 0}}))});
    const QString said = bench.finding("PCA-001");
    for (const char *part : {"explains 9", "limit 95 %", "Shot 2 carries"})
        DYNCAL_SAYS(said, part);
    bench.clickOffer("show", "PCA-001");
    QVERIFY(bench.window->pages()[static_cast<std::size_t>(Page::Components)]->isVisible());
    bench.prompts.setNextSentence("the mount of this shot was loose");
    bench.clickOffer("reason", "PCA-001");
    DYNCAL_SAYS(bench.finding("PCA-001"), "Accepted: the mount of this shot was loose");
    DYNCAL_SAYS(certificateText(bench), "the mount of this shot was loose");
}

DYNCAL_TEST(TestSensors)
#include "tst_sensors.moc"
