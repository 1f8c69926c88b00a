// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Time axes that were printed with few digits, counts in front of samples, and compressed streams:
// each is made here, or by Python, from what it must be read as.

#include "core/capture/formats/bytes/counted_header.h"
#include "core/capture/formats/bytes/large_pages.h"
#include "core/capture/formats/bytes/time_axis.h"
#include "core/capture/formats/bytes/zlib_stream.h"
#include "tests/support/python_answer.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <random>
#include <vector>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// Times as a file states them that prints so many decimals.
std::vector<double> printed(double first, double step, int rows, int decimals)
{
    std::vector<double> times;
    for (int i = 0; i < rows; ++i)
        times.push_back(QString::number(first + step * i, 'f', decimals).toDouble());
    return times;
}

/// A column as digitizers of PTB write it.
std::vector<double> counted(std::vector<double> header, std::size_t samples)
{
    for (std::size_t i = 0; i < samples; ++i)
        header.push_back(-1.5 - static_cast<double>(i % 7)); // no sample looks like a header
    return header;
}

} // namespace

class TestAxesAndStreams : public QObject
{
    Q_OBJECT

private slots:
    /// Rounding to at most half a step is no gap, wherever the axis begins.
    void printedAxis_isRegularAndHasItsStep()
    {
        std::mt19937 random(1);
        for (int trial = 0; trial < 2000; ++trial) {
            const int decimals = 2 + static_cast<int>(random() % 8);
            const double unit = std::pow(10.0, -decimals);
            const double step = unit * (2.0 + static_cast<double>(random() % 1000) / 37.0);
            const double first = unit * (static_cast<double>(random() % 200000) - 100000.0);
            const int rows = 40 + static_cast<int>(random() % 100);
            const TimeAxis axis = timeAxisOf(printed(first, step, rows, decimals), unit);
            QVERIFY2(!axis.irregular, qPrintable(QString("trial %1").arg(trial)));
            QVERIFY(std::abs(axis.step - step) <= unit / (rows - 1) * 1.001);
            QVERIFY(std::abs(axis.first - first) <= 0.5001 * unit);
        }
    }

    void missingRow_isFoundWhereItIs()
    {
        std::mt19937 random(2);
        for (int trial = 0; trial < 1000; ++trial) {
            std::vector<double> times
                = printed(0.0, 1e-4 * (2.0 + static_cast<double>(random() % 100)), 60, 4);
            const auto gap = 1 + static_cast<std::ptrdiff_t>(random() % 58);
            times.erase(times.begin() + gap);
            const TimeAxis axis = timeAxisOf(times);
            QVERIFY2(axis.irregular, qPrintable(QString("trial %1").arg(trial)));
            QCOMPARE(*axis.irregular, Index(gap));
        }
    }

    void timesThatAreNone_areIrregularFromTheBeginning()
    {
        const double nan = std::nan("");
        for (const std::vector<double> &times : {std::vector{1.0, 1.0}, std::vector{2.0, 1.0},
                 std::vector{nan, nan}, std::vector{0.0, nan}, std::vector{0.0, 0.0, 0.0}})
            QVERIFY(timeAxisOf(times, 0.1).irregular);
        const TimeAxis two = timeAxisOf(std::vector{0.0, 0.5}, 0.1);
        QVERIFY(!two.irregular && two.step == 0.5);
    }

    void countInFront_isRecognisedByTheRowsBehind()
    {
        for (const std::size_t samples : {8U, 9U, 100U, 5000U}) {
            const double n = static_cast<double>(samples);
            for (const std::vector<double> &header :
                {std::vector{n, 1e-6}, std::vector{n, 1e-6, n / 2.0 - std::fmod(n, 2.0) / 2.0},
                    std::vector{n, 1e-6, 3.0, 0.25}, std::vector{n, 0.01, 0.0, 1.0},
                    std::vector{n, 1e-12, n, 0.0}}) {
                const auto found = countedHeader(counted(header, samples));
                QVERIFY(found && found->complete);
                QCOMPARE(found->lines, std::ssize(header));
                QCOMPARE(found->declared, static_cast<Index>(samples));
                QCOMPARE(found->interval_s, header[1]);
            }
        }
    }

