// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the certificate of each kind of calibration says, and what it never says.

#include "core/base/constants.h"
#include "core/certificate/certificate.h"
#include "core/pipeline/calibration_kind.h"
#include "tests/support/certificate_text.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"
#include "tests/support/writable_result.h"

#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <limits>

using namespace dyncal;
using testing::keyResult;
using testing::writable;
using enum dyncal::CalibrationKind;

namespace {

const char *const kMeanSensitivity = "Sensitivity at the onset of the step, mean of the shots";

CalibrationResults resultsOf(CalibrationKind kind)
{
    CalibrationResults results = example::calibration();
    if (kind == FreeDecay)
        writable(results.input).treatment = ResponseTreatment::Impulse;
    for (ShockConditions &shot : writable(results.shock).shots) {
        shot.stepTyped = kind == TypedStep;
        if (kind == UnknownStep || kind == FreeDecay) {
            shot.step_Pa.reset();
            shot.states.reset();
        }
    }
    if (kind != UnknownStep && kind != FreeDecay)
        return results;
    ResponseResult &response = writable(results.response);
    response.sensitivity.reset();
    response.unit = "1";
    for (ShotSensitivity &shot : response.shots)
        shot.sensitivity.reset();
    if (kind == FreeDecay) {
        response.shots.clear();
        response.magnitude.resize(0);
        response.characteristics = {};
        response.gap = CharacteristicsGap::FreeDecay;
    }
    return results;
}

CertificateData certificateOf(CalibrationResults results, const Recipe &recipe = {})
{
    results.uncertainty = example::uncertaintyOf(results);
    return makeCertificate(results, recipe, "2026-11-21T03:04:05Z");
}

QStringList textsOf(const CertificateData &data)
{
    QStringList texts;
    const auto add
        = [&texts](const Message &message) { texts += QString::fromStdString(english(message)); };
    add(data.title);
    for (const CertificateSection &section : data.sections) {
        add(section.title);
        for (const auto *messages : {&section.paragraphs, &section.notes})
            std::for_each(messages->begin(), messages->end(), add);
        for (const CertificateField &field : section.fields) {
            add(field.label);
            add(field.value);
        }
        for (const CertificateTable &table : section.tables) {
            add(table.caption);
            for (const CertificateColumn &column : table.columns)
                add(column.heading);
            for (const auto &row : table.rows)
                std::for_each(row.begin(), row.end(), add);
        }
        for (const CertificateFigure &figure : section.figures)
            add(figure.caption);
    }
    return texts;
}

bool says(const CertificateData &data, const char *words)
{
    return textsOf(data).join('\n').contains(words, Qt::CaseInsensitive);
}

const CertificateTable *tableOf(const CertificateData &data, const char *section)
{
    const CertificateSection *part = data.section(section);
    return part && !part->tables.empty() ? &part->tables.front() : nullptr;
}

QStringList columnsOf(const CertificateTable &table)
{
    QStringList headings;
    for (const CertificateColumn &column : table.columns)
        headings += QString::fromStdString(english(column.heading));
    return headings;
}

} // namespace

class TestCertificateKinds : public QObject
{
    Q_OBJECT

private slots:
    void title_followsFromTheKind()
    {
        QCOMPARE(english(certificateOf(resultsOf(ComputedStep)).title),
            std::string("Certificate of dynamic calibration"));
        QCOMPARE(english(certificateOf(resultsOf(TypedStep)).title),
            std::string("Certificate of dynamic calibration"));
        QCOMPARE(english(certificateOf(resultsOf(UnknownStep)).title),
            std::string("Certificate of the normalised dynamic response"));
        QCOMPARE(english(certificateOf(resultsOf(FreeDecay)).title),
            std::string("Certificate of natural frequency and damping"));
    }

    void freeDecay_hasNoWordOfPressureStepsOrShockTubes()
    {
        const CertificateData data = certificateOf(resultsOf(FreeDecay));
        for (const char *words :
            {"sensitivity", "shock", "pressure step", "S(f)", "rise time", "overshoot", "settling",
                "within 5 %", "Mach", "plateau", "output step", "Frequency response, magnitude"})
            QVERIFY2(!says(data, words), words);
        QVERIFY(tableOf(data, "conditions") == nullptr);
        QVERIFY(tableOf(data, "frequency-response") == nullptr);
        QCOMPARE(data.section("frequency-response")->paragraphs.size(), std::size_t(1));
        QCOMPARE(keyResult(data, "Undamped natural frequency"),
            std::string("2.33000 MHz | 0.00082 MHz | 2"));
        QCOMPARE(columnsOf(*tableOf(data, "shots")),
            (QStringList{"Shot", "Level", "Sample rate", "Largest deflection", "Signal to noise"}));
        QVERIFY(says(data, "decayed freely"));
    }

