// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Complete uncertainties of the rows of S(f), from parts that are written down.

#include "core/base/uncertain_complex.h"
#include "core/model_analysis/model_response.h"
#include "core/uncertainty/row_uncertainty.h"
#include "tests/support/damped_shots.h"
#include "tests/support/near.h"
#include "tests/support/realized_model.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::isNear;

namespace {

/// Three rows, the last one withheld.
ResponseResult response()
{
    ResponseResult made;
    made.unit = "V/Pa";
    made.frequency_Hz = Eigen::Vector3d(1e3, 1e5, 1e6);
    made.magnitude = Eigen::Vector3d(2.0, 2.5, kUnknown);
    made.phase_rad = Eigen::Vector3d(0.0, -0.5, kUnknown);
    made.modelMagnitude = Eigen::Vector3d(2.01, 2.5, 4.0);
    made.u_noiseMagnitude = Eigen::Vector3d(0.003, 0.01, kUnknown);
    made.u_frontMagnitude = Eigen::Vector3d(0.0, 0.0, kUnknown);
    made.boundEnd = Eigen::Vector3d(0.004 * std::sqrt(3.0), 0.0, 1.0);
    made.boundAlias = Eigen::Vector3d(0.0, 0.02 * std::sqrt(3.0), 0.0);
    made.u_magnitude = Eigen::Vector3d(0.005, std::hypot(0.01, 0.02), kUnknown);
    made.u_noisePhase_rad = Eigen::Vector3d(std::hypot(0.0015, 0.002), 0.004, kUnknown);
    made.dof = Eigen::Vector3d(20.0 * std::pow(5.0 / 3.0, 4), 20.0 * 25.0, kUnknown);
    return made;
}

const std::vector<UncertaintyLine> kCommon{directLine("t1_k", -0.012), directLine("gain", 0.005)};

CommonLines shared(const std::vector<UncertaintyLine> &lines)
{
    return {lines, lines};
}

} // namespace

class TestRowUncertainty : public QObject
{
    Q_OBJECT

private slots:
    void commonAndOwnParts_joinInQuadrature()
    {
        const ResponseResult made = response();
        const RowUncertainty rows
            = rowUncertainty(made, shared(kCommon), {}, {}, ResponseTreatment::StepDeflated);
        QVERIFY(rows.isComplete());
        QVERIFY(isNear(rows.u_common_relative, 0.013));
        const double front = made.magnitude[1] * frontLine(1e5).u;
        QVERIFY(isNear(rows.u_magnitude[0], std::hypot(0.005, 0.026), 1e-6));
        QVERIFY(isNear(rows.u_magnitude[1],
            std::sqrt(0.01 * 0.01 + 0.02 * 0.02 + front * front + std::pow(2.5 * 0.013, 2))));
        QVERIFY(isNear(rows.u_phase_rad[0], std::hypot(0.0015, 0.002, 0.002)));
        // The noise alone has few degrees of freedom: 20.
        QVERIFY(
            isNear(rows.dof_magnitude[0], 20.0 * std::pow(rows.u_magnitude[0] / 0.003, 4), 1e-6));
        QVERIFY(isNear(rows.k_magnitude[0], coverageFactor(rows.dof_magnitude[0], 0.95)));
    }

    void linesOfARow_makeItsUncertainty()
    {
        const ResponseResult made = response();
        const RowUncertainty rows
            = rowUncertainty(made, shared(kCommon), {}, {}, ResponseTreatment::StepDeflated);
        for (Index row = 0; row < 2; ++row) {
            QVERIFY(isNear(*magnitudeOfRow(made, rows, row).u, rows.u_magnitude[row]));
            QVERIFY(isNear(*phaseOfRow(made, rows, row).u, rows.u_phase_rad[row]));
        }
    }

    /// Turned back by the phase the covariance is that of magnitude and of magnitude times phase.
    void covariance_isTheEllipseOfTheOwnPart()
    {
        const ResponseResult made = response();
        const RowUncertainty rows
            = rowUncertainty(made, shared(kCommon), {}, {}, ResponseTreatment::StepDeflated);
        const Eigen::Vector3d v = rows.covarianceReIm.row(1).transpose();
        Eigen::Matrix2d covariance;
        covariance << v[0], v[1], v[1], v[2];
        Eigen::Matrix2d turn;
        turn << std::cos(-0.5), std::sin(-0.5), -std::sin(-0.5), std::cos(-0.5);
        const Eigen::Matrix2d turned = turn * covariance * turn.transpose();
        const double front = 2.5 * frontLine(1e5).u;
        QVERIFY(isNear(turned(0, 0), 0.01 * 0.01 + 0.02 * 0.02 + front * front));
        QVERIFY(isNear(turned(1, 1), std::pow(2.5 * rows.u_phase_rad[1], 2)));
        QVERIFY(std::abs(turned(0, 1)) < 1e-12);
        const UncertainComplex z{std::polar(2.5, -0.5), covariance};
        const UncertainPolar polar = toPolar(z);
        QVERIFY(isNear(polar.covariance(0, 0), turned(0, 0)));
        QVERIFY(isNear(polar.covariance(1, 1), std::pow(rows.u_phase_rad[1], 2)));
    }

