// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/matlab/mat.h"
#include "tests/support/test_program.h"

#include "tests/core/capture/formats/bytes/binary_test_support.h"
#include "tests/core/capture/formats/matlab/mat_test_file.h"
#include "tests/core/capture/formats/matlab/mat_test_signals.h"

using namespace dyncal;
using namespace dyncal::testing;
using namespace testing::level5;

namespace {

/// Rates by uniform axes: rounding of the times.
constexpr double kRateTolerance = 1e-9;

bool near(double a, double b)
{
    return std::abs(a - b) <= kRateTolerance * std::abs(b);
}

} // namespace

/// MATLAB files have no units: no rate that is not certain.
class TestMatRates : public QObject
{
    Q_OBJECT

private slots:
    void rate_byScalar();
    void rate_byTimeVector();
    void rate_byUnnamedColumn_isAQuestion();
    void rate_statedTwice_isNoRateUnlessTheSame();
    void rate_contradictions_areNoRate();
    void rate_irregularTimes_areNoRate();
    void temperature_isNoTime();

private:
    BytesReader readBytes{"mat"};
};

void TestMatRates::rate_byScalar()
{
    for (const char *name : {"fs", "Fs", "FS", "sample_rate", "SampleRate"}) {
        const auto set = readBytes(Mat5()
                                       .add("y", kMiDouble, signal())
                                       .add<double>(name, kMiDouble, {2.5e6})
                                       .add<double>("t0", kMiDouble, {-1e-3})
                                       .bytes());
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 2.5e6);
        QCOMPARE(set->shots[0].channels[0].t0_s, -1e-3);
        QVERIFY(set->findings.empty());
    }
    for (const char *name : {"dt", "Ts", "ts", "Tinterval"}) {
        const auto set = readBytes(
            Mat5().add("y", kMiDouble, signal()).add<double>(name, kMiDouble, {4e-7}).bytes());
        QVERIFY(set && near(set->shots[0].channels[0].sampleRate_Hz, 2.5e6));
    }
}

void TestMatRates::rate_byTimeVector()
{
    struct Row
    {
        const char *name;
        double step, rate_Hz, first_s;
        bool convention;
    };
    for (const Row &row : {Row{"t", 1e-6, 1e6, -3e-6, true}, Row{"Time", 1e-6, 1e6, -3e-6, true},
             Row{"t_ms", 0.001, 1e6, -3e-6, false}, Row{"time_us", 0.5, 2e6, -1.5e-6, false},
             Row{"time_s", 2e-8, 5e7, -6e-8, false}}) {
        const auto set = readBytes(Mat5()
                                       .add(row.name, kMiDouble, axis(-3 * row.step, row.step))
                                       .add("y", kMiDouble, signal())
                                       .add("other", kMiDouble, signal(30))
                                       .bytes());
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots[0].channels.size(), std::size_t(2));
        const Channel *y = channelNamed(set->shots[0], "y");
        QVERIFY2(near(y->sampleRate_Hz, row.rate_Hz), row.name);
        QVERIFY(near(y->t0_s, row.first_s));
        QCOMPARE(channelNamed(set->shots[0], "other")->sampleRate_Hz, 0.0);
        QCOMPARE(hasFinding(set->findings, "CAP-016"), row.convention);
        if (row.convention)
            QCOMPARE(set->findings[0].severity, Severity::Info);
    }
    // A scalar tells the unit of a vector that does not.
    const auto set = readBytes(Mat5()
                                   .add("t", kMiDouble, axis(-0.002, 0.001))
                                   .add<double>("fs", kMiDouble, {1e6})
                                   .add("y", kMiDouble, signal())
                                   .bytes());
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 1e6);
    QVERIFY(near(set->shots[0].channels[0].t0_s, -2e-6));
    QVERIFY(set->findings.empty());
}

void TestMatRates::rate_byUnnamedColumn_isAQuestion()
{
    for (const bool first : {true, false}) {
        const std::vector<double> times = axis(0.0, 0.001);
        const std::vector<double> values
            = first ? joined(times, signal()) : joined(signal(), times);
        const QByteArray file = Mat5().add("M", kMiDouble, values, {20, 2}).bytes();
        const auto asked = readBytes(file);
        QVERIFY2(asked.has_value(), sentence(asked).c_str());
        QCOMPARE(asked->shots[0].channels.size(), std::size_t(1));
        QCOMPARE(asked->shots[0].channels[0].name, std::string(first ? "M 2" : "M 1"));
        QCOMPARE(asked->shots[0].channels[0].sampleRate_Hz, 0.0);
        QVERIFY(hasFinding(asked->findings, "CAP-016"));
        QVERIFY(contains(english(asked->findings[0].message), "1 MHz if milliseconds"));
        ImportSettings settings;
        settings.sampleRate_Hz = 1e6;
        const auto told = readBytes(file, settings);
        QVERIFY(told && told->findings.empty());
        QCOMPARE(told->shots[0].channels[0].sampleRate_Hz, 1e6);
    }
    // A counter is no time, and neither is a column that only begins like one.
    std::vector<double> bent = axis(0.0, 0.001);
    bent[10] += 5e-4;
    for (const std::vector<double> &values : {axis(1.0, 1.0), bent}) {
        const auto set
            = readBytes(Mat5().add("M", kMiDouble, joined(values, signal()), {20, 2}).bytes());
        QVERIFY(set && set->findings.empty());
        QCOMPARE(set->shots[0].channels.size(), std::size_t(2));
    }
}

