// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The search for modes in the settled part of a record: blocks of known sums, modes that were put
// there, and records without any.

#include "core/realization/nuisance/nuisance_tail.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

using Complex = std::complex<double>;

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Complex poleFrom(double frequency_Hz, double zeta)
{
    return kTwoPi * frequency_Hz * Complex(-zeta, std::sqrt(1.0 - zeta * zeta));
}

ModelSeries seriesOf(const Eigen::VectorXd &values, double rate_Hz)
{
    return testing::makeSeries(1, values, rate_Hz);
}

Eigen::VectorXd sumOf(
    const std::vector<NuisanceTerm> &terms, double constant, double rate_Hz, Index count)
{
    Eigen::VectorXd y = Eigen::VectorXd::Constant(count, constant);
    for (const NuisanceTerm &term : terms) {
        for (Index k = 0; k < count; ++k)
            y[k] += term.value(static_cast<double>(k) / rate_Hz);
    }
    return y;
}

/// What the mean of a block leaves of e^(s t) at the block's middle: the geometric sum.
Complex gainOfBlock(Complex pole_rad_s, double rate_Hz, int block)
{
    const Complex q = std::exp(pole_rad_s / rate_Hz);
    const Complex sum = block == 1 ? 1.0 : (1.0 - std::pow(q, block)) / (1.0 - q);
    return sum / static_cast<double>(block) * std::exp(-0.5 * (block - 1) * pole_rad_s / rate_Hz);
}

bool findsIn(const ModelSeries &series, double frequency_Hz, std::vector<NuisanceTerm> &terms)
{
    const double half_s = 0.5 * static_cast<double>(series.fullRate.size()) / series.fullRate_Hz;
    return addBestTerm(
        tailOf(series, half_s, frequency_Hz), {terms.size(), frequency_Hz}, true, terms);
}

} // namespace

class TestNuisanceTail : public QObject
{
    Q_OBJECT

private slots:
    void blocksOfARamp_areTheRampAtTheirTimes_data()
    {
        QTest::addColumn<double>("begin_s");
        QTest::addColumn<double>("fastest_Hz");
        QTest::newRow("long blocks") << 0.0 << 1e2;
        QTest::newRow("blocks of a few") << 1.003e-3 << 7.3e3;
        QTest::newRow("samples") << 1e-3 << 4e4;
        QTest::newRow("faster than the samples") << 1e-3 << 9e5;
        QTest::newRow("one block is left") << 1.5e-3 << 1e2;
    }
    void blocksOfARamp_areTheRampAtTheirTimes()
    {
        // A mean of a straight line is its value in the middle: a time that is half a sample off,
        // or a mode's phase with it, shows at once.
        QFETCH(double, begin_s);
        QFETCH(double, fastest_Hz);
        constexpr double kRate_Hz = 1e6;
        constexpr double kSlope_per_s = 700.0;
        const Eigen::VectorXd ramp = Eigen::VectorXd::NullaryExpr(
            2001, [&](Index k) { return 3.0 - kSlope_per_s * static_cast<double>(k) / kRate_Hz; });
        const NuisanceTail tail = tailOf(seriesOf(ramp, kRate_Hz), begin_s, fastest_Hz);
        QVERIFY(tail.y.size() > 0);
        for (Index k = 0; k < tail.y.size(); ++k) {
            const double t_s = tail.begin_s + static_cast<double>(k) * tail.step_s;
            QVERIFY(std::abs(tail.y[k] - (3.0 - kSlope_per_s * t_s)) < 1e-12);
        }
        QVERIFY(tail.step_s <= std::max(1.0 / (24.0 * fastest_Hz), 1.0 / kRate_Hz) * 1.000001);
        // Only less than a block is dropped at the end.
        const double end_s = tail.begin_s + static_cast<double>(tail.y.size()) * tail.step_s;
        QVERIFY(end_s <= 2001.0 / kRate_Hz + 0.5 * tail.step_s);
        QVERIFY(end_s > 2001.0 / kRate_Hz - tail.step_s);
        QCOMPARE(tail.count(), tail.y.size());
        QCOMPARE(tail.used, (std::vector<SampleRange>{{0, tail.y.size()}}));
    }

    void leftOutSamples_areInNoUsedBlock()
    {
        // What is left out is poisoned, so that whoever looks at it is found out.
        std::mt19937_64 random(3);
        for (int trial = 0; trial < 200; ++trial) {
            ModelSeries series = seriesOf(Eigen::VectorXd::Ones(1000), 1e6);
            Index at = 0;
            for (int part = 0; part < 3; ++part) {
                const auto begin = at + static_cast<Index>(random() % 250);
                at = begin + 1 + static_cast<Index>(random() % 80);
                series.leftOut.push_back({{begin, at}, Eigen::VectorXd::Zero(at - begin)});
                series.fullRate.segment(begin, at - begin).setConstant(kNan);
            }
            const NuisanceTail tail
                = tailOf(series, 1e-6 * static_cast<double>(random() % 500), 3e3);
            Index behind = -1;
            for (const SampleRange &range : tail.used) {
                QVERIFY(range.begin > behind && range.size() > 0);
                QVERIFY(tail.y.segment(range.begin, range.size()).allFinite());
                behind = range.end;
            }
            QCOMPARE(tail.count(), (tail.y.array() == 1.0).count()); // and no good one is lost
        }
    }

