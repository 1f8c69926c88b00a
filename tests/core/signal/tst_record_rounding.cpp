// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/rounding.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

Eigen::VectorXd rounded(Eigen::VectorXd values, double step)
{
    for (double &value : values)
        value = std::nearbyint(value / step) * step;
    return values;
}

/// A ringing that covers the range densely.
Eigen::VectorXd ringing(Index count)
{
    return testing::sampledStep(3e3, 0.05, 1e6, count);
}

/// Six significant digits, as a text file has them.
Eigen::VectorXd sixDigits(Eigen::VectorXd values)
{
    for (double &value : values)
        value = QByteArray::number(value, 'g', 6).toDouble();
    return values;
}

Channel channelOf(RawSamples::Counts counts)
{
    Channel channel;
    channel.samples = RawSamples(std::move(counts));
    return channel;
}

Channel channelOf(const Eigen::VectorXd &values)
{
    return channelOf(std::vector<double>(values.begin(), values.end()));
}

/// Mean error of rounding to whole numbers at `level` in normal noise: by its distribution.
double meanError(double level, double sd)
{
    double mean = 0.0;
    for (int k = -20; k <= 20; ++k) {
        const auto below
            = [&](double x) { return 0.5 * std::erfc((level - x) / (sd * std::sqrt(2.0))); };
        mean += k * (below(k + 0.5) - below(k - 0.5));
    }
    return mean - level;
}

} // namespace

class TestRecordRounding : public QObject
{
    Q_OBJECT

private slots:
    void step_isFound_data()
    {
        QTest::addColumn<double>("step");
        for (const double step : {1e-9, 1e-6, 1e-4, 1.0 / 8192.0, 3.0517578e-4, 0.0173})
            QTest::newRow(qPrintable(QString::number(step))) << step;
    }
    void step_isFound()
    {
        QFETCH(double, step);
        // A tenth of a millionth: what the last bit of the values leaves of the smallest step.
        const double found = commonStep(rounded(ringing(5000), step));
        QVERIFY2(std::abs(found / step - 1.0) < 1e-7, qPrintable(QString::number(found, 'g', 12)));
        // An offset of its own changes nothing.
        const double shifted = commonStep(rounded(ringing(5000), step).array() + 0.123456789);
        QVERIFY(std::abs(shifted / step - 1.0) < 1e-6);
    }

    void noStep_isFoundWhereThereIsNone()
    {
        QCOMPARE(commonStep(ringing(5000)), 0.0);
        testing::Noise noise(3);
        QCOMPARE(commonStep(ringing(3000) + noise.series(3000, 1e-3)), 0.0);
        QCOMPARE(commonStep(Eigen::VectorXd::Constant(100, 2.0)), 0.0);
        QCOMPARE(commonStep(Eigen::VectorXd()), 0.0);
        QCOMPARE(commonStep(Eigen::VectorXd::LinSpaced(7, 0.0, 6.0)), 0.0); // too few to tell
        QCOMPARE(commonStep(Eigen::VectorXd::LinSpaced(8, 0.0, 7.0)), 1.0);
    }

    void resolution_ofCounts_isOneCount()
    {
        Channel channel = channelOf(std::vector<std::int16_t>{5, 6, 7, 9});
        channel.polynomial = {0.5, -2e-3};
        channel.polarity = -1.0;
        QVERIFY(std::abs(resolutionOf(channel, {0, 4}) / 2e-3 - 1.0) < 1e-9);
        QCOMPARE(resolutionOf(channel, {2, 2}), 0.0);
    }

    void resolution_ofText_isThatOfItsLargeValues()
    {
        // 1.4 has a last digit of 1e-5, 0.5 one of 1e-6: the large values decide.
        Channel channel = channelOf(sixDigits(ringing(5000)));
        channel.userScale = 3.0;
        const double found = resolutionOf(channel, {0, 5000});
        QVERIFY2(std::abs(found / 3e-5 - 1.0) < 1e-6, qPrintable(QString::number(found)));
    }

