// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate.h"
#include "tests/support/certificate_text.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"
#include "tests/support/writable_result.h"

#include <limits>

#include <QtTest>

#include <algorithm>

using dyncal::CalibrationResults;
using dyncal::CertificateData;
using dyncal::CertificateField;
using dyncal::CertificateSection;
using dyncal::CertificateTable;
using dyncal::english;
using dyncal::Finding;
using dyncal::Index;
using dyncal::makeCertificate;
using dyncal::Message;
using dyncal::Recipe;
using dyncal::Severity;
using dyncal::testing::keyResult;
using dyncal::testing::writable;

namespace {

const char *const kF0 = "Undamped natural frequency";

/// With every field typed.
Recipe typedRecipe()
{
    Recipe recipe;
    recipe.certificate.fields = dyncal::example::certificateFields();
    return recipe;
}

CertificateData certificateOf(CalibrationResults results, const Recipe &recipe = typedRecipe())
{
    results.uncertainty = dyncal::example::uncertaintyOf(results);
    return makeCertificate(results, recipe, "2026-11-21T03:04:05Z");
}

QString value(const CertificateData &data, const char *section, const char *field)
{
    const CertificateSection *part = data.section(section);
    if (!part)
        return "no section";
    for (const CertificateField &candidate : part->fields)
        if (candidate.id == field)
            return QString::fromStdString(english(candidate.value));
    return "no field";
}

const CertificateTable *table(const CertificateData &data, const char *section)
{
    const CertificateSection *part = data.section(section);
    return part && !part->tables.empty() ? &part->tables.front() : nullptr;
}

QString cell(const CertificateTable &table, std::size_t row, std::size_t column)
{
    return QString::fromStdString(english(table.rows[row][column]));
}

QString allText(const CertificateData &data)
{
    QString text;
    const auto add = [&text](const Message &message) {
        text += QString::fromStdString(english(message)) + '\n';
    };
    for (const CertificateSection &section : data.sections) {
        add(section.title);
        for (const auto *messages : {&section.paragraphs, &section.notes})
            std::for_each(messages->begin(), messages->end(), add);
        for (const CertificateField &field : section.fields) {
            add(field.label);
            add(field.value);
        }
        for (const CertificateTable &part : section.tables) {
            add(part.caption);
            for (const auto &row : part.rows)
                std::for_each(row.begin(), row.end(), add);
        }
    }
    return text;
}

} // namespace

class TestCertificateData : public QObject
{
    Q_OBJECT

private slots:
    void complete_example_hasEverySectionAndNumber();
    void complete_example_missesNothingButStaysDraft();
    void keyResults_withBudget_haveValueUAndK();
    void keyResults_stand_behindTheItem();
    void fields_notTyped_areMissing();
    void item_typedField_winsOverCard();
    void nothing_computed_saysWhy();
    void shock_withoutStep_isNotDetermined();
    void findings_cautions_areListedWithReason();
    void excluded_shot_isNamedWithReason();
    void poles_pairOnce_realAndUnstableToo();
    void poles_ofScatteringShots_haveTheirOwnCoverageFactor();
    void frequency_withoutMeasuredValues_hasDashes();
    void frequency_ofFewDegreesOfFreedom_hasItsOwnK();
    void frequency_behindAFront_isSaid();
    void frequency_outsideTheScope_isMarked();
    void order_typed_isSaid();
    void tables_everyRow_hasAllCells();
    void text_never_containsNan();
};

void TestCertificateData::complete_example_hasEverySectionAndNumber()
{
    const CalibrationResults results = dyncal::example::calibration();
    const CertificateData data = certificateOf(results);
    QCOMPARE(data.number, std::string("D-2026-0117"));
    // Nothing is a result without its u.
    QCOMPARE(keyResult(data, "Sensitivity at the onset of the step, mean of the shots"),
        std::string("no complete uncertainty"));
    QCOMPARE(keyResult(data, "Magnitude within 5 % up to"), std::string("no complete uncertainty"));
    // u = 412 Hz; U = 824 Hz rounds to 0.00082 MHz, the value to the same decimal.
    QCOMPARE(keyResult(data, kF0), std::string("2.33000 MHz | 0.00082 MHz | 2"));
    QCOMPARE(keyResult(data, "Damping ratio"), std::string("0.02000 | 0.00035 | 2"));
    QCOMPARE(value(data, "model", "order"), QString("2 (as suggested from the data)"));
    QCOMPARE(value(data, "model", "fit"),
        QString("98.76 %; in this noise the true model would reach 98.91 % on average"));
    QCOMPARE(value(data, "item", "sensor_serial"), QString("SN-0042"));
    QCOMPARE(value(data, "conditions", "ambient_temperature"), QString("294.15 K"));
    QCOMPARE(
        value(data, "conditions", "ambient_pressure"), QString("not determined (not recorded)"));
    QCOMPARE(cell(*table(data, "conditions"), 2, 6), QString("434 kPa"));
    QCOMPARE(cell(*table(data, "shots"), 1, 1), QString("medium"));
    QCOMPARE(cell(*table(data, "records"), 0, 2).size(), 64);
    QCOMPARE(data.section("figures")->figures.size(), std::size_t(8));
}

