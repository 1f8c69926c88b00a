// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/number_text.h"
#include "core/capture/formats/foreign/foreign_hdf5.h"
#include "core/capture/formats/preview/foreign_datasets.h"
#include "core/capture/opening/capture_open.h"
#include "tests/core/capture/formats/foreign/foreign_file.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>

#include <filesystem>

using namespace dyncal;
using namespace dyncal::testing;

class TestForeignHdf5 : public QObject, ForeignFile
{
    Q_OBJECT

private slots:
    void read_everyTypeAndLayout_data()
    {
        QTest::addColumn<int>("typeIndex");
        QTest::addColumn<int>("layout");
        for (int type = 0; type < 18; ++type) {
            for (int layout = 0; layout < 7; ++layout) {
                const bool longRecord = layout == 2 || layout == 3;
                if (longRecord && type % 5 != 2) // some types will do where it takes long
                    continue;
                QTest::addRow("type %d, layout %d", type, layout) << type << layout;
            }
        }
    }

    void read_everyTypeAndLayout()
    {
        QFETCH(int, typeIndex);
        QFETCH(int, layout);
        struct Type
        {
            hid_t id;
            bool isSigned;
            int bits;
        };
        H5open();
        const std::vector<Type> types{{H5T_STD_I8LE, true, 8}, {H5T_STD_U8LE, false, 8},
            {H5T_STD_I16LE, true, 16}, {H5T_STD_I16BE, true, 16}, {H5T_STD_U16LE, false, 16},
            {H5T_STD_U16BE, false, 16}, {H5T_STD_I32LE, true, 31}, {H5T_STD_I32BE, true, 31},
            {H5T_STD_U32LE, false, 31}, {H5T_STD_U32BE, false, 31}, {H5T_STD_I64LE, true, 31},
            {H5T_STD_U64BE, false, 31}, {H5T_IEEE_F32LE, true, 16}, {H5T_IEEE_F32BE, true, 16},
            {H5T_IEEE_F64LE, true, 31}, {H5T_IEEE_F64BE, true, 31}, {H5T_STD_I8BE, true, 8},
            {H5T_NATIVE_LDOUBLE, true, 31}};
        const Type type = types.at(static_cast<std::size_t>(typeIndex));
        const std::vector<StoredAs> layouts{{type.id, {}}, {type.id, {512}}, {type.id, {65536}},
            {type.id, {1 << 20}}, {type.id, {700}, true, 4}, {type.id, {999}, true, 1, true},
            {type.id, {}, false, 0, false, true}};
        const StoredAs as = layouts.at(static_cast<std::size_t>(layout));
        const hsize_t chunk = as.chunk.empty() ? 0 : as.chunk.front(); // the last one is clipped
        const std::vector<double> values
            = valuesOf(type.isSigned, type.bits, static_cast<Index>(chunk) + 3500);
        const auto set = readMade([&](const Hdf5TestFile &file) {
            file.dataset("/a", {values.size()}, as, H5T_NATIVE_DOUBLE, values.data());
        });
        QVERIFY2(set, sentence(set).c_str());
        const Channel &channel = set->shots.at(0).channels.at(0);
        QVERIFY(physical(channel) == values);
        const bool plain = H5Tget_size(type.id) <= 2 || typeIndex == 6 || typeIndex == 7
            || (typeIndex >= 12 && typeIndex <= 16);
        QCOMPARE(channel.samples.isInMemory(), !(plain && layout < 4));
    }

    void read_tables_data()
    {
        QTest::addColumn<int>("rows");
        QTest::addColumn<int>("columns");
        QTest::addColumn<int>("chunkRows"); // 0 = contiguous
        QTest::addColumn<int>("chunkColumns");
        QTest::addColumn<bool>("packed");
        for (const bool packed : {false, true}) {
            const QByteArray kind = packed ? " deflate" : "";
            QTest::addRow("whole chunks%s", kind.data()) << 700 << 3 << 100 << 3 << packed;
            QTest::addRow("single columns%s", kind.data()) << 700 << 3 << 64 << 1 << packed;
            QTest::addRow("clipped chunks%s", kind.data()) << 701 << 5 << 97 << 2 << packed;
            QTest::addRow("64 columns%s", kind.data()) << 40000 << 64 << 1000 << 64 << packed;
            QTest::addRow("rows are channels%s", kind.data()) << 3 << 700 << 2 << 97 << packed;
            QTest::addRow("rows, one chunk%s", kind.data()) << 4 << 900 << 4 << 900 << packed;
        }
        QTest::newRow("contiguous") << 700 << 3 << 0 << 0 << false;
        QTest::newRow("contiguous rows") << 3 << 700 << 0 << 0 << false;
        QTest::newRow("one column") << 700 << 1 << 0 << 0 << false;
    }

