// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/certificate/certificate_page.h"
#include "ui/stages/components_page.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/model/model_page.h"
#include "ui/stages/model/model_text.h"
#include "ui/stages/model_input_page.h"
#include "ui/stages/shock/shock_page.h"
#include "ui/stages/spectrum/spectrum_page.h"
#include "ui/stages/window/window_page.h"

#include <QCheckBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

using namespace dyncal;
using test::PageBench;

class TestStagePages : public QObject
{
    Q_OBJECT

private slots:
    void window_autoUnticked_takesWhatWasUsed();
    void window_startTyped_isOnePerShot();
    void spectrum_givenResonance_isInTheRecipe();
    void spectrum_searchBand_hasBothEnds();
    void components_controls_changeTheRecipe();
    void modelInput_treatmentAndRate_changeTheRecipe();
    void modelInput_samplesPerPeriod_hasAWord();
    void model_readouts_showTheResults();
    void poles_flagsAreWords();
    void noise_isNamedInWords();
    void shock_typedValues_areSi();
    void shock_arrivalDistance_makesOneSensor();
    void shock_states_areListedPerShot();
    void certificate_fields_areOneStepEach();
    void certificate_missing_isListed();
    void page_blocked_saysWhy();
    void undo_anyPage_setsTheControlsBack();
};

void TestStagePages::window_autoUnticked_takesWhatWasUsed()
{
    PageBench<WindowPage> bench;
    bench.control<QCheckBox>("baselineAuto")->click();
    QCOMPARE(bench.recipe().window.baseline_s.value->begin, -5e-5);
    QCOMPARE(bench.recipe().window.baseline_s.value->end, -5e-6);
    bench.control<QCheckBox>("baselineAuto")->click();
    QVERIFY(bench.recipe().window.baseline_s.isAuto());
    bench.control<QCheckBox>("subtractBaseline")->click();
    QVERIFY(!bench.recipe().window.subtractBaseline);
    bench.control<QCheckBox>("remap")->click();
    QVERIFY(!bench.recipe().remap);
}

void TestStagePages::window_startTyped_isOnePerShot()
{
    PageBench<WindowPage> bench;
    bench.control<QCheckBox>("startAuto")->click();
    QCOMPARE(bench.recipe().window.start_s.size(), std::size_t(3));
    bench.choose("startShot", 1);
    bench.control<QuantityEdit>("startValue")->setValue(2.5);
    QCOMPARE(bench.recipe().window.start_s[1], 2.5e-6);
    bench.control<QCheckBox>("startAuto")->click();
    QVERIFY(bench.recipe().window.start_s.empty());
}

void TestStagePages::spectrum_givenResonance_isInTheRecipe()
{
    PageBench<SpectrumPage> bench;
    bench.choose("resonanceSource", 1);
    QVERIFY(!bench.recipe().spectrum.searchResonance);
    QCOMPARE(bench.recipe().spectrum.resonances_Hz, std::vector<double>{test::kResonance_Hz});
    bench.control<QuantityEdit>("resonanceFrequency")->setValue(1501.5);
    QCOMPARE(bench.recipe().spectrum.resonances_Hz, std::vector<double>{1501.5e3});
    bench.choose("resonanceSource", 2);
    QVERIFY(bench.recipe().spectrum.resonances_Hz.empty());
    QVERIFY(!bench.recipe().spectrum.searchResonance);
    bench.choose("resonanceSource", 0);
    QVERIFY(bench.recipe().spectrum.searchResonance);
}

void TestStagePages::spectrum_searchBand_hasBothEnds()
{
    PageBench<SpectrumPage> bench;
    bench.type("resonanceBandBeginValue", "100");
    QCOMPARE(bench.recipe().spectrum.resonanceBand_Hz->begin, 100e3);
    bench.type("resonanceBandEndValue", "5000");
    QCOMPARE(bench.recipe().spectrum.resonanceBand_Hz->end, 5e6);
    bench.choose("taper", 1);
    QCOMPARE(bench.recipe().spectrum.taper, Taper::Hann);
    bench.choose("spectrumMethod", 1);
    QCOMPARE(bench.recipe().spectrum.method, SpectrumMethod::Welch);
    bench.choose("detrend", 2);
    QCOMPARE(bench.recipe().spectrum.detrend, Detrend::Linear);
}

