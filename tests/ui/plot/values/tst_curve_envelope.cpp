// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/plot/values/curve_envelope.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using dyncal::CurveEnvelope;
using dyncal::DrawnPoints;
using dyncal::Index;
using dyncal::SampleExtremes;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Series
{
    std::vector<double> x;
    std::vector<double> y;
};

/// Unevenly spaced noise with gaps of NaN.
Series noise(Index count, std::mt19937 &random, double gapShare)
{
    std::uniform_real_distribution<double> step(0.1, 2.0);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    Series series;
    double x = -5.0;
    for (Index i = 0; i < count; ++i) {
        x += step(random);
        series.x.push_back(x);
        series.y.push_back(uniform(random) < gapShare ? kNan : normal(random));
    }
    return series;
}

SampleExtremes bruteForce(const Series &series, Index begin, Index end)
{
    SampleExtremes found;
    for (Index i = begin; i < end; ++i) {
        const double y = series.y[static_cast<std::size_t>(i)];
        if (std::isnan(y))
            continue;
        found.min = found.any ? std::min(found.min, y) : y;
        found.max = found.any ? std::max(found.max, y) : y;
        found.any = true;
    }
    return found;
}

std::vector<double> evenEdges(double from, double to, Index columns)
{
    std::vector<double> edges;
    for (Index k = 0; k <= columns; ++k)
        edges.push_back(from + (to - from) * static_cast<double>(k) / static_cast<double>(columns));
    return edges;
}

} // namespace

class TestCurveEnvelope : public QObject
{
    Q_OBJECT

private slots:
    void extremes_thousandRandomWindows_equalBruteForce();
    void points_thousandRandomViews_columnsEqualBruteForce();
    void points_fewSamples_areTheSamplesAndNeighbours();
    void points_allNanColumn_isGap();
    void points_degenerateInput_isEmpty();
    void extremes_emptyAndSmall_work();
};

void TestCurveEnvelope::extremes_thousandRandomWindows_equalBruteForce()
{
    std::mt19937 random(11);
    const Index count = 54321;
    const Series series = noise(count, random, 0.3);
    const CurveEnvelope envelope(series.x, series.y);
    std::uniform_int_distribution<Index> place(0, count);
    for (int k = 0; k < 1000; ++k) {
        auto [begin, end] = std::minmax({place(random), place(random)});
        if (k % 3 == 0) // short ones too: they never touch a block
            end = std::min(count, begin + k % 90);
        const auto expected = bruteForce(series, begin, end);
        const auto found = envelope.extremes(begin, end);
        QCOMPARE(found.any, expected.any);
        if (found.any) {
            QCOMPARE(found.min, expected.min);
            QCOMPARE(found.max, expected.max);
        }
    }
}

void TestCurveEnvelope::points_thousandRandomViews_columnsEqualBruteForce()
{
    std::mt19937 random(12);
    const Index count = 30000;
    const Series series = noise(count, random, 0.05);
    const CurveEnvelope envelope(series.x, series.y);
    std::uniform_real_distribution<double> place(series.x.front() - 50.0, series.x.back() + 50.0);
    std::uniform_int_distribution<Index> columnCount(1, 400);
    int enveloped = 0;
    for (int k = 0; k < 1000; ++k) {
        const auto [from, to] = std::minmax({place(random), place(random)});
        const std::vector<double> edges = evenEdges(from, to, columnCount(random));
        const DrawnPoints drawn = envelope.points(edges);
        if (!drawn.enveloped)
            continue;
        ++enveloped;
        std::size_t at = 0;
        for (std::size_t c = 0; c + 1 < edges.size(); ++c) {
            const bool last = c + 2 == edges.size();
            const Index begin
                = std::lower_bound(series.x.begin(), series.x.end(), edges[c]) - series.x.begin();
            const Index end
                = (last ? std::upper_bound(series.x.begin(), series.x.end(), to)
                        : std::lower_bound(series.x.begin(), series.x.end(), edges[c + 1]))
                - series.x.begin();
            if (begin == end)
                continue;
            const auto expected = bruteForce(series, begin, end);
            QVERIFY(at + 1 < drawn.y.size());
            const auto [low, high] = std::minmax({drawn.y[at], drawn.y[at + 1]});
            if (expected.any) {
                QCOMPARE(low, expected.min);
                QCOMPARE(high, expected.max);
            } else {
                QVERIFY(std::isnan(drawn.y[at]));
            }
            QVERIFY(drawn.x[at] >= edges[c] && drawn.x[at] <= edges[c + 1]);
            at += 2;
        }
        QCOMPARE(at, drawn.y.size());
    }
    QVERIFY(enveloped > 500);
}

void TestCurveEnvelope::points_fewSamples_areTheSamplesAndNeighbours()
{
    const Series series{{0, 1, 2, 3, 4, 5, 6}, {0, 10, 20, 30, 40, 50, 60}};
    const CurveEnvelope envelope(series.x, series.y);
    const DrawnPoints drawn = envelope.points(evenEdges(2.5, 4.0, 100));
    QVERIFY(!drawn.enveloped);
    QCOMPARE(drawn.x, (std::vector<double>{2, 3, 4, 5}));
    QCOMPARE(drawn.y, (std::vector<double>{20, 30, 40, 50}));
}

void TestCurveEnvelope::points_allNanColumn_isGap()
{
    Series series;
    for (int i = 0; i < 1000; ++i) {
        series.x.push_back(i);
        series.y.push_back(i >= 500 && i < 600 ? kNan : 1.0);
    }
    const CurveEnvelope envelope(series.x, series.y);
    const DrawnPoints drawn = envelope.points(evenEdges(0.0, 1000.0, 10));
    QVERIFY(drawn.enveloped);
    QCOMPARE(drawn.y.size(), std::size_t(20));
    for (std::size_t i = 0; i < 20; ++i)
        QCOMPARE(std::isnan(drawn.y[i]), i == 10 || i == 11);
}

void TestCurveEnvelope::points_degenerateInput_isEmpty()
{
    const Series series{{0, 1}, {0, 1}};
    const CurveEnvelope envelope(series.x, series.y);
    QVERIFY(envelope.points({}).x.empty());
    const std::vector<double> one{0.5};
    QVERIFY(envelope.points(one).x.empty());
    const CurveEnvelope empty(std::span<const double>{}, std::span<const double>{});
    QVERIFY(empty.points(evenEdges(0.0, 1.0, 4)).x.empty());
}

void TestCurveEnvelope::extremes_emptyAndSmall_work()
{
    const Series series{{0, 1, 2}, {3, kNan, -1}};
    const CurveEnvelope envelope(series.x, series.y);
    QVERIFY(!envelope.extremes(1, 1).any);
    QVERIFY(!envelope.extremes(1, 2).any);
    QCOMPARE(envelope.extremes(0, 3).min, -1.0);
    QCOMPARE(envelope.extremes(0, 3).max, 3.0);
}

DYNCAL_TEST(TestCurveEnvelope)
#include "tst_curve_envelope.moc"
