// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What TDMS files tell beside their samples: names, rates, units, groups and notes.

#include "core/capture/formats/tdms/tdms_types.h"
#include "core/capture/opening/capture_open.h"
#include "tests/core/capture/formats/tdms/tdms_test_support.h"
#include "tests/support/test_program.h"

using namespace dyncal;
using namespace dyncal::testing;

namespace {

using Segment = TdmsSegment;

constexpr std::uint32_t kFresh = Segment::kMetaData | Segment::kNewList | Segment::kRawData;
constexpr const char *kA = "/'group'/'a'";

Segment waveform(double increment)
{
    Segment segment(kFresh);
    segment.channel<std::int16_t>(kA, 2).property("wf_increment", increment);
    segment.data().all<std::int16_t>({1, 2});
    return segment;
}

/// A log of SignalExpress with one channel of one value per group.
struct LogGroup
{
    std::string name;
    std::int32_t decimation;
    std::int32_t interval;
    std::int16_t value;
};

std::string signalExpressLog(const std::vector<LogGroup> &groups, bool complete)
{
    Segment segment(kFresh);
    segment.object("/").property("WriterName", "LabVIEW SignalExpress 2011");
    segment.property("recording-complete", complete);
    for (const LogGroup &group : groups) {
        segment.object("/'" + group.name + "'").property("DecimationLevel", group.decimation);
        segment.property("IntervalIndex", group.interval);
        segment.channel<std::int16_t>("/'" + group.name + "'/'ai0'", 1);
        segment.data().add(group.value);
    }
    return segment.bytes();
}

} // namespace

class TestTdmsNotes : public QObject
{
    Q_OBJECT

private slots:
    void waveformUnit_scalesOrIsRefused_data()
    {
        QTest::addColumn<QByteArray>("property");
        QTest::addColumn<QByteArray>("value");
        QTest::addColumn<double>("unit_s"); ///< 0: no recording over time
        const auto row = [](const char *property, const char *value, double unit_s) {
            QTest::addRow("%s %s", property, value)
                << QByteArray(property) << QByteArray(value) << unit_s;
        };
        row("wf_xunit_string", "", 1.0);
        row("wf_xunit_string", "s", 1.0);
        row("wf_xunit_string", "ms", 1e-3);
        row("wf_xunit_string", "Hz", 0.0);
        row("wf_xunit_string", "m", 0.0);
        row("wf_xname", "Time", 1.0);
        row("wf_xname", "Frequency", 0.0);
    }