void TestStagePages::components_controls_changeTheRecipe()
{
    PageBench<ComponentsPage> bench;
    bench.control<QuantityEdit>("componentsKept")->setValue(2);
    QCOMPARE(bench.recipe().pca.components, Index(2));
    bench.control<QuantityEdit>("residualLags")->setValue(200);
    QCOMPARE(bench.recipe().pca.residualLags, Index(200));
    bench.choose("residualConfidence", 1);
    QCOMPARE(bench.recipe().pca.residualConfidence, 0.95);
    bench.control<QCheckBox>("centre")->click();
    QVERIFY(bench.recipe().pca.centre);
    QCOMPARE(bench.control<QLabel>("firstExplains")->text(), QString("99.8 %"));
}

void TestStagePages::modelInput_treatmentAndRate_changeTheRecipe()
{
    PageBench<ModelInputPage> bench;
    bench.choose("treatment", 1);
    QCOMPARE(bench.recipe().input.treatment, ResponseTreatment::StepAsImpulse);
    bench.choose("combine", 1);
    QCOMPARE(*bench.recipe().input.combine, CombineMethod::Stacked);
    bench.choose("combine", 0);
    QVERIFY(!bench.recipe().input.combine);
    bench.control<QCheckBox>("modelRateAuto")->click();
    bench.control<QuantityEdit>("modelRateValue")->setValue(10000);
    QCOMPARE(*bench.recipe().input.sampleRate_Hz.value, 10e6);
    bench.control<QCheckBox>("modelSamplesAuto")->click();
    QCOMPARE(*bench.recipe().input.samples.value, Index(600));
}

void TestStagePages::modelInput_samplesPerPeriod_hasAWord()
{
    PageBench<ModelInputPage> bench;
    const QString text = bench.control<QLabel>("samplesPerPeriod")->text();
    QVERIFY2(text.startsWith("13.3") && text.contains("comfortable"), qPrintable(text));
}

void TestStagePages::model_readouts_showTheResults()
{
    PageBench<ModelPage> bench;
    QCOMPARE(bench.control<QLabel>("modelFit")->text(), QString("89.4 % of attainable 89.9 %"));
    QCOMPARE(
        bench.control<QLabel>("modelRise")->text(), QString::fromUtf8("120.0 ns (u = 2.1 ns)"));
    QVERIFY(!bench.control<QLabel>("modelOvershoot")->text().contains("±")); // no budget
    QCOMPARE(bench.control<ValueTable>("poleTable")->rowCount(), 1); // a pair is one line
    QCOMPARE(bench.control<ValueTable>("poleTable")->item(0, 0)->text(), QString("1.5000 MHz"));
}

void TestStagePages::poles_flagsAreWords()
{
    Pole pole;
    pole.z = {0.5, 0.5};
    pole.frequency_Hz = 2.33e6;
    pole.u_frequency_Hz = 12.0; // of the noise alone
    pole.dampingRatio = 0.02;
    pole.u_dampingRatio = 9.3e-5;
    pole.flags = {kBelowNoiseFlag, kTubeModeFlag, "of-tomorrow"};
    const QStringList row = poleRows({pole}, {{130.0, 2.26, 9.3e-5, 1.96}}).at(0);
    QCOMPARE(row.last(), QString("below the noise, tube mode?, of-tomorrow"));
    QCOMPARE(row.mid(0, 6),
        (QStringList{"2.33000 MHz", "0.00013 MHz", "2.26", "0.020000", "0.000093", "1.96"}));
}

void TestStagePages::noise_isNamedInWords()
{
    const std::pair<const char *, const char *> cases[]{{"white", "white"}, {"AR(3)", "AR(3)"},
        {"AR(3) of the residual", "AR(3), of the residual"},
        {"white of the residual", "white, of the residual"}};
    for (const auto &[method, words] : cases) {
        SensorModel model;
        model.uncertaintyMethod = method;
        QCOMPARE(noiseText(model), QString(words));
    }
}

void TestStagePages::shock_typedValues_areSi()
{
    PageBench<ShockPage> bench;
    bench.type("p1Value", "101,1");
    QCOMPARE(*bench.recipe().shock.p1_Pa, 101100.0);
    bench.type("T1Value", "294.15");
    QCOMPARE(*bench.recipe().shock.T1_K, 294.15);
    bench.type("stepPressureValue", "434.2");
    const Index last = std::ssize(bench.session.state().captures->shots);
    QCOMPARE(bench.recipe().shock.step_Pa.of(last).value_or(0.0), 434200.0); // it is on show
    bench.choose("drivenGas", 2); // humid air
    bench.type("humidityValue", "45");
    QCOMPARE(*bench.recipe().shock.relativeHumidity, 0.45);
    QVERIFY(bench.control<QuantityEdit>("drivenMolarMass")->isReadOnly()); // of air
    bench.choose("drivenGas", 7); // typed
    bench.control<QuantityEdit>("drivenMolarMass")->setValue(28.97);
    QCOMPARE(bench.recipe().shock.drivenGas.molarMass_kg_mol, 28.97e-3);
    bench.control<QCheckBox>("shockEnabled")->click();
    QVERIFY(!bench.recipe().shock.enabled);
}