    void read_tables()
    {
        QFETCH(int, rows);
        QFETCH(int, columns);
        QFETCH(int, chunkRows);
        QFETCH(int, chunkColumns);
        QFETCH(bool, packed);
        std::vector<std::int16_t> values;
        for (int i = 0; i < rows * columns; ++i)
            values.push_back(static_cast<std::int16_t>(i * 31 + i / 7));
        const auto set = readMade([&](const Hdf5TestFile &file) {
            StoredAs as{H5T_STD_I16LE, {}};
            if (chunkRows > 0)
                as.chunk = {hsize_t(chunkRows), hsize_t(chunkColumns)};
            as.deflate = packed ? 3 : 0;
            file.dataset(
                "/g/t", {hsize_t(rows), hsize_t(columns)}, as, H5T_NATIVE_INT16, values.data());
        });
        QVERIFY2(set, sentence(set).c_str());
        const bool byRow = rows < columns;
        const int count = byRow ? rows : columns;
        const int samples = byRow ? columns : rows;
        const auto &channels = set->shots.at(0).channels;
        QCOMPARE(static_cast<int>(channels.size()), count);
        for (int c = 0; c < count; ++c) {
            const Channel &channel = channels[static_cast<std::size_t>(c)];
            const std::string number = std::to_string(c);
            const std::string suffix = byRow ? "[" + number + ",:]" : "[:," + number + "]";
            QCOMPARE(channel.name, count == 1 ? "/g/t" : "/g/t" + suffix);
            QCOMPARE(channel.samples.isInMemory(), packed);
            std::vector<double> expected;
            for (int i = 0; i < samples; ++i)
                expected.push_back(
                    values[static_cast<std::size_t>(byRow ? c * columns + i : i * columns + c)]);
            QVERIFY(physical(channel) == expected);
        }
    }

    void read_nothingButTimes_isSaidAndNoFaultOfTheSettings()
    {
        std::vector<double> times(100);
        for (std::size_t k = 0; k < times.size(); ++k)
            times[k] = 1e-6 * static_cast<double>(k);
        const auto set = readMade([&](const Hdf5TestFile &file) {
            for (const char *name : {"/time", "/zeit"})
                file.dataset(name, {100}, {H5T_IEEE_F64LE, {}}, H5T_NATIVE_DOUBLE, times.data());
        });
        QCOMPARE(findingId(set), std::string("CAP-001"));
        QCOMPARE(set.error().kind, ErrorKind::FileUnreadable);
        QVERIFY(sentence(set).find("holds times") != std::string::npos);
    }

    void read_tableOf65Columns_isNone()
    {
        const std::vector<std::int16_t> values(65 * 100, 1);
        const auto set = readMade([&](const Hdf5TestFile &file) {
            file.dataset("/t", {100, 65}, {H5T_STD_I16LE, {}}, H5T_NATIVE_INT16, values.data());
        });
        QCOMPARE(findingId(set), std::string("CAP-001"));
    }

    void read_severalLengths_longestThatIsShared()
    {
        const auto set = readMade([](const Hdf5TestFile &file) {
            ramp(file, "/raw/p1", 1000);
            ramp(file, "/raw/p2", 1000);
            ramp(file, "/spectrum", 4000);
            ramp(file, "/short/a", 10);
            ramp(file, "/short/b", 10);
        });
        QVERIFY2(set, sentence(set).c_str());
        QVERIFY(namesOf(set) == (Names{"/raw/p1", "/raw/p2"}));
        QVERIFY(hasFinding(set->findings, "CAP-026"));
        QVERIFY(contains(english(set->findings.at(0).message), "/spectrum"));
    }

    void read_namedChannels_areThose()
    {
        ImportSettings settings;
        settings.channels = {{"/spectrum", "dut"}, {"/t[:,1]", "trigger"}};
        const auto make = [](const Hdf5TestFile &file) {
            ramp(file, "/raw/p1", 1000);
            ramp(file, "/spectrum", 4000);
            file.dataset("/t", {500, 2}, {H5T_IEEE_F64LE, {}}, H5T_NATIVE_DOUBLE,
                valuesOf(true, 16, 1000).data());
        };
        const auto set = readMade(make, settings);
        QVERIFY2(set, sentence(set).c_str());
        QVERIFY(namesOf(set) == (Names{"/spectrum", "/t[:,1]"}));
        settings.channels = {{"/nothing", "dut"}};
        const auto none = readMade(make, settings);
        QVERIFY(!none && none.error().kind == ErrorKind::Usage);
        QVERIFY(contains(sentence(none), "/raw/p1, /spectrum, /t[:,0]"));
    }

