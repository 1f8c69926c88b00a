// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Statements of conformity, from rows that are written down.

#include "core/certificate/certificate.h"
#include "core/certificate/conformity.h"
#include "tests/support/example_results.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"
#include "tests/support/writable_result.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>

using namespace dyncal;
using testing::isNear;
using enum dyncal::ConformityVerdict;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kLevelNoise = 0.004;

/// S is 2 V/Pa at low frequency; the rows deviate by 0, 1, 2 and 4 %, each with u of 0.3 %.
ResponseResult rising()
{
    ResponseResult made;
    made.unit = made.sensitivityUnit = "V/Pa";
    made.sensitivity = 2.0;
    made.fLow_Hz = 500.0;
    made.fHigh_Hz = 5e3;
    made.frequency_Hz = Eigen::Vector4d(1000.0, 1258.9, 1584.9, 1995.3);
    made.magnitude = Eigen::Vector4d(2.0, 2.02, 2.04, 2.08);
    made.u_noiseMagnitude = made.u_magnitude = Eigen::Vector4d::Constant(0.006);
    made.boundEnd = made.boundAlias = made.u_frontMagnitude = Eigen::Vector4d::Zero();
    made.dof = Eigen::Vector4d::Constant(kInf);
    made.front = {1e-9, 1e-10};
    ShotSensitivity shot;
    shot.shot = 1;
    shot.uLevel_relative = kLevelNoise;
    made.shots = {shot};
    return made;
}

DecisionSettings claim(DecisionRule rule, double within_percent)
{
    return {rule, within_percent, 1000.0, 1995.3, 5.0};
}

ConformityVerdict verdictOf(
    DecisionRule rule, double within_percent, const ResponseResult &response = rising())
{
    return judgeConformity(response, claim(rule, within_percent)).verdict;
}

std::string reasonOf(const ResponseResult &response, const DecisionSettings &decision)
{
    const ConformityResult judged = judgeConformity(response, decision);
    return judged.verdict == NoStatement ? english(judged.why) : "judged";
}

} // namespace

class TestConformity : public QObject
{
    Q_OBJECT

private slots:
    void probabilityOutside_ofTheNormalDistribution()
    {
        // 1.959964 standard deviations to either side leave 5 % outside.
        QVERIFY(isNear(probabilityOutside(0.0, 0.05 / 1.959963985, kInf, 0.05), 0.05, 1e-8));
        // On the limit half lies beyond it; the other limit is 10 u away.
        QVERIFY(isNear(probabilityOutside(0.05, 0.01, kInf, 0.05), 0.5, 1e-12));
        QVERIFY(isNear(probabilityOutside(-0.05, 0.01, kInf, 0.05), 0.5, 1e-12));
        // 1.644854 u inside one limit: 5 %.
        QVERIFY(isNear(probabilityOutside(0.05 - 0.01644853627, 0.01, kInf, 0.05), 0.05, 1e-8));
    }

    void probabilityOutside_ofOneDegreeOfFreedom_isCauchys()
    {
        const double inside = (std::atan(3.0) + std::atan(7.0)) / std::numbers::pi;
        QVERIFY(isNear(probabilityOutside(0.02, 0.01, 1.0, 0.05), 1.0 - inside, 1e-9));
    }

    void probabilityOutside_withoutUncertainty_isNoneOrAll()
    {
        QCOMPARE(probabilityOutside(0.05, 0.0, kInf, 0.05), 0.0);
        QCOMPARE(probabilityOutside(-0.051, 0.0, kInf, 0.05), 1.0);
    }

