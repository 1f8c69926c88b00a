// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/capture_seal.h"
#include "core/capture/formats/hdf5/hdf5_capture_reader.h"
#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "tests/core/capture/capture_test_support.h"
#include "tests/support/same_samples.h"
#include "tests/support/test_program.h"

#include "core/base/content_hash.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include <filesystem>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

const std::string kCreated = "2026-01-02T03:04:05Z";

/// Something in every field that a capture can hold.
CaptureSet richSet()
{
    CaptureSet set;
    set.inputs = {{"/somewhere/a.lvm", "a.lvm", std::string(64, 'a'), "lvm"}};
    set.tube = {{"driver_length_m", "0.97"}, {"driver_gas", "air"}, {"gamma1", "1.402"}};
    set.sensors["p/1"] = {{"serial", "0042"}, {"model", "1e3"}, {"sensitivity", "1.5e-06"},
        {"manufacturer", "Kjøller & Søn"}, {"role", "dut"}};
    set.instruments["scope"] = {{"vendor", "NI"}, {"adc_bits", "14"}};
    const std::vector<RawSamples::Counts> kinds{std::vector<std::int16_t>{-32768, 0, 1, 32767},
        std::vector<std::int32_t>{-2147483647 - 1, 5, 2147483647},
        std::vector<float>{0.1F, -3e38F, 7.0F}, std::vector<double>{0.1, 1e-300, kNan, 5.0}};
    for (int number = 1; number <= 12; ++number) {
        Shot shot;
        shot.label = "Shot №" + std::to_string(number);
        shot.level = number == 1 ? ShotLevel::Low : ShotLevel::High;
        shot.included = number != 2;
        shot.excludeReason = number == 2 ? "diaphragm held" : "";
        shot.environment.p1_Pa = 101325.0 + number;
        shot.environment.u_T1_K = 0.3;
        shot.notes = {{"operator", "Åsa"}, {"start_utc", "2026-01-01T00:00:00Z"}};
        for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
            Channel channel;
            channel.name = kind == 1 ? "side/2 (µV)" : "z" + std::to_string(9 - kind);
            channel.role = kind == 0 ? ChannelRole::Dut : ChannelRole::DrivenSide;
            channel.samples = RawSamples(kinds[kind]);
            channel.sampleRate_Hz = 100e6 / static_cast<double>(kind + 1);
            channel.t0_s = -1e-4;
            channel.unit = kind == 2 ? "Pa" : "V";
            channel.quantity = "pressure";
            channel.reference = kind == 2 ? PressureReference::Gauge : PressureReference::Unknown;
            if (kind == 3)
                channel.polynomial = {0.25, 1.5, 1e-7};
            else
                channel.polynomial = {0.5, 0.1};
            if (kind == 0) {
                channel.adcMin = -8192.0;
                channel.adcMax = 8191.0;
                channel.adcBits = 14;
                channel.sensorId = "p/1";
            }
            shot.channels.push_back(std::move(channel));
        }
        set.shots.push_back(std::move(shot));
    }
    return set;
}

/// Read and its hashes held against those in the file, as before a calibration.
Result<CaptureSet> readSealed(const std::string &path)
{
    return readHdf5Capture(path, {}, {}).and_then([](CaptureSet set) {
        return sealCaptures(std::move(set));
    });
}

} // namespace

class TestHdf5Capture : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    std::string path(const char *name) const { return m_folder.filePath(name).toStdString(); }

    std::string written(const char *name, const CaptureSet &set) const
    {
        const Result<void> done = writeHdf5Capture(set, {path(name), true}, kCreated, "Title");
        if (!done)
            qFatal("%s", english(done.error().message).c_str());
        return path(name);
    }

    /// Makes files with an independent implementation of HDF5.
    bool makeWithPython(const char *name, const QString &body) const
    {
        const QString script = "import sys, h5py, numpy as np\n"
                               "f = h5py.File(sys.argv[1], 'w')\n"
                               "f.attrs['format'] = 'dyncal-capture'\n"
                               "f.attrs['format_version'] = np.array([1, 0], dtype='i4')\n"
                               "c = f.create_group('shots/001/channels')\n"
                               "x = (np.arange(5000) * 7 - 16000).astype('i2')\n"
            + body + "\nf.close()\n";
        return runPython(script, {QString::fromStdString(path(name))});
    }