    void unknownStep_isNormalised()
    {
        const CertificateData data = certificateOf(resultsOf(UnknownStep));
        for (const char *words : {"shock tube", "S(f)", "Sensitivity over frequency"})
            QVERIFY2(!says(data, words), words);
        QVERIFY(says(data, "Normalised response over frequency"));
        QCOMPARE(
            keyResult(data, kMeanSensitivity), std::string("not determined (no pressure step)"));
        QVERIFY(tableOf(data, "conditions") == nullptr);
        QCOMPARE(data.section("conditions")->notes.size(), std::size_t(1));
        QVERIFY(!columnsOf(*tableOf(data, "shots")).contains("Sensitivity"));
        QVERIFY(keyResult(data, "Rise time, 10 % to 90 %") != "no row");
    }

    void typedStep_needsNoShockTube()
    {
        const CertificateData data = certificateOf(resultsOf(TypedStep));
        for (const char *words : {"shock tube", "shock wave"})
            QVERIFY2(!says(data, words), words);
        QVERIFY(says(data, "stated by the operator"));
        QVERIFY(says(data, "Sensitivity over frequency"));
        QVERIFY(columnsOf(*tableOf(data, "shots")).contains("Sensitivity"));
    }

    void computedStep_namesTheWall()
    {
        Recipe recipe;
        QVERIFY(says(certificateOf(resultsOf(ComputedStep), recipe), "end-wall plane"));
        recipe.shock.dutPosition = "side-wall";
        const CertificateData data = certificateOf(resultsOf(ComputedStep), recipe);
        QVERIFY(!says(data, "end-wall") && says(data, "side wall of a shock tube"));
    }

    /// The recipe may ask for a relative response although the step is known.
    void relativeResponseOfAKnownStep_isNormalised()
    {
        CalibrationResults results = resultsOf(ComputedStep);
        writable(results.response).unit = "1";
        const CertificateData data = certificateOf(results);
        QVERIFY(!says(data, "Sensitivity over frequency"));
        QVERIFY(says(data, "Normalised response over frequency"));
        QCOMPARE(keyResult(data, kMeanSensitivity), std::string("no complete uncertainty"));
    }

    void rows_lieInsideTheBand()
    {
        CalibrationResults results = resultsOf(ComputedStep);
        ResponseResult &response = writable(results.response);
        const auto all = static_cast<std::size_t>(response.frequency_Hz.size());
        QCOMPARE(tableOf(certificateOf(results), "frequency-response")->rows.size(), all);
        response.fLow_Hz = 1.01 * response.frequency_Hz[0];
        response.fHigh_Hz = 0.99 * response.frequency_Hz[static_cast<Index>(all) - 2];
        const CertificateData data = certificateOf(results);
        QCOMPARE(tableOf(data, "frequency-response")->rows.size(), all - 3);
        QVERIFY(says(data, "Of the 12 frequencies asked for, 3 lie outside these limits"));
        response.fLow_Hz = 2.0 * response.frequency_Hz.maxCoeff();
        QVERIFY(tableOf(certificateOf(results), "frequency-response") == nullptr);
    }

    void modelColumns_endAtHalfTheRateOfTheModel()
    {
        CalibrationResults results = resultsOf(ComputedStep);
        ResponseResult &response = writable(results.response);
        response.modelLimit_Hz = 1.001 * response.frequency_Hz[8];
        const CertificateTable table = *tableOf(certificateOf(results), "frequency-response");
        for (std::size_t row = 0; row < table.rows.size(); ++row) {
            for (const std::size_t column : {5U, 6U}) {
                const bool isDash = english(table.rows[row][column]) == "\xE2\x80\x93";
                QCOMPARE(isDash, row > 8);
            }
            QVERIFY(english(table.rows[row][1]) != "\xE2\x80\x93"); // measured up to f_high
        }
    }

