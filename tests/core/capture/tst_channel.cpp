// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/content_hash.h"
#include "core/capture/capture_set.h"
#include "core/capture/channel.h"
#include "core/capture/natural_order.h"
#include "core/capture/raw_samples.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

Channel channelOf(RawSamples::Counts counts)
{
    Channel channel;
    channel.samples = RawSamples(std::move(counts));
    channel.sampleRate_Hz = 1e6;
    return channel;
}

} // namespace

class TestChannel : public QObject
{
    Q_OBJECT

private slots:
    void physicalValue_polynomial_isItsSum();
    void physicalValue_fewCoefficients_areConstantOrZero();
    void physicalValue_polarityAndScale_multiplyTheWholePolynomial();
    void physicalValue_invalidSample_staysInvalid();
    void physicalValues_range_isElementByElement();
    void physicalValues_emptyRange_isEmpty();
    void physicalValues_millionSamples_keepTheirPlace();
    void times_followRateAndStart();
    void roleNames_andBack_data();
    void roleNames_andBack();
    void referenceNames_areTheWordsOfRecipes();
    void rawSamples_everyType_keepsValuesAndBytes();
    void rawSamples_copy_sharesTheMemory();
    void rawSamples_default_isEmpty();
    void levelNames_andBack();
    void environment_default_isNotRecorded();
    void channelWithRole_isTheFirstOrNone();
    void tubeNumber_readsNumbersOnly_data();
    void tubeNumber_readsNumbersOnly();
    void naturalLess_knownNames_data();
    void naturalLess_knownNames();
    void naturalLess_isAStrictTotalOrder();
    void naturalLess_longDigits_doNotOverflow();
};

void TestChannel::physicalValue_polynomial_isItsSum()
{
    Channel channel;
    channel.polynomial = {1.5, -2.0, 0.25, 0.125}; // exact in binary, so is the oracle
    for (const double x : {-4.0, -1.0, 0.0, 0.5, 3.0, 1024.0})
        QCOMPARE(physicalValue(channel, x), 1.5 - 2.0 * x + 0.25 * x * x + 0.125 * x * x * x);
}

void TestChannel::physicalValue_fewCoefficients_areConstantOrZero()
{
    Channel channel;
    QCOMPARE(physicalValue(channel, 7.0), 7.0); // the default is the identity
    channel.polynomial = {3.5};
    QCOMPARE(physicalValue(channel, 7.0), 3.5);
    channel.polynomial = {};
    QCOMPARE(physicalValue(channel, 7.0), 0.0);
}

void TestChannel::physicalValue_polarityAndScale_multiplyTheWholePolynomial()
{
    Channel channel;
    channel.polynomial = {10.0, 2.0};
    channel.polarity = -1.0;
    channel.userScale = 0.5;
    QCOMPARE(physicalValue(channel, 4.0), -9.0); // the offset turns too
}

void TestChannel::physicalValue_invalidSample_staysInvalid()
{
    Channel channel;
    channel.polynomial = {1.0, 2.0, 3.0};
    QVERIFY(std::isnan(physicalValue(channel, kNan)));
    QVERIFY(!std::isfinite(physicalValue(channel, kInf)));
    QVERIFY(!std::isfinite(physicalValue(channel, -kInf)));
}

void TestChannel::physicalValues_range_isElementByElement()
{
    const std::vector<RawSamples::Counts> records{std::vector<std::int16_t>{-32768, 0, 5, 32767},
        std::vector<std::int32_t>{-2147483647 - 1, 0, 5, 2147483647},
        std::vector<float>{-1.5F, 0.0F, 5.0F, 3e38F}, std::vector<double>{-1e300, 0.0, 5.0, 1e300}};
    for (const RawSamples::Counts &counts : records) {
        Channel channel = channelOf(counts);
        channel.polynomial = {1.0, -0.5};
        const Eigen::VectorXd all = physicalValues(channel, 0, 4);
        const Eigen::VectorXd inner = physicalValues(channel, 1, 2);
        for (Index i = 0; i < 4; ++i)
            QCOMPARE(all[i], 1.0 - 0.5 * channel.samples.at(i));
        QCOMPARE(inner[0], 1.0);
        QCOMPARE(inner[1], -1.5);
    }
}

void TestChannel::physicalValues_emptyRange_isEmpty()
{
    QCOMPARE(physicalValues(channelOf(std::vector<float>{}), 0, 0).size(), Index(0));
    QCOMPARE(physicalValues(channelOf(std::vector<float>{1.0F}), 1, 0).size(), Index(0));
}

