// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// S(f) without the chain: the division of one point and of what the model says.

#include "core/base/constants.h"
#include "core/model_analysis/chain_correction.h"
#include "core/model_analysis/response_rows.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::isNear;

namespace {

class FlatSource : public ResponseSource
{
public:
    ResponsePoint at(double) const override
    {
        return {.magnitude = 2.0,
            .phase_rad = 3.0,
            .u_magnitude = 0.02,
            .u_phase_rad = 0.01,
            .dof = 20.0,
            .boundEnd = 0.003,
            .boundAlias = 0.005,
            .u_front = 0.007,
            .u_reference = 0.009};
    }
};

ReferenceSensitivity chain(bool hasPhase = true)
{
    const double phase = hasPhase ? -0.5 : kUnknown, u = hasPhase ? 0.004 : kUnknown;
    return ReferenceSensitivity::fromTable(
        {{100.0, 1.0, 0.002, hasPhase ? 0.0 : kUnknown, u, 7.0}, {1e6, 0.5, 0.01, phase, u, 7.0}})
        .value();
}

ResponsePoint divided(const ReferenceSensitivity &by, double f_Hz)
{
    return ChainCorrected(std::make_unique<FlatSource>(), by).at(f_Hz);
}

} // namespace

class TestChainCorrection : public QObject
{
    Q_OBJECT

private slots:
    void point_isDivided()
    {
        const ResponsePoint point = divided(chain(), 1e6);
        QVERIFY(isNear(point.magnitude, 4.0) && isNear(point.u_magnitude, 0.04));
        QVERIFY(isNear(point.boundEnd, 0.006) && isNear(point.boundAlias, 0.01));
        QVERIFY(isNear(point.u_front, 0.014) && isNear(point.u_reference, 0.018));
        QVERIFY(isNear(point.phase_rad, 3.5 - kTwoPi)); // in -pi .. pi
        QVERIFY(isNear(point.u_chain, 4.0 * 0.02) && isNear(point.u_chainPhase_rad, 0.004));
        QCOMPARE(point.dofChain, 7.0);
    }

    void outsideTheTable_nothingIsStated()
    {
        for (const double f_Hz : {99.0, 1.1e6}) {
            const ResponsePoint point = divided(chain(), f_Hz);
            QVERIFY(std::isnan(point.magnitude) && !point.isChainKnown);
        }
    }

    void withoutPhase_magnitudeAlone()
    {
        const ResponsePoint point = divided(chain(false), 1e6);
        QVERIFY(isNear(point.magnitude, 4.0));
        QVERIFY(std::isnan(point.phase_rad) && std::isnan(point.u_chainPhase_rad));
    }

    void rows_haveItsUAndReason()
    {
        const ReferenceSensitivity by = chain();
        ResponseResult result;
        result.frequency_Hz = Eigen::Vector2d(1e6, 2e6);
        result.modelMagnitude = result.modelPhase_rad = Eigen::Vector2d(2.0, 2.0);
        divideModel(by, result);
        measureRows(ChainCorrected(std::make_unique<FlatSource>(), by), 1e7, result);
        QVERIFY(result.isWithoutChain);
        QVERIFY(isNear(result.modelMagnitude[0], 4.0) && std::isnan(result.modelMagnitude[1]));
        QVERIFY(isNear(result.modelPhase_rad[0], 2.5));
        QVERIFY(isNear(result.u_chain_relative[0], 0.02)
            && isNear(result.u_chainLowest_relative, 0.002));
        const double bounds = std::hypot(0.006, 0.01) / std::sqrt(3.0);
        const double u = std::sqrt(
            0.04 * 0.04 + bounds * bounds + 0.014 * 0.014 + 0.018 * 0.018 + 0.08 * 0.08);
        QVERIFY(isNear(result.u_magnitude[0], u));
        const double inverse
            = (std::pow(0.04, 4) / 20.0 + std::pow(0.08, 4) / 7.0) / std::pow(u, 4);
        QVERIFY(isNear(result.dof[0], 1.0 / inverse));
        QVERIFY(result.withheld[1] == WithheldReason::ChainUnknown);
    }

    void delay_isAPartOfTheOnsetsU()
    {
        const ReferenceSensitivity by = chain();
        const double u_s = uOnsetBehind(by, 1e6, 1e6);
        QVERIFY(isNear(u_s, 0.5 / (kTwoPi * 1e6) / std::sqrt(3.0)));
        QCOMPARE(uOnsetBehind(chain(false), 100.0, 1e6), 0.0);
        QVERIFY(uOnsetBehind(by, 100.0, 1e6) >= u_s);
        const ResponsePoint point = ChainCorrected(std::make_unique<FlatSource>(), by, u_s).at(1e6);
        QVERIFY(isNear(point.u_phase_rad, std::hypot(0.01, 0.5 / std::sqrt(3.0))));
    }
};

DYNCAL_TEST(TestChainCorrection)
#include "tst_chain_correction.moc"