void TestCertificateData::complete_example_missesNothingButStaysDraft()
{
    const CalibrationResults results = dyncal::example::calibration();
    const CertificateData data = certificateOf(results);
    QVERIFY(data.missingFields().empty());
    QVERIFY(data.draft);
}

void TestCertificateData::keyResults_withBudget_haveValueUAndK()
{
    CalibrationResults results = dyncal::example::calibration();
    dyncal::UncertaintyReport &report = writable(results.uncertainty);
    const auto with = [](const char *of, double number, double u, double k, const char *unit) {
        dyncal::ReportedValue one{of, number, unit};
        one.u = u;
        one.k = k;
        return one;
    };
    report.sensitivity = with("sensitivity", 12.5e-6, 0.1e-6, 1.96, "V/Pa");
    report.ofModel.push_back(with("rise_time_s", 7.2e-8, 1e-9, 3.18, "s"));
    report.ofModel.push_back(with("q", 25.0, 0.1, 1.96, ""));
    dyncal::ReportedValue overshoot{"overshoot_percent", 93.9, "%"};
    overshoot.missing = {"the model was not refined", {}};
    report.ofModel.push_back(overshoot);
    const CertificateData data = makeCertificate(results, typedRecipe(), {});
    QCOMPARE(keyResult(data, "Sensitivity at the onset of the step, mean of the shots"),
        std::string("12.50 µV/Pa | 0.20 µV/Pa | 2"));
    // 3.18 times 1 ns
    QCOMPARE(keyResult(data, "Rise time, 10 % to 90 %"), std::string("72.0 ns | 3.2 ns | 3.18"));
    QCOMPARE(keyResult(data, "Quality factor"), std::string("25.00 | 0.20 | 2"));
    QCOMPARE(keyResult(data, "Overshoot"),
        std::string("no complete uncertainty:\nthe model was not refined"));
}

void TestCertificateData::keyResults_stand_behindTheItem()
{
    const CertificateData data = certificateOf(dyncal::example::calibration());
    QCOMPARE(data.sections.at(1).id, std::string("item"));
    QCOMPARE(data.sections.at(2).id, std::string("key-results"));
    // No result is printed a second time behind them.
    for (const CertificateSection &section : data.sections)
        for (const CertificateField &field : section.fields)
            QVERIFY(!english(field.value).starts_with("2.33"));
}

void TestCertificateData::fields_notTyped_areMissing()
{
    const CalibrationResults results = dyncal::example::calibration();
    const CertificateData data = certificateOf(results, {});
    QStringList missing;
    for (const Message &label : data.missingFields())
        missing += QString::fromStdString(english(label));
    QVERIFY(missing.contains("Customer"));
    QVERIFY(missing.contains("Certificate number"));
    QVERIFY(missing.contains("Method"));
    QVERIFY(!missing.contains("Manufacturer")); // the capture knows it
    QVERIFY(data.number.empty());
}

void TestCertificateData::item_typedField_winsOverCard()
{
    const CalibrationResults results = dyncal::example::calibration();
    Recipe recipe = typedRecipe();
    recipe.certificate.fields["sensor_serial"] = "typed";
    QCOMPARE(value(certificateOf(results, recipe), "item", "sensor_serial"), QString("typed"));
}

void TestCertificateData::nothing_computed_saysWhy()
{
    const CertificateData data = makeCertificate({}, {}, {});
    QCOMPARE(keyResult(data, kF0), std::string("not determined (no model)"));
    QCOMPARE(keyResult(data, "Sensitivity at the onset of the step, mean of the shots"),
        std::string("not determined (no pressure step)"));
    QVERIFY(!data.section("shots")->paragraphs.empty());
    QVERIFY(!data.section("model")->paragraphs.empty());
    QVERIFY(data.section("figures")->figures.empty());
    QVERIFY(!data.section("conditions")->notes.empty());
}

void TestCertificateData::shock_withoutStep_isNotDetermined()
{
    CalibrationResults results = dyncal::example::calibration();
    dyncal::ShockConditionsSet &shock = writable(results.shock);
    shock.shots[1].step_Pa.reset();
    shock.shots[1].states.reset();
    const CertificateData data = certificateOf(results);
    QCOMPARE(cell(*table(data, "conditions"), 1, 6), QString("not determined"));
    QCOMPARE(cell(*table(data, "conditions"), 0, 7), QString("computed"));
    // The initial pressures of the others, and what is missing.
    QCOMPARE(data.section("conditions")->notes.size(), std::size_t(2));
}

