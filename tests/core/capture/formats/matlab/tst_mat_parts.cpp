// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the numbers of a MATLAB file become, and what its variables say of time, piece by piece.

#include "core/capture/formats/matlab/mat_samples.h"
#include "core/capture/formats/matlab/mat_time.h"
#include "tests/core/capture/formats/matlab/mat_test_signals.h"
#include "tests/support/memory_file.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cstring>
#include <limits>

using namespace dyncal;

namespace {

template <typename T>
std::vector<std::byte> bytesOf(const std::vector<T> &values, std::endian order)
{
    std::vector<std::byte> bytes(values.size() * sizeof(T));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    for (std::size_t i = 0; order != std::endian::native && i < values.size(); ++i)
        std::reverse(bytes.begin() + std::ptrdiff_t(i * sizeof(T)),
            bytes.begin() + std::ptrdiff_t((i + 1) * sizeof(T)));
    return bytes;
}

/// Numbers first, first + step ... of these, from a file or as if they had been compressed.
template <typename T>
std::vector<double> samplesOf(const std::vector<T> &values, MatNumber number, std::endian order,
    bool expanded, Index first, Index step, Index count)
{
    std::vector<std::byte> bytes(5, std::byte{0x55}); // they begin somewhere in the file
    const std::vector<std::byte> numbers = bytesOf(values, order);
    bytes.insert(bytes.end(), numbers.begin(), numbers.end());
    const testing::MemoryFile file(bytes.data(), bytes.size());
    MatVariable variable;
    variable.number = number;
    variable.order = order;
    variable.offset = 5;
    if (expanded)
        variable.expanded = std::make_shared<const std::vector<std::byte>>(numbers);
    const auto samples = matSamples(*SampleFile::open(file.path()), variable, first, step, count);
    std::vector<double> found;
    for (Index i = 0; samples && i < samples->size(); ++i)
        found.push_back(samples->at(i));
    return found;
}

RawSamples samples(std::vector<double> values)
{
    return RawSamples(std::move(values));
}

} // namespace

class TestMatParts : public QObject
{
    Q_OBJECT

private slots:
    void everyNumber_isTheSameFromFileAndMemory()
    {
        const auto check = [&]<typename T>(MatNumber number, T) {
            QCOMPARE(bytesOfMatNumber(number), Index(sizeof(T)));
            const std::vector<T> values{T(1), std::numeric_limits<T>::max(), T(3),
                std::numeric_limits<T>::lowest(), T(5), T(77), T(7)};
            const bool isLong = sizeof(T) == 8 && std::is_integral_v<T>;
            for (const std::endian order : {std::endian::little, std::endian::big}) {
                for (const bool expanded : {false, true}) {
                    const auto all = samplesOf(values, number, order, expanded, 0, 1, 7);
                    QCOMPARE(all.size(), std::size_t(isLong ? 0 : 7)); // no double holds the ends
                    for (std::size_t i = 0; i < all.size(); ++i)
                        QCOMPARE(all[i], static_cast<double>(values[i]));
                    // Every second or third, up to the very last byte.
                    QCOMPARE(samplesOf(values, number, order, expanded, 2, 2, 3),
                        (std::vector<double>{3.0, 5.0, 7.0}));
                    QCOMPARE(samplesOf(values, number, order, expanded, 0, 5, 2),
                        (std::vector<double>{1.0, 77.0}));
                    QCOMPARE(samplesOf(values, number, order, expanded, 6, 1, 1),
                        (std::vector<double>{7.0}));
                }
            }
        };
        check(MatNumber::Int8, std::int8_t());
        check(MatNumber::UInt8, std::uint8_t());
        check(MatNumber::Int16, std::int16_t());
        check(MatNumber::UInt16, std::uint16_t());
        check(MatNumber::Int32, std::int32_t());
        check(MatNumber::UInt32, std::uint32_t());
        check(MatNumber::Float32, float());
        check(MatNumber::Float64, double());
        check(MatNumber::Int64, std::int64_t());
        check(MatNumber::UInt64, std::uint64_t());
        QCOMPARE(bytesOfMatNumber(MatNumber{8}), Index(0));
    }

