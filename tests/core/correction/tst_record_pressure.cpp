// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/portable_random.h"
#include "core/correction/record_pressure.h"
#include "tests/support/known_sensor.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr double kRate_Hz = 5e6;
constexpr Index kCount = 20000;
constexpr double kT0_s = -1e-3;
constexpr double kPulse_s = 1.5e-3; ///< on the record's own axis
constexpr double kPeak_Pa = 1e5;
constexpr double kOffset_V = 0.3; ///< of the record without pressure
constexpr double kNoise_V = 1e-6;

Eigen::VectorXd truePressure()
{
    return kPeak_Pa * burst(kCount, kRate_Hz, kPulse_s - kT0_s, 20e-6, 0.0);
}

/// A record of a pulse on an offset, with noise.
Channel channelWithPulse(double noise_V = kNoise_V)
{
    RandomStream random(11, 1, 1);
    Eigen::VectorXd record = TrueSensor().recordOf(truePressure(), kRate_Hz).array() + kOffset_V;
    for (double &value : record)
        value += noise_V * random.nextNormal();
    Channel channel;
    channel.name = "blast";
    channel.role = ChannelRole::Dut;
    channel.sampleRate_Hz = kRate_Hz;
    channel.t0_s = kT0_s;
    channel.samples = RawSamples(std::vector<double>(record.begin(), record.end()));
    return channel;
}

const CorrectionFilter &filter()
{
    static const CorrectionFilter made
        = designCorrection(TrueSensor().known(), kRate_Hz, {150e3}).value();
    return made;
}

std::string whyRefused(const Channel &channel, const RecordOptions &options = {})
{
    const auto found = recordPressure(channel, 3, filter(), options);
    return found ? std::string() : english(found.error().message);
}

bool has(const std::string &text, const char *words)
{
    return text.find(words) != std::string::npos;
}

Channel withSamples(Channel channel, std::vector<double> values)
{
    channel.samples = RawSamples(std::move(values));
    return channel;
}

std::vector<double> samplesOf(const Channel &channel)
{
    const Eigen::VectorXd values = physicalValues(channel, 0, channel.samples.size());
    return {values.begin(), values.end()};
}

} // namespace

class TestRecordPressure : public QObject
{
    Q_OBJECT

private slots:
    void askedToStop_itStops()
    {
        std::stop_source stop;
        stop.request_stop();
        const auto found
            = recordPressure(channelWithPulse(), 1, filter(), {}, {stop.get_token(), {}});
        QVERIFY(!found && found.error().kind == ErrorKind::Cancelled);
    }

    /// The offset is taken off, the quiet stretch is found, the pulse has its size and its place.
    void pulse_comesBackAtItsTime()
    {
        const auto found = recordPressure(channelWithPulse(), 1, filter());
        QVERIFY2(found.has_value(), found ? "" : english(found.error().message).c_str());
        QVERIFY(isNear(found->level, kOffset_V, 1e-6));
        QVERIFY(std::abs(found->noiseSd / kNoise_V - 1.0) < 0.05);
        QCOMPARE(found->quiet_s.begin, kT0_s);
        QVERIFY(found->quiet_s.end > 0.5e-3 && found->quiet_s.end < kPulse_s - 60e-6);
        const CorrectedPressure &pressure = found->pressure;
        Index largest = 0;
        const double peak = pressure.pressure_Pa.maxCoeff(&largest);
        QVERIFY(std::abs(peak - kPeak_Pa) < 3.0 * pressure.u_Pa[largest] + 2e-4 * kPeak_Pa);
        const double at_s = pressure.time_s + double(largest) / kRate_Hz;
        QVERIFY(std::abs(at_s - kPulse_s) < 2e-6);
        const Eigen::VectorXd truth = truePressure();
        const auto first = static_cast<Index>(std::lround((pressure.time_s - kT0_s) * kRate_Hz));
        Index inside = 0;
        for (Index i = 0; i < pressure.pressure_Pa.size(); ++i)
            inside += std::abs(pressure.pressure_Pa[i] - truth[first + i])
                    <= pressure.k[i] * pressure.u_Pa[i] + 2e-4 * kPeak_Pa
                ? 1
                : 0;
        QVERIFY(double(inside) > 0.93 * double(pressure.pressure_Pa.size()));
    }

