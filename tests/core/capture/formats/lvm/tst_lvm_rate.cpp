// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Rates from what is printed with few digits: true steps are printed and read back, and the rate
// must be as good as it is said to be.

#include "core/capture/formats/lvm/lvm_rate.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace dyncal;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double unitOfLastDigit(double largest, int digits)
{
    return std::pow(10.0, std::floor(std::log10(std::abs(largest))) - digits + 1);
}

double rounded(double value, double unit)
{
    return unit * std::round(value / unit);
}

/// Delta_X with so many digits; 0 digits: none is stated.
LvmChannel channelOf(double step, int digits)
{
    LvmChannel channel;
    if (digits > 0) {
        channel.deltaResolution = unitOfLastDigit(step, digits);
        channel.deltaX = rounded(step, channel.deltaResolution);
    }
    return channel;
}

std::vector<double> timesOf(double first, double step, std::size_t rows, double unit)
{
    std::vector<double> x(rows);
    for (std::size_t k = 0; k < rows; ++k)
        x[k] = rounded(first + step * static_cast<double>(k), unit);
    return x;
}

} // namespace

class TestLvmRate : public QObject
{
    Q_OBJECT

private slots:
    void printedTimes_giveTheTrueRateAsWellAsTheySay()
    {
        // Steps with any number of digits in Delta_X and in the X cells; never a contradiction, as
        // there is none, and the true rate lies within what is stated.
        std::mt19937_64 random(12);
        const auto share = [&random] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
        int known = 0;
        for (int trial = 0; trial < 4000; ++trial) {
            const double step = std::pow(10.0, -7.0 + 5.0 * share());
            const std::size_t rows = 2 + random() % 3000;
            const double first = random() % 2 == 0 ? 0.0 : -step * static_cast<double>(rows) / 3.0;
            const double last = first + step * static_cast<double>(rows);
            const double unit = unitOfLastDigit(last, 4 + static_cast<int>(random() % 8));
            const LvmChannel channel = channelOf(step, static_cast<int>(random() % 8));
            const LvmRate rate = lvmRate(channel, timesOf(first, step, rows, unit), unit);
            if (rate.contradicted) {
                // Only where there is no Delta_X and a single step is lost in the rounding.
                QVERIFY2(channel.deltaX == 0.0 && unit > 0.4 * step,
                    qPrintable(QString("%1 %2 %3").arg(step).arg(unit).arg(channel.deltaX)));
                continue;
            }
            QVERIFY(rate.sampleRate_Hz > 0.0);
            ++known;
            const double off = std::abs(rate.sampleRate_Hz * step - 1.0);
            const double allowed = rate.relativePrecision * (1.0 + 2.0 * rate.relativePrecision);
            QVERIFY2(off <= allowed + 1e-9,
                qPrintable(QString("%1 %2 %3").arg(step).arg(off).arg(rate.relativePrecision)));
        }
        QVERIFY2(known > 2500, qPrintable(QString::number(known)));
    }

    void timesOfAnotherStep_areAContradiction()
    {
        for (const double wrong : {0.5, 0.98, 1.02, 2.0, 1000.0}) {
            const LvmChannel channel = channelOf(1e-4, 6);
            const LvmRate rate = lvmRate(channel, timesOf(0.0, 1e-4 * wrong, 500, 1e-9), 1e-9);
            QVERIFY(rate.contradicted);
            QCOMPARE(rate.sampleRate_Hz, 0.0);
            QVERIFY(std::abs(rate.meanStep / (1e-4 * wrong) - 1.0) < 1e-3);
        }
    }

    void gap_isAContradictionWithOrWithoutDelta()
    {
        std::vector<double> x = timesOf(0.0, 1e-4, 400, 1e-9);
        for (std::size_t k = 200; k < x.size(); ++k)
            x[k] += 3e-4;
        QVERIFY(lvmRate(channelOf(1e-4, 6), x, 1e-9).contradicted);
        QVERIFY(lvmRate(channelOf(1e-4, 0), x, 1e-9).contradicted);
        for (std::size_t k = 0; k < x.size(); ++k)
            x[k] = 1e-4 * static_cast<double>(x.size() - k); // backwards
        QVERIFY(lvmRate(channelOf(1e-4, 6), x, 1e-9).contradicted);
    }

    void noTimes_leaveWhatIsStated()
    {
        const LvmChannel stated = channelOf(2.5e-5, 2);
        for (const std::vector<double> &x :
            {std::vector<double>(), std::vector<double>{0.0}, std::vector<double>(50, kNan)}) {
            const LvmRate rate = lvmRate(stated, x, 1e-6);
            QVERIFY(!rate.contradicted);
            QCOMPARE(rate.sampleRate_Hz, 4e4);
            QVERIFY(std::abs(rate.relativePrecision - 0.5e-6 / 2.5e-5) < 1e-12);
            QCOMPARE(lvmRate({}, x, 1e-6).sampleRate_Hz, 0.0);
            QVERIFY(!lvmRate({}, x, 1e-6).contradicted);
        }
    }

    void fineTimes_tellACoarseDeltaMore()
    {
        // Delta_X 0.000977 for 1/1024 s; a thousand rows know it a thousand times better.
        const double step = 1.0 / 1024.0;
        const LvmChannel channel = channelOf(step, 3);
        const LvmRate alone = lvmRate(channel, {}, 0.0);
        const LvmRate both = lvmRate(channel, timesOf(0.0, step, 1025, 1e-6), 1e-6);
        QVERIFY(std::abs(alone.sampleRate_Hz / 1024.0 - 1.0) > 1e-4);
        QVERIFY(std::abs(both.sampleRate_Hz / 1024.0 - 1.0) < 1.1e-6);
        QVERIFY(both.relativePrecision < 2e-6);
        // Enough digits are kept as they are: 1/Delta_X to the last bit.
        const LvmChannel exact = channelOf(1e-6, 7);
        QCOMPARE(
            lvmRate(exact, timesOf(0.0, 1e-6, 2000, 1e-9), 1e-9).sampleRate_Hz, 1.0 / exact.deltaX);
    }
};

DYNCAL_TEST(TestLvmRate)
#include "tst_lvm_rate.moc"