    void waveformUnit_scalesOrIsRefused()
    {
        QFETCH(QByteArray, property);
        QFETCH(QByteArray, value);
        QFETCH(double, unit_s);
        Segment segment;
        segment.channel<std::int16_t>("/'group'/'a'", 2);
        segment.property("wf_increment", 0.25).property("wf_start_offset", -3.0);
        segment.property(property.toStdString(), value.constData());
        segment.data().add<std::int16_t>(1).add<std::int16_t>(2);
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(set.has_value(), unit_s > 0.0);
        if (unit_s == 0.0) {
            QVERIFY2(contains(sentence(set), value.toStdString()), sentence(set).c_str());
            return;
        }
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 4.0 / unit_s);
        QCOMPARE(set->shots[0].channels[0].t0_s, -3.0 * unit_s);
    }

    void names_withQuotesSlashesAndUnicode_arePlain()
    {
        Segment segment;
        segment.channel<std::int16_t>("/'Dr. T''s/lab'/'p \xCE\xB1/''x'''", 1);
        segment.data().add<std::int16_t>(1);
        const auto set = m_folder.read(segment.bytes());
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots[0].channels[0].name, std::string("p \xCE\xB1/'x'"));
    }

    void waveform_givesRateStartAndUnit()
    {
        Segment segment = waveform(1e-8);
        segment.property("wf_start_offset", -0.004).property("unit_string", "bar");
        segment.property("wf_samples", std::int32_t{99999});
        segment.property("wf_start_time", TdmsTime{3524551547, 12345678900000000000ULL});
        const auto set = m_folder.read(segment.bytes());
        QVERIFY2(set.has_value(), sentence(set).c_str());
        const Channel &channel = set->shots[0].channels[0];
        QCOMPARE(channel.sampleRate_Hz, 1e8);
        QCOMPARE(channel.t0_s, -0.004);
        QCOMPARE(channel.unit, std::string("bar"));
        QCOMPARE(channel.samples.size(), Index{2});
        // 12345678900000000000 / 2^64 = 0.66926059...: from exact integer arithmetic in Python.
        QCOMPARE(
            set->shots[0].notes.at("start_utc"), std::string("2015-09-08T10:05:47.669260594209Z"));
        QCOMPARE(set->shots[0].notes.at("start_1904"),
            std::string("3524551547 s + 12345678900000000000 / 2^64 s"));
    }

    void waveform_rateHasNoDigitsOfRounding()
    {
        const auto set = m_folder.read(waveform(1.9999999999999998e-05).bytes());
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 50000.0);
    }

    void waveform_withoutOrBadIncrement_asksForTheRate()
    {
        for (const double increment : {0.0, -1e-6, kNan, 1e-320, HUGE_VAL}) {
            const auto set = m_folder.read(waveform(increment).bytes());
            QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 0.0);
            QVERIFY(hasFinding(set->findings, "CAP-003"));
        }
    }

    void isoText_knowsTheCalendarAndItsEnds()
    {
        QCOMPARE(isoText({0, 1}), std::string());
        QCOMPARE(isoText({1, 0}), std::string("1904-01-01T00:00:01Z"));
        QCOMPARE(isoText({-1, std::uint64_t{1} << 63}), std::string("1903-12-31T23:59:59.5Z"));
        QCOMPARE(isoText({std::numeric_limits<std::int64_t>::max(), 0}), std::string());
        QCOMPARE(isoText({std::numeric_limits<std::int64_t>::min(), 0}), std::string());
        QCOMPARE(isoText({3155760000, ~std::uint64_t{0}}),
            std::string("2004-01-01T00:00:00.999999999999Z"));
    }

    void attributes_areKeptAsNotes()
    {
        Segment segment;
        segment.object("/").property("Author", "M. Curie").property("ambient", 21.5);
        segment.object("/'group'")
            .property("description", "shot 3")
            .property("n", std::int32_t{-4});
        segment.channel<std::int16_t>(kA, 1);
        segment.data().add<std::int16_t>(1);
        const auto set = m_folder.read(segment.bytes());
        const Attributes &notes = set->shots[0].notes;
        QCOMPARE(notes.at("operator"), std::string("M. Curie"));
        QCOMPARE(notes.at("comment"), std::string("shot 3"));
        QCOMPARE(notes.at("ambient"), std::string("21.5"));
        QCOMPARE(notes.at("n"), std::string("-4"));
    }

    void groupsOfEqualChannels_areShots()
    {
        Segment segment;
        for (const char *group : {"low", "high"}) {
            segment.channel<std::int16_t>(std::string("/'") + group + "'/'p'", 1);
            segment.channel<std::int16_t>(std::string("/'") + group + "'/'q'", 1);
        }
        segment.channel<std::int16_t>("/'log'/'T'", 1);
        segment.data().all<std::int16_t>({1, 2, 3, 4, 5});
        const auto set = readTdms(m_folder.write(segment.bytes()), {}, {});
        QCOMPARE(set->shots.size(), std::size_t{2});
        QCOMPARE(set->shots[0].label, std::string("record, low"));
        QCOMPARE(set->shots[1].label, std::string("record, high"));
        QCOMPARE(rawValuesOf(*channelNamed(set->shots[1], "q")), numbers(4));
        const Finding *left = findingWith(set->findings, "CAP-026");
        QVERIFY(left != nullptr && contains(english(left->message), "\"log\""));
    }

    void groupsOfOtherChannels_areOneShot()
    {
        Segment segment;
        segment.channel<std::int16_t>("/'x'/'p'", 1).channel<std::int16_t>("/'y'/'p'", 1);
        segment.channel<std::int16_t>("/'y'/'q'", 1);
        segment.data().all<std::int16_t>({1, 2, 3});
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(set->shots.size(), std::size_t{1});
        QCOMPARE(valuesIn(set, "x/p"), numbers(1));
        QCOMPARE(valuesIn(set, "y/p"), numbers(2));
        QCOMPARE(valuesIn(set, "q"), numbers(3));
    }

    void signalExpress_intervalsAreShots_thinnedCopiesAreLeftOut()
    {
        const auto set = m_folder.read(signalExpressLog(
            {{"i0 - All Data", 0, 0, 1}, {"i0 - Decimated Data_Level1", 1, 0, 2},
                {"i1 - All Data", 0, 1, 3}, {"i1 - Decimated Data_Level1", 1, 1, 4}},
            true));
        QCOMPARE(set->shots.size(), std::size_t{2});
        QCOMPARE(rawValuesOf(set->shots[0].channels[0]), numbers(1));
        QCOMPARE(rawValuesOf(set->shots[1].channels[0]), numbers(3));
        QVERIFY(!hasFinding(set->findings, "CAP-018"));
        QVERIFY(hasFinding(set->findings, "CAP-026"));
        QVERIFY(hasFinding(set->findings, "CAP-028"));
    }

    void signalExpress_unfinishedRecording_isSaid()
    {
        const auto set = m_folder.read(signalExpressLog({{"All Data", 0, 0, 1}}, false));
        QCOMPARE(set->shots.size(), std::size_t{1});
        QVERIFY(!contains(set->shots[0].label, ","));
        QVERIFY(hasFinding(set->findings, "CAP-018"));
    }

    void signalExpress_levelOfTheChannelAlone_counts()
    {
        Segment segment(kFresh);
        segment.channel<std::int16_t>("/'All Data'/'ai0'", 1);
        segment.property("DecimationLevel", std::int32_t{0});
        segment.channel<std::int16_t>("/'Decimated'/'ai0'", 1);
        segment.property("DecimationLevel", std::int32_t{1});
        segment.data().all<std::int16_t>({1, 2});
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(set->shots.size(), std::size_t{1});
        QCOMPARE(valuesIn(set, "ai0"), numbers(1));
    }

    void unknownVersion_isReadAndSaid()
    {
        Segment segment = waveform(1e-6);
        segment.version = 4714;
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(valuesIn(set, "a"), numbers(1, 2));
        QVERIFY(hasFinding(set->findings, "CAP-021"));
    }

    void changedFile_isNotRead()
    {
        const auto set = readTdms(m_folder.write(waveform(1e-6).bytes()), {}, {});
        const Channel channel = set->shots[0].channels[0];
        m_folder.write(waveform(1e-6).bytes() + "x");
        QVERIFY(!channel.samples.visitBlocks(0, 2, [](auto, Index) {}));
        QVERIFY(std::isnan(channel.samples.at(0)));
    }

    void registry_readsTdmsAndPassesOverItsIndex()
    {
        QTemporaryDir folder;
        const std::string bytes = waveform(1e-6).bytes();
        const QByteArray data(bytes.data(), static_cast<qsizetype>(bytes.size()));
        testing::write(folder.filePath("shot.tdms"), data);
        const std::string index
            = testing::write(folder.filePath("shot.tdms_index"), "TDSh" + data.mid(4));
        const auto set = readCaptures({folder.path().toStdString()}, {});
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->inputs.size(), std::size_t{1});
        QCOMPARE(set->inputs[0].format, std::string("tdms"));
        QVERIFY(!hasFinding(set->findings, "CAP-024"));
        const auto named = readCapture(index, {});
        QVERIFY(!named && findingId(named) == "CAP-001");
        QVERIFY2(contains(sentence(named), "open shot.tdms"), sentence(named).c_str());
    }

private:
    TdmsFolder m_folder;
};

DYNCAL_TEST(TestTdmsNotes)
#include "tst_tdms_notes.moc"