    /// Exactly what lies in the window, and the same numbers as of the whole recording.
    void window_isCutExactly()
    {
        const Channel channel = channelWithPulse();
        const Interval window{1.4e-3, 1.7e-3};
        const auto whole = recordPressure(channel, 1, filter());
        const auto part = recordPressure(channel, 1, filter(), {window});
        QVERIFY(part.has_value());
        const CorrectedPressure &cut = part->pressure;
        QVERIFY(std::abs(cut.time_s - window.begin) < 1e-9);
        QCOMPARE(cut.pressure_Pa.size(), Index(1500));
        QCOMPARE(cut.k.size(), Index(1500));
        QCOMPARE(cut.u_Pa.size(), Index(1500));
        const auto at
            = static_cast<Index>(std::lround((cut.time_s - whole->pressure.time_s) * kRate_Hz));
        const Eigen::VectorXd same = whole->pressure.pressure_Pa.segment(at, 1500);
        QVERIFY((same - cut.pressure_Pa).cwiseAbs().maxCoeff() < 1e-9 * kPeak_Pa);
        QVERIFY((whole->pressure.u_Pa.segment(at, 1500) - cut.u_Pa).cwiseAbs().maxCoeff()
            < 1e-6 * kPeak_Pa);
    }

    void window_beyondTheFilter_isRefusedOrCut()
    {
        const Channel channel = channelWithPulse();
        const auto early = recordPressure(channel, 1, filter(), {Interval{kT0_s, kT0_s + 1e-3}});
        QVERIFY(early.has_value() && early->pressure.time_s > kT0_s); // as far as it is known
        QVERIFY(has(whyRefused(channel, {Interval{kT0_s, kT0_s + 2e-6}}), "beyond the ends"));
        QVERIFY(has(whyRefused(channel, {Interval{7.0, 8.0}}), "has 0 samples"));
        const auto one = recordPressure(channel, 1, filter(), {Interval{0.0, 1e-9}});
        QCOMPARE(one->pressure.pressure_Pa.size(), Index(1));
    }

    void quietStretch_thatIsStated_isUsed()
    {
        const Channel channel = channelWithPulse();
        const auto found = recordPressure(channel, 1, filter(), {{}, Interval{-0.5e-3, 0.5e-3}});
        QVERIFY(found.has_value());
        QVERIFY(isNear(found->quiet_s.begin, -0.5e-3, 1e-6)
            && isNear(found->quiet_s.end, 0.5e-3, 1e-6));
        const auto behind = recordPressure(channel, 1, filter(), {{}, Interval{2e-3, 2.9e-3}});
        QVERIFY(behind.has_value()); // it may lie behind the pressure too
        QVERIFY(std::abs(behind->level - kOffset_V) < 1e-6);
    }

    void quietStretch_thatIsTooShort_isRefused()
    {
        QVERIFY(has(
            whyRefused(channelWithPulse(), {{}, Interval{0.0, 20e-6}}), "has 100 samples without"));
        QVERIFY(
            has(whyRefused(channelWithPulse(), {{}, Interval{5.0, 6.0}}), "has 0 samples without"));
    }

    void recordWithoutAPulse_asksForTheQuietStretch()
    {
        RandomStream random(4, 1, 1);
        std::vector<double> values(20000);
        for (double &value : values)
            value = kNoise_V * random.nextNormal();
        const Channel channel = withSamples(channelWithPulse(), values);
        QVERIFY(has(whyRefused(channel), "--quiet"));
        QVERIFY(recordPressure(channel, 3, filter(), {{}, Interval{kT0_s, 0.0}}).has_value());
    }

