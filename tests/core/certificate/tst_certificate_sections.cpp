// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The words and numbers of single sections, also where something is missing or went wrong.

#include "core/base/version.h"
#include "core/certificate/certificate.h"
#include "core/certificate/certificate_conditions_section.h"
#include "core/certificate/certificate_header_sections.h"
#include "core/certificate/certificate_method_sections.h"
#include "core/certificate/certificate_result_sections.h"
#include "core/certificate/certificate_words.h"
#include "tests/support/certificate_text.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"
#include "tests/support/writable_result.h"

#include <QTest>

#include <limits>

using namespace dyncal;
using testing::writable;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
const char *const kDash = "\xE2\x80\x93";

std::string valueOf(const CertificateSection &section, const std::string &id)
{
    for (const CertificateField &field : section.fields) {
        if (field.id == id)
            return english(field.value);
    }
    return "no field";
}

std::string cellOf(const CertificateSection &section, std::size_t row, std::size_t column)
{
    return english(section.tables.at(0).rows.at(row).at(column));
}

} // namespace

class TestCertificateSections : public QObject
{
    Q_OBJECT

private slots:
    void printed_withoutValue_saysOtherwise();
    void printedWithUncertainty_isExpandedByTwo();
    void levelWord_everyLevel();
    void method_everyTreatment_hasItsSentence();
    void method_average_isSaid();
    void method_choiceOfTheOrder_isPrintedWhenGiven();
    void environment_shotsDiffer_isARangeOfTheIncluded();
    void conditions_statedStep_isSaid();
    void conditions_stepWithBudget_printsUAndK();
    void model_thatDiverges_printsNoFit();
    void model_attainableUnknown_isADash();
    void model_listingFit_onlyWhereThereIsOne();
    void results_modelWithoutOscillation_saysSo();
    void records_inputs_areNamedWithTheirHash();
    void statements_claimNoTraceability();
    void approval_typed_replacesNotYet();
    void section_unknown_isNone();
};

void TestCertificateSections::printed_withoutValue_saysOtherwise()
{
    const Message otherwise{"nothing", {}};
    QCOMPARE(english(printed({}, "V", otherwise)), std::string("nothing"));
    QCOMPARE(english(printed(kUnknown, "V", otherwise)), std::string("nothing"));
    QCOMPARE(english(printed(kInf, "V", otherwise)), std::string("nothing"));
    QCOMPARE(english(printed(2.5, "V", otherwise)), std::string("2.50 V"));
}

void TestCertificateSections::printedWithUncertainty_isExpandedByTwo()
{
    QCOMPARE(english(printedWithUncertainty(2.33e6, 412.0, "Hz")),
        std::string("2.33000 MHz \xC2\xB1 0.00082 MHz (k = 2)"));
    QCOMPARE(english(printedWithUncertainty(kUnknown, 1.0, "Hz")), std::string(kDash));
    const std::string bare = english(printedWithUncertainty(2.5, kUnknown, "V"));
    QCOMPARE(bare, std::string("2.50 V"));
}

void TestCertificateSections::levelWord_everyLevel()
{
    QCOMPARE(english(levelWord(ShotLevel::Low)), std::string("low"));
    QCOMPARE(english(levelWord(ShotLevel::Medium)), std::string("medium"));
    QCOMPARE(english(levelWord(ShotLevel::High)), std::string("high"));
    QCOMPARE(english(levelWord(ShotLevel::None)), std::string(kDash));
}

void TestCertificateSections::method_everyTreatment_hasItsSentence()
{
    const std::pair<ResponseTreatment, const char *> words[]
        = {{ResponseTreatment::StepDeflated, "removed before the realisation"},
            {ResponseTreatment::StepAsImpulse, "contains the pole of the step"},
            {ResponseTreatment::Differenced, "First difference"},
            {ResponseTreatment::Impulse, "Free decay"}};
    for (const auto &[treatment, word] : words) {
        CalibrationResults results;
        writable(results.input).treatment = treatment;
        const std::string text = english(methodSection(results, {}).paragraphs.at(1));
        QVERIFY2(text.find(word) != std::string::npos, text.c_str());
    }
}

void TestCertificateSections::method_average_isSaid()
{
    CalibrationResults results;
    ModelInput &input = writable(results.input);
    input.combine = CombineMethod::PcaAverage;
    input.sampleRate_Hz = 10e6;
    input.samples = 1000;
    const CertificateSection section = methodSection(results, {});
    QVERIFY(valueOf(section, "series").starts_with("average"));
    QCOMPARE(valueOf(section, "model_rate"), std::string("10 MHz"));
    QCOMPARE(valueOf(section, "model_samples"), std::string("1000"));
}

