// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Rates, times, units and scales that foreign HDF5 files state.

#include "core/base/number_text.h"
#include "core/capture/formats/foreign/foreign_hdf5.h"
#include "tests/core/capture/formats/foreign/foreign_file.h"
#include "tests/support/test_program.h"

using namespace dyncal;
using namespace dyncal::testing;

class TestForeignRates : public QObject, ForeignFile
{
    Q_OBJECT

private slots:
    void read_rateStatements_data()
    {
        QTest::addColumn<QString>("place");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QVariant>("value");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("rate_Hz");
        QTest::newRow("ours") << "/g/a"
                              << "sample_rate_Hz" << QVariant(1e6) << "" << 1e6;
        QTest::newRow("group") << "/g"
                               << "SampleRate" << QVariant(2e5) << "" << 2e5;
        QTest::newRow("root") << "/"
                              << "fs" << QVariant(51200.0) << "" << 51200.0;
        QTest::newRow("kHz in the name") << "/g/a"
                                         << "sampling_rate_kHz" << QVariant(5.0) << "" << 5000.0;
        QTest::newRow("unit beside") << "/g/a"
                                     << "sample_rate" << QVariant(10.0) << "MHz" << 1e7;
        QTest::newRow("text with unit") << "/g/a"
                                        << "Sampling Frequency" << QVariant("100 MHz") << "" << 1e8;
        QTest::newRow("text") << "/g/a"
                              << "fs" << QVariant("25000") << "" << 25000.0;
        QTest::newRow("dt") << "/g/a"
                            << "dt" << QVariant(1e-6) << "" << 1e6;
        QTest::newRow("dt in us") << "/g/a"
                                  << "dt_us" << QVariant(0.5) << "" << 2e6;
        QTest::newRow("TDMS word") << "/g/a"
                                   << "wf_increment" << QVariant(1e-4) << "" << 1e4;
        QTest::newRow("interval") << "/g/a"
                                  << "sampling_interval_s" << QVariant(1.0) << "" << 1.0;
        QTest::newRow("interval unit") << "/g/a"
                                       << "sample_interval" << QVariant(10.0) << "ns" << 1e8;
        QTest::newRow("no unit, hardly seconds") << "/g/a"
                                                 << "dt" << QVariant(10.0) << "" << 0.0;
        QTest::newRow("no unit, hardly hertz") << "/g/a"
                                               << "fs" << QVariant(100e-3) << "" << 0.0;
        QTest::newRow("unit of something else") << "/g/a"
                                                << "sample_rate" << QVariant(1e6) << "rpm" << 0.0;
        QTest::newRow("zero") << "/g/a"
                              << "dt" << QVariant(0.0) << "s" << 0.0;
        QTest::newRow("negative") << "/g/a"
                                  << "fs" << QVariant(-1e6) << "Hz" << 0.0;
        QTest::newRow("nan") << "/g/a"
                             << "fs" << QVariant(kNan) << "" << 0.0;
        QTest::newRow("another word") << "/g/a"
                                      << "rate" << QVariant(1e6) << "" << 0.0;
    }