    void resolution_ofPlainNumbers_isTheirLastBit()
    {
        const Eigen::VectorXd y = ringing(5000);
        const double bit = std::numeric_limits<double>::epsilon() * y.maxCoeff();
        const double found = resolutionOf(channelOf(y), {0, 5000});
        QVERIFY2(std::abs(found / bit - 1.0) < 1e-6, qPrintable(QString::number(found)));
        QCOMPARE(resolutionOf(channelOf(Eigen::VectorXd::Zero(50)), {0, 50}), 0.0);
        Eigen::VectorXd invalid = Eigen::VectorXd::Constant(50, std::nan(""));
        QCOMPARE(resolutionOf(channelOf(invalid), {0, 50}), 0.0);
        invalid[7] = 2.0;
        QVERIFY(resolutionOf(channelOf(invalid), {0, 50}) > 0.0);
    }

    void resolution_ofSingleNumbers_isTheirLastBit()
    {
        const Eigen::VectorXd y = ringing(5000);
        std::vector<float> values;
        for (const double value : y)
            values.push_back(static_cast<float>(value));
        // Of 24 bits, between that of 0.5 and that of 1.
        const double found = resolutionOf(channelOf(std::move(values)), {0, 5000});
        QVERIFY2(found >= std::ldexp(1.0, -24) * 0.99 && found <= std::ldexp(1.0, -23) * 1.01,
            qPrintable(QString::number(found)));
    }

    void lasting_isTheMeanSquareOfTheMeanError()
    {
        for (const double sd : {0.05, 0.1, 0.2, 0.3, 0.5}) {
            constexpr int kLevels = 2000;
            double squares = 0.0;
            for (int i = 0; i < kLevels; ++i)
                squares += std::pow(meanError((i + 0.5) / kLevels, sd), 2) / kLevels;
            const double lasting = lastingRounding(2.5 * sd, 2.5) / 2.5;
            QVERIFY2(std::abs(lasting / std::sqrt(squares) - 1.0) < 1e-4,
                qPrintable(QString("%1: %2").arg(sd).arg(lasting / std::sqrt(squares))));
        }
    }

    void lasting_hasItsLimits()
    {
        QCOMPARE(lastingRounding(0.0, 2.0), 2.0 / std::sqrt(12.0));
        QVERIFY(std::abs(lastingRounding(1e-4, 1.0) * std::sqrt(12.0) - 1.0) < 1e-3);
        QVERIFY(lastingRounding(1.0, 1.0) < 1e-8);
        QCOMPARE(lastingRounding(5.0, 1.0), 0.0);
        QCOMPARE(lastingRounding(1.0, 0.0), 0.0);
        QCOMPARE(lastingRounding(0.0, 0.0), 0.0);
        for (double sd = 0.01; sd < 1.0; sd += 0.01)
            QVERIFY(lastingRounding(sd + 0.01, 1.0) < lastingRounding(sd, 1.0));
    }

    void noiseBefore_isWhatWasRounded()
    {
        testing::Noise noise(11);
        for (const double sd : {0.6, 1.0, 4.0}) {
            const Eigen::VectorXd x = rounded(noise.series(20000, sd), 1.0);
            QVERIFY(std::abs(noiseBeforeRounding(x, 1.0) / sd - 1.0) < 0.03); // 20000: 0.5 %
        }
        // Between two values: the level lies at their middle, whatever the noise.
        const Eigen::VectorXd toggling
            = rounded(noise.series(20000, 0.05).array() + 0.5, 1.0).array() - 0.5;
        QCOMPARE(noiseBeforeRounding(toggling, 1.0), 0.0);
        QCOMPARE(noiseBeforeRounding(Eigen::VectorXd::Zero(100), 1.0), 0.0);
        QCOMPARE(noiseBeforeRounding(Eigen::VectorXd(), 1.0), 0.0);
        const Eigen::VectorXd unrounded = noise.series(20000, 2.0);
        QVERIFY(std::abs(noiseBeforeRounding(unrounded, 0.0) / 2.0 - 1.0) < 0.03);
    }
};

DYNCAL_TEST(TestRecordRounding)
#include "tst_record_rounding.moc"