    /// A resonance between two rows that lie within the limit, or behind the last of them.
    void modelBetweenTheRows_mustKeepTheLimitToo()
    {
        ResponseResult response = rising();
        response.modelCurve.frequency_Hz = Eigen::Vector4d(1000.0, 1400.0, 1990.0, 2100.0);
        response.modelCurve.magnitude = Eigen::Vector4d(2.0, 2.03, 2.08, 3.0);
        QVERIFY(verdictOf(DecisionRule::Simple, 5.0, response) == Conforms); // 3.0 is not claimed
        response.modelCurve.magnitude[1] = 2.12;
        const std::string said = reasonOf(response, claim(DecisionRule::Simple, 5.0));
        QVERIFY2(said.find("1.4 kHz") != said.npos, said.c_str());
        QVERIFY(said.find("by 6") != said.npos);
        response.modelCurve.magnitude[1] = 2.095; // 4.75 %: within 5 %, but not less U
        QVERIFY(verdictOf(DecisionRule::Simple, 5.0, response) == Conforms);
        QVERIFY(verdictOf(DecisionRule::GuardBand, 5.2, response) == NoStatement);
        QVERIFY(verdictOf(DecisionRule::GuardBand, 6.0, response) == Conforms);
        // A row that is rejected decides, whatever the model says.
        QVERIFY(verdictOf(DecisionRule::Simple, 3.0, response) == DoesNotConform);
    }

    /// u of the ratio: noise of the row, and that of the level; nothing that both share.
    void worstRow_hasTheRatioAndItsU()
    {
        const ConformityResult judged = judgeConformity(rising(), claim(DecisionRule::Simple, 5.0));
        QCOMPARE(judged.rows, Index(4));
        QVERIFY(judged.worst);
        QCOMPARE(judged.worst->frequency_Hz, 1995.3);
        QVERIFY(isNear(judged.worst->deviation, 0.04));
        QVERIFY(isNear(judged.worst->u, std::hypot(0.003, 1.04 * kLevelNoise)));
        QCOMPARE(judged.worst->k, 2.0);
        ResponseResult shared = rising(); // a step that is known to 10 % changes nothing
        shared.summary.mean = SensitivityMean{};
        shared.summary.mean->lines = {directLine("t1_k", 0.1)};
        const double u = judgeConformity(shared, claim(DecisionRule::Simple, 5.0)).worst->u;
        QCOMPARE(u, judged.worst->u);
    }

    void simple_comparesTheDeviation()
    {
        QCOMPARE(verdictOf(DecisionRule::Simple, 4.001), Conforms);
        QCOMPARE(verdictOf(DecisionRule::Simple, 3.999), DoesNotConform);
    }

    void guardBand_takesUOffTheLimit()
    {
        const double U_percent = 200.0 * std::hypot(0.003, 1.04 * kLevelNoise);
        QCOMPARE(verdictOf(DecisionRule::GuardBand, 4.001 + U_percent), Conforms);
        QCOMPARE(verdictOf(DecisionRule::GuardBand, 3.999 + U_percent), DoesNotConform);
    }

    void risk_ofFivePercent_is1p645uInside()
    {
        const double u_percent = 100.0 * std::hypot(0.003, 1.04 * kLevelNoise);
        QCOMPARE(verdictOf(DecisionRule::Risk, 4.001 + 1.644854 * u_percent), Conforms);
        QCOMPARE(verdictOf(DecisionRule::Risk, 3.999 + 1.644854 * u_percent), DoesNotConform);
    }

    /// With two degrees of freedom U is 4.303 u and the tails are heavy.
    void fewDegreesOfFreedom_areStudents()
    {
        ResponseResult few = rising();
        few.shots.front().uLevel_relative = 0.0;
        few.dof.setConstant(2.0);
        const JudgedRow worst = *judgeConformity(few, claim(DecisionRule::GuardBand, 9.0)).worst;
        QVERIFY(isNear(worst.dof, 2.0, 1e-9));
        QVERIFY(isNear(worst.k, 4.302653, 1e-6));
        // P(T > t) = 1/2 - t / (2 sqrt(2 + t^2)) at two degrees of freedom.
        const auto beyond = [](double t) { return 0.5 - 0.5 * t / std::sqrt(2.0 + t * t); };
        QVERIFY(isNear(worst.risk, beyond(0.05 / 0.003) + beyond(0.13 / 0.003), 1e-9));
    }

