// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the series of a model are made of: one per shot, or the average with the noise it has.

#include "core/realization/input/series_source.h"
#include "tests/support/model_inputs.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr Index kQuiet = 500;
constexpr double kResolution = 1e-3;
constexpr double kRoundingSd = 2e-4;

WindowedResponse responseOf(Index shot, const Eigen::VectorXd &noise)
{
    WindowedResponse response;
    response.shot = shot;
    response.sampleRate_Hz = kRate_Hz;
    response.values = Eigen::VectorXd::Ones(40);
    response.lead = 8;
    response.length = 32;
    response.noise = noise;
    response.resolution = kResolution;
    response.roundingSd = kRoundingSd;
    return response;
}

/// Shots with white noise of sd 1; those whose number is in `without` have no quiet stretch.
std::vector<WindowedResponse> shots(Index count, const std::vector<Index> &without = {})
{
    std::vector<WindowedResponse> responses;
    for (Index shot = 1; shot <= count; ++shot) {
        const bool isQuiet = std::ranges::find(without, shot) == without.end();
        Noise noise(static_cast<std::uint64_t>(shot));
        responses.push_back(
            responseOf(shot, isQuiet ? noise.series(kQuiet, 1.0) : Eigen::VectorXd()));
    }
    return responses;
}

ComponentResult components()
{
    ComponentResult result;
    result.sampleRate_Hz = kRate_Hz;
    result.average = Eigen::VectorXd::Ones(32);
    return result;
}

SeriesSource averageOf(const std::vector<WindowedResponse> &responses)
{
    static const ComponentResult result = components();
    return seriesSources(responses, result, CombineMethod::PcaAverage).front();
}

double sdOf(const Eigen::VectorXd &values)
{
    return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

} // namespace

class TestSeriesSource : public QObject
{
    Q_OBJECT

private slots:
    void shots_areThemselves()
    {
        const auto responses = shots(3);
        const ComponentResult none;
        const auto sources = seriesSources(responses, none, CombineMethod::Stacked);
        QCOMPARE(sources.size(), std::size_t(3));
        for (std::size_t i = 0; i < 3; ++i) {
            QCOMPARE(sources[i].shot, Index(i) + 1);
            QCOMPARE(sources[i].lead, Index(8));
            QCOMPARE(sources[i].length, Index(32));
            QCOMPARE(sources[i].rate_Hz, kRate_Hz);
            QVERIFY(sources[i].noise == responses[i].noise);
            QVERIFY(isNear(sources[i].leastNoiseSd, kResolution / std::sqrt(12.0)));
            QCOMPARE(sources[i].roundingSd, kRoundingSd);
        }
    }

    /// Independent noise of n shots: sd/sqrt(n), point by point.
    void average_hasTheNoiseOfTheMean()
    {
        const auto responses = shots(4);
        const SeriesSource average = averageOf(responses);
        QCOMPARE(average.shot, Index(0));
        QCOMPARE(average.noise.size(), kQuiet);
        Eigen::VectorXd mean = Eigen::VectorXd::Zero(kQuiet);
        for (const WindowedResponse &response : responses)
            mean += 0.25 * response.noise;
        QVERIFY((average.noise - mean).cwiseAbs().maxCoeff() < 1e-14);
        QVERIFY(std::abs(sdOf(average.noise) / 0.5 - 1.0) < 0.1);
        QVERIFY(isNear(average.leastNoiseSd, 0.5 * kResolution / std::sqrt(12.0)));
        QVERIFY(isNear(average.roundingSd, 0.5 * kRoundingSd));
    }

    /// A shot whose noise is not known changes nothing of what the others say, wherever it stands.
    void shotWithoutQuietStretch_doesNotCount()
    {
        for (const Index unknown : {1, 2, 3}) {
            const auto responses = shots(3, {unknown});
            auto known = responses;
            known.erase(known.begin() + unknown - 1);
            const SeriesSource average = averageOf(responses);
            QVERIFY(average.noise == averageOf(known).noise);
            QVERIFY(std::abs(sdOf(average.noise) * std::sqrt(2.0) - 1.0) < 0.1);
            QVERIFY(isNear(average.leastNoiseSd, kResolution / std::sqrt(12.0) / std::sqrt(2.0)));
            QVERIFY(isNear(average.roundingSd, kRoundingSd / std::sqrt(2.0)));
        }
    }

    void noQuietStretchAtAll_leavesTheNoiseUnknown()
    {
        const SeriesSource average = averageOf(shots(2, {1, 2}));
        QCOMPARE(average.noise.size(), Index(0));
        QCOMPARE(average.leastNoiseSd, 0.0);
        QCOMPARE(average.roundingSd, 0.0);
    }

    /// Of another rate than the average's: not averaged point by point.
    void otherRates_areLeftOutOfTheNoise()
    {
        auto responses = shots(3);
        responses[1].sampleRate_Hz = 2.0 * kRate_Hz;
        auto same = responses;
        same.erase(same.begin() + 1);
        QVERIFY(averageOf(responses).noise == averageOf(same).noise);
    }
};

DYNCAL_TEST(TestSeriesSource)
#include "tst_series_source.moc"
