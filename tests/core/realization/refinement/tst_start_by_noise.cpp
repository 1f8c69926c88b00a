// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Records begin where noise helped a sample over a threshold. That sample is not like the others,
// and of many shots all of them lie on the same side.

#include "core/realization/exponentials/pole_mapping.h"
#include "core/realization/refinement/draft_fit.h"
#include "tests/support/damped_shots.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace dyncal;

namespace {

constexpr double kF0_Hz = 200e3, kZeta = 0.4, kRate_Hz = 10e6;

/// Re s and Im s of the pair, refined from the truth on.
Refinement refined(const ModelInput &input)
{
    const double w0 = 2.0 * std::numbers::pi * kF0_Hz;
    const std::complex<double> s(-kZeta * w0, w0 * std::sqrt(1.0 - kZeta * kZeta));
    ModelDraft draft = linearDraft(input, discretePoles({s, std::conj(s)}, 1.0 / kRate_Hz));
    refineDraft(input, draft, {});
    return draft.refinement.value();
}

} // namespace

class TestStartByNoise : public QObject
{
    Q_OBJECT

private slots:
    void theSampleOfTheStart_hasNoSay()
    {
        ModelInput input = testing::shotsFromTheirCrossings({kF0_Hz, kZeta}, 4);
        const Refinement before = refined(input);
        for (ModelSeries &series : input.series)
            series.fullRate[0] += 0.02;
        const Refinement after = refined(input);
        QCOMPARE(after.poles_rad_s.front(), before.poles_rad_s.front());
        QCOMPARE(after.covariance(0, 0), before.covariance(0, 0));
    }

    /// Many shots make u small, and what leans the same way in all of them large beside it. The
    /// mean of n errors over u has a standard deviation of 1/sqrt(n).
    void manyShots_leaveNoBias()
    {
        const int runs = trials::count(400, 2000);
        double mean = 0.0, square = 0.0;
        for (int seed = 1; seed <= runs; ++seed) {
            const Refinement fit = refined(testing::shotsFromTheirCrossings(
                {.f0_Hz = kF0_Hz, .zeta = kZeta, .shots = 24}, static_cast<std::uint64_t>(seed)));
            const double w0 = 2.0 * std::numbers::pi * kF0_Hz;
            const double z
                = (fit.poles_rad_s.front().real() + kZeta * w0) / std::sqrt(fit.covariance(0, 0));
            mean += z / runs;
            square += z * z / runs;
        }
        qInfo(
            "of %d: decay rate %.2f u off in the mean, rms %.2f u", runs, mean, std::sqrt(square));
        QVERIFY(std::abs(mean) < 3.0 / std::sqrt(runs));
        QVERIFY(std::abs(std::sqrt(square) - 1.0) < 0.1);
    }
};

DYNCAL_TEST(TestStartByNoise)
#include "tst_start_by_noise.moc"