    void read_rateStatements()
    {
        QFETCH(QString, place);
        QFETCH(QString, name);
        QFETCH(QVariant, value);
        QFETCH(QString, unit);
        QFETCH(double, rate_Hz);
        const auto set = readMade([&](const Hdf5TestFile &file) {
            ramp(file, "/g/a");
            const std::string object = place.toStdString();
            if (value.userType() == QMetaType::QString)
                file.text(object, name.toStdString(), value.toString().toStdString());
            else
                file.number(object, name.toStdString(), value.toDouble());
            if (!unit.isEmpty())
                file.text(object, name.toStdString() + "_units", unit.toStdString());
        });
        QVERIFY2(set, sentence(set).c_str());
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, rate_Hz);
    }

    void read_ratesThatContradict_unknownAndSaid()
    {
        const auto set = readMade([](const Hdf5TestFile &file) {
            ramp(file, "/a");
            file.number("/a", "fs", 1e6);
            file.number("/a", "dt", 1e-5);
        });
        QVERIFY(set && hasFinding(set->findings, "CAP-003"));
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 0.0);
    }

    void read_nearestStatementCounts()
    {
        const auto set = readMade([](const Hdf5TestFile &file) {
            ramp(file, "/g/a");
            ramp(file, "/g/b");
            file.number("/g/a", "fs", 1e6);
            file.number("/g", "fs", 5e5);
        });
        QVERIFY2(set, sentence(set).c_str());
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 1e6);
        QCOMPARE(set->shots[0].channels[1].sampleRate_Hz, 5e5);
    }

    void read_singleValueBesideTheRecord_isItsRate()
    {
        const auto set = readMade([](const Hdf5TestFile &file) {
            ramp(file, "/g/a");
            file.doubles("/g/dt", {2e-6});
        });
        QVERIFY2(set, sentence(set).c_str());
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 5e5);
    }

    void read_datasetOfTimes_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<bool>("single");
        QTest::addColumn<double>("rate_Hz");
        QTest::newRow("seconds") << "time"
                                 << "s" << false << 1e3;
        QTest::newRow("no unit") << "t"
                                 << "" << false << 1e3;
        QTest::newRow("ms") << "Time"
                            << "ms" << false << 1e6;
        QTest::newRow("us in the name") << "time_us"
                                        << "" << false << 1e9;
        QTest::newRow("float32") << "time"
                                 << "s" << true << 1e3;
        QTest::newRow("a temperature") << "t"
                                       << "K" << false << 0.0;
    }

    void read_datasetOfTimes()
    {
        QFETCH(QString, name);
        QFETCH(QString, unit);
        QFETCH(bool, single);
        QFETCH(double, rate_Hz);
        const std::string axis = "/g/" + name.toStdString();
        const auto set = readMade([&](const Hdf5TestFile &file) {
            ramp(file, "/g/p");
            file.dataset(axis, {1000}, {single ? H5T_IEEE_F32LE : H5T_IEEE_F64LE, {}},
                H5T_NATIVE_DOUBLE, times(1000, -0.05, 1e-3).data());
            if (!unit.isEmpty())
                file.text(axis, "units", unit.toStdString());
        });
        QVERIFY2(set, sentence(set).c_str());
        constexpr double kSinglePrecision = 1e-6;
        const Channel &channel = *channelNamed(set->shots[0], "/g/p");
        QVERIFY(std::abs(channel.sampleRate_Hz - rate_Hz) <= kSinglePrecision * rate_Hz);
        const bool isAxis = rate_Hz > 0.0;
        QCOMPARE(channelNamed(set->shots[0], axis) == nullptr, isAxis);
        QCOMPARE(channel.t0_s < 0.0, isAxis);
    }

    void read_timesWithAGap_rateUnknownAndSaid()
    {
        const auto set = readMade([](const Hdf5TestFile &file) {
            ramp(file, "/p");
            std::vector<double> axis = times(1000, 0.0, 1e-6);
            for (std::size_t i = 600; i < axis.size(); ++i)
                axis[i] += 1e-6;
            file.doubles("/time", axis);
        });
        QVERIFY(set && hasFinding(set->findings, "CAP-016"));
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 0.0);
    }

    void read_timesAgainstStatedRate_unknownAndSaid()
    {
        const auto set = readMade([](const Hdf5TestFile &file) {
            ramp(file, "/p");
            file.number("/p", "fs", 1e7);
            file.doubles("/time", times(1000, 0.0, 1e-6));
        });
        QVERIFY(set && hasFinding(set->findings, "CAP-003"));
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 0.0);
    }

    void read_unitAndScale_becomePhysicalValues()
    {
        const std::vector<std::int16_t> counts{-4, 0, 8};
        const auto set = readMade([&](const Hdf5TestFile &file) {
            for (const char *name : {"/cf", "/lab", "/scope/Channel 1 Data", "/scope/volts"})
                file.dataset(name, {3},
                    {std::string_view(name) == "/scope/volts" ? H5T_IEEE_F32LE : H5T_STD_I16LE, {}},
                    H5T_NATIVE_INT16, counts.data());
            file.number("/cf", "scale_factor", 0.5);
            file.number("/cf", "add_offset", 2.0);
            file.text("/cf", "units", "kPa");
            file.text("/cf", "long_name", "pressure");
            file.number("/lab", "scale", 4.0);
            file.text("/lab", "unit", "mV");
            file.number("/scope", "XInc", 1e-9);
            file.number("/scope", "XOrg", -1e-6);
            file.text("/scope", "XUnits", "Second");
            file.text("/scope", "YUnits", "Volt");
            file.number("/scope", "YInc", 0.25);
            file.number("/scope", "YOrg", 1.0);
        });
        QVERIFY2(set, sentence(set).c_str());
        const Channel &cf = *channelNamed(set->shots[0], "/cf");
        QVERIFY(physical(cf) == (std::vector<double>{0.0, 2.0, 6.0}));
        QCOMPARE(cf.unit, std::string("kPa"));
        QCOMPARE(cf.quantity, std::string("pressure"));
        const Channel &lab = *channelNamed(set->shots[0], "/lab");
        QVERIFY(physical(lab) == (std::vector<double>{-16.0, 0.0, 32.0}));
        QCOMPARE(lab.unit, std::string("mV"));
        const Channel &scope = *channelNamed(set->shots[0], "/scope/Channel 1 Data");
        QVERIFY(physical(scope) == (std::vector<double>{0.0, 1.0, 3.0}));
        QCOMPARE(scope.unit, std::string("V"));
        QCOMPARE(scope.sampleRate_Hz, 1e9);
        QCOMPARE(scope.t0_s, -1e-6);
        QVERIFY(physical(*channelNamed(set->shots[0], "/scope/volts"))
            == (std::vector<double>{-4.0, 0.0, 8.0}));
    }

    void read_scaleThatIsNoNumber_fails()
    {
        for (const char *name : {"scale", "add_offset"}) {
            const auto text = readMade([&](const Hdf5TestFile &file) {
                ramp(file, "/a");
                file.text("/a", name, "unity");
            });
            QCOMPARE(findingId(text), std::string("CAP-018"));
            const auto nan = readMade([&](const Hdf5TestFile &file) {
                ramp(file, "/a");
                file.number("/a", name, kNan);
            });
            QCOMPARE(findingId(nan), std::string("CAP-018"));
        }
    }

    void read_scaleStatedTwice_failsUnlessEqual()
    {
        for (const double other : {2.0, 3.0}) {
            const auto set = readMade([&](const Hdf5TestFile &file) {
                ramp(file, "/a");
                file.number("/a", "scale", 2.0);
                file.number("/a", "scale_factor", other);
            });
            QCOMPARE(set.has_value(), other == 2.0);
        }
    }
};

DYNCAL_TEST(TestForeignRates)
#include "tst_foreign_rates.moc"
