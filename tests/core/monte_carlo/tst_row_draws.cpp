// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Rows of S(f) from parts that are written down.

#include "core/monte_carlo/row_draws.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr Index kTrials = 20000;

/// A large value, one that its noise hides, and one that is withheld.
ResponseResult response()
{
    ResponseResult made;
    made.unit = "V/Pa";
    made.frequency_Hz = Eigen::Vector3d(1e3, 1e4, 1e6);
    made.magnitude = Eigen::Vector3d(2.0, 0.02, kUnknown);
    made.phase_rad = Eigen::Vector3d(-1.0, -7.0, kUnknown);
    made.u_noiseMagnitude = Eigen::Vector3d(0.004, 0.01, kUnknown);
    made.u_magnitude = made.u_noiseMagnitude;
    made.u_frontMagnitude = Eigen::Vector3d::Zero();
    made.u_noisePhase_rad = Eigen::Vector3d(std::hypot(0.002, 0.003), 0.5, kUnknown);
    made.boundEnd = Eigen::Vector3d(0.002, 0.0, 1.0);
    made.boundAlias = Eigen::Vector3d::Zero();
    made.dof = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    made.front = {0.0, 1e-15}; // stated to be sharp
    return made;
}

struct Made
{
    ModelInput input;
    SensorModel model;
    ModelAssessment assessment;
    ResponseResult response;
    ShockConditionsSet shock;
    UncertaintyReport report;
    std::vector<StatedUncertainty> stated;

    ChainSubject subject() const
    {
        return {input, model, assessment, response, shock, report, stated};
    }
};

/// What all rows share is normal with u = 1 %.
std::vector<DrawnRow> drawn(const Made &made, double u_common = 0.01, bool isKnown = true)
{
    TrialPlan plan{made.subject(), {}, {}, 1};
    TrialBlock trials{0, Eigen::MatrixXd(kTrials, 0), Eigen::VectorXd(kTrials),
        Eigen::VectorXd::Zero(kTrials), Eigen::VectorXd(kTrials)};
    for (Index i = 0; i < kTrials; ++i) {
        RandomStream stream(99, i, 1);
        trials.common[i] = 1.0 + u_common * stream.nextNormal();
        trials.drift[i] = stream.nextNormal();
    }
    const std::vector<UncertaintyLine> lines{directLine("t1_k", u_common)};
    const RowUncertainty rows = rowUncertainty(made.response,
        isKnown ? std::optional(CommonLines{lines, lines}) : std::nullopt, {}, {},
        ResponseTreatment::StepDeflated);
    return *drawnRows(plan, trials, made.response, rows, {0.95, 1});
}

std::vector<DrawnRow> drawn(
    const ResponseResult &response, double u_common = 0.01, bool isKnown = true)
{
    Made made;
    made.response = response;
    return drawn(made, u_common, isKnown);
}

} // namespace

class TestRowDraws : public QObject
{
    Q_OBJECT

private slots:
    /// Nearly linear: the two propagations agree.
    void largeValue_isValidated()
    {
        const DrawnRow row = drawn(response())[0];
        QVERIFY(row.withMagnitude && row.withPhase);
        QVERIFY(isNear(row.magnitude.u, std::hypot(0.004, 0.002 / std::sqrt(3.0), 0.02), 0.02));
        QVERIFY(isNear(row.magnitude.u, row.gumMagnitude.u, 0.02));
        QVERIFY(isNear(row.phase.u, row.gumPhase.u, 0.02));
        QVERIFY(isNear(row.magnitude.mean, 2.0, 1e-3));
        QVERIFY(std::abs(row.phase.mean + 1.0) < 1e-4);
        QVERIFY(row.gumMagnitude.validated && row.gumPhase.validated);
        QVERIFY(!row.isBivariate);
    }

    /// The ellipse: along the value what rows share too, across it the phase.
    void covariance_isThatOfTheComplexValue()
    {
        const DrawnRow row = drawn(response())[0];
        const double c = std::cos(-1.0), s = std::sin(-1.0);
        const double along = row.varRe * c * c + 2.0 * row.covReIm * c * s + row.varIm * s * s;
        const double across = row.varRe * s * s - 2.0 * row.covReIm * c * s + row.varIm * c * c;
        QVERIFY(isNear(std::sqrt(along), row.gumMagnitude.u, 0.02));
        QVERIFY(isNear(std::sqrt(across), 2.0 * row.gumPhase.u, 0.02));
    }

    /// |S| of twice its u (JCGM 102): its mean is too large, its distribution that of Rice, and the
    /// covariance of the complex value remains that of the noise.
    void valueInItsNoise_isBivariateAndNotValidated()
    {
        const DrawnRow row = drawn(response(), 1e-6)[1];
        QVERIFY(row.isBivariate);
        QVERIFY(!row.gumMagnitude.validated);
        QVERIFY(row.magnitude.mean > 0.02 * 1.1);
        QVERIFY(isNear(row.magnitude.mean * row.magnitude.mean + row.magnitude.u * row.magnitude.u,
            0.02 * 0.02 + 2.0 * 0.01 * 0.01, 0.02)); // second moment of Rice
        QVERIFY(isNear(row.varRe, 1e-4, 0.04) && isNear(row.varIm, 1e-4, 0.04));
        QVERIFY(row.phase.high < -7.0 + 3.2 && row.phase.low > -7.0 - 3.2); // unwrapped as the row
    }