void TestCertificateData::findings_cautions_areListedWithReason()
{
    CalibrationResults results = dyncal::example::calibration();
    QVERIFY(table(certificateOf(results), "remarks") == nullptr);
    writable(results.captures).findings = {Finding{.id = "CAP-005",
        .severity = Severity::Info,
        .channel = "",
        .message = {"Only for information.", {}}}};
    writable(results.window).findings = {Finding{.id = "WIN-001",
                                             .severity = Severity::Caution,
                                             .shot = 3,
                                             .channel = "",
                                             .message = {"Shot %1 drifts.", {"3"}}},
        Finding{.id = "CAP-020",
            .severity = Severity::Block,
            .shot = 2,
            .channel = "",
            .message = {"Not at rest.", {}}}};
    Recipe recipe = typedRecipe();
    recipe.acknowledge = {{"WIN-001", 3, "known of this tube"}, {"CAP-020", 1, "other"}};
    const CertificateData data = certificateOf(results, recipe);
    const CertificateTable *findings = table(data, "remarks");
    QVERIFY(findings);
    QCOMPARE(findings->rows.size(), std::size_t(2));
    QCOMPARE(cell(*findings, 0, 0), QString("WIN-001"));
    QCOMPARE(cell(*findings, 0, 3), QString("Shot 3 drifts."));
    QCOMPARE(cell(*findings, 0, 4), QString("known of this tube"));
    QCOMPARE(cell(*findings, 1, 2), QString("blocking"));
    QCOMPARE(cell(*findings, 1, 4), QString::fromUtf8("–"));
}

void TestCertificateData::excluded_shot_isNamedWithReason()
{
    CalibrationResults results = dyncal::example::calibration();
    dyncal::CaptureSet &captures = writable(results.captures).set;
    captures.shots[1].included = false;
    captures.shots[1].excludeReason = "diaphragm burst twice";
    const CertificateData data = certificateOf(results);
    const std::string text = english(data.section("remarks")->paragraphs.front());
    QCOMPARE(text, std::string("Shot 2 was excluded. Reason: diaphragm burst twice."));
}

void TestCertificateData::poles_pairOnce_realAndUnstableToo()
{
    CalibrationResults results = dyncal::example::calibration();
    dyncal::SensorModel &model = writable(results.model);
    dyncal::Pole real;
    real.z = {1.2, 0.0};
    real.s_rad_s = {1.8e6, 0.0};
    real.poleClass = dyncal::PoleClass::Unstable;
    real.frequency_Hz = 290e3;
    real.dampingRatio = -1.0;
    writable(results.assessment).poles.push_back(real);
    model.poles.push_back(real);
    model.diverges = true;
    const CertificateData data = certificateOf(results);
    const CertificateTable *poles = table(data, "model");
    QCOMPARE(poles->rows.size(), std::size_t(2));
    QVERIFY(cell(*poles, 0, 1).contains(QString::fromUtf8(" ± j")));
    QCOMPARE(cell(*poles, 1, 0), QString("unstable"));
    QCOMPARE(cell(*poles, 1, 1), QString("1.20"));
    QCOMPARE(cell(*poles, 1, 3), QString::fromUtf8("–"));
    QVERIFY(allText(data).contains("diverges"));
}

void TestCertificateData::poles_ofScatteringShots_haveTheirOwnCoverageFactor()
{
    CalibrationResults results = dyncal::example::calibration();
    dyncal::ModelAssessment &assessment = writable(results.assessment);
    for (dyncal::Pole &pole : assessment.poles)
        pole.coverageFactor = 4.303; // Student's, two degrees of freedom
    const CertificateData data = certificateOf(results);
    // 4.303 times 412 Hz is 1773 Hz
    QCOMPARE(keyResult(data, kF0), std::string("2.3300 MHz | 0.0018 MHz | 4.30"));
    const CertificateTable *poles = table(data, "model");
    QCOMPARE(cell(*poles, 0, 2), QString("2.3300 MHz"));
    QCOMPARE(cell(*poles, 0, 3), QString("0.0018 MHz (k = 4.30)"));

    for (dyncal::Pole &pole : assessment.poles)
        pole.coverageFactor = 1.97; // of many samples: k = 2 covers it
    QCOMPARE(keyResult(certificateOf(results), kF0), std::string("2.33000 MHz | 0.00082 MHz | 2"));
}

