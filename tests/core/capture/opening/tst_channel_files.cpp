// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Oscilloscope files that hold one channel each: what is one recording, and what only looks so.

#include "core/capture/opening/channel_files.h"
#include "tests/support/test_program.h"

#include "core/capture/import_rules.h"
#include "tests/core/capture/capture_test_support.h"

#include <QTemporaryDir>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// A file with so many shots of one channel of eight samples.
void addFile(CaptureSet &set, const std::string &path, const std::string &channel, int shots = 1,
    const std::string &format = "lecroy-trc")
{
    InputFile input;
    input.path = path;
    input.file = path.substr(path.find_last_of('/') + 1);
    input.format = format;
    for (int k = 0; k < shots; ++k) {
        Shot shot;
        shot.input = std::ssize(set.inputs);
        shot.inFile = k + 1;
        shot.notes["recorded"] = "2025-03-02 14:05:07.25";
        Channel made;
        made.name = channel;
        made.sampleRate_Hz = 1e8;
        made.t0_s = -1e-6;
        made.samples = RawSamples(std::vector<std::int16_t>(8, static_cast<std::int16_t>(k)));
        shot.channels.push_back(std::move(made));
        set.shots.push_back(std::move(shot));
    }
    set.inputs.push_back(std::move(input));
}

CaptureSet pair()
{
    CaptureSet set;
    addFile(set, "/d/C1shot00001.trc", "C1");
    addFile(set, "/d/C2shot00001.trc", "C2");
    return set;
}

std::vector<std::string> namesOf(const Shot &shot)
{
    std::vector<std::string> names;
    for (const Channel &channel : shot.channels)
        names.push_back(channel.name);
    return names;
}

using Names = std::vector<std::string>;

} // namespace

class TestChannelFiles : public QObject
{
    Q_OBJECT

private slots:
    void channelFileName_ofWhatScopesWrite_isTheirChannel_data()
    {
        QTest::addColumn<QByteArray>("path");
        QTest::addColumn<int>("channel"); // 0 = none
        const auto row = [](const char *path, int channel) {
            QTest::newRow(path) << QByteArray(path) << channel;
        };
        row("/d/C1Trace00007.trc", 1);
        row("/d/C4--shot--00000.trc", 4);
        row("C2shot00001.trc", 2);
        row("/C1/C3shot.trc", 3); // the folder does not count
        row("/d/DHO824-ch2.bin", 2);
        row("/d/NewFile3_CH1.wfm", 1);
        row("/d/RefCurve_2025_chan8.bin", 8);
        row("/d/run 5 Channel2.wfm", 2);
        row("/d/C9shot.trc", 0); // no scope has nine
        row("/d/C12shot.trc", 0);
        row("/d/ch0.bin", 0);
        row("/d/run_c1abc.bin", 0); // a word that begins so
        row("/d/arc1.bin", 0);
        row("/d/C1--CH2.trc", 0); // which?
        row("/d/shot00001.trc", 0);
    }
    void channelFileName_ofWhatScopesWrite_isTheirChannel()
    {
        QFETCH(QByteArray, path);
        QFETCH(int, channel);
        const auto name = channelFileName(path.toStdString());
        QCOMPARE(name ? name->channel : 0, channel);
        if (name)
            QCOMPARE(path.at(static_cast<qsizetype>(name->digit)), char('0' + channel));
    }

    void join_twoChannels_areOneShotOfBothFiles()
    {
        CaptureSet set = pair();
        joinChannelFiles(set);
        QCOMPARE(set.shots.size(), std::size_t(1));
        QCOMPARE(namesOf(set.shots[0]), (Names{"C1", "C2"}));
        QCOMPARE(set.inputs.size(), std::size_t(2));
        QCOMPARE(inputOf(set.shots[0], set.shots[0].channels[0]), Index(0));
        QCOMPARE(inputOf(set.shots[0], set.shots[0].channels[1]), Index(1));
        QVERIFY(comesFrom(set.shots[0], 1) && !comesFrom(set.shots[0], 2));
        QCOMPARE(set.findings.size(), std::size_t(1));
        QCOMPARE(set.findings[0].id, std::string("CAP-029"));
        QVERIFY(set.findings[0].severity == Severity::Info);
        QVERIFY(contains(
            english(set.findings[0].message), "C1shot00001.trc, C2shot00001.trc were taken"));
    }

    void join_sequences_pairTheirSegments()
    {
        CaptureSet set;
        addFile(set, "/d/C2seq.trc", "C2", 3); // named first: its shots come first
        addFile(set, "/d/other.trc", "C1", 1);
        addFile(set, "/d/C1seq.trc", "C1", 3);
        set.findings.push_back({.id = "CAP-016", .severity = Severity::Caution, .shot = 4});
        set.findings.push_back({.id = "CAP-026", .severity = Severity::Info, .shot = 6});
        joinChannelFiles(set);
        QCOMPARE(set.shots.size(), std::size_t(4));
        for (std::size_t k = 0; k < 3; ++k) {
            QCOMPARE(namesOf(set.shots[k]), (Names{"C2", "C1"}));
            QCOMPARE(set.shots[k].channels[1].samples.at(0), double(k));
        }
        QCOMPARE(set.findings[0].shot, Index(4)); // the other file's, where it was
        QCOMPARE(set.findings[1].shot, Index(2)); // second segment, now with its twin
    }