    void cutBehindItsCount_isNeverCalledComplete()
    {
        const std::vector<double> whole = counted({100.0, 1e-6, 3.0, 0.25}, 100);
        for (std::size_t rows = 4; rows < whole.size(); ++rows) {
            const auto found = countedHeader(std::span(whole).first(rows));
            QVERIFY2(found && !found->complete, qPrintable(QString::number(rows)));
            QCOMPARE(found->lines, Index(4));
            QCOMPARE(found->declared, Index(100));
        }
    }

    void ordinaryColumns_haveNoCountInFront()
    {
        const double nan = std::nan("");
        for (const std::vector<double> &header : {std::vector{7.0, 1e-6}, std::vector{100.5, 1e-6},
                 std::vector{-100.0, 1e-6}, std::vector{nan, 1e-6}, std::vector{100.0, 0.0},
                 std::vector{100.0, -1e-6}, std::vector{100.0, 0.011}, std::vector{100.0, nan},
                 std::vector{1e13, 1e-6}, std::vector{HUGE_VAL, 1e-6}})
            QVERIFY(!countedHeader(counted(header, 100)));
        QVERIFY(!countedHeader(counted({100.0, 1e-6}, 150))); // more rows than it counts
        QVERIFY(!countedHeader(std::vector{100.0}) && !countedHeader({}));
    }

    /// Longer than the pieces in which it is read and expanded, and in the middle of a file.
    void longStream_isWhatPythonPacked()
    {
        const ScratchFolder place;
        const PythonAnswer answer = python({"-c",
            "import random, sys, zlib\n"
            "r = random.Random(1)\n"
            "plain = bytes(r.randrange(256) for i in range(300000)) + bytes(3000000)\n"
            "packed = zlib.compress(plain, 6)\n"
            "open(sys.argv[1] + '/plain', 'wb').write(plain)\n"
            "open(sys.argv[1] + '/file', 'wb').write(b'head' + packed + b'tail')\n"
            "print(len(packed))\n",
            QString::fromStdString(place.file(""))});
        QVERIFY2(answer.ran, answer.err.constData());
        const auto size = answer.out.trimmed().toULongLong();
        const std::string plain = contentOf(place.file("plain"));
        const auto file = SampleFile::open(place.file("file"));
        QVERIFY(file && plain.size() == 3300000);
        for (const std::size_t piece :
            {std::size_t(65536), std::size_t(1048577), plain.size() + 10}) {
            ZlibStream stream(*file, 4, size);
            std::vector<std::byte> part(piece);
            std::string read;
            for (std::size_t count = piece; count == piece;) {
                count = stream.read(part);
                read.append(reinterpret_cast<const char *>(part.data()), count);
            }
            QVERIFY(stream.ok() && stream.ended());
            QVERIFY(read == plain);
        }
        ZlibStream cut(*file, 4, size - 1);
        std::vector<std::byte> all(plain.size() + 10);
        (void)cut.read(all);
        QVERIFY(!cut.ended() && !cut.ok());
    }

    void largePages_changeNoByte()
    {
        std::vector<unsigned char> memory(3 * kLargePage + 12345);
        for (std::size_t i = 0; i < memory.size(); ++i)
            memory[i] = static_cast<unsigned char>(i * 31 >> 5);
        const std::vector<unsigned char> before = memory;
        for (const std::size_t begin : {0U, 1U, 4096U, 12345U})
            for (const std::size_t size : {std::size_t(0), std::size_t(1), kLargePage - 1,
                     kLargePage, 2 * kLargePage + 1, memory.size() - begin})
                preferLargePages(memory.data() + begin, size);
        preferLargePages(nullptr, 10 * kLargePage);
        QVERIFY(memory == before);
    }
};

DYNCAL_TEST(TestAxesAndStreams)
#include "tst_axes_and_streams.moc"
