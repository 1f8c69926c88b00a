// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A certificate of which one number after the other is not a number, infinite, zero or denormal:
// the page must stay readable, and every printed number must be one.

#include "core/certificate/certificate.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"
#include "tests/support/writable_result.h"

#include <QRegularExpression>
#include <QTest>

#include <limits>
#include <map>
#include <string>

using namespace dyncal;
using testing::writable;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
const char *const kDash = "\xE2\x80\x93";

/// The example's results, to be written to.
struct Scene
{
    CalibrationResults results = example::calibration({50e6, 20e-6, 40, 4});
    CaptureSet &captures = writable(results.captures).set;
    WindowResult &window = writable(results.window);
    ShockConditionsSet &shock = writable(results.shock);
    ModelInput &input = writable(results.input);
    OrderEvidence &evidence = writable(results.evidence);
    SensorModel &model = writable(results.model);
    ModelAssessment &assessment = writable(results.assessment);
    ResponseResult &response = writable(results.response);

    Scene(const Scene &) = delete;
    Scene &operator=(const Scene &) = delete;
    Scene()
    {
        StepUncertainty uncertainty;
        uncertainty.budget.value = Eigen::VectorXd::Constant(kStepResults, 169e3);
        uncertainty.budget.u = Eigen::VectorXd::Constant(kStepResults, 700.0);
        uncertainty.budget.dof = Eigen::VectorXd::Constant(kStepResults, 12.0);
        shock.shots[0].uncertainty = uncertainty;
        evidence.poles = {{2, example::kF0_Hz, example::kZeta, PoleStability::New, true, 1.0},
            {3, example::kF0_Hz * 1.002, example::kZeta * 1.01, PoleStability::FrequencyAndDamping,
                true, 1.0}};
        NuisanceOfShot mode;
        mode.shot = 1;
        mode.term.pole_rad_s = {-600.0, 6e4};
        mode.u_frequency_Hz = 3.2;
        mode.u_dampingRatio = 1e-4;
        mode.relativeAmplitude = 0.03;
        NuisanceMode tube;
        tube.reason = "seen in every shot";
        model.nuisance = {{tube, {mode}}};
        const NuisanceEffect::Side side{0.03, 88.0, 2.33e6, 400.0, 0.02, 1e-4, 1.0};
        assessment.nuisanceEffect = NuisanceEffect{side, side};
        model.fitListing_percent = 81.0;
        input.leftOut = {{1, 1e-6, 2e-6, "knock"}};
    }

    /// With a budget of everything that a certificate states.
    std::shared_ptr<const UncertaintyReport> budget() const
    {
        auto report = std::make_shared<UncertaintyReport>(*example::uncertaintyOf(results));
        const auto of = [](const char *name, double value) {
            ReportedValue one{name, value, ""};
            one.u = 0.01 * std::abs(value);
            return one;
        };
        const StepCharacteristics &c = response.characteristics;
        report->sensitivity = of("sensitivity", *response.sensitivity);
        for (const ReportedValue &one :
            {of("rise_time_s", *c.riseTime_s), of("overshoot_percent", *c.overshoot_percent),
                of("settling_time_s", *c.settlingTime_s),
                of("within_5_percent_hz", *c.within5percent_Hz),
                of("within_10_percent_hz", *c.within10percent_Hz),
                of("minus_3_db_hz", *c.minus3dB_Hz)})
            report->ofModel.push_back(one);
        return report;
    }

    CertificateData certificate() const
    {
        Recipe recipe;
        recipe.certificate.fields = example::certificateFields();
        CalibrationResults shown = results;
        shown.uncertainty = budget();
        return makeCertificate(shown, recipe, "2026-11-21T03:04:05Z");
    }