    void read_integersBeyondDouble_refused()
    {
        const std::vector<std::int64_t> counts{1, (std::int64_t(1) << 53) + 2};
        const auto set = readMade([&](const Hdf5TestFile &file) {
            file.dataset("/a", {2}, {H5T_STD_I64LE, {}}, H5T_NATIVE_INT64, counts.data());
        });
        QCOMPARE(findingId(set), std::string("CAP-018"));
        QVERIFY(contains(sentence(set), "53 bits"));
    }

    void read_missingChunk_refusedOrLeftOutAndSaid()
    {
        const auto make = [](const Hdf5TestFile &file) {
            const hsize_t begin = 0;
            const hsize_t count = 100;
            const std::vector<std::int16_t> some(100, 5);
            file.claim("/holed", {1000}, {H5T_STD_I16LE, {100}});
            const hid_t dataset = H5Dopen2(file.id(), "/holed", H5P_DEFAULT);
            const hid_t space = H5Dget_space(dataset);
            const hid_t memory = H5Screate_simple(1, &count, nullptr);
            H5Sselect_hyperslab(space, H5S_SELECT_SET, &begin, nullptr, &count, nullptr);
            H5Dwrite(dataset, H5T_NATIVE_INT16, memory, space, H5P_DEFAULT, some.data());
            H5Sclose(memory);
            H5Sclose(space);
            H5Dclose(dataset);
        };
        const auto alone = readMade(make);
        QCOMPARE(findingId(alone), std::string("CAP-018"));
        QVERIFY(contains(sentence(alone), "/holed"));
        const auto beside = readMade([&](const Hdf5TestFile &file) {
            make(file);
            ramp(file, "/whole");
        });
        QVERIFY(beside && hasFinding(beside->findings, "CAP-018"));
        QVERIFY(namesOf(beside) == Names{"/whole"});
        ImportSettings settings;
        settings.channels = {{"/holed", "dut"}};
        QCOMPARE(findingId(readMade(make, settings)), std::string("CAP-018"));
    }

    void read_userBlock_offsetsCountIt()
    {
        for (const std::vector<hsize_t> &chunk : {std::vector<hsize_t>{}, {512}}) {
            const std::vector<double> values = valuesOf(true, 16);
            {
                const Hdf5TestFile file(path(), 2048);
                file.dataset("/a", {values.size()}, {H5T_STD_I16LE, chunk}, H5T_NATIVE_DOUBLE,
                    values.data());
            }
            const auto set = openCapture(path(), {});
            QVERIFY2(set, sentence(set).c_str());
            QCOMPARE(set->inputs.at(0).format, std::string("hdf5"));
            QVERIFY(physical(set->shots[0].channels[0]) == values);
        }
    }

    void read_hardLinkCircleAndSecondName_eachDatasetOnce()
    {
        const auto set = readMade([](const Hdf5TestFile &file) {
            ramp(file, "/g/a");
            H5Lcreate_hard(file.id(), "/", file.id(), "/g/up", H5P_DEFAULT, H5P_DEFAULT);
            H5Lcreate_hard(file.id(), "/g/a", file.id(), "/same", H5P_DEFAULT, H5P_DEFAULT);
            H5Lcreate_soft("/g/a", file.id(), "/soft", H5P_DEFAULT, H5P_DEFAULT);
            H5Lcreate_external("/etc/x.h5", "/a", file.id(), "/ext", H5P_DEFAULT, H5P_DEFAULT);
        });
        QVERIFY2(set, sentence(set).c_str());
        QCOMPARE(set->shots[0].channels.size(), 1U);
        QVERIFY(hasFinding(set->findings, "CAP-026")); // links not followed
    }