void TestCertificateSections::method_choiceOfTheOrder_isPrintedWhenGiven()
{
    CalibrationResults results;
    results.input = std::make_shared<const ModelInput>();
    results.model = example::model(*example::modelInput({}));
    QCOMPARE(valueOf(methodSection(results, {}), "order_reason"), std::string("no field"));
    QCOMPARE(valueOf(methodSection(results, {}), "order_spread"), std::string("no field"));
    OrderEvidence &evidence = writable(results.evidence);
    evidence.poles = {{2, example::kF0_Hz, example::kZeta, PoleStability::New, true, 1.0},
        {3, example::kF0_Hz * 1.002, example::kZeta, PoleStability::FrequencyAndDamping, true,
            1.0}};
    Recipe recipe;
    recipe.realization.adoptedReason = "lowest order that fits";
    const CertificateSection section = methodSection(results, recipe);
    QCOMPARE(valueOf(section, "order_reason"), std::string("lowest order that fits"));
    QCOMPARE(valueOf(section, "order_spread"),
        std::string("orders 2 to 3: frequency \xC2\xB1"
                    "0.1 %, damping ratio \xC2\xB1"
                    "0 % (half of the range)"));
    evidence.poles.pop_back(); // one order alone says nothing of a spread
    QCOMPARE(valueOf(methodSection(results, recipe), "order_spread"), std::string("no field"));
}

void TestCertificateSections::environment_shotsDiffer_isARangeOfTheIncluded()
{
    CalibrationResults results;
    CaptureSet &captures = writable(results.captures).set;
    captures.shots.resize(4);
    const double temperatures_K[] = {294.0, 293.0, 250.0, kUnknown};
    for (std::size_t i = 0; i < 4; ++i)
        captures.shots[i].environment.ambientT_K = temperatures_K[i];
    captures.shots[2].included = false;
    const CertificateSection section = conditionsSection(results, {});
    QCOMPARE(valueOf(section, "ambient_temperature"), std::string("293 K \xE2\x80\xA6 294 K"));
    QCOMPARE(valueOf(section, "ambient_pressure"), std::string("not determined (not recorded)"));
}

void TestCertificateSections::conditions_statedStep_isSaid()
{
    CalibrationResults results;
    ShockConditionsSet &shock = writable(results.shock);
    ShockConditions conditions;
    conditions.shot = 1;
    conditions.step_Pa = 4e5;
    conditions.stepTyped = true;
    shock.shots = {conditions};
    const CertificateSection section = conditionsSection(results, {});
    QCOMPARE(cellOf(section, 0, 1), std::string(kDash)); // no such shot in the captures
    QCOMPARE(cellOf(section, 0, 6), std::string("400 kPa"));
    QCOMPARE(cellOf(section, 0, 7), std::string("stated"));
    QCOMPARE(cellOf(section, 0, 8), std::string("not determined"));
    QVERIFY(section.notes.empty());
}

void TestCertificateSections::conditions_stepWithBudget_printsUAndK()
{
    CalibrationResults results;
    ShockConditionsSet &shock = writable(results.shock);
    ShockConditions conditions;
    conditions.shot = 1;
    conditions.step_Pa = 434498.07;
    StepUncertainty uncertainty;
    uncertainty.budget.value = Eigen::VectorXd::Constant(kStepResults, 434498.07);
    uncertainty.budget.u = Eigen::VectorXd::Constant(kStepResults, 1800.2);
    uncertainty.budget.dof
        = Eigen::VectorXd::Constant(kStepResults, std::numeric_limits<double>::infinity());
    conditions.uncertainty = uncertainty;
    shock.shots = {conditions};
    Recipe recipe;
    CertificateSection section = conditionsSection(results, recipe);
    QCOMPARE(cellOf(section, 0, 6), std::string("434.5 kPa"));
    QCOMPARE(cellOf(section, 0, 8), std::string("3.6 kPa")); // twice
    QCOMPARE(cellOf(section, 0, 9), std::string("2")); // as of everything else
    QCOMPARE(section.notes.size(), std::size_t(1));
    QCOMPARE(section.notes[0].arguments, std::vector<std::string>{"95"});
    // Student's t of the effective degrees of freedom, for the recipe's coverage.
    shock.shots[0].uncertainty->budget.dof.setConstant(5.0);
    recipe.uncertainty.coverage = 0.9545;
    section = conditionsSection(results, recipe);
    QCOMPARE(cellOf(section, 0, 9), std::string("2.65")); // GUM table G.2
    // Where an input's uncertainty is not stated there is no U, and no note about it.
    shock.shots[0].uncertainty->stepMissing = Message{"not stated", {}};
    section = conditionsSection(results, recipe);
    QCOMPARE(cellOf(section, 0, 8), std::string("not determined"));
    QVERIFY(section.notes.empty());
}