    void longIntegers_areExactOrRefused()
    {
        // 2^53 + 1 is the first that a double does not hold: it would come out as 2^53.
        constexpr std::int64_t kLargest = std::int64_t(1) << 53;
        const auto signedOnes = [](std::int64_t value) {
            return samplesOf<std::int64_t>(
                {0, value}, MatNumber::Int64, std::endian::little, false, 0, 1, 2);
        };
        const auto unsignedOnes = [](std::uint64_t value) {
            return samplesOf<std::uint64_t>(
                {0, value}, MatNumber::UInt64, std::endian::big, true, 0, 1, 2);
        };
        for (const std::int64_t value : {kLargest, -kLargest, kLargest - 1, std::int64_t(0)})
            QCOMPARE(signedOnes(value), (std::vector<double>{0.0, static_cast<double>(value)}));
        for (const std::int64_t value :
            {kLargest + 1, -kLargest - 1, std::numeric_limits<std::int64_t>::max(),
                std::numeric_limits<std::int64_t>::min()})
            QVERIFY2(signedOnes(value).empty(), qPrintable(QString::number(value)));
        QCOMPARE(unsignedOnes(kLargest), (std::vector<double>{0.0, 9007199254740992.0}));
        QVERIFY(unsignedOnes(kLargest + 1).empty());
        QVERIFY(unsignedOnes(std::numeric_limits<std::uint64_t>::max()).empty());
    }

    void namesOfTime_areThoseAndNoOthers()
    {
        const MatTime time("file.mat", {});
        for (const char *name : {"t", "time", "TIME", "Times", "zeit", "tid", "t_s", "t_ms",
                 "Time_us", "time_NS", "t_S"})
            QVERIFY2(time.isTimeName(name), name);
        for (const char *name : {"T", "T_ms", "", "_s", "ts", "t0", "t_", "temperature", "time2",
                 "t_min", "dt", "fs", "tt", "s", "_ms"})
            QVERIFY2(!time.isTimeName(name), name);
    }

    void scalars_thatCannotBe_areNone()
    {
        const double inf = std::numeric_limits<double>::infinity();
        for (const double value : {0.0, -1e6, std::nan(""), inf, 1e-320}) {
            MatTime time("file.mat", {});
            time.addScalar("fs", value);
            time.addScalar("dt", value);
            Findings findings;
            QCOMPARE(time.rateOfLength(10, findings).sampleRate_Hz, 0.0);
            QVERIFY(findings.empty());
        }
    }

    void operatorsRate_isAboveTheFiles()
    {
        MatTime time("file.mat", 5e5);
        time.addScalar("fs", 1e6);
        time.addScalar("dt", 3e-6); // and the file contradicts itself
        time.addScalar("t_start", -0.25);
        Findings findings;
        const MatRate rate = time.rateOfLength(10, findings);
        QCOMPARE(rate.sampleRate_Hz, 5e5);
        QCOMPARE(rate.first_s, -0.25);
        QVERIFY(findings.empty());
    }

    void axis_isForSignalsAsLong()
    {
        MatTime time("file.mat", {});
        time.addVector("t_us", samples(testing::level5::axis(-3.0, 0.5, 20)));
        Findings findings;
        QCOMPARE(time.rateOfLength(20, findings).sampleRate_Hz, 2e6);
        QVERIFY(std::abs(time.rateOfLength(20, findings).first_s + 3e-6) < 1e-18);
        QCOMPARE(time.rateOfLength(19, findings).sampleRate_Hz, 0.0);
        QVERIFY(findings.empty());
    }

    void column_risingUniformly_isTheTime()
    {
        const MatTime time("file.mat", {});
        const std::vector<double> y = testing::level5::signal(20);
        const auto at = [&](std::vector<double> first, std::vector<double> last) {
            return time.columnOf({samples(std::move(first)), samples(y), samples(std::move(last))})
                .value_or(-1);
        };
        const std::vector<double> x = testing::level5::axis(-1.0, 0.125, 20);
        QCOMPARE(at(x, y), Index(0));
        QCOMPARE(at(y, x), Index(2));
        QCOMPARE(at(x, x), Index(0));
        QCOMPARE(at(y, y), Index(-1));
        QCOMPARE(at(testing::level5::axis(7.0, 1.0, 20), y), Index(-1)); // counts rows
        QCOMPARE(at(testing::level5::axis(0.5, 1.0, 20), y), Index(0)); // between whole numbers
        QCOMPARE(at(std::vector<double>(20, std::nan("")), x), Index(2));
        QCOMPARE(at(testing::level5::axis(0.0, 0.1, 7), y), Index(-1)); // too few to tell
    }
};

DYNCAL_TEST(TestMatParts)
#include "tst_mat_parts.moc"
