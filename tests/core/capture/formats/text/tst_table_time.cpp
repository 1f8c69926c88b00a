// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How the times of a table become a sample rate.

#include "core/capture/formats/bytes/time_axis.h"
#include "core/capture/formats/text/text_time.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

constexpr double kRounding = 1e-12; ///< a few roundings of a quotient

std::vector<double> uniform(double first, double step, int count)
{
    std::vector<double> times;
    for (int k = 0; k < count; ++k)
        times.push_back(first + step * k);
    return times;
}

bool isNear(double a, double b)
{
    return std::abs(a - b) <= kRounding * std::abs(b);
}

std::string sentence(const Error &error)
{
    return english(error.message);
}

bool contains(const std::string &text, const std::string &part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

class TestTableTime : public QObject
{
    Q_OBJECT

private slots:
    void time_units_scaleTheRate_data();
    void time_units_scaleTheRate();
    void time_unknownUnit_isCap016();
    void time_namedColumns_withoutTime_haveNone();
    void time_singleRow_hasNoRate();
    void time_gap_namesTheLine();
    void time_decreasing_isNoRate();
    void timeAxis_gap_isLocated();
    void printedResolution_lastDigit_data();
    void printedResolution_lastDigit();
};

void TestTableTime::time_units_scaleTheRate_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<double>("seconds");
    QTest::newRow("s") << "Time"
                       << "s" << 1.0;
    QTest::newRow("ms") << "Zeit"
                        << "ms" << 1e-3;
    QTest::newRow("us") << "x"
                        << "us" << 1e-6;
    QTest::newRow("micro sign") << "x" << QString::fromUtf8("\xC2\xB5s") << 1e-6;
    QTest::newRow("Greek mu") << "x" << QString::fromUtf8("\xCE\xBCs") << 1e-6;
    QTest::newRow("ns") << "x"
                        << "ns" << 1e-9;
    QTest::newRow("suffix") << "time_ms"
                            << "" << 1e-3;
    QTest::newRow("capitals") << "TIME"
                              << "MS" << 1e-3;
}

void TestTableTime::time_units_scaleTheRate()
{
    QFETCH(QString, name);
    QFETCH(QString, unit);
    QFETCH(double, seconds);
    const std::vector<ColumnTitle> titles{{name.toStdString(), unit.toStdString()}, {"p", "V"}};
    const auto time
        = timeOfTable("f", {}, {}, titles, {uniform(-2.0, 0.5, 20), std::vector<double>(20, 1.0)});
    QVERIFY(time.has_value());
    QCOMPARE(time->column.value_or(-1), Index(0));
    QVERIFY(isNear(time->sampleRate_Hz, 2.0 / seconds));
    QVERIFY(isNear(time->first_s, -2.0 * seconds));
}

void TestTableTime::time_unknownUnit_isCap016()
{
    const auto time = timeOfTable("f.csv", {}, {}, {{"time", "fortnight"}, {"p", "V"}},
        {uniform(0.0, 1.0, 9), uniform(0.0, 1.0, 9)});
    QVERIFY(!time);
    QCOMPARE(time.error().findingId, std::string("CAP-016"));
    QVERIFY(contains(sentence(time.error()), "\"fortnight\""));
}

void TestTableTime::time_namedColumns_withoutTime_haveNone()
{
    ImportSettings settings;
    settings.columns["dut"] = 1;
    const std::vector<std::vector<double>> columns{uniform(0.0, 1e-6, 9), uniform(0.0, 1.0, 9)};
    const auto time = timeOfTable("f", settings, {}, {{"time", "s"}, {"p", "V"}}, columns);
    QVERIFY(time && !time->column);
    QCOMPARE(time->sampleRate_Hz, 0.0);
    settings.columns["time"] = 0;
    QVERIFY(isNear(
        timeOfTable("f", settings, {}, {{"x", ""}, {"p", "V"}}, columns).value().sampleRate_Hz,
        1e6));
}

void TestTableTime::time_singleRow_hasNoRate()
{
    for (const std::vector<double> &values : {std::vector<double>{}, std::vector<double>{1.0}}) {
        const auto time = timeOfTable("f", {}, {}, {{"time", "s"}, {"p", "V"}}, {values, values});
        QVERIFY(time.has_value());
        QCOMPARE(time->sampleRate_Hz, 0.0);
    }
}

void TestTableTime::time_gap_namesTheLine()
{
    std::vector<double> times = uniform(0.0, 1e-6, 100);
    for (std::size_t k = 40; k < times.size(); ++k)
        times[k] += 2e-6; // two samples missing before row 40 (from 0)
    TextDialect dialect;
    dialect.header.resize(3);
    const auto time = timeOfTable(
        "f.csv", {}, dialect, {{"time", "s"}, {"p", "V"}}, {times, uniform(0.0, 1.0, 100)});
    QVERIFY(!time);
    QCOMPARE(time.error().findingId, std::string("CAP-016"));
    QVERIFY2(contains(sentence(time.error()), "line 44 "), sentence(time.error()).c_str());
}

void TestTableTime::time_decreasing_isNoRate()
{
    const auto time = timeOfTable("f.csv", {}, {}, {{"time", "s"}, {"p", "V"}},
        {uniform(1.0, -1e-3, 20), uniform(0.0, 1.0, 20)});
    QVERIFY(!time || time->sampleRate_Hz >= 0.0);
    const auto constant = timeOfTable("f.csv", {}, {}, {{"time", "s"}, {"p", "V"}},
        {std::vector<double>(20, 1.0), uniform(0.0, 1.0, 20)});
    QVERIFY(!constant || std::isfinite(constant->sampleRate_Hz));
}

void TestTableTime::timeAxis_gap_isLocated()
{
    std::vector<double> times = uniform(0.0, 0.5, 50);
    const TimeAxis whole = timeAxisOf(times);
    QVERIFY(!whole.irregular);
    QCOMPARE(whole.step, 0.5);
    times.erase(times.begin() + 20);
    const TimeAxis gap = timeAxisOf(times);
    QCOMPARE(gap.irregular.value_or(-1), Index(20));
    QCOMPARE(gap.step, 0.5);
    times[5] = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(timeAxisOf(times).irregular.value_or(-1), Index(5));
}

void TestTableTime::printedResolution_lastDigit_data()
{
    QTest::addColumn<QString>("cell");
    QTest::addColumn<QChar>("decimal");
    QTest::addColumn<double>("resolution");
    QTest::newRow("fixed") << "0.0120" << QChar('.') << 1e-4;
    QTest::newRow("exponent") << "1.5E-5" << QChar('.') << 1e-6;
    QTest::newRow("plus") << "1.25e+3" << QChar('.') << 10.0;
    QTest::newRow("integer") << "17" << QChar('.') << 1.0;
    QTest::newRow("comma") << "0,25" << QChar(',') << 0.01;
}

void TestTableTime::printedResolution_lastDigit()
{
    QFETCH(QString, cell);
    QFETCH(QChar, decimal);
    QFETCH(double, resolution);
    const std::string text = cell.toStdString();
    QVERIFY(isNear(printedResolution(text, decimal.toLatin1()), resolution));
}

DYNCAL_TEST(TestTableTime)
#include "tst_table_time.moc"