    void read_threeLongRecords_opensWithoutReadingThem()
    {
        constexpr hsize_t kLong = 100'000'000;
        {
            const Hdf5TestFile file(path("long.h5"), 0, true);
            for (const char *name : {"/a", "/b", "/c"}) { // holes in the file: no disk is used
                const hid_t space = H5Screate_simple(1, &kLong, nullptr);
                const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
                H5Pset_alloc_time(creation, H5D_ALLOC_TIME_EARLY);
                H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER);
                H5Dclose(H5Dcreate2(
                    file.id(), name, H5T_STD_I16LE, space, H5P_DEFAULT, creation, H5P_DEFAULT));
                H5Pclose(creation);
                H5Sclose(space);
            }
        }
        QElapsedTimer timer;
        timer.start();
        const auto set = openCapture(path("long.h5"), {});
        const qint64 took_ms = timer.elapsed();
        qInfo("3 x 100 MS opened in %lld ms", took_ms);
        QVERIFY2(set, sentence(set).c_str());
        QCOMPARE(set->shots[0].channels.size(), 3U);
        QCOMPARE(set->shots[0].channels[2].samples.size(), Index(kLong));
        QVERIFY(!set->shots[0].channels[2].samples.isInMemory());
        constexpr qint64 kSlowMachine_ms = 250; // reading 600 MB takes longer on any
        QVERIFY(took_ms < kSlowMachine_ms);
    }

    void list_everyKind_saysWhatItIs()
    {
        {
            const Hdf5TestFile file(path());
            ramp(file, "/entry/data", 100);
            file.text("/entry/data", "units", "bar");
            file.number("/entry/data", "fs", 1e6);
            file.dataset("/entry/table", {80, 2}, {H5T_STD_U16BE, {10, 2}}, H5T_NATIVE_DOUBLE,
                valuesOf(false, 16, 160).data());
            file.claim("/entry/never", {10}, {H5T_STD_I32LE, {}});
            const hid_t text = H5Tcopy(H5T_C_S1);
            H5Tset_size(text, 8);
            file.claim("/text", {3}, {text, {}});
            H5Tclose(text);
        }
        const auto list = listDatasets(path());
        QVERIFY2(list, sentence(list).c_str());
        QCOMPARE(list->size(), 4U);
        const DatasetEntry &data = list->at(0);
        QCOMPARE(data.path, std::string("/entry/data"));
        QCOMPARE(data.type, std::string("float64"));
        QVERIFY(data.shape == std::vector<std::uint64_t>{100});
        QVERIFY(data.channels == Names{"/entry/data"});
        QCOMPARE(data.attributes.at("units"), std::string("bar"));
        QCOMPARE(data.attributes.at("fs"), numberText(1e6));
        QVERIFY(std::string_view(data.whyNot.text).empty());
        const DatasetEntry &never = list->at(1);
        QVERIFY(never.channels.empty() && contains(english(never.whyNot), "claims more"));
        QCOMPARE(list->at(2).type, std::string("uint16 big-endian"));
        QVERIFY(list->at(2).channels == (Names{"/entry/table[:,0]", "/entry/table[:,1]"}));
        QCOMPARE(list->at(3).type, std::string("text"));
        QVERIFY(list->at(3).channels.empty() && !english(list->at(3).whyNot).empty());
    }

    void list_fewValues_areNoWaveform()
    {
        {
            const Hdf5TestFile file(path());
            ramp(file, "/a", 64);
            ramp(file, "/c", 3);
        }
        const auto list = listDatasets(path());
        QVERIFY2(list, sentence(list).c_str());
        QVERIFY(list->at(0).channels == Names{"/a"});
        QVERIFY(list->at(1).channels.empty());
        QCOMPARE(
            english(list->at(1).whyNot), std::string("Dataset /c has 3 values - not a waveform."));
    }

    void list_noHdf5_fails()
    {
        QCOMPARE(findingId(listDatasets(path("missing.h5"))), std::string("CAP-018"));
        QCOMPARE(findingId(listDatasets(write(m_folder.filePath("x.h5"), "\x89HDF\r\n\x1a\n"))),
            std::string("CAP-018"));
    }

    void read_fileOfAnIndependentWriter_sameValues()
    {
        const QString script
            = "import sys, h5py, numpy as np\n"
              "f = h5py.File(sys.argv[1], 'w')\n"
              "e = f.create_group('entry'); e.attrs['NX_class'] = 'NXentry'\n"
              "d = e.create_dataset('p', data=np.arange(3000, dtype='u2'), chunks=(256,), compression='gzip', shuffle=True)\n"
              "d.attrs['units'] = 'Pa'; d.attrs['scale_factor'] = 0.25\n"
              "e.create_dataset('q', data=np.arange(3000, dtype='>f4'))\n"
              "e.create_dataset('time', data=np.arange(3000) * 1e-6)\n"
              "e.create_dataset('name', data='text')\n"
              "f['v'] = h5py.SoftLink('/entry/p')\n"
              "f.close()\n";
        if (!runPython(script, {QString::fromStdString(path("py.h5"))}))
            QSKIP("no Python with h5py here: files of an independent writer not covered");
        const auto set = openCapture(path("py.h5"), {});
        QVERIFY2(set, sentence(set).c_str());
        QVERIFY(namesOf(set) == (Names{"/entry/p", "/entry/q"}));
        const Channel &p = set->shots[0].channels[0];
        QCOMPARE(p.unit, std::string("Pa"));
        constexpr double kTimesRounding = 1e-9;
        QVERIFY(std::abs(p.sampleRate_Hz - 1e6) < kTimesRounding * 1e6);
        for (Index i = 0; i < 3000; ++i) {
            QCOMPARE(physicalValue(p, p.samples.at(i)), 0.25 * static_cast<double>(i));
            QCOMPARE(set->shots[0].channels[1].samples.at(i), static_cast<double>(i));
        }
    }
};

DYNCAL_TEST(TestForeignHdf5)
#include "tst_foreign_hdf5.moc"
