// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Types and instants of TDMS files against numpy's types and python's calendar and whole numbers.

#include "core/capture/formats/tdms/tdms_types.h"
#include "tests/support/python_answer.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <limits>
#include <random>

using namespace dyncal;

namespace {

/// Of "seconds fraction" pairs: the ISO text, cut to picoseconds, zeros at the end left out.
const char *const kIsoTexts = R"py(
import datetime, sys
words = sys.argv[1].split()
for seconds, fraction in zip(map(int, words[::2]), map(int, words[1::2])):
    t = datetime.datetime(1904, 1, 1) + datetime.timedelta(seconds=seconds)
    digits = ("%012d" % (fraction * 10**12 >> 64)).rstrip("0")
    print(t.strftime("%m-%dT%H:%M:%S").join(["%04d-" % t.year, ""]) + ("." if digits else "")
          + digits + "Z")
)py";

} // namespace

class TestTdmsTypes : public QObject
{
    Q_OBJECT

private slots:
    void isoText_isThatOfPythonsCalendar()
    {
        constexpr std::int64_t kFirst = -60052752000; // 0001-01-01
        constexpr std::int64_t kLast = 255485145599; // 9999-12-31T23:59:59
        constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();
        std::vector<TdmsTimestamp> times{{kFirst, 0}, {kLast, kAll}, {-1, 0}, {1, 1}, {86399, kAll},
            {86400, std::uint64_t(1) << 63}, {3424204800, 18446744}};
        std::mt19937_64 random(17);
        for (int i = 0; i < 1000; ++i) {
            const auto span = static_cast<std::uint64_t>(kLast - kFirst);
            const std::int64_t seconds = kFirst + static_cast<std::int64_t>(random() % span);
            times.push_back({seconds == 0 ? 1 : seconds, random() << (random() % 64)});
        }
        QString words;
        QByteArrayList found;
        for (const TdmsTimestamp &time : times) {
            words += QString("%1 %2 ").arg(time.seconds).arg(time.fraction);
            found << QByteArray::fromStdString(isoText(time));
        }
        const testing::PythonAnswer answer = testing::python({"-c", kIsoTexts, words});
        QVERIFY2(answer.ran, answer.err);
        QCOMPARE(found, answer.out.simplified().split(' '));
    }

    void isoText_isEmptyWhereThereIsNoDate()
    {
        using Limits = std::numeric_limits<std::int64_t>;
        for (const std::int64_t seconds : {std::int64_t(0), std::int64_t(-60052752001),
                 std::int64_t(255485145600), Limits::min(), Limits::max()})
            QCOMPARE(isoText({seconds, 5}), std::string());
    }

    void types_areAsWideAsNumpySays()
    {
        if (!testing::hasNumericalPython())
            QSKIP("/usr/bin/python3 with numpy is missing: the widths are not compared.");
        QString names;
        QByteArrayList widths;
        for (std::uint32_t number = 1; number <= 10; ++number) {
            names += QString::fromStdString(tdmsTypeName(TdmsType(number))) + ' ';
            widths << QByteArray::number(qint64(tdmsTypeBytes(TdmsType(number)).value_or(-1)));
        }
        for (const TdmsType type : {TdmsType::Complex64, TdmsType::Complex128}) {
            names += QString::fromStdString(tdmsTypeName(type)) + ' ';
            widths << QByteArray::number(qint64(*tdmsTypeBytes(type)));
        }
        const testing::PythonAnswer answer = testing::python({"-c",
            "import sys, numpy as np\n"
            "for name in sys.argv[1].split(): print(np.dtype(name).itemsize)",
            names});
        QVERIFY2(answer.ran, answer.err);
        QCOMPARE(widths, answer.out.simplified().split(' '));
    }

    void numbersThatAreNoType_haveNoWidth()
    {
        // 11 and 27: extended floating point; 79: fixed point; both have no documented size.
        for (const std::uint32_t number : {11U, 27U, 0x4FU, 0x22U, 0x45U, 0xFFFFFFFEU}) {
            QVERIFY(!tdmsTypeBytes(TdmsType(number)));
            QCOMPARE(tdmsTypeName(TdmsType(number)), "number " + std::to_string(number));
        }
        QCOMPARE(*tdmsTypeBytes(TdmsType::Void), Index(0));
        QCOMPARE(*tdmsTypeBytes(TdmsType::Timestamp), Index(16));
    }

    void unitMark_changesNeitherWidthNorName()
    {
        for (const TdmsType type : {TdmsType::Float32WithUnit, TdmsType::Float64WithUnit}) {
            QVERIFY(withoutUnit(type) != type);
            QCOMPARE(tdmsTypeBytes(withoutUnit(type)), tdmsTypeBytes(type));
            QCOMPARE(tdmsTypeName(withoutUnit(type)), tdmsTypeName(type));
        }
        QCOMPARE(withoutUnit(TdmsType::Int16), TdmsType::Int16);
    }

    void daqmxNumbers_areAnOrderOfTheirOwn()
    {
        // From 0 on without and with sign by turns, ever wider, then the floating point types.
        for (std::uint32_t number = 0; number < 8; ++number) {
            const std::string name = tdmsTypeName(daqmxType(number).value_or(TdmsType::Void));
            const std::string expected
                = (number % 2 == 0 ? "uint" : "int") + std::to_string(8 << (number / 2));
            QCOMPARE(name, expected);
        }
        QCOMPARE(tdmsTypeName(*daqmxType(8)), std::string("float32"));
        QCOMPARE(tdmsTypeName(*daqmxType(9)), std::string("float64"));
        QCOMPARE(*daqmxType(0xFFFFFFFF), TdmsType::Timestamp);
        QVERIFY(!daqmxType(10) && !daqmxType(0xFFFFFFFE));
    }
};

DYNCAL_TEST(TestTdmsTypes)
#include "tst_tdms_types.moc"