    /// A mark at a frequency asked for names its line; another has a line of its own in its place.
    void markedFrequencies_haveLinesWithTheirNames()
    {
        CalibrationResults results = resultsOf(ComputedStep);
        ResponseResult &response = writable(results.response);
        const std::size_t asked
            = tableOf(certificateOf(results), "frequency-response")->rows.size();
        auto marked = std::make_shared<ResponseResult>(response);
        marked->frequency_Hz.resize(3);
        marked->frequency_Hz << response.frequency_Hz[0],
            0.5 * (response.frequency_Hz[4] + response.frequency_Hz[5]), response.fHigh_Hz;
        marked->marks = {RowMark::LowEnd, RowMark::Resonance, RowMark::HighEnd};
        marked->magnitude[1] = 7.7e-6;
        response.atMarks = marked;
        const CertificateData data = certificateOf(results);
        const CertificateTable &table = *tableOf(data, "frequency-response");
        QCOMPARE(table.rows.size(), asked + 1);
        QVERIFY(english(table.rows.front().front()).starts_with("lower limit "));
        QVERIFY(english(table.rows[5].front()).starts_with("resonance "));
        QCOMPARE(english(table.rows[5][1]).substr(0, 3), std::string("7.7"));
        QVERIFY(english(table.rows.back().front()).starts_with("upper limit "));
        QVERIFY(english(table.rows[1].front()).find(' ') != std::string::npos);
        QCOMPARE(keyResult(data, "Magnitude at the resonance, from the records"),
            std::string("no complete uncertainty"));
    }

    void bandsBeyondTheAnswer_areBounds()
    {
        CalibrationResults results = resultsOf(ComputedStep);
        ResponseResult &response = writable(results.response);
        response.fHigh_Hz = 6e5;
        const CertificateData data = certificateOf(results);
        QCOMPARE(
            keyResult(data, "Magnitude within 5 % up to"), std::string("no complete uncertainty"));
        for (const char *label : {"Magnitude within 10 % up to", "Magnitude above -3 dB up to"})
            QCOMPARE(keyResult(data, label),
                std::string("above 600 kHz (the band of the response ends there)"));
    }

    /// Nothing has five digits but with an uncertainty beside it: no number of more than four
    /// stands in a text that has no U, nor in a line of a table that has none.
    void withoutAnyUncertainty_nothingHasFiveDigits_data()
    {
        QTest::addColumn<int>("kind");
        for (const CalibrationKind kind : {ComputedStep, TypedStep, UnknownStep, FreeDecay})
            QTest::newRow(calibrationKindName(kind)) << int(kind);
    }
    void withoutAnyUncertainty_nothingHasFiveDigits()
    {
        QFETCH(int, kind);
        CalibrationResults results = resultsOf(static_cast<CalibrationKind>(kind));
        for (Pole &pole : writable(results.assessment).poles)
            pole.u_frequency_Hz = pole.u_dampingRatio = kUnknown;
        ResponseResult &response = writable(results.response);
        for (Eigen::VectorXd *u : {&response.u_magnitude, &response.u_phase_rad})
            u->setConstant(u->size(), kUnknown);
        for (Index i = 0; i < response.frequency_Hz.size(); ++i)
            response.frequency_Hz[i] *= 1.0 + 1e-9 * static_cast<double>(i % 2); // as computed
        Environment &air = writable(results.captures).set.shots[0].environment;
        air.ambientT_K = 293.4567;
        air.ambientPressure_Pa = 101234.567;
        writable(results.input).offset_s = 1.2345678e-6;
        static const QRegularExpression number("\\d[\\d.]*");
        for (const QString &text : textsOf(certificateOf(results))) {
            if (text.contains("SN-") || text.size() > 60 || text.contains("build"))
                continue; // serial numbers, sentences, hashes
            QRegularExpressionMatchIterator found = number.globalMatch(text);
            while (found.hasNext()) {
                QString digits = found.next().captured().remove('.');
                while (digits.startsWith('0'))
                    digits.remove(0, 1);
                const int most = text.endsWith(" K") ? 5 : 4; // a temperature has five
                QVERIFY2(digits.size() <= most || text.contains("2026"), qPrintable(text));
            }
        }
    }