void TestCertificateData::frequency_withoutMeasuredValues_hasDashes()
{
    CalibrationResults results = dyncal::example::calibration();
    dyncal::ResponseResult &response = writable(results.response);
    for (auto *values :
        {&response.magnitude, &response.u_magnitude, &response.phase_rad, &response.u_phase_rad})
        values->resize(0);
    response.unit = "1";
    response.highEnd = dyncal::BandEnd::Reference;
    const CertificateData data = certificateOf(results);
    const CertificateTable *frequency = table(data, "frequency-response");
    QVERIFY(
        english(data.section("frequency-response")->notes.front())
            .ends_with("the upper limit where the calibration of the reference transducer ends."));
    for (const std::size_t column : {1U, 2U, 3U, 4U})
        QCOMPARE(cell(*frequency, 0, column), QString::fromUtf8("–"));
    QVERIFY(!cell(*frequency, 0, 5).contains("V/Pa"));
    QCOMPARE(data.section("frequency-response")->notes.size(), std::size_t(4));
}

void TestCertificateData::frequency_ofFewDegreesOfFreedom_hasItsOwnK()
{
    CalibrationResults results = dyncal::example::calibration();
    dyncal::ResponseResult &response = writable(results.response);
    const CertificateData plain = certificateOf(results);
    QVERIFY(!cell(*table(plain, "frequency-response"), 0, 2).contains("k ="));
    response.dof.setConstant(response.frequency_Hz.size(), 1e4);
    response.dof[0] = 8.0; // t is 2.306
    const CertificateData data = certificateOf(results);
    const CertificateTable *frequency = table(data, "frequency-response");
    for (const std::size_t column : {2U, 4U}) {
        QVERIFY(cell(*frequency, 0, column).endsWith("(k = 2.31)"));
        QVERIFY(!cell(*frequency, 1, column).contains("k ="));
    }
}

void TestCertificateData::frequency_behindAFront_isSaid()
{
    CalibrationResults results = dyncal::example::calibration();
    const auto notes = [&] { return certificateOf(results).section("frequency-response")->notes; };
    const std::size_t before = notes().size();
    writable(results.response).front = {400e-9, 20e-9};
    QCOMPARE(notes().size(), before + 1);
    bool isSaid = false;
    for (const dyncal::Message &note : notes())
        isSaid = isSaid
            || dyncal::english(note).find(
                   "rises over 400 ns at the sensor, standard uncertainty 20 ns")
                != std::string::npos;
    QVERIFY(isSaid);
}

void TestCertificateData::frequency_outsideTheScope_isMarked()
{
    const CalibrationResults results = dyncal::example::calibration();
    Recipe recipe = typedRecipe();
    const auto firstCell
        = [&] { return cell(*table(certificateOf(results, recipe), "frequency-response"), 0, 0); };
    const auto notes = [&] {
        return certificateOf(results, recipe).section("frequency-response")->notes.size();
    };
    const QString plain = firstCell();
    const std::size_t before = notes();
    recipe.uncertainty.cmc = {{"magnitude", 1e-6, true}};
    QCOMPARE(firstCell(), plain); // accredited everywhere
    recipe.uncertainty.cmc.front().from_Hz = 1e9;
    QCOMPARE(firstCell(), plain + " *");
    QCOMPARE(notes(), before + 1);
}

void TestCertificateData::order_typed_isSaid()
{
    const CalibrationResults results = dyncal::example::calibration();
    Recipe recipe = typedRecipe();
    recipe.realization.order = Index(2);
    const CertificateData data = certificateOf(results, recipe);
    QCOMPARE(value(data, "model", "order"), QString("2 (chosen by the operator)"));
    QVERIFY(data.section("model")->paragraphs.empty()); // no reason for a suggestion
}

void TestCertificateData::tables_everyRow_hasAllCells()
{
    const CalibrationResults results = dyncal::example::calibration();
    const CertificateData data = certificateOf(results);
    int tables = 0;
    for (const CertificateSection &section : data.sections)
        for (const CertificateTable &part : section.tables) {
            ++tables;
            for (const auto &row : part.rows)
                QCOMPARE(row.size(), part.columns.size());
        }
    QCOMPARE(tables, 7);
}

void TestCertificateData::text_never_containsNan()
{
    CalibrationResults results = dyncal::example::calibration();
    dyncal::ResponseResult &response = writable(results.response);
    response.magnitude[3] = dyncal::kUnknown;
    response.u_phase_rad[4] = dyncal::kUnknown;
    response.sensitivity = dyncal::kUnknown;
    dyncal::WindowResult &window = writable(results.window);
    window.responses[0].riseTime_s = dyncal::kUnknown;
    window.responses[0].snr_dB = std::numeric_limits<double>::infinity();
    const QString text = allText(certificateOf(results));
    QVERIFY(!text.contains("nan"));
    QVERIFY2(!text.contains("inf "), "an infinite signal to noise ratio is printed as a dash");
}

DYNCAL_TEST(TestCertificateData)
#include "tst_certificate_data.moc"