void TestCertificateSections::model_thatDiverges_printsNoFit()
{
    CalibrationResults results;
    SensorModel &model = writable(results.model);
    model.order = 3;
    model.fit_percent = -1e30; // whatever was computed means nothing
    model.fitListing_percent = -1e30;
    model.fitAttainable_percent = 90.0;
    model.diverges = true;
    const CertificateSection section = modelSection(results, {});
    QCOMPARE(valueOf(section, "fit"),
        std::string(kDash) + " %; in this noise the true model would reach 90.00 % on average");
    QCOMPARE(valueOf(section, "fit_listing"), std::string(kDash) + " %");
}

void TestCertificateSections::model_attainableUnknown_isADash()
{
    CalibrationResults results;
    SensorModel &model = writable(results.model);
    model.fit_percent = 87.0;
    model.fitAttainable_percent = kUnknown;
    QCOMPARE(valueOf(modelSection(results, {}), "fit"),
        std::string("87.00 %; in this noise the true model would reach ") + kDash
            + " % on average");
}

void TestCertificateSections::model_listingFit_onlyWhereThereIsOne()
{
    CalibrationResults results;
    SensorModel &model = writable(results.model);
    QCOMPARE(valueOf(modelSection(results, {}), "fit_listing"), std::string("no field"));
    model.fitListing_percent = 81.234;
    QCOMPARE(valueOf(modelSection(results, {}), "fit_listing"), std::string("81.23 %"));
}

void TestCertificateSections::results_modelWithoutOscillation_saysSo()
{
    CalibrationResults results;
    results.model = std::make_shared<const SensorModel>(); // no poles at all
    const CertificateData data = makeCertificate(results, {}, {});
    for (const char *label : {"Undamped natural frequency", "Damping ratio"})
        QCOMPARE(testing::keyResult(data, label),
            std::string("not determined (the model does not oscillate)"));
    results.response = std::make_shared<const ResponseResult>();
    QCOMPARE(testing::keyResult(makeCertificate(results, {}, {}), "Rise time, 10 % to 90 %"),
        std::string("not determined (outside the range of the model)"));
}

void TestCertificateSections::records_inputs_areNamedWithTheirHash()
{
    CalibrationResults results;
    writable(results.captures).set.inputs
        = {{"/secret/folder/a.h5", "a.h5", "0123", "dyncal-capture"}};
    const CertificateSection section = recordsSection(results, "2026-11-21T03:04:05Z");
    QCOMPARE(valueOf(section, "software"),
        std::string("Dyncal ") + versionText() + ", build " + buildText());
    QCOMPARE(valueOf(section, "created"), std::string("2026-11-21T03:04:05Z"));
    QCOMPARE(cellOf(section, 0, 0), std::string("a.h5")); // never the folder
    QCOMPARE(cellOf(section, 0, 2), std::string("0123"));
    QVERIFY(recordsSection({}, {}).tables.empty());
}

void TestCertificateSections::statements_claimNoTraceability()
{
    std::string text;
    for (const Message &paragraph : statementsSection({}, {}).paragraphs)
        text += english(paragraph);
    QVERIFY(text.find("relate only to the item") != std::string::npos);
    QVERIFY(text.find("no statement of metrological traceability") != std::string::npos);
}

void TestCertificateSections::approval_typed_replacesNotYet()
{
    Recipe recipe;
    QCOMPARE(
        valueOf(administrativeSection(recipe), "approved_by"), std::string("not yet approved"));
    recipe.certificate.fields["approved_by"] = "A. Person";
    QCOMPARE(valueOf(administrativeSection(recipe), "approved_by"), std::string("A. Person"));
}

void TestCertificateSections::section_unknown_isNone()
{
    const CertificateData data = makeCertificate({}, {}, {});
    QVERIFY(!data.section("nonsense"));
    QCOMPARE(data.sections.size(), std::size_t(13));
    QVERIFY(data.missingFields().size() > 5);
}

DYNCAL_TEST(TestCertificateSections)
#include "tst_certificate_sections.moc"