    void everythingLeftOut_holdsNoMode()
    {
        const NuisanceTerm term{0, true, poleFrom(6.8e3, 0.01), 0.05};
        ModelSeries series = seriesOf(sumOf({term}, 1.0, 1e6, 1600), 1e6);
        series.leftOut = {{{700, 1600}, Eigen::VectorXd::Zero(900)}};
        std::vector<NuisanceTerm> terms;
        QVERIFY(!findsIn(series, 6.8e3, terms));
        QVERIFY(terms.empty());
    }

    void modePutThere_isFoundAndPolishedExactly_data()
    {
        QTest::addColumn<double>("zeta");
        QTest::addColumn<double>("off"); ///< of the expected frequency
        QTest::newRow("undamped") << 1e-6 << 0.0;
        QTest::newRow("little damped, expected too low") << 0.004 << -0.04;
        QTest::newRow("expected too high") << 0.02 << 0.05;
        QTest::newRow("damped") << 0.1 << 0.02;
    }
    void modePutThere_isFoundAndPolishedExactly()
    {
        QFETCH(double, zeta);
        QFETCH(double, off);
        constexpr double kRate_Hz = 1e6;
        const double f_Hz = 6.8e3;
        const NuisanceTerm truth{0, true, poleFrom(f_Hz, zeta), std::polar(0.03, -2.1)};
        const ModelSeries series = seriesOf(sumOf({truth}, 1.0, kRate_Hz, 1600), kRate_Hz);
        const NuisanceTail tail = tailOf(series, 0.8e-3, f_Hz);
        std::vector<NuisanceTerm> terms;
        QVERIFY(addBestTerm(tail, {4, f_Hz * (1.0 + off)}, false, terms));
        QCOMPARE(terms.size(), std::size_t(1));
        QCOMPARE(terms[0].mode, std::size_t(4));
        QVERIFY(!terms[0].startsWithStep);
        polish(tail, true, terms);
        QVERIFY2(std::abs(terms[0].pole_rad_s / truth.pole_rad_s - 1.0) < 1e-7,
            qPrintable(QString::number(terms[0].frequency_Hz(), 'g', 12)));
        const Complex seen = truth.amplitude
            * gainOfBlock(truth.pole_rad_s, kRate_Hz, static_cast<int>(tail.step_s * 1e6 + 0.5));
        QVERIFY2(std::abs(terms[0].amplitude / seen - 1.0) < 1e-5,
            qPrintable(QString::number(std::abs(terms[0].amplitude / seen - 1.0))));
    }

    void twoModes_areTakenOneAfterTheOther()
    {
        const std::vector<NuisanceTerm> truth{{0, true, poleFrom(5e3, 0.01), {0.02, 0.0}},
            {1, true, poleFrom(8.9e3, 0.02), {0.0, 0.05}}};
        const ModelSeries series = seriesOf(sumOf(truth, 0.7, 1e6, 3000), 1e6);
        const NuisanceTail tail = tailOf(series, 1e-3, 8.9e3);
        std::vector<NuisanceTerm> terms;
        QVERIFY(addBestTerm(tail, {0, 5.05e3}, true, terms));
        QVERIFY(addBestTerm(tail, {1, 8.8e3}, true, terms));
        polish(tail, true, terms);
        for (std::size_t i = 0; i < 2; ++i) {
            QCOMPARE(terms[i].mode, i);
            QVERIFY(std::abs(terms[i].frequency_Hz() / truth[i].frequency_Hz() - 1.0) < 1e-7);
            QVERIFY(std::abs(terms[i].dampingRatio() - truth[i].dampingRatio()) < 1e-7);
        }
    }

    void noise_isNoMode()
    {
        // Whatever its size: the limit is relative to what is left.
        int found = 0;
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            testing::Noise noise(seed);
            std::vector<NuisanceTerm> terms;
            const double sd = std::pow(10.0, static_cast<double>(seed % 5) * 6.0 - 12.0);
            found += findsIn(seriesOf(noise.series(1600, sd), 1e6), 6.8e3, terms);
        }
        QVERIFY2(found <= 1, qPrintable(QString::number(found)));
    }

    void stillRecords_holdNoMode()
    {
        for (const double level : {0.0, 1.0, -1e9, 1e-300}) {
            std::vector<NuisanceTerm> terms;
            findsIn(seriesOf(Eigen::VectorXd::Constant(1600, level), 1e6), 6.8e3, terms);
            for (const NuisanceTerm &term : terms) // of rounding, if any
                QVERIFY(std::abs(term.amplitude) <= 1e-12 * std::abs(level));
        }
        std::vector<NuisanceTerm> terms; // two blocks: nothing can be fitted
        QVERIFY(!findsIn(seriesOf(Eigen::VectorXd::LinSpaced(24, 0.0, 1.0), 1e6), 6.8e3, terms));
        polish(tailOf(seriesOf(Eigen::VectorXd::Ones(1600), 1e6), 8e-4, 6.8e3), true, terms);
        QVERIFY(terms.empty());
    }

    void brokenRecord_changesNothing()
    {
        Eigen::VectorXd values
            = sumOf({{0, true, poleFrom(6.8e3, 0.01), {0.03, 0.0}}}, 1.0, 1e6, 1600);
        values[1234] = kNan;
        std::vector<NuisanceTerm> terms;
        QVERIFY(!findsIn(seriesOf(values, 1e6), 6.8e3, terms));
        QVERIFY(terms.empty());
    }
};

DYNCAL_TEST(TestNuisanceTail)
#include "tst_nuisance_tail.moc"