void TestChannel::physicalValues_millionSamples_keepTheirPlace()
{
    std::vector<std::int32_t> counts(1000000);
    for (std::size_t i = 0; i < counts.size(); ++i)
        counts[i] = static_cast<std::int32_t>(i);
    const Channel channel = channelOf(std::move(counts));
    const Eigen::VectorXd values = physicalValues(channel, 1000, 999000);
    QVERIFY(
        values == Eigen::VectorXd::LinSpaced(999000, 1000.0, 999999.0).array().round().matrix());
}

void TestChannel::times_followRateAndStart()
{
    Channel channel = channelOf(std::vector<std::int16_t>(500, 0));
    channel.t0_s = -0.25e-3;
    QCOMPARE(channel.duration_s(), 5e-4);
    QCOMPARE(channel.timeOf_s(0), -0.25e-3);
    QCOMPARE(channel.timeOf_s(250), 0.0);
}

void TestChannel::roleNames_andBack_data()
{
    QTest::addColumn<QString>("word");
    QTest::addColumn<int>("role");
    QTest::addColumn<QString>("name");
    const auto row = [](const char *word, ChannelRole role, const char *name) {
        QTest::newRow(word) << word << static_cast<int>(role) << name;
    };
    row("dut", ChannelRole::Dut, "dut");
    row("driven_side", ChannelRole::DrivenSide, "driven_side");
    row("driver", ChannelRole::Driver, "driver");
    row("trigger", ChannelRole::Trigger, "trigger");
    row("other", ChannelRole::Other, "other");
    row("velocity", ChannelRole::DrivenSide, "driven_side");
    row("driver_static", ChannelRole::Driver, "driver");
    row("DUT", ChannelRole::Other, "other");
    row("", ChannelRole::Other, "other");
    row("dut ", ChannelRole::Other, "other");
}

void TestChannel::roleNames_andBack()
{
    QFETCH(QString, word);
    QFETCH(int, role);
    QFETCH(QString, name);
    const ChannelRole read = channelRoleFromName(word.toStdString());
    QCOMPARE(static_cast<int>(read), role);
    QCOMPARE(QString(channelRoleName(read)), name);
}

void TestChannel::referenceNames_areTheWordsOfRecipes()
{
    QCOMPARE(QString(pressureReferenceName(PressureReference::Gauge)), QString("gauge"));
    QCOMPARE(QString(pressureReferenceName(PressureReference::Absolute)), QString("absolute"));
    QCOMPARE(QString(pressureReferenceName(PressureReference::Unknown)), QString());
}

void TestChannel::rawSamples_everyType_keepsValuesAndBytes()
{
    const auto check = [](auto type, bool integer) {
        using T = decltype(type);
        const std::vector<T> values{T(1), T(-2), T(300)};
        const RawSamples samples{RawSamples::Counts(values)};
        return samples.size() == 3 && samples.isInteger() == integer && samples.at(1) == -2.0
            && samples.at(2) == 300.0 && bytesPerSample(samples.type()) == Index(sizeof(T))
            && sha256OfSamples(samples) == sha256Hex(std::as_bytes(std::span(values)));
    };
    QVERIFY(check(std::int16_t(), true));
    QVERIFY(check(std::int32_t(), true));
    QVERIFY(check(float(), false));
    QVERIFY(check(double(), false));
    const RawSamples one{RawSamples::Counts(std::vector<std::int16_t>{0x0102})};
    QCOMPARE(sha256OfSamples(one), sha256Hex(std::string_view("\x02\x01"))); // little endian
}

void TestChannel::rawSamples_copy_sharesTheMemory()
{
    const RawSamples samples{RawSamples::Counts(std::vector<double>(1000, 1.0))};
    const RawSamples copy = samples;
    const auto addressOf = [](const RawSamples &of) {
        const void *address = nullptr;
        of.visitBlocks(0, of.size(), [&](auto values, Index) { address = values.data(); });
        return address;
    };
    QCOMPARE(addressOf(copy), addressOf(samples));
}

void TestChannel::rawSamples_default_isEmpty()
{
    const RawSamples samples;
    QCOMPARE(samples.size(), Index(0));
    QVERIFY(samples.isInMemory());
}

void TestChannel::levelNames_andBack()
{
    for (const ShotLevel level :
        {ShotLevel::None, ShotLevel::Low, ShotLevel::Medium, ShotLevel::High})
        QCOMPARE(shotLevelFromName(shotLevelName(level)), level);
    QCOMPARE(shotLevelFromName("Low"), ShotLevel::None);
    QCOMPARE(shotLevelFromName("highest"), ShotLevel::None);
}