    void sensitivityWithoutU_isNoResultAndTheNoteSaysSo()
    {
        CalibrationResults results = resultsOf(ComputedStep);
        writable(results.response).sensitivity = 12.34567e-6;
        const CertificateData data = certificateOf(results);
        QCOMPARE(keyResult(data, kMeanSensitivity), std::string("no complete uncertainty"));
        QVERIFY(!says(data, "12.3"));
        QVERIFY(says(data, "has none that is complete: it is no result"));
    }

    void oneShot_isNoMean()
    {
        CalibrationResults results = resultsOf(ComputedStep);
        ResponseResult &response = writable(results.response);
        response.shots.resize(2);
        QVERIFY(says(certificateOf(results), "mean of the shots"));
        response.shots.resize(1);
        const CertificateData data = certificateOf(results);
        QVERIFY(says(data, "Sensitivity at the onset of the step"));
        QVERIFY(!says(data, "mean of the shots"));
    }

    /// A model's value is no better known than the measured one beside it, and has no U of its own.
    void modelValues_haveThreeDigitsAtMost()
    {
        CalibrationResults results = resultsOf(ComputedStep);
        ResponseResult &response = writable(results.response);
        response.magnitude[2] = response.modelMagnitude[2] = 12.34567e-6;
        response.u_magnitude[2] = 0.0002e-6;
        response.magnitude[3] = response.modelMagnitude[3] = 12.34567e-6;
        response.u_magnitude[3] = 1.4e-6;
        const CertificateTable table = *tableOf(certificateOf(results), "frequency-response");
        QCOMPARE(
            QString::fromStdString(english(table.rows[2][1])), QString::fromUtf8("12.34567 µV/Pa"));
        QCOMPARE(
            QString::fromStdString(english(table.rows[2][5])), QString::fromUtf8("12.3 µV/Pa"));
        QCOMPARE(
            QString::fromStdString(english(table.rows[3][5])), QString::fromUtf8("12.3 µV/Pa"));
        response.u_magnitude[3] = 7e-6; // U = 14
        QCOMPARE(QString::fromStdString(
                     english(tableOf(certificateOf(results), "frequency-response")->rows[3][5])),
            QString::fromUtf8("12 µV/Pa"));
    }

    void frequencies_areSettings()
    {
        CalibrationResults results = resultsOf(ComputedStep);
        ResponseResult &response = writable(results.response);
        const double typed_Hz[] = {1e5, 123456.0, 125892.5411794, 2e6};
        for (Index i = 0; i < 4; ++i)
            response.frequency_Hz[i] = typed_Hz[i];
        const CertificateTable table = *tableOf(certificateOf(results), "frequency-response");
        const char *const words[] = {"100 kHz", "123.456 kHz", "125.9 kHz", "2 MHz"};
        for (std::size_t i = 0; i < 4; ++i)
            QCOMPARE(english(table.rows[i][0]), std::string(words[i]));
    }

    void riseOfARecord_shorterThanTwoSamples_isABound()
    {
        CalibrationResults results = resultsOf(ComputedStep);
        writable(results.window).responses[0].riseTime_s = 1.5 / 50e6;
        const CertificateTable table = *tableOf(certificateOf(results), "shots");
        QCOMPARE(english(table.rows[0][5]), std::string("below 40.0 ns (two samples)"));
        QCOMPARE(english(table.rows[0][6]), std::string("\xE2\x80\x93")); // the overshoot
    }

    void velocity_hasItsU()
    {
        CalibrationResults results = resultsOf(ComputedStep);
        ShockConditions &shot = writable(results.shock).shots[0];
        QCOMPARE(english(tableOf(certificateOf(results), "conditions")->rows[0][4]),
            std::string("438 m/s"));
        StepUncertainty uncertainty;
        uncertainty.budget.value = Eigen::VectorXd::Constant(kStepResults, 1.0);
        uncertainty.budget.u = Eigen::VectorXd::Constant(kStepResults, 0.5);
        uncertainty.budget.dof
            = Eigen::VectorXd::Constant(kStepResults, std::numeric_limits<double>::infinity());
        shot.uncertainty = uncertainty;
        QCOMPARE(english(tableOf(certificateOf(results), "conditions")->rows[0][4]),
            std::string("437.6 m/s \xC2\xB1 1.0 m/s (k = 2)"));
    }
};

DYNCAL_TEST(TestCertificateKinds)
#include "tst_certificate_kinds.moc"