    /// Every number that the page may print.
    std::vector<std::pair<const char *, double *>> numbers()
    {
        Environment &air = captures.shots[0].environment;
        WindowedResponse &shot = window.responses[0];
        ShockConditions &step = shock.shots[0];
        Pole &pole = assessment.poles[0];
        NuisanceOfShot &mode = model.nuisance[0].perShot[0];
        NuisanceEffect::Side &side = assessment.nuisanceEffect->before;
        StepCharacteristics &c = response.characteristics;
        return {{"ambient T", &air.ambientT_K}, {"ambient p", &air.ambientPressure_Pa},
            {"humidity", &air.relativeHumidity}, {"rate", &shot.sampleRate_Hz},
            {"output step", &shot.step}, {"snr", &shot.snr_dB}, {"shot rise", &*shot.riseTime_s},
            {"shot overshoot", &*shot.overshoot_percent}, {"shot settling", &*shot.settlingTime_s},
            {"step", &*step.step_Pa},
            {"step u", &step.uncertainty->budget.u[static_cast<Index>(StepResult::Step)]},
            {"step dof", &step.uncertainty->budget.dof[static_cast<Index>(StepResult::Step)]},
            {"velocity", &step.states->velocity_m_s}, {"mach", &step.states->mach},
            {"p1", &step.states->driven.pressure_Pa}, {"T1", &step.states->driven.temperature_K},
            {"plateau", &*step.plateau_s}, {"model rate", &input.sampleRate_Hz},
            {"offset", &input.offset_s}, {"left out from", &input.leftOut[0].from_s},
            {"left out to", &input.leftOut[0].to_s}, {"f0", &pole.frequency_Hz},
            {"u f0", &pole.u_frequency_Hz}, {"zeta", &pole.dampingRatio},
            {"u zeta", &pole.u_dampingRatio}, {"amplitude", &pole.amplitude},
            {"k", &pole.coverageFactor}, {"fit", &model.fit_percent},
            {"attainable", &model.fitAttainable_percent}, {"listing", &*model.fitListing_percent},
            {"mode f u", &mode.u_frequency_Hz}, {"mode zeta u", &mode.u_dampingRatio},
            {"mode size", &mode.relativeAmplitude}, {"side residual", &side.residualRms},
            {"side fit", &side.fit_percent}, {"side f0", &side.f0_Hz}, {"side u f0", &side.u_f0_Hz},
            {"side zeta", &side.zeta}, {"side u zeta", &side.u_zeta},
            {"side plateau", &side.plateauGain}, {"f low", &response.fLow_Hz},
            {"f high", &response.fHigh_Hz}, {"frequency", &response.frequency_Hz[1]},
            {"magnitude", &response.magnitude[1]}, {"u magnitude", &response.u_magnitude[1]},
            {"phase", &response.phase_rad[1]}, {"u phase", &response.u_phase_rad[1]},
            {"model magnitude", &response.modelMagnitude[1]},
            {"model phase", &response.modelPhase_rad[1]}, {"rise", &*c.riseTime_s},
            {"overshoot", &*c.overshoot_percent}, {"settling", &*c.settlingTime_s},
            {"5 %", &*c.within5percent_Hz}, {"10 %", &*c.within10percent_Hz},
            {"3 dB", &*c.minus3dB_Hz}, {"sensitivity", &*response.sensitivity},
            {"shot sensitivity", &*response.shots[0].sensitivity},
            {"order f0", &evidence.poles[0].frequency_Hz},
            {"order zeta", &evidence.poles[1].dampingRatio}};
    }
};

std::vector<QString> texts(const CertificateData &data)
{
    std::vector<QString> list;
    const auto add
        = [&](const Message &message) { list.push_back(QString::fromStdString(english(message))); };
    for (const CertificateSection &section : data.sections) {
        for (const auto *messages : {&section.paragraphs, &section.notes})
            std::for_each(messages->begin(), messages->end(), add);
        for (const CertificateField &field : section.fields)
            add(field.value);
        for (const CertificateTable &table : section.tables) {
            for (const auto &row : table.rows)
                std::for_each(row.begin(), row.end(), add);
        }
    }
    return list;
}

/// What no reader can make sense of: a word for no number, a unit without a number before it, a
/// number of dozens of digits, nothing at all.
QString nonsense(const CertificateData &data)
{
    static const QRegularExpression noNumber(
        "(^|[^a-z])(nan|inf|infinity)([^a-z]|$)", QRegularExpression::CaseInsensitiveOption);
    static const QRegularExpression manyDigits("[0-9]{25}|[0-9]\\.[0-9]{25}");
    for (const QString &text : texts(data)) {
        if (text.contains(noNumber) || text.contains(manyDigits) || text.isEmpty()
            || text.startsWith(' ') || text.contains("  "))
            return "\"" + text + "\"";
    }
    return {};
}

} // namespace

class TestCertificateHostile : public QObject
{
    Q_OBJECT

private slots:
    void example_isFreeOfNonsense()
    {
        const QString found = nonsense(Scene().certificate());
        QVERIFY2(found.isEmpty(), qPrintable(found));
    }