    void join_again_orWithAThirdFile_keepsNumbersAndSaysAll()
    {
        CaptureSet set = pair();
        addFile(set, "/d/later.trc", "C1");
        joinChannelFiles(set);
        const CaptureSet before = set;
        joinChannelFiles(set);
        QCOMPARE(set.shots.size(), before.shots.size());
        QVERIFY(set.findings == before.findings);
        addFile(set, "/d/C3shot00001.trc", "C3");
        joinChannelFiles(set);
        QCOMPARE(set.shots.size(), std::size_t(2));
        QCOMPARE(namesOf(set.shots[0]), (Names{"C1", "C2", "C3"}));
        QCOMPARE(namesOf(set.shots[1]), (Names{"C1"}));
        QCOMPARE(set.findings.size(), std::size_t(1));
        QVERIFY(contains(english(set.findings[0].message), "C3shot00001.trc"));
    }

    void join_whatDiffers_staysApart_data()
    {
        QTest::addColumn<int>("what");
        for (const char *name : {"time of recording", "only one states a time", "rate", "no rate",
                 "length", "first sample", "channel's name", "number of shots", "format", "folder",
                 "file number", "a text table", "the same channel twice"})
            QTest::newRow(name) << 0;
    }
    void join_whatDiffers_staysApart()
    {
        const QByteArray what = QTest::currentDataTag();
        CaptureSet set = pair();
        Shot &other = set.shots[1];
        const auto rename = [&](const std::string &path) { set.inputs[1].path = path; };
        if (what == "time of recording")
            other.notes["recorded"] = "2025-03-02 14:05:08.25";
        else if (what == "only one states a time")
            other.notes.clear();
        else if (what == "rate")
            other.channels[0].sampleRate_Hz = 1.0001e8;
        else if (what == "no rate")
            set.shots[0].channels[0].sampleRate_Hz = other.channels[0].sampleRate_Hz = 0.0;
        else if (what == "length")
            other.channels[0].samples = RawSamples(std::vector<std::int16_t>(9));
        else if (what == "first sample")
            other.channels[0].t0_s += 0.6e-8;
        else if (what == "channel's name")
            other.channels[0].name = "C1";
        else if (what == "number of shots")
            set.shots.push_back(other);
        else if (what == "format")
            set.inputs[1].format = "rigol-wfm";
        else if (what == "folder")
            rename("/e/C2shot00001.trc");
        else if (what == "file number")
            rename("/d/C2shot00002.trc");
        else if (what == "a text table")
            set.inputs[0].format = set.inputs[1].format = "text";
        else
            addFile(set, "/d/C2shot00001.trc", "C4");
        const std::size_t shots = set.shots.size();
        joinChannelFiles(set);
        QCOMPARE(set.shots.size(), shots);
        QVERIFY(set.findings.empty());
    }

    void join_halfAnIntervalBetweenTheFirstSamples_isOneTrigger()
    {
        CaptureSet set = pair();
        set.shots[1].channels[0].t0_s += 0.4e-8;
        joinChannelFiles(set);
        QCOMPARE(set.shots.size(), std::size_t(1));
        QCOMPARE(set.shots[0].channels[1].t0_s, -1e-6 + 0.4e-8); // each keeps its own time
    }

    void importSettings_ofOneFile_areForItsChannelOnly()
    {
        CaptureSet set = pair();
        joinChannelFiles(set);
        ImportSettings settings;
        settings.channels = {{"C1", "dut"}, {"C2", "driven_side"}};
        settings.files["C2shot00001.trc"].sampleRate_Hz = 5e7;
        settings.files["C2shot00001.trc"].sampleRateReason = "external clock";
        settings.files["C2shot00001.trc"].channelDetails["C2"].scale = 3.0;
        const auto applied = applyImportSettings(set, settings);
        QVERIFY2(applied.has_value(), sentence(applied).c_str());
        const auto &channels = applied->shots[0].channels;
        QCOMPARE(channels[0].role, ChannelRole::Dut);
        QCOMPARE(channels[1].role, ChannelRole::DrivenSide);
        QCOMPARE(channels[0].sampleRate_Hz, 1e8);
        QCOMPARE(channels[1].sampleRate_Hz, 5e7);
        QCOMPARE(channels[1].userScale, 3.0 * channels[0].userScale);
        settings.files["C2shot00001.trc"].channelDetails["C1"].scale = 2.0; // not in that file
        QVERIFY(!applyImportSettings(set, settings));
    }

    void moveInputs_movesTheShotsFileAndItsChannelsFiles()
    {
        CaptureSet set = pair();
        joinChannelFiles(set);
        moveInputs(set.shots[0], [](Index input) { return input + 5; });
        QCOMPARE(set.shots[0].input, Index(5));
        QCOMPARE(inputOf(set.shots[0], set.shots[0].channels[1]), Index(6));
    }

    void channelFilesBeside_listsThoseThatAreThere()
    {
        const QTemporaryDir folder(quickTemplate());
        for (const char *name : {"C1a1.trc", "C3a1.trc", "C3a2.trc", "x.trc"})
            write(folder.filePath(name), "x");
        const auto path = [&](const char *name) { return folder.filePath(name).toStdString(); };
        QCOMPARE(channelFilesBeside(path("C3a1.trc")), (Names{path("C1a1.trc"), path("C3a1.trc")}));
        QVERIFY(channelFilesBeside(path("C3a2.trc")).empty());
        QVERIFY(channelFilesBeside(path("x.trc")).empty());
    }
};

DYNCAL_TEST(TestChannelFiles)
#include "tst_channel_files.moc"