    /// Of a response relative to its level the level's noise does not cancel.
    void relativeResponse_isComparedWithOne()
    {
        ResponseResult relative = rising();
        relative.unit = "1";
        relative.magnitude /= 2.0;
        relative.u_noiseMagnitude /= 2.0;
        relative.u_magnitude /= 2.0;
        const JudgedRow worst = *judgeConformity(relative, claim(DecisionRule::Simple, 5.0)).worst;
        QVERIFY(isNear(worst.deviation, 0.04));
        QVERIFY(isNear(worst.u, std::hypot(0.003, 1.04 * kLevelNoise)));
    }

    void markedRows_areJudgedToo()
    {
        ResponseResult response = rising();
        auto marked = std::make_shared<ResponseResult>(rising());
        marked->marks.assign(4, RowMark::Resonance);
        marked->frequency_Hz = Eigen::Vector4d(400.0, 1700.0, 3000.0, 4000.0);
        marked->magnitude = Eigen::Vector4d(9.0, 3.0, 9.0, 9.0); // three lie outside the claim
        response.atMarks = marked;
        const ConformityResult judged = judgeConformity(response, claim(DecisionRule::Simple, 5.0));
        QCOMPARE(judged.verdict, DoesNotConform);
        QCOMPARE(judged.rows, Index(5));
        QCOMPARE(judged.worst->frequency_Hz, 1700.0);
    }

    void missingRows_giveNoStatement()
    {
        const DecisionSettings asked = claim(DecisionRule::Simple, 5.0);
        QCOMPARE(reasonOf(rising(), asked), std::string("judged"));
        ResponseResult rounded = rising(); // as ISO 266 writes third octaves
        rounded.frequency_Hz = Eigen::Vector4d(1000.0, 1250.0, 1600.0, 1995.3);
        QCOMPARE(reasonOf(rounded, asked), std::string("judged"));
        DecisionSettings beyond = asked;
        beyond.to_Hz = 6e3;
        QCOMPARE(reasonOf(rising(), beyond),
            std::string("no statement: the response was measured from 500 Hz to 5 kHz only"));
        DecisionSettings wider = asked;
        wider.to_Hz = 3e3;
        QVERIFY(reasonOf(rising(), wider).starts_with("no statement: between 1.995 kHz and 3 kHz"));
        ResponseResult withheld = rising();
        withheld.magnitude[2] = kUnknown;
        QCOMPARE(reasonOf(withheld, asked),
            std::string(
                "no statement: at 1.585 kHz no value with a complete uncertainty is stated"));
        ResponseResult unknown = rising();
        unknown.shots.front().uLevel_relative = kUnknown;
        QVERIFY(reasonOf(unknown, asked).starts_with("no statement: no response"));
        QVERIFY(reasonOf({}, asked).starts_with("no statement: no response"));
    }

    void certificate_statesItOnlyWhenAskedFor()
    {
        CalibrationResults results = example::calibration();
        Recipe recipe;
        const auto statements = [&] {
            std::string text;
            const CertificateData data = makeCertificate(results, recipe, {});
            for (const Message &one : data.section("statements")->paragraphs)
                text += english(one);
            return text;
        };
        QVERIFY(!makeCertificate(results, recipe, {}).section("conformity"));
        QVERIFY(statements().find("No statement of conformity is made.") != std::string::npos);
        recipe.certificate.decision = claim(DecisionRule::GuardBand, 5.0);
        testing::writable(results.response) = rising();
        const CertificateData data = makeCertificate(results, recipe, {});
        const CertificateSection *section = data.section("conformity");
        QVERIFY(section && section->fields.size() == 4);
        QCOMPARE(english(section->fields[0].value),
            std::string(
                "the magnitude of the response lies within ±5 % of its value at low frequency, from 1 kHz to 1.995 kHz"));
        QVERIFY(english(section->fields[1].value).starts_with("guard band w = U (ILAC-G8)"));
        QCOMPARE(english(section->fields[2].value), std::string("does not conform"));
        QCOMPARE(english(section->fields[3].value),
            std::string(
                "at 1.995 kHz the deviation is 4.0 % ± 1.0 % (k = 2); it lies beyond the limit with a probability of 2.6 %"));
        QVERIFY(statements().find("No statement") == std::string::npos);
    }
};

DYNCAL_TEST(TestConformity)
#include "tst_conformity.moc"