    void oneNumberOff_pageStaysReadable_data()
    {
        QTest::addColumn<double>("value");
        QTest::newRow("not a number") << std::nan("");
        QTest::newRow("infinite") << kInf;
        QTest::newRow("minus infinite") << -kInf;
        QTest::newRow("zero") << 0.0;
        QTest::newRow("minus zero") << -0.0;
        QTest::newRow("smallest") << std::numeric_limits<double>::denorm_min();
        QTest::newRow("tiny") << 1e-40;
        QTest::newRow("largest") << std::numeric_limits<double>::max();
        QTest::newRow("negative") << -3.0;
    }
    void oneNumberOff_pageStaysReadable()
    {
        QFETCH(double, value);
        Scene scene;
        QStringList bad;
        for (const auto &[name, number] : scene.numbers()) {
            const double before = *number;
            *number = value;
            const QString found = nonsense(scene.certificate());
            if (!found.isEmpty())
                bad += QString(name) + ": " + found;
            *number = before;
        }
        QVERIFY2(bad.isEmpty(), qPrintable(bad.join("; ")));
    }

    void everyNumberIsPrinted()
    {
        // Keeps the list above honest: a value that nobody prints would pass whatever it is.
        Scene scene;
        const std::vector<QString> before = texts(scene.certificate());
        QStringList silent;
        for (const auto &[name, number] : scene.numbers()) {
            const double value = *number;
            *number = std::isfinite(value) ? 1.7 * value : 7.0;
            if (texts(scene.certificate()) == before)
                silent += name;
            *number = value;
        }
        QVERIFY2(silent.isEmpty(), qPrintable(silent.join(", ")));
    }

    void poleAtTheOrigin_orAtInfinity_isListed()
    {
        Scene scene;
        Pole delay = scene.assessment.poles[0];
        delay.z = 0.0;
        delay.s_rad_s = {-kInf, 0.0};
        delay.frequency_Hz = kInf;
        delay.dampingRatio = std::nan("");
        delay.u_frequency_Hz = delay.u_dampingRatio = kUnknown;
        Pole far = delay;
        far.z = {-1e300, 1e300};
        scene.assessment.poles = {delay, far};
        scene.model.poles = scene.assessment.poles;
        const QString found = nonsense(scene.certificate());
        QVERIFY2(found.isEmpty(), qPrintable(found));
    }

    void nothingButFieldsOfBlanks_areMissing()
    {
        // A blank typed into a form is not a customer.
        Recipe recipe;
        std::map<std::string, std::string> &fields = recipe.certificate.fields;
        for (const char *blank : {"", " ", "\t \n"}) {
            for (auto &[key, text] : example::certificateFields())
                fields[key] = blank;
            fields["approved_by"] = blank;
            const CertificateData data = makeCertificate({}, recipe, {});
            const std::size_t all = makeCertificate({}, {}, {}).missingFields().size();
            QCOMPARE(data.missingFields().size(), all);
            QVERIFY(data.number.find_first_not_of(" \t\n") == std::string::npos);
            const CertificateSection &section = *data.section("administrative");
            QCOMPARE(english(section.fields.back().value), std::string("not yet approved"));
            const auto method = data.section("method")->fields.front();
            QVERIFY(method.missing);
        }
    }

    void exclusionWithoutAReason_saysSo()
    {
        Scene scene;
        scene.captures.shots[1].included = false;
        const std::string text
            = english(scene.certificate().section("remarks")->paragraphs.front());
        QVERIFY2(text.find("Reason: .") == std::string::npos, text.c_str());
        QVERIFY(text.find("Shot 2") != std::string::npos);
    }

    void rangeThatRoundsToOneValue_isOneValue()
    {
        Scene scene;
        for (Shot &shot : scene.captures.shots)
            shot.environment.ambientT_K = 294.12;
        scene.captures.shots[0].environment.ambientT_K = 294.1200001;
        const CertificateData data = scene.certificate();
        for (const CertificateField &field : data.section("conditions")->fields) {
            if (field.id == "ambient_temperature")
                QCOMPARE(english(field.value), std::string("294.12 K"));
        }
    }

    void stepWhoseInputsAreExact_hasNoEmptyUncertainty()
    {
        // Every input stated with u = 0: then u of the step is 0, and there is no U to print.
        Scene scene;
        scene.shock.shots[0].uncertainty->budget.u.setZero();
        const CertificateData data = scene.certificate();
        const CertificateTable &table = data.section("conditions")->tables.at(0);
        QCOMPARE(english(table.rows[0][6]), std::string("169 kPa"));
        QCOMPARE(english(table.rows[0][8]), std::string("not determined"));
        QCOMPARE(english(table.rows[0][9]), std::string(kDash));
    }
};

DYNCAL_TEST(TestCertificateHostile)
#include "tst_certificate_hostile.moc"