private slots:
    void write_everyField_readsBackEqual()
    {
        const CaptureSet set = richSet();
        const Result<CaptureSet> read = readSealed(written("rich.h5", set));
        QVERIFY2(read, sentence(read).c_str());
        QVERIFY(read->findings.empty());
        QVERIFY(read->tube == set.tube);
        QVERIFY(read->sensors.at("p|1") == set.sensors.at("p/1"));
        QVERIFY(read->instruments == set.instruments);
        QCOMPARE(read->shots.size(), set.shots.size());
        for (std::size_t i = 0; i < set.shots.size(); ++i) {
            const Shot &shot = read->shots[i];
            QCOMPARE(shot.label, set.shots[i].label);
            QVERIFY(shot.level == set.shots[i].level);
            QCOMPARE(shot.included, set.shots[i].included);
            QCOMPARE(shot.excludeReason, set.shots[i].excludeReason);
            QVERIFY(shot.notes == set.shots[i].notes);
            QCOMPARE(shot.environment.p1_Pa, set.shots[i].environment.p1_Pa);
            QCOMPARE(shot.environment.u_T1_K, 0.3);
            QVERIFY(std::isnan(shot.environment.p4_Pa));
            compareChannels(shot, set.shots[i]);
        }
    }

    void write_sameContentTwice_sameBytes()
    {
        const CaptureSet set = richSet();
        QCOMPARE(sha256OfFile(written("one.h5", set)), sha256OfFile(written("two.h5", set)));
    }

    void write_otherContent_otherUuid()
    {
        CaptureSet set = richSet();
        written("one.h5", set);
        set.shots[0].label = "renamed";
        QVERIFY(sha256OfFile(path("one.h5")) != sha256OfFile(written("two.h5", set)));
    }

    void write_overOldCapture_replacesItAndLeavesNoTemporary()
    {
        written("again.h5", richSet());
        CaptureSet small;
        small.shots = {shotOf(std::vector<std::int16_t>{1, 2, 3})};
        QCOMPARE(readSealed(written("again.h5", small))->shots.size(), 1U);
        QVERIFY(!std::filesystem::exists(path("again.h5.part")));
    }

    void write_polarityAndScale_foldedIntoPhysicalValues()
    {
        CaptureSet set;
        set.shots = {shotOf(std::vector<std::int16_t>{-100, 0, 250})};
        Channel &channel = set.shots[0].channels[0];
        channel.polynomial = {0.25, 2.0};
        channel.polarity = -1.0;
        channel.userScale = 4.0;
        const Result<CaptureSet> read = readSealed(written("folded.h5", set));
        QVERIFY2(read, sentence(read).c_str());
        const Channel &again = read->shots[0].channels[0];
        QVERIFY(physicalValues(again, 0, 3) == physicalValues(channel, 0, 3)); // powers of two
        QCOMPARE(again.polarity, 1.0);
    }

    void write_severalChunks_readsBackEqual()
    {
        std::vector<std::int16_t> values((1 << 21) + 12345);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = static_cast<std::int16_t>(i * 7919);
        CaptureSet set;
        set.shots = {shotOf(values)};
        const Result<CaptureSet> read = readSealed(written("long.h5", set));
        QVERIFY2(read, sentence(read).c_str());
        QVERIFY(testing::sameSamples(
            read->shots[0].channels[0].samples, set.shots[0].channels[0].samples));
    }

    void write_sameNamesAndEmptyRecord_keptApart()
    {
        CaptureSet set;
        set.shots = {shotOf(std::vector<std::int16_t>{1})};
        set.shots[0].channels.push_back(set.shots[0].channels[0]);
        set.shots[0].channels.push_back(set.shots[0].channels[0]);
        set.shots[0].channels[2].samples = RawSamples(std::vector<double>());
        const Result<CaptureSet> read = readSealed(written("names.h5", set));
        QVERIFY2(read, sentence(read).c_str());
        QCOMPARE(read->shots[0].channels.size(), 3U);
        QCOMPARE(read->shots[0].channels[1].name, std::string("DUT"));
        QCOMPARE(read->shots[0].channels[2].samples.size(), Index(0));
    }

    void write_impossibleTarget_saysSoAndLeavesNothing()
    {
        const Result<void> noFolder
            = writeHdf5Capture(richSet(), {path("no/such/folder.h5")}, kCreated, "");
        QVERIFY(!noFolder && contains(sentence(noFolder), "folder exists"));
        QVERIFY(!writeHdf5Capture(richSet(), {"/dev/full", true}, kCreated, ""));
        QVERIFY(!writeHdf5Capture(richSet(), {m_folder.path().toStdString(), true}, kCreated, ""));
    }

    void write_stopRequested_keepsTheOldFile()
    {
        const std::string before = sha256OfFile(written("kept.h5", richSet()));
        std::stop_source stop;
        stop.request_stop();
        JobControl control;
        control.stop = stop.get_token();
        const Result<void> done
            = writeHdf5Capture(richSet(), {path("kept.h5"), true}, kCreated, "other", {}, control);
        QVERIFY(!done && done.error().kind == ErrorKind::Cancelled);
        QCOMPARE(sha256OfFile(path("kept.h5")), before);
        QVERIFY(!std::filesystem::exists(path("kept.h5.part")));
    }

    void write_withTruth_independentReaderFindsIt()
    {
        const Result<void> done = writeHdf5Capture(richSet(), {path("truth.h5"), true}, kCreated,
            "T", {{{"f0_Hz", 2.33e6}, {"zeta", 0.02}}, {{"f0_Hz", 1e6}}});
        QVERIFY(done);
        const QString script
            = "import sys, h5py, hashlib\n"
              "f = h5py.File(sys.argv[1])\n"
              "assert f.attrs['format'] == 'dyncal-capture'\n"
              "assert list(f.attrs['format_version']) == [1, 0]\n"
              "assert f['truth/shot_001'].attrs['zeta'] == 0.02\n"
              "assert f['truth/shot_002'].attrs['f0_Hz'] == 1e6\n"
              "assert f['setup/tube'].attrs['driver_length_m'] == 0.97\n"
              "assert f['setup/sensors/p|1'].attrs['serial'] == '0042'\n"
              "d = f['shots/001/channels/z9']\n"
              "assert d.dtype.str == '<i2' and d.chunks and d.compression is None\n"
              "assert hashlib.sha256(d[:].tobytes()).hexdigest() == d.attrs['raw_sha256']\n"
              "assert d.attrs['scale'] == 0.1 and d.attrs['offset'] == 0.5\n"
              "assert len(f['shots']) == 12\n";
        if (!runPython("import h5py", {}))
            QSKIP("no Python with h5py here: not held against an independent reader");
        QVERIFY(runPython(script, {QString::fromStdString(path("truth.h5"))}));
    }

    void read_flippedSampleByte_namesTheChannel()
    {
        CaptureSet set;
        set.shots = {shotOf(std::vector<std::int16_t>(4096, 0x5A5A))};
        const std::string file = written("flipped.h5", set);
        QByteArray bytes = bytesOf(QString::fromStdString(file));
        const auto position = bytes.indexOf(QByteArray(64, 0x5A));
        QVERIFY(position > 0);
        bytes[position + 10] = 0x5B;
        const Result<CaptureSet> read = readSealed(write(m_folder.filePath("flipped2.h5"), bytes));
        QCOMPARE(findingId(read), std::string("CAP-018"));
        QVERIFY(contains(sentence(read), "shot 1, channel 'DUT'"));
    }

    void read_truncatedAnywhere_errorNeverCrash()
    {
        CaptureSet set;
        set.shots = {shotOf(std::vector<std::int16_t>(3000, 77))};
        const QByteArray bytes = bytesOf(QString::fromStdString(written("whole.h5", set)));
        constexpr int kEvery = 64;
        for (int length = 0; length < bytes.size(); length += kEvery) {
            const std::string cut = write(m_folder.filePath("cut.h5"), bytes.left(length));
            const Result<CaptureSet> read = readSealed(cut);
            QVERIFY2(!read, qPrintable(QString("cut at %1 was read").arg(length)));
            QVERIFY(read.error().kind == ErrorKind::FileUnreadable);
        }
    }

    void read_flippedBytes_neverAnotherNumber()
    {
        CaptureSet set;
        set.shots = {shotOf(std::vector<std::int16_t>(500, 77))};
        const QByteArray bytes = bytesOf(QString::fromStdString(written("whole2.h5", set)));
        constexpr int kEvery = 13;
        for (int at = 0; at < bytes.size(); at += kEvery) {
            QByteArray flipped = bytes;
            flipped[at] = static_cast<char>(flipped[at] ^ 0x41);
            const Result<CaptureSet> read
                = readSealed(write(m_folder.filePath("flip.h5"), flipped));
            if (read)
                QVERIFY(testing::sameSamples(
                    read->shots[0].channels[0].samples, set.shots[0].channels[0].samples));
        }
    }

    void read_noCaptures_saysWhat()
    {
        QCOMPARE(findingId(readSealed(path("missing.h5"))), std::string("CAP-018"));
        QCOMPARE(findingId(readSealed(write(m_folder.filePath("empty.h5"), ""))),
            std::string("CAP-018"));
        QCOMPARE(findingId(readSealed(write(m_folder.filePath("pdf.h5"), "%PDF-1.4\n%..."))),
            std::string("CAP-018"));
        QCOMPARE(findingId(readSealed(m_folder.path().toStdString())), std::string("CAP-018"));
    }

    void read_otherWriters_data()
    {
        QTest::addColumn<QString>("body");
        QTest::addColumn<bool>("exact");
        QTest::newRow("contiguous") << "c.create_dataset('a', data=x)" << true;
        QTest::newRow("shuffle, deflate, fletcher32")
            << "c.create_dataset('a', data=x, chunks=(512,), compression=9, shuffle=True, fletcher32=True)"
            << true;
        QTest::newRow("big endian") << "c.create_dataset('a', data=x.astype('>i2'))" << true;
        QTest::newRow("int32") << "c.create_dataset('a', data=x.astype('i4'))" << true;
        QTest::newRow("double") << "c.create_dataset('a', data=x.astype('f8'))" << true;
        QTest::newRow("float16")
            << "c.create_dataset('a', data=np.round(x/16).astype('f2')); c['a'].attrs['scale'] = 16.0"
            << false;
        QTest::newRow("int64") << "c.create_dataset('a', data=x.astype('i8'))" << true;
        QTest::newRow("fixed-length text, numbers as text")
            << "d = c.create_dataset('a', data=x)\n"
               "d.attrs['unit'] = np.bytes_('V   ')\nd.attrs['sample_rate_Hz'] = '1e6'"
            << true;
    }

    void read_otherWriters()
    {
        QFETCH(QString, body);
        QFETCH(bool, exact);
        if (!makeWithPython("other.h5", body))
            QSKIP("no Python with h5py here: files of other writers not covered");
        const Result<CaptureSet> read = readSealed(path("other.h5"));
        QVERIFY2(read, sentence(read).c_str());
        const Channel &channel = read->shots.at(0).channels.at(0);
        QCOMPARE(channel.samples.size(), Index(5000));
        QVERIFY(channel.role == ChannelRole::Other);
        constexpr double kHalfStep = 8.0; // float16 keeps multiples of 16 only
        for (Index i = 0; i < channel.samples.size(); ++i) {
            const double expected = static_cast<double>(i * 7 - 16000);
            const double found = physicalValue(channel, channel.samples.at(i));
            QVERIFY(exact ? found == expected : std::abs(found - expected) <= kHalfStep);
        }
    }

    void read_unusable_data()
    {
        QTest::addColumn<QString>("body");
        QTest::addColumn<QString>("id");
        QTest::addColumn<QString>("words");
        QTest::newRow("no format") << "del f.attrs['format']"
                                   << "CAP-001"
                                   << "attribute format";
        QTest::newRow("version 2") << "f.attrs['format_version'] = np.array([2, 0], dtype='i4')"
                                   << "CAP-018"
                                   << "version 2";
        QTest::newRow("no version") << "del f.attrs['format_version']"
                                    << "CAP-018"
                                    << "version ?";
        QTest::newRow("no shots") << "del f['shots']"
                                  << "CAP-018"
                                  << "no shots";
        QTest::newRow("no channels") << ""
                                     << "CAP-018"
                                     << "no channels";
        QTest::newRow("2-D") << "c.create_dataset('a', data=np.zeros((3, 3)))"
                             << "CAP-018"
                             << "one-dimensional";
        QTest::newRow("text") << "c.create_dataset('a', data=np.array([b'x', b'y']))"
                              << "CAP-018"
                              << "integers";
        QTest::newRow("group as channel") << "c.create_group('a')"
                                          << "CAP-018"
                                          << "no dataset";
        QTest::newRow("nothing written") << "c.create_dataset('a', shape=(10**9,), dtype='i2')"
                                         << "CAP-018"
                                         << "claims more";
        QTest::newRow("sparse bomb")
            << "d = c.create_dataset('a', shape=(2**46,), chunks=(2**20,), dtype='i2', compression=1)\nd[:10] = 1"
            << "CAP-018"
            << "claims more";
        QTest::newRow("deflate bomb")
            << "d = c.create_dataset('a', shape=(2**46,), chunks=(2**22,), dtype='i1', compression=9)\nd[:2**22] = 0"
            << "CAP-018"
            << "claims more";
        QTest::newRow("deflate bomb of one chunk")
            << "d = c.create_dataset('a', shape=(2**28,), chunks=(2**28,), dtype='i1', compression=1)\nd[:] = 0"
            << "CAP-018"
            << "64 MiB";
        QTest::newRow("external file")
            << "c.create_dataset('a', shape=(100,), dtype='i2', external=[('/etc/passwd', 0, 200)])"
            << "CAP-018"
            << "another file (/etc/passwd), which is not opened";
        QTest::newRow("large external file")
            << "c.create_dataset('a', shape=(10**9,), dtype='i2', external=[('/etc/passwd', 0, 2 * 10**9)])"
            << "CAP-018"
            << "another file (/etc/passwd), which is not opened";
        QTest::newRow("external link") << "c['a'] = h5py.ExternalLink('/tmp/x.h5', '/a')"
                                       << "CAP-018"
                                       << "channels of its own";
        QTest::newRow("wrong hash")
            << "d = c.create_dataset('a', data=x)\nd.attrs['raw_sha256'] = '0' * 64"
            << "CAP-018"
            << "SHA-256";
        QTest::newRow("scale nan") << "d = c.create_dataset('a', data=x)\nd.attrs['scale'] = np.nan"
                                   << "CAP-018"
                                   << "not a number";
    }

    void read_unusable()
    {
        QFETCH(QString, body);
        QFETCH(QString, id);
        QFETCH(QString, words);
        if (!makeWithPython("unusable.h5", body))
            QSKIP("no Python with h5py here: unusable files of other writers not covered");
        const Result<CaptureSet> read = readSealed(path("unusable.h5"));
        QVERIFY(!read);
        QVERIFY(read.error().kind == ErrorKind::FileUnreadable);
        QCOMPARE(findingId(read), id.toStdString());
        QVERIFY2(contains(sentence(read), words.toStdString()), sentence(read).c_str());
    }

    void read_newerMinorVersion_infoFinding()
    {
        if (!makeWithPython("minor.h5",
                "f.attrs['format_version'] = np.array([1, 7], dtype='i4')\n"
                "c.create_dataset('a', data=x)"))
            QSKIP("no Python with h5py here: newer layout not covered");
        const Result<CaptureSet> read = readSealed(path("minor.h5"));
        QVERIFY(read && hasFinding(read->findings, "CAP-021"));
    }

    void read_realCaptureOfAnotherWriter_expectedCounts()
    {
        const QString folder = recordingsFolder();
        if (folder.isEmpty())
            DYNCAL_SKIP_WITHOUT_DATA("data folder missing: 0 captures of other writers covered");
        const QString file = folder + "/derived/ds1_capture_v1_shots123.h5";
        const Result<CaptureSet> read = readSealed(file.toStdString());
        QVERIFY2(read, sentence(read).c_str());
        const QJsonObject expected
            = QJsonDocument::fromJson(bytesOf(folder + "/derived/expected_shots123.json")).object();
        QCOMPARE(read->shots.size(), 3U);
        for (int s = 0; s < 3; ++s) {
            const Shot &shot = read->shots[static_cast<std::size_t>(s)];
            QVERIFY(shot.level == ShotLevel::None);
            const QJsonObject channels = expected.value(QString("shot%1").arg(s + 1)).toObject();
            QCOMPARE(shot.channels.size(), static_cast<std::size_t>(channels.size()));
            for (const QString &name : channels.keys())
                compareWithExpected(shot, name, channels.value(name).toObject());
        }
        QVERIFY(read->shots[0].channelWithRole(ChannelRole::Dut)->name == "accel_1");
        QVERIFY(read->tube.find("driven_length_m") == read->tube.end()); // recorded as NaN
    }

    void read_filesThatCrashTheLibrary_errorAndStillHere()
    {
        const QString folder = recordingsFolder() + "/hdf5_crashers";
        const QStringList files = QDir(folder).entryList({"*.h5"}, QDir::Files);
        if (files.isEmpty())
            DYNCAL_SKIP_WITHOUT_DATA("data folder missing: 0 files that crash libhdf5 covered");
        for (const QString &file : files) {
            const Result<CaptureSet> read = readSealed((folder + "/" + file).toStdString());
            QVERIFY(!read && read.error().kind == ErrorKind::FileUnreadable);
        }
    }