void TestStagePages::shock_arrivalDistance_makesOneSensor()
{
    PageBench<ShockPage> bench;
    bench.type("arrivalDistanceValue", "0.3");
    QCOMPARE(bench.recipe().shock.arrivalSensors.size(), std::size_t(1));
    QCOMPARE(bench.recipe().shock.arrivalSensors[0].channel, std::string("driven_side"));
    QCOMPARE(bench.recipe().shock.arrivalSensors[0].distanceToEndWall_m, 0.3);
}

void TestStagePages::shock_states_areListedPerShot()
{
    PageBench<ShockPage> bench;
    auto *table = bench.control<ValueTable>("stateTable");
    QCOMPARE(table->columnCount(), 4);
    QCOMPARE(table->item(1, 3)->text(), QString("512.000 m/s"));
    QVERIFY(bench.control<QLabel>("sensitivityReason")->text().contains("5.02 µV/Pa"));
}

void TestStagePages::certificate_fields_areOneStepEach()
{
    PageBench<test::DatedPage<CertificatePage>> bench;
    bench.type("field_customer", "Testbolaget AB");
    bench.type("field_sensor_serial", "4711");
    bench.control<QPlainTextEdit>("field_remarks")->setPlainText("one");
    bench.control<QPlainTextEdit>("field_remarks")->setPlainText("one two");
    QCOMPARE(bench.recipe().certificate.fields.at("customer"), std::string("Testbolaget AB"));
    QCOMPARE(bench.recipe().certificate.fields.at("remarks"), std::string("one two"));
    QCOMPARE(bench.session.undoStack().count(), 3);
    bench.choose("certificateLanguage", 1);
    QCOMPARE(bench.recipe().certificate.languages, std::vector<std::string>{"sv"});
    QVERIFY(!bench.session.isComputing()); // words change no number
    QSignalSpy asked(&bench.page, &CertificatePage::exportRequested);
    bench.control<QPushButton>("exportCertificate")->click();
    QCOMPARE(asked.count(), 1);
}

void TestStagePages::certificate_missing_isListed()
{
    PageBench<test::DatedPage<CertificatePage>> bench;
    auto *missing = bench.control<QLabel>("missingFields");
    QVERIFY(missing->text().contains("Address of the customer"));
    bench.type("field_customer_address", "Storgatan 1");
    QVERIFY(!missing->text().contains("Address of the customer"));
    QVERIFY(missing->text().contains("Place of calibration"));
    bench.type("field_place", "Lund");
    QVERIFY(!missing->text().contains("Place of calibration"));
    QVERIFY(!missing->text().contains("Approved by")); // may be empty
    bench.type("field_approved_by", "A. Andersson");
    QCOMPARE(bench.recipe().certificate.fields.at("approved_by"), std::string("A. Andersson"));
}

void TestStagePages::page_blocked_saysWhy()
{
    const auto failing
        = [](const auto &, const Recipe &, ResultCache &, StageId, const JobControl &) {
              PipelineOutcome outcome;
              outcome.failedStage = StageId::Window;
              outcome.error
                  = Error{ErrorKind::DataBlocked, {"Shot %1 has no step.", {"2"}}, "CAP-009", 2};
              return outcome;
          };
    Session session(failing);
    WindowPage page(session);
    page.show();
    session.reset({std::make_shared<const CaptureSet>(test::sampleCaptures()), {}});
    QTRY_VERIFY(!session.isComputing());
    const auto *problem = page.findChild<QLabel *>("pageProblem");
    QVERIFY(problem->isVisible());
    QVERIFY(problem->text().contains("Shot 2 has no step."));
    delete page.inspector();
}

void TestStagePages::undo_anyPage_setsTheControlsBack()
{
    PageBench<ComponentsPage> bench;
    auto *kept = bench.control<QuantityEdit>("componentsKept");
    kept->setValue(3);
    bench.session.undoStack().undo();
    QCOMPARE(kept->value(), 1.0);
    bench.session.undoStack().redo();
    QCOMPARE(kept->value(), 3.0);
}

DYNCAL_TEST(TestStagePages)
#include "tst_stage_pages.moc"
