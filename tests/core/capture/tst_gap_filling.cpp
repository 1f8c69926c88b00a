// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/gap_filling.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <typename T>
std::vector<T> ofDoubles(const std::vector<double> &values)
{
    return {values.begin(), values.end()};
}

std::vector<double> valuesOf(const RawSamples &samples)
{
    std::vector<double> values;
    for (Index i = 0; i < samples.size(); ++i)
        values.push_back(samples.at(i));
    return values;
}

/// Samples that a file holds in blocks, until it is gone.
class Elsewhere : public SampleSource
{
public:
    Elsewhere(std::vector<double> values, bool isGone)
        : m_values(std::move(values))
        , m_isGone(isGone)
    {
    }
    bool read(Index begin, Index count, std::byte *target) const override
    {
        if (m_isGone && begin > 0)
            return false;
        std::copy_n(m_values.begin() + begin, count, reinterpret_cast<double *>(target));
        return true;
    }

private:
    std::vector<double> m_values;
    bool m_isGone;
};

} // namespace

class TestGapFilling : public QObject
{
    Q_OBJECT

private slots:
    void gap_liesOnTheLineBetweenItsNeighbours()
    {
        RawSamples samples(std::vector<double>{1.0, kNaN, kNaN, kNaN, 9.0, -2.0, kInfinity, 4.0});
        QCOMPARE(fillGaps(samples, 3), Index(4));
        QCOMPARE(valuesOf(samples), (std::vector<double>{1, 3, 5, 7, 9, -2, 1, 4}));
        QVERIFY(samples.type() == SampleType::Float64);
    }

    void straightRecord_comesBackWhateverIsMissing()
    {
        // Every gap of at most `longest`, wherever it lies but at the ends.
        for (Index longest = 1; longest <= 4; ++longest) {
            for (Index begin = 1; begin < 10 - longest; ++begin) {
                std::vector<double> values;
                for (int i = 0; i < 10; ++i)
                    values.push_back(3.0 - 0.25 * i);
                const std::vector<double> whole = values;
                for (Index k = 0; k < longest; ++k)
                    values[static_cast<std::size_t>(begin + k)] = -kInfinity;
                RawSamples samples{values};
                QCOMPARE(fillGaps(samples, longest), longest);
                QCOMPARE(valuesOf(samples), whole);
            }
        }
    }

    void longerGap_staysAltogether()
    {
        const std::vector<double> values{1.0, kNaN, kNaN, 4.0, kNaN, 6.0};
        RawSamples samples{values};
        QCOMPARE(fillGaps(samples, 1), Index(1));
        QVERIFY(std::isnan(samples.at(1)) && std::isnan(samples.at(2)));
        QCOMPARE(samples.at(4), 5.0);
    }

    void gapsAtTheEnds_stay()
    {
        RawSamples samples(std::vector<double>{kNaN, 2.0, kNaN, 4.0, kNaN});
        QCOMPARE(fillGaps(samples, 10), Index(1));
        QVERIFY(std::isnan(samples.at(0)) && std::isnan(samples.at(4)));
        QCOMPARE(samples.at(2), 3.0);
        RawSamples none(std::vector<double>{kNaN, kNaN});
        QCOMPARE(fillGaps(none, 10), Index(0));
        RawSamples empty;
        QCOMPARE(fillGaps(empty, 10), Index(0));
    }

    void singlePrecision_staysSinglePrecision()
    {
        RawSamples samples(ofDoubles<float>({0.1, kNaN, 0.4}));
        QCOMPARE(fillGaps(samples, 1), Index(1));
        QVERIFY(samples.type() == SampleType::Float32);
        const double between = 0.5 * (double(0.1F) + double(0.4F));
        QCOMPARE(samples.at(1), double(static_cast<float>(between)));
        QCOMPARE(samples.at(0), double(0.1F));
    }

    void counts_areAlwaysValid()
    {
        RawSamples samples(std::vector<std::int16_t>{1, 32767, -32768, 4});
        const RawSamples before = samples;
        QCOMPARE(fillGaps(samples, 100), Index(0));
        QVERIFY(samples.sharesWith(before));
    }

    void nothingFilled_recordIsTheSame()
    {
        for (const std::vector<double> &values :
            {std::vector<double>{1, 2, 3}, {1, kNaN, kNaN, 4}, {kNaN, 1}}) {
            RawSamples samples{values};
            const RawSamples before = samples;
            QCOMPARE(fillGaps(samples, 1), Index(0));
            QVERIFY(samples.sharesWith(before));
        }
        for (const Index longest : {Index(0), Index(-5)}) {
            RawSamples samples(std::vector<double>{1, kNaN, 3});
            QCOMPARE(fillGaps(samples, longest), Index(0));
            QVERIFY(std::isnan(samples.at(1)));
        }
    }

    void recordInItsFile_isFilledAcrossBlocksInMemory()
    {
        std::vector<double> values(static_cast<std::size_t>(RawSamples::kBlock) + 10, 5.0);
        const auto edge = static_cast<std::size_t>(RawSamples::kBlock);
        values[edge - 1] = kNaN;
        values[edge] = kNaN;
        values[edge + 1] = 8.0;
        RawSamples samples(
            std::make_shared<Elsewhere>(values, false), SampleType::Float64, std::ssize(values));
        QCOMPARE(fillGaps(samples, 2), Index(2));
        QVERIFY(samples.isInMemory());
        QCOMPARE(samples.at(RawSamples::kBlock - 1), 6.0);
        QCOMPARE(samples.at(RawSamples::kBlock), 7.0);
        QCOMPARE(samples.at(3), 5.0);
    }

    void fileThatIsGone_isNotFilledWithAnything()
    {
        std::vector<double> values(static_cast<std::size_t>(RawSamples::kBlock) + 10, 5.0);
        values[3] = kNaN;
        RawSamples samples(
            std::make_shared<Elsewhere>(values, true), SampleType::Float64, std::ssize(values));
        QCOMPARE(fillGaps(samples, 2), Index(0));
        QVERIFY(!samples.isInMemory());
    }
};

DYNCAL_TEST(TestGapFilling)
#include "tst_gap_filling.moc"