void TestChannel::environment_default_isNotRecorded()
{
    const Environment e;
    for (const double value : {e.p1_Pa, e.u_p1_Pa, e.T1_K, e.u_T1_K, e.p4_Pa, e.T4_K,
             e.ambientPressure_Pa, e.ambientT_K, e.relativeHumidity})
        QVERIFY(std::isnan(value));
}

void TestChannel::channelWithRole_isTheFirstOrNone()
{
    Shot shot;
    QVERIFY(!shot.channelWithRole(ChannelRole::Dut));
    shot.channels.resize(3);
    shot.channels[1].role = shot.channels[2].role = ChannelRole::Dut;
    QCOMPARE(shot.channelWithRole(ChannelRole::Dut), &shot.channels[1]);
    QCOMPARE(shot.channelWithRole(ChannelRole::Other), &shot.channels[0]);
    QVERIFY(!shot.channelWithRole(ChannelRole::Driver));
}

void TestChannel::tubeNumber_readsNumbersOnly_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("isNumber");
    QTest::addColumn<double>("value");
    QTest::newRow("plain") << "0.97" << true << 0.97;
    QTest::newRow("exponent") << "97e-2" << true << 0.97;
    QTest::newRow("negative") << "-3" << true << -3.0;
    QTest::newRow("comma") << "0,97" << false << 0.0;
    QTest::newRow("unit") << "0.97 m" << false << 0.0;
    QTest::newRow("word") << "long" << false << 0.0;
    QTest::newRow("empty") << "" << false << 0.0;
}

void TestChannel::tubeNumber_readsNumbersOnly()
{
    QFETCH(QString, text);
    QFETCH(bool, isNumber);
    QFETCH(double, value);
    CaptureSet set;
    set.tube["driver_length_m"] = text.toStdString();
    const auto number = set.tubeNumber("driver_length_m");
    QCOMPARE(number.has_value(), isNumber);
    QCOMPARE(number.value_or(0.0), value);
    QVERIFY(!set.tubeNumber("driven_length_m"));
}

void TestChannel::naturalLess_knownNames_data()
{
    QTest::addColumn<QString>("first");
    QTest::addColumn<QString>("second");
    QTest::newRow("count") << "shot 9"
                           << "shot 10";
    QTest::newRow("prefix") << "shot"
                            << "shot 1";
    QTest::newRow("empty") << ""
                           << "a";
    QTest::newRow("digits before letters") << "1"
                                           << "a";
    QTest::newRow("second number") << "a2b9"
                                   << "a2b10";
    QTest::newRow("zeros") << "a007"
                           << "a7";
    QTest::newRow("zeros count") << "a007"
                                 << "a8";
    QTest::newRow("only zeros") << "a0"
                                << "a1";
    QTest::newRow("behind the number") << "2.h5"
                                       << "2a.h5";
    QTest::newRow("bytes") << "B"
                           << "a";
}

void TestChannel::naturalLess_knownNames()
{
    QFETCH(QString, first);
    QFETCH(QString, second);
    QVERIFY(naturalLess(first.toStdString(), second.toStdString()));
    QVERIFY(!naturalLess(second.toStdString(), first.toStdString()));
}

void TestChannel::naturalLess_isAStrictTotalOrder()
{
    const std::vector<std::string> names{"", "0", "00", "01", "1", "1a", "01a", "10", "2", "a",
        "a1", "a01", "a1b", "a1b2", "a1b02", "a01b2", "a2", "a10", "b", "\xc3\xa5", "1.5", "1.10"};
    for (const std::string &a : names) {
        for (const std::string &b : names) {
            QCOMPARE(int(naturalLess(a, b)) + int(naturalLess(b, a)), a == b ? 0 : 1);
            for (const std::string &c : names) {
                if (naturalLess(a, b) && naturalLess(b, c))
                    QVERIFY2(naturalLess(a, c),
                        qPrintable(QString("%1 %2 %3").arg(a.c_str(), b.c_str(), c.c_str())));
            }
        }
    }
}

void TestChannel::naturalLess_longDigits_doNotOverflow()
{
    const std::string nines(40, '9');
    QVERIFY(naturalLess(nines, "1" + std::string(40, '0')));
    QVERIFY(naturalLess("18446744073709551615", "18446744073709551616"));
}

DYNCAL_TEST(TestChannel)
#include "tst_channel.moc"