    void otherUnitOrRate_isRefused()
    {
        Channel channel = channelWithPulse();
        channel.unit = "mV";
        QVERIFY(has(whyRefused(channel), "Shot 3: channel blast is in \"mV\""));
        channel.unit = "";
        QVERIFY(has(whyRefused(channel), "state the unit"));
        channel = channelWithPulse();
        channel.sampleRate_Hz = 4.9e6;
        QVERIFY(has(whyRefused(channel), "recorded at 4.9 MHz"));
    }

    void samplesThatAreNoNumbers_areRefused()
    {
        const Channel channel = channelWithPulse();
        std::vector<double> values = samplesOf(channel);
        values[12500] = NAN;
        const Interval quiet{kT0_s, 0.0};
        QVERIFY(has(whyRefused(withSamples(channel, values), {{}, quiet}), "no numbers"));
        values = samplesOf(channel);
        values[100] = INFINITY;
        QVERIFY(has(whyRefused(withSamples(channel, values), {{}, quiet}),
            "without pressure that are no numbers"));
    }

    void emptyAndShortRecords_areRefused()
    {
        const Channel channel = channelWithPulse();
        QVERIFY(!whyRefused(withSamples(channel, {})).empty());
        QVERIFY(!whyRefused(withSamples(channel, {1.0})).empty());
        QVERIFY(!whyRefused(
            withSamples(channel, std::vector<double>(300, 0.0)), {{}, Interval{-1.0, 1.0}})
                     .empty());
    }

    /// Counts of a converter whose noise is below one step: the u of rounding is there.
    void roundedRecord_hasTheUOfItsRounding()
    {
        const double step_V = 1e-5;
        std::vector<double> values = samplesOf(channelWithPulse(0.0));
        for (double &value : values)
            value = step_V * std::round(value / step_V);
        const Channel channel = withSamples(channelWithPulse(), values);
        const auto found = recordPressure(channel, 1, filter(), {{}, Interval{kT0_s, 1e-3}});
        QVERIFY2(found.has_value(), found ? "" : english(found.error().message).c_str());
        QVERIFY(found->noiseSd > 0.0);
        QVERIFY(found->pressure.u_noise_Pa > 0.0);
    }

    void beyond_isHandedOn()
    {
        const auto found = recordPressure(channelWithPulse(), 1, filter(), {{}, {}, 1234.0});
        QVERIFY(found.has_value());
        QCOMPARE(found->pressure.bound_Pa.minCoeff(), 1234.0);
        QCOMPARE(found->pressure.bound_Pa.maxCoeff(), 1234.0);
    }

    /// Of the record's zero, per ms in shares of the peak's voltage.
    void driftBeforeThePressure_isTold()
    {
        const Channel still = channelWithPulse();
        QVERIFY(recordPressure(still, 1, filter())->findings.empty());
        const double peak_V = kPeak_Pa / filter().gain();
        for (const double per_ms : {0.002, -0.02}) {
            std::vector<double> values = samplesOf(still);
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] += per_ms * peak_V * 1e3 * static_cast<double>(i) / kRate_Hz;
            const auto found = recordPressure(withSamples(still, values), 2, filter());
            QCOMPARE(found->findings.size(), std::size_t(1));
            QCOMPARE(found->findings[0].id, std::string("COR-001"));
            QCOMPARE(found->findings[0].shot, Index(2));
            const double end_ms = 1e3
                * (found->pressure.time_s
                    + static_cast<double>(found->pressure.pressure_Pa.size()) / kRate_Hz);
            const double middle_ms = 0.5e3 * (found->quiet_s.begin + found->quiet_s.end);
            QVERIFY(
                isNear(*found->findings[0].value, per_ms * kPeak_Pa * (end_ms - middle_ms), 0.02));
        }
    }
};

DYNCAL_TEST(TestRecordPressure)
#include "tst_record_pressure.moc"