    void unknownStep_leavesTheMagnitudeWithoutU()
    {
        const RowUncertainty rows
            = rowUncertainty(response(), std::nullopt, {}, {}, ResponseTreatment::StepDeflated);
        QVERIFY(!rows.isComplete());
        QVERIFY(rows.u_magnitude.array().isNaN().all());
        QVERIFY(std::isfinite(rows.u_phase_rad[0])); // no step is in a phase
    }

    void withheldRows_haveNone()
    {
        const RowUncertainty rows
            = rowUncertainty(response(), shared(kCommon), {}, {}, ResponseTreatment::StepDeflated);
        QVERIFY(std::isnan(rows.u_magnitude[2]) && std::isnan(rows.u_phase_rad[2]));
        QVERIFY(rows.covarianceReIm.row(2).array().isNaN().all());
    }

    void statedFront_takesThePlaceOfTheUnknownOne()
    {
        ResponseResult made = response();
        made.front = {200e-9, 10e-9};
        made.u_frontMagnitude[1] = 0.03;
        const auto lines = magnitudeOfRow(made, {}, 1).lines;
        QVERIFY(std::ranges::any_of(lines, [](const UncertaintyLine &line) {
            return line.quantity == "front_duration_s" && line.contribution == 0.03;
        }));
        QVERIFY(std::ranges::none_of(
            lines, [](const UncertaintyLine &line) { return line.quantity == "front_unknown"; }));
    }

    void heat_isALineThatFallsWithFrequency()
    {
        ResponseResult made = response();
        made.drift.kind = DriftKind::Heat;
        made.drift.shots = {{1, 0.5e-3, 0.02, -0.018, 0.0005, 1e-3}};
        const auto at = [&](Index row) {
            const auto lines = magnitudeOfRow(made, {}, row).lines;
            return std::ranges::find(lines, std::string("drift"), &UncertaintyLine::quantity)
                ->contribution;
        };
        const double u_share = 0.0005 / (1.0 - std::exp(-2.0));
        QVERIFY(isNear(at(0), 2.0 * u_share / std::hypot(1.0, kTwoPi * 1e3 * 0.5e-3)));
        QVERIFY(at(1) < 0.02 * at(0));
    }

    /// u of the model's response is the scatter of models of 60 records; at the resonance it is
    /// wholly that of the damping.
    void modelsResponse_scattersAsStated()
    {
        constexpr double kF0_Hz = 318e3, kZeta = 0.05;
        constexpr int kRuns = 60;
        double squares = 0.0;
        for (int seed = 1; seed <= kRuns; ++seed) {
            const ModelInput input
                = testing::dampedShots(kF0_Hz, kZeta, static_cast<std::uint64_t>(seed));
            const auto hankel = decomposeHankel(input, {});
            const SensorModel model = testing::realizeModel(input, *hankel, 2)->model;
            ResponseResult made;
            made.unit = "1";
            made.front.u_s = 1e-15; // a front that is stated to be sharp
            made.frequency_Hz = Eigen::VectorXd::Constant(1, kF0_Hz);
            made.magnitude = Eigen::VectorXd::Constant(1, kUnknown);
            made.modelMagnitude = Eigen::VectorXd::Constant(
                1, std::abs(modelResponse(model, input.treatment, kF0_Hz)) / model.level());
            const RowUncertainty rows = rowUncertainty(
                made, CommonLines{}, model, modelVariations(input, model), input.treatment);
            squares
                += std::pow((made.modelMagnitude[0] - 0.5 / kZeta) / rows.u_modelMagnitude[0], 2)
                / kRuns;
        }
        qInfo("mean square of error over u: %.2f", squares);
        QVERIFY(squares > 0.6 && squares < 1.5); // 99 % of 60: 0.59 to 1.53
    }

    /// Without noise the model's response is as uncertain as the front makes the ringing: at the
    /// resonance, which is nothing else, by w0^2 T^2/24 over sqrt(5).
    void modelsResponse_hasTheUnknownFront()
    {
        constexpr double kF0_Hz = 318e3, kZeta = 0.02;
        const ModelInput input = testing::dampedShots(kF0_Hz, kZeta, 1, {1e-6});
        const auto hankel = decomposeHankel(input, {});
        const SensorModel model = testing::realizeModel(input, *hankel, 2)->model;
        ResponseResult made;
        made.unit = "1";
        made.frequency_Hz = Eigen::Vector2d(1e3, kF0_Hz);
        made.magnitude = Eigen::Vector2d::Constant(kUnknown);
        made.modelMagnitude = Eigen::Vector2d(1.0, 0.5 / kZeta);
        const RowUncertainty rows = rowUncertainty(
            made, CommonLines{}, model, modelVariations(input, model), input.treatment);
        const double share
            = std::pow(kTwoPi * kF0_Hz * kUnstatedFront_s, 2) / 24.0 / std::sqrt(5.0);
        QVERIFY(isNear(rows.u_modelMagnitude[1], 25.0 * share, 0.05));
        QVERIFY(rows.u_modelMagnitude[0] < 1e-4 * share);
    }
};

DYNCAL_TEST(TestRowUncertainty)
#include "tst_row_uncertainty.moc"
