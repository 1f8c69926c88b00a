// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a certificate says of profile, chain and the references of the budget.

#include "core/certificate/certificate_traceability.h"
#include "core/certificate/required_fields.h"
#include "core/project/capability_quantities.h"
#include "core/uncertainty/quantity_words.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>

using namespace dyncal;

namespace {

const CertificateField *fieldOf(const std::vector<CertificateField> &fields, const std::string &id)
{
    const auto found = std::ranges::find(fields, id, &CertificateField::id);
    return found == fields.end() ? nullptr : &*found;
}

std::string textOf(const CertificateField *field)
{
    return field ? english(field->value) : "";
}

Recipe recipe()
{
    Recipe made;
    made.profile = {"Tube 2", "7", "abc", R"({"shock":{"driven_length_m":0.97}})"};
    made.shock.drivenLength_m = 0.97;
    made.uncertainty.budget = {{"t1_k", 0.3, "normal", {}, "T-0815", "2026-05-31"}, {"p1_pa", 9.0}};
    return made;
}

} // namespace

class TestCertificateTraceability : public QObject
{
    Q_OBJECT

private slots:
    void nothing_saysNothing() { QVERIFY(traceabilityFields({}, {}).empty()); }

    void profile_isNamedWithItsVersion()
    {
        Recipe made = recipe();
        QCOMPARE(textOf(fieldOf(traceabilityFields({}, made), "profile")),
            "Tube 2, version 7 (SHA-256 abc)");
        QVERIFY(!fieldOf(traceabilityFields({}, made), "profile_changed"));
        made.shock.drivenLength_m = 1.0;
        QCOMPARE(textOf(fieldOf(traceabilityFields({}, made), "profile_changed")),
            "shock.driven_length_m");
    }

    void chain_isNamedByItsFile()
    {
        auto stage = std::make_shared<ReferenceStageResult>();
        stage->chain = {ReferenceSensitivity::fromTable({{1e3, 1.0, 0.0}}).value(), "beef", {}};
        CalibrationResults results;
        results.reference = stage;
        QVERIFY(!fieldOf(traceabilityFields(results, {}), "chain")); // nothing was divided
        auto response = std::make_shared<ResponseResult>();
        response->magnitude = Eigen::VectorXd::Ones(1);
        results.response = response;
        const auto fields = traceabilityFields(results, {});
        QVERIFY(textOf(fieldOf(fields, "chain")).find("beef") != std::string::npos);
    }

    void capability_isListed()
    {
        Recipe made;
        made.uncertainty.cmc = {{"sensitivity", 0.015}, {"phase_rad", 0.02}, {"f0_hz", 50.0, false},
            {"magnitude", 0.025, true, 1e3, 1e5}, {"magnitude", 0.05, true, 1e5}};
        made.uncertainty.cmc.push_back({"magnitude", 2e-7, false, 0.0, 2e3});
        made.uncertainty.cmc.push_back({"settling_time_s", 1e-6, false});
        CalibrationResults results;
        auto response = std::make_shared<ResponseResult>();
        response->unit = "V/Pa";
        results.response = response;
        QStringList said;
        for (const CertificateField &field : traceabilityFields(results, made))
            said << QString::fromStdString(field.id + ' ' + english(field.value));
        QCOMPARE(said,
            QStringList({"cmc Sensitivity at the onset of the step: 1.5 %",
                "cmc Phase of the frequency response: 0.02 rad",
                "cmc Undamped natural frequency: 50 Hz",
                "cmc Magnitude of the frequency response: 2.5 % from 1 kHz to 100 kHz",
                "cmc Magnitude of the frequency response: 5 % from 100 kHz on",
                "cmc Magnitude of the frequency response: 200 nV/Pa up to 2 kHz",
                "cmc Settling time, within 5 %: 1 \u00b5s"}));
    }

    /// Whatever the budget may state, and whatever a CMC may be of, is said in words.
    void everyQuantity_hasWords()
    {
        for (const std::string &name : statedQuantities())
            QVERIFY2(english(sourceWords(name)) != name, name.c_str());
        for (const char *name : kCapabilityQuantities)
            QVERIFY2(english(valueWords(name)) != name, name);
        QCOMPARE(english(sourceWords("distance_m[Side 1]")), "distance along the tube, Side 1");
        QCOMPARE(english(sourceWords("weak_mode")), "weak_mode");
        QCOMPARE(english(valueWords("x")), "x");
    }

    /// The references of a step are no part of a free decay, nor of a response without one.
    void withoutAStep_onlyWhatTheModelDependsOnIsNamed_data()
    {
        QTest::addColumn<bool>("isDecay");
        QTest::newRow("free decay") << true;
        QTest::newRow("shock not evaluated") << false;
    }
    void withoutAStep_onlyWhatTheModelDependsOnIsNamed()
    {
        QFETCH(bool, isDecay);
        Recipe made = recipe();
        if (isDecay)
            made.input.treatment = ResponseTreatment::Impulse;
        else
            made.shock.enabled = false;
        made.uncertainty.budget.push_back({"clock_relative", 1e-6, "normal", {}, "C-1", ""});
        CalibrationResults results;
        UncertaintyReport report;
        UncertaintyLine clock;
        clock.quantity = "clock_relative";
        report.ofModel = {{"f0_hz", 1e5, "Hz", {clock}}};
        results.uncertainty = std::make_shared<UncertaintyReport>(report);
        const auto fields = traceabilityFields(results, made);
        QVERIFY(fieldOf(fields, "reference_clock_relative"));
        QVERIFY(!fieldOf(fields, "reference_t1_k"));
        QCOMPARE(
            textOf(fieldOf(fields, "reference_clock_relative")), "sample clock: certificate C-1");
    }

    void reference_thatEndedBeforeTheMeasurement_isMissing_data()
    {
        QTest::addColumn<QByteArray>("day");
        QTest::addColumn<bool>("isOver");
        QTest::newRow("before") << QByteArray("2026-05-30") << false;
        QTest::newRow("last day") << QByteArray(" 2026-05-31 ") << false;
        QTest::newRow("after") << QByteArray(" 2026-06-01") << true;
        QTest::newRow("no day") << QByteArray("banana") << false;
        QTest::newRow("none") << QByteArray() << false;
    }
    void reference_thatEndedBeforeTheMeasurement_isMissing()
    {
        QFETCH(QByteArray, day);
        QFETCH(bool, isOver);
        Recipe made = recipe();
        made.certificate.fields["date_performed"] = day.toStdString();
        const auto fields = traceabilityFields({}, made);
        const CertificateField *field = fieldOf(fields, "reference_t1_k");
        QVERIFY(textOf(field).find("T-0815") != std::string::npos);
        QCOMPARE(field->missing, isOver);
        QVERIFY(!fieldOf(fields, "reference_p1_pa"));
        made.uncertainty.budget[0].certificate.clear(); // a day alone counts too
        QCOMPARE(fieldOf(traceabilityFields({}, made), "reference_t1_k")->missing, isOver);
        QCOMPARE(fieldOf(unfilledFields({}, made), "reference_t1_k") != nullptr, isOver);
    }
};

DYNCAL_TEST(TestCertificateTraceability)
#include "tst_certificate_traceability.moc"