void TestMatRates::rate_statedTwice_isNoRateUnlessTheSame()
{
    const auto rateOf = [this](Mat5 &file, std::size_t findings) {
        const auto set = readBytes(file.add("y", kMiDouble, signal()).bytes());
        if (!set || set->findings.size() != findings
            || (findings > 0 && set->findings[0].id != "CAP-003"))
            return -1.0;
        return set->shots[0].channels[0].sampleRate_Hz;
    };
    const auto scalars = [](double fs, double sampleRate) {
        Mat5 file;
        file.add<double>("fs", kMiDouble, {fs}).add<double>("sample_rate", kMiDouble, {sampleRate});
        return file;
    };
    Mat5 twoRates = scalars(1e6, 2e6), same = scalars(1e6, 1e6);
    QCOMPARE(rateOf(twoRates, 1), 0.0);
    QCOMPARE(rateOf(same, 0), 1e6);
    Mat5 oneIsThatOfTheTimes = scalars(2e6, 1e6);
    oneIsThatOfTheTimes.add("t_s", kMiDouble, axis(0.0, 1e-6));
    QCOMPARE(rateOf(oneIsThatOfTheTimes, 1), 0.0);
    const auto vectors = [](const char *first, double step, const char *second, double other) {
        Mat5 file;
        file.add(first, kMiDouble, axis(0.0, step)).add(second, kMiDouble, axis(0.0, other));
        return file;
    };
    Mat5 twoSteps = vectors("t_s", 1e-6, "time_s", 2e-6);
    QCOMPARE(rateOf(twoSteps, 1), 0.0);
    Mat5 twoStepsWithoutUnit = vectors("t", 1e-6, "time", 1e-3);
    QCOMPARE(rateOf(twoStepsWithoutUnit, 1), 0.0);
    Mat5 otherUnit = vectors("t_s", 1e-6, "time_us", 2.0);
    QCOMPARE(rateOf(otherUnit, 1), 0.0);
    Mat5 sameInOtherUnits = vectors("t_s", 1e-6, "time_us", 1.0);
    QVERIFY(near(rateOf(sameInOtherUnits, 0), 1e6));
}

void TestMatRates::rate_contradictions_areNoRate()
{
    const auto vector = readBytes(Mat5()
                                      .add("t", kMiDouble, axis(0.0, 1e-6))
                                      .add<double>("fs", kMiDouble, {1.1e6})
                                      .add("y", kMiDouble, signal())
                                      .add("z", kMiDouble, signal())
                                      .bytes());
    QVERIFY2(vector.has_value(), sentence(vector).c_str());
    QCOMPARE(vector->shots[0].channels[0].sampleRate_Hz, 0.0);
    QCOMPARE(vector->findings.size(), std::size_t(1)); // once, not per channel
    QCOMPARE(vector->findings[0].id, std::string("CAP-003"));
    const auto known = readBytes(Mat5()
                                     .add("t_us", kMiDouble, axis(0.0, 0.001))
                                     .add<double>("fs", kMiDouble, {1e6}) // fits ms only
                                     .add("y", kMiDouble, signal())
                                     .bytes());
    QVERIFY(known && hasFinding(known->findings, "CAP-003"));
    QCOMPARE(known->shots[0].channels[0].sampleRate_Hz, 0.0);
    const auto scalars = readBytes(Mat5()
                                       .add<double>("fs", kMiDouble, {1e6})
                                       .add<double>("dt", kMiDouble, {2e-6})
                                       .add("y", kMiDouble, signal())
                                       .bytes());
    QVERIFY(scalars && hasFinding(scalars->findings, "CAP-003"));
    QCOMPARE(scalars->shots[0].channels[0].sampleRate_Hz, 0.0);
}

void TestMatRates::rate_irregularTimes_areNoRate()
{
    std::vector<double> gap = axis(0.0, 1e-6);
    gap[12] += 3e-7;
    std::vector<double> falling = axis(0.0, -1e-6);
    std::vector<double> drifting{0.0};
    for (int k = 1; k < 2000; ++k)
        drifting.push_back(drifting.back() + (k < 1000 ? 1e-6 : 1.009e-6));
    for (const std::vector<double> &times :
        {gap, falling, std::vector<double>(20, 0.0), drifting}) {
        const std::vector<double> values(times.size(), 0.25);
        const auto set
            = readBytes(Mat5().add("t", kMiDouble, times).add("y", kMiDouble, values).bytes());
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 0.0);
        QVERIFY(hasFinding(set->findings, "CAP-016"));
        QCOMPARE(set->findings[0].severity, Severity::Caution);
    }
}

void TestMatRates::temperature_isNoTime()
{
    const auto set = readBytes(Mat5().add("T", kMiDouble, axis(290.0, 0.5)).bytes());
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->shots[0].channels[0].name, std::string("T"));
    QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 0.0);
}

DYNCAL_TEST(TestMatRates)
#include "tst_mat_rates.moc"