    void withheldRow_hasNothing()
    {
        const DrawnRow row = drawn(response())[2];
        QVERIFY(!row.withMagnitude && !row.withPhase);
        QVERIFY(std::isnan(row.magnitude.u) && std::isnan(row.phase.u) && std::isnan(row.varRe));
        QCOMPARE(row.frequency_Hz, 1e6);
    }

    void unknownStep_leavesThePhase()
    {
        const DrawnRow row = drawn(response(), 0.01, false)[0];
        QVERIFY(!row.withMagnitude && row.withPhase);
        QVERIFY(std::isnan(row.magnitude.u) && std::isfinite(row.phase.u));
    }

    /// Few degrees of freedom: Student's factor.
    void noise_isStudents()
    {
        ResponseResult made = response();
        made.dof.setConstant(3.0);
        made.boundEnd.setZero();
        made.u_noisePhase_rad = Eigen::Vector3d(0.002, 0.5, kUnknown);
        const DrawnRow row = drawn(made, 1e-6)[0];
        QVERIFY(isNear(row.magnitude.expanded, 3.182 * 0.004, 0.03));
        QVERIFY(row.gumMagnitude.validated);
    }

    /// A front of up to 100 ns takes sinc(f T) off what was measured: the value lies above it.
    void unknownFront_isOneSided()
    {
        ResponseResult made = response();
        made.front = {};
        made.frequency_Hz[0] = 3e6;
        Made all;
        all.response = made;
        TrialPlan plan{all.subject(), {}, {}, 1};
        TrialBlock trials{0, Eigen::MatrixXd(kTrials, 0), Eigen::VectorXd::Ones(kTrials),
            Eigen::VectorXd(kTrials), Eigen::VectorXd::Zero(kTrials)};
        for (Index i = 0; i < kTrials; ++i)
            trials.front_s[i] = 100e-9 * (static_cast<double>(i) + 0.5) / kTrials;
        RowUncertainty rows
            = rowUncertainty(made, CommonLines{}, {}, {}, ResponseTreatment::StepDeflated);
        const DrawnRow row = (*drawnRows(plan, trials, made, rows, {0.95, 1}))[0];
        const auto over = [](double T_s) {
            const double x = std::numbers::pi * 3e6 * T_s;
            return 2.0 * x / std::sin(x);
        };
        QVERIFY(isNear(row.magnitude.low, over(2.5e-9), 0.005));
        QVERIFY(isNear(row.magnitude.high, over(97.5e-9), 0.01));
    }

    void reference_andChain_areTheirOwn()
    {
        ResponseResult made = response();
        made.isByTransducer = made.isWithoutChain = true;
        made.u_noiseMagnitude.setConstant(1e-9);
        made.u_noisePhase_rad.setConstant(1e-9);
        made.boundEnd.setZero();
        made.u_referenceMagnitude = Eigen::Vector3d(0.02, 0.0, 0.0);
        made.u_referencePhase_rad = Eigen::Vector3d(0.01, 0.0, 0.0);
        made.dofReference = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
        made.u_chain_relative = Eigen::Vector3d(0.005, 0.0, 0.0);
        made.u_chainPhase_rad = Eigen::Vector3d(0.002, 0.0, 0.0);
        made.dofChain = made.dofReference;
        const DrawnRow row = drawn(made, 1e-9)[0];
        QVERIFY(isNear(row.magnitude.u, 2.0 * std::hypot(0.01, 0.005), 0.02));
        QVERIFY(isNear(row.phase.u, std::hypot(0.01, 0.002), 0.02));
    }

    void heat_isDividedOut()
    {
        ResponseResult made = response();
        made.u_noiseMagnitude.setConstant(1e-9);
        made.u_noisePhase_rad.setConstant(1e-9);
        made.boundEnd.setZero();
        made.drift.kind = DriftKind::Heat;
        made.drift.shots = {{1, 0.5e-3, 0.02, -0.018, 0.0005, 1e-3}};
        const DrawnRow row = drawn(made, 1e-9)[0];
        const double h = 0.0005 / (1.0 - std::exp(-2.0));
        const double x = kTwoPi * 1e3 * 0.5e-3;
        QVERIFY(isNear(row.magnitude.u, 2.0 * h / (1.0 + x * x), 0.03));
        QVERIFY(isNear(row.phase.u, h * x / (1.0 + x * x), 0.03));
    }

    void stopped_isCancelled()
    {
        std::stop_source stop;
        stop.request_stop();
        Made made;
        made.response = response();
        const TrialPlan plan{made.subject(), {}, {}, 1};
        const TrialBlock trials{0, Eigen::MatrixXd(10, 0), Eigen::VectorXd::Ones(10),
            Eigen::VectorXd::Zero(10), Eigen::VectorXd::Zero(10)};
        const auto rows = drawnRows(
            plan, trials, made.response, made.report.rows, {0.95, 1}, {stop.get_token(), {}});
        QVERIFY(!rows);
        QCOMPARE(rows.error().kind, ErrorKind::Cancelled);
    }
};

DYNCAL_TEST(TestRowDraws)
#include "tst_row_draws.moc"
