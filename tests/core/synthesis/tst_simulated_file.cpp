// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/content_hash.h"
#include "core/capture/formats/hdf5/hdf5_capture_reader.h"
#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

using namespace dyncal;

namespace {

constexpr const char *kCreated = "2026-01-02T03:04:05Z";

SimulatedCapture smallCapture()
{
    SimulationSettings settings;
    settings.sensor = sensorPreset("optic3").value();
    settings.sampleRate_Hz = 10e6;
    settings.duration_s = 0.004;
    settings.bits = 18; // 32 bit integers beside the floating point channel of the second shot
    settings.defects = {{DefectKind::Nan, 2}, {DefectKind::Psi, 3}, {DefectKind::Fs50, 1}};
    return simulateShots(settings).value();
}

void compareChannels(const Channel &read, const Channel &made)
{
    QCOMPARE(read.name, made.name);
    QCOMPARE(read.role, made.role);
    QCOMPARE(read.unit, made.unit);
    QCOMPARE(read.sampleRate_Hz, made.sampleRate_Hz);
    QCOMPARE(read.t0_s, made.t0_s);
    QCOMPARE(read.sensorId, made.sensorId);
    QCOMPARE(read.adcBits, made.adcBits);
    QCOMPARE(sha256OfSamples(read.samples), made.sha256);
    QCOMPARE(physicalValue(read, 1000.0), physicalValue(made, 1000.0));
}

} // namespace

/// A simulated capture is complete: written and read back, it is the same.
class TestSimulatedFile : public QObject
{
    Q_OBJECT

private slots:
    void writtenAndRead_sameCapture();
    void writtenTwice_sameBytes();
};

void TestSimulatedFile::writtenAndRead_sameCapture()
{
    QTemporaryDir folder;
    const std::string path = folder.filePath("simulated.h5").toStdString();
    const SimulatedCapture made = smallCapture();
    const auto written
        = writeHdf5Capture(made.set, {path, true}, kCreated, "simulated", made.truth);
    QVERIFY2(written.has_value(), written ? "" : english(written.error().message).c_str());
    const auto read = readHdf5Capture(path, {}, {});
    QVERIFY2(read.has_value(), read ? "" : english(read.error().message).c_str());
    QCOMPARE(read->shots.size(), made.set.shots.size());
    QCOMPARE(*read->tubeNumber("endflange_to_sensor2_m"), 0.8);
    QCOMPARE(read->sensors.size(), made.set.sensors.size());
    for (std::size_t s = 0; s < read->shots.size(); ++s) {
        QCOMPARE(read->shots[s].level, made.set.shots[s].level);
        QCOMPARE(read->shots[s].environment.T1_K, made.set.shots[s].environment.T1_K);
        QCOMPARE(read->shots[s].environment.p4_Pa, made.set.shots[s].environment.p4_Pa);
        QCOMPARE(read->shots[s].channels.size(), std::size_t(3));
        for (std::size_t c = 0; c < 3; ++c)
            compareChannels(read->shots[s].channels[c], made.set.shots[s].channels[c]);
    }
}

void TestSimulatedFile::writtenTwice_sameBytes()
{
    QTemporaryDir folder;
    const std::string first = folder.filePath("first.h5").toStdString();
    const std::string second = folder.filePath("second.h5").toStdString();
    for (const std::string &path : {first, second}) {
        const SimulatedCapture made = smallCapture();
        QVERIFY(writeHdf5Capture(made.set, {path, true}, kCreated, "simulated", made.truth)
                    .has_value());
    }
    QVERIFY(!sha256OfFile(first).empty());
    QCOMPARE(sha256OfFile(first), sha256OfFile(second));
}

DYNCAL_TEST(TestSimulatedFile)
#include "tst_simulated_file.moc"