private:
    static void compareChannels(const Shot &found, const Shot &expected)
    {
        QCOMPARE(found.channels.size(), expected.channels.size());
        for (std::size_t i = 0; i < found.channels.size(); ++i) {
            const Channel &a = found.channels[i];
            const Channel &b = expected.channels[i];
            QCOMPARE(a.name, b.name);
            QVERIFY(a.role == b.role && a.reference == b.reference);
            QCOMPARE(a.sampleRate_Hz, b.sampleRate_Hz);
            QCOMPARE(a.t0_s, b.t0_s);
            QVERIFY(a.polynomial == b.polynomial);
            QCOMPARE(a.unit, b.unit);
            QCOMPARE(a.quantity, b.quantity);
            QVERIFY(a.adcMin == b.adcMin && a.adcMax == b.adcMax && a.adcBits == b.adcBits);
            QCOMPARE(a.sensorId, b.sensorId.empty() ? "" : std::string("p|1"));
            QVERIFY(a.samples.type() == b.samples.type());
            QCOMPARE(a.sha256, sha256OfSamples(b.samples)); // bytes, so that NaN equals NaN
        }
    }

    static void compareWithExpected(
        const Shot &shot, const QString &name, const QJsonObject &expected)
    {
        const Channel *channel = channelNamed(shot, name.toStdString());
        QVERIFY(channel != nullptr);
        QVERIFY(channel->samples.type() == SampleType::Int16);
        std::vector<std::int16_t> counts;
        channel->samples.visitBlocks(0, channel->samples.size(), [&](auto values, Index) {
            for (const auto value : values)
                counts.push_back(static_cast<std::int16_t>(value));
        });
        QCOMPARE(static_cast<int>(counts.size()), expected.value("n").toInt());
        QCOMPARE(channel->polynomial.at(1), expected.value("scale").toDouble());
        QCOMPARE(channel->sampleRate_Hz, 1e6);
        const auto low = std::min_element(counts.begin(), counts.end());
        const auto high = std::max_element(counts.begin(), counts.end());
        QCOMPARE(int(*low), expected.value("min_count").toInt());
        QCOMPARE(int(*high), expected.value("max_count").toInt());
        QCOMPARE(static_cast<int>(high - counts.begin()), expected.value("argmax").toInt());
        double sum = 0.0;
        for (const std::int16_t count : counts)
            sum += count;
        QCOMPARE(sum, expected.value("sum_counts").toDouble());
    }
};

DYNCAL_TEST(TestHdf5Capture)

#include "tst_hdf5_capture.moc"
