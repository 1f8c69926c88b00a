// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a certificate says of a reference transducer: by itself, beside the step, and not at all.

#include "core/certificate/certificate.h"
#include "core/certificate/certificate_reference.h"
#include "core/certificate/certificate_words.h"
#include "core/pipeline/calibration_kind.h"
#include "core/pipeline/pipeline.h"
#include "tests/support/reference_capture.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

class TestCertificateReference : public QObject
{
    Q_OBJECT

private:
    std::shared_ptr<const CaptureSet> m_set;

    static Recipe compared(const char *reference)
    {
        Recipe recipe;
        recipe.comparison = testing::referenceComparison();
        recipe.response.reference = reference;
        return recipe;
    }

    CalibrationResults run(const Recipe &recipe) const
    {
        ResultCache cache;
        return runPipeline(m_set, recipe, cache, StageId::Comparison).results;
    }

    static bool says(const CertificateSection &section, const std::string &words)
    {
        const auto holds = [&](const Message &message) {
            return english(message).find(words) != std::string::npos;
        };
        return std::ranges::any_of(section.paragraphs, holds)
            || std::ranges::any_of(section.notes, holds);
    }

    static bool showsComparison(const CertificateData &data)
    {
        const auto &figures = data.section("figures")->figures;
        return std::ranges::find(figures, std::string("comparison"), &CertificateFigure::id)
            != figures.end();
    }

    static std::string captionOf(const CertificateData &data, const char *id)
    {
        for (const CertificateFigure &figure : data.section("figures")->figures)
            if (figure.id == id)
                return english(figure.caption);
        return {};
    }

private slots:
    void initTestCase() { m_set = testing::referenceCapture(); }

    void againstTheTransducer_itSaysWhatThatIs()
    {
        const Recipe recipe = compared("transducer");
        const CalibrationResults results = run(recipe);
        QVERIFY(calibrationKind(results, recipe) == CalibrationKind::Transducer);
        QCOMPARE(stepsUsed(results, recipe), &results.reference->steps);
        const CertificateData data = makeCertificate(results, recipe, {});
        QVERIFY(says(*data.section("method"), "comparison with a reference transducer"));
        QVERIFY(says(*data.section("method"), "what the reference transducer saw"));
        QVERIFY(says(*data.section("frequency-response"), "ratios of the item's record"));
        QVERIFY(says(*data.section("frequency-response"), "Check by the second way"));
        const std::string zero = "model: from the item's own onset"; // two zeros of one figure
        QVERIFY(captionOf(data, "phase").ends_with(zero));
        QVERIFY(says(*data.section("frequency-response"), "that of the model from the item's own"));
        const CertificateTable &steps = data.section("conditions")->tables.front();
        for (const std::vector<Message> &row : steps.rows)
            QCOMPARE(english(row[7]), std::string("of the reference"));
    }

    void besideTheStep_itSaysTheDifference()
    {
        const Recipe recipe = compared("computed-step");
        const CalibrationResults results = run(recipe);
        QVERIFY(calibrationKind(results, recipe) == CalibrationKind::ComputedStep);
        QCOMPARE(stepsUsed(results, recipe), results.shock.get());
        QVERIFY(comparisonSentence(results).has_value());
        const std::vector<CertificateField> fields = referenceFields(results, recipe);
        QCOMPARE(fields.front().id, std::string("reference_channel"));
        QCOMPARE(english(fields.front().value), std::string("Reference"));
        const ReferenceModel &model = *recipe.comparison.model;
        QCOMPARE(english(fields.back().value),
            "second-order sensor, as stated by the laboratory: sensitivity "
                + english(printedWithUncertainty(model.sensitivity, model.u_sensitivity, "V/Pa"))
                + ", natural frequency "
                + english(printedWithUncertainty(model.f0_Hz, model.u_f0_Hz, "Hz"))
                + ", damping ratio "
                + english(printedWithUncertainty(model.zeta, model.u_zeta, "")));
        const CertificateData data = makeCertificate(results, recipe, {});
        QVERIFY(showsComparison(data));
        QCOMPARE(captionOf(data, "phase"), std::string("Frequency response, phase"));
    }

    void without_itSaysNothing()
    {
        const CalibrationResults results = run({});
        QVERIFY(referenceFields(results, {}).empty() && !comparisonSentence(results));
        QVERIFY(referenceFields({}, {}).empty() && !comparisonSentence({}));
        QVERIFY(stepsUsed({}, {}) == nullptr);
        QVERIFY(!showsComparison(makeCertificate(results, {}, {})));
    }
};

DYNCAL_TEST(TestCertificateReference)
#include "tst_certificate_reference.moc"
