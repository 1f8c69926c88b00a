// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Several shots as one series: what a weighted mean must be, and when there may be none.

#include "core/realization/input/shot_combination.h"
#include "tests/support/model_inputs.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr Index kSamples = 400, kQuiet = 4000;

struct MadeShot
{
    double height = 1.0;
    double sd = 0.01;
    double f0_Hz = 30e3;
};

ModelInput shotsOf(const std::vector<MadeShot> &shots, std::uint64_t seed = 1)
{
    testing::Noise noise(seed);
    std::vector<ModelSeries> series;
    for (const MadeShot &shot : shots) {
        const Eigen::VectorXd y
            = shot.height * testing::sampledStep(shot.f0_Hz, 0.05, kRate_Hz, kSamples, 0.5)
            + noise.series(kSamples, shot.sd);
        series.push_back(testing::makeSeries(
            std::ssize(series) + 1, y, kRate_Hz, noise.series(kQuiet, shot.sd)));
    }
    return testing::makeInput(ResponseTreatment::StepDeflated, kRate_Hz, std::move(series));
}

Eigen::VectorXd truth()
{
    return testing::sampledStep(30e3, 0.05, kRate_Hz, kSamples, 0.5);
}

/// Standard deviation about what is true, at the height of the clearest shot.
double errorOf(const Eigen::VectorXd &y, double height)
{
    return std::sqrt((y - height * truth()).squaredNorm() / static_cast<double>(kSamples));
}

} // namespace

class TestShotCombination : public QObject
{
    Q_OBJECT

private slots:
    /// n alike shots have 1/sqrt(n) of the noise, in the response and in the record before it.
    void alikeShots_haveTheNoiseOfAMean()
    {
        const auto mean = combineShots(shotsOf({{}, {}, {}, {}}));
        QVERIFY(mean.has_value());
        QVERIFY(isNear(mean->noiseSd, 0.005, 0.05));
        QVERIFY(isNear(errorOf(mean->y, 1.0), 0.005, 0.12));
        QCOMPARE(mean->noise.size(), kQuiet);
    }

    /// The best that can be made of shots with heights h_i and noise s_i has, at height 1, the
    /// variance 1/sum (h_i/s_i)^2.
    void unlikeShots_areWeightedByWhatTheySay()
    {
        const auto mean
            = combineShots(shotsOf({{2.0, 0.01}, {0.5, 0.01}, {1.0, 0.04}, {4.0, 0.1}}));
        QVERIFY(mean.has_value());
        const double best
            = 1.0 / std::sqrt(200.0 * 200.0 + 50.0 * 50.0 + 25.0 * 25.0 + 40.0 * 40.0);
        QVERIFY(isNear(errorOf(mean->y, 2.0), 2.0 * best, 0.12)); // at the clearest one's height
        QVERIFY(isNear(mean->noiseSd, 2.0 * best, 0.05));
    }

    /// The order of the shots says nothing.
    void order_changesNothing()
    {
        const std::vector<MadeShot> made{{2.0, 0.01}, {0.5, 0.01}, {1.0, 0.02}};
        ModelInput input = shotsOf(made);
        const auto mean = combineShots(input);
        std::swap(input.series[0], input.series[2]);
        const auto turned = combineShots(input);
        QVERIFY(mean && turned);
        QVERIFY((mean->y - turned->y).norm() < 1e-12 * mean->y.norm());
        QVERIFY(isNear(turned->noiseSd, mean->noiseSd, 1e-12));
    }

    /// Volts or millivolts: one unit for all shots.
    void unit_changesNothingButTheSize()
    {
        ModelInput input = shotsOf({{2.0, 0.01}, {0.5, 0.01}});
        const auto mean = combineShots(input);
        for (ModelSeries &series : input.series) {
            series.y *= -1e3;
            series.noise *= -1e3;
            series.noiseSd *= 1e3;
        }
        const auto scaled = combineShots(input);
        QVERIFY(mean && scaled);
        QVERIFY((scaled->y + 1e3 * mean->y).norm() < 1e-9 * scaled->y.norm());
        QVERIFY(isNear(scaled->noiseSd, 1e3 * mean->noiseSd, 1e-9));
    }

    /// A shot downwards is the same response with a height below 0.
    void turnedShot_isTurnedBack()
    {
        const auto mean = combineShots(shotsOf({{2.0, 0.01}, {-1.0, 0.01}}));
        QVERIFY(mean.has_value());
        QVERIFY(isNear(errorOf(mean->y, 2.0), 2.0 / std::hypot(200.0, 100.0), 0.12));
    }

    /// 2 % of the frequency is seen in noise of 1 %, and no mean is made.
    void anotherFrequency_isNotHidden()
    {
        QVERIFY(combineShots(shotsOf({{}, {1.0, 0.01, 30e3}, {}})).has_value());
        QVERIFY(!combineShots(shotsOf({{}, {1.0, 0.01, 30.6e3}, {}})).has_value());
        QVERIFY(combineShots(shotsOf({{1.0, 0.3}, {1.0, 0.3, 30.6e3}})).has_value()); // unseen
    }

    /// Shots that share their shape are refused in about 1 of 100 draws of the noise.
    void alikeShots_areSeldomRefused()
    {
        int refused = 0;
        for (std::uint64_t seed = 1; seed <= 200; ++seed)
            refused += combineShots(shotsOf({{}, {2.0}, {0.7, 0.02}}, seed)) ? 0 : 1;
        QVERIFY2(refused <= 8, std::to_string(refused).c_str()); // 2 expected; 9: 2e-4
    }

    /// One shot, no noise, unlike lengths, nothing recorded: no mean, and no crash.
    void nothingToCombine_isEmpty()
    {
        QVERIFY(!combineShots({}));
        QVERIFY(!combineShots(shotsOf({{}})));
        QVERIFY(!combineShots(shotsOf({{1.0, 0.0}, {1.0, 0.0}})));
        ModelInput uneven = shotsOf({{}, {}});
        uneven.series[1].y.conservativeResize(kSamples - 1);
        QVERIFY(!combineShots(uneven));
        ModelInput brief = shotsOf({{}, {}});
        brief.series[0].noise.conservativeResize(49);
        QVERIFY(!combineShots(brief));
        ModelInput broken = shotsOf({{}, {}});
        broken.series[1].y[7] = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!combineShots(broken));
        ModelInput flat = shotsOf({{}, {}});
        flat.series[1].y.setZero();
        QVERIFY(!combineShots(flat));
    }

    /// Records of unlike length before the start: the noise of the mean is as long as the shortest.
    void noise_isAsLongAsTheShortest()
    {
        ModelInput input = shotsOf({{}, {}});
        input.series[1].noise.conservativeResize(1234);
        const auto mean = combineShots(input);
        QVERIFY(mean.has_value());
        QCOMPARE(mean->noise.size(), Index(1234));
    }
};

DYNCAL_TEST(TestShotCombination)
#include "tst_shot_combination.moc"
