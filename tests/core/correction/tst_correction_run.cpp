// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// From results.json and recordings to pressures: what command line and window share.

#include "core/base/content_hash.h"
#include "core/correction/correction_run.h"
#include "core/pipeline/early_stages.h"
#include "tests/support/made_results.h"
#include "tests/support/near.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr double kRate_Hz = 5e6;
constexpr Index kCount = 6000;
constexpr double kPeak_Pa = 1e5;
const CorrectionSettings kTo150kHz{150e3};

Channel channelOf(const std::string &name, ChannelRole role, double factor)
{
    const Eigen::VectorXd record = factor
        * TrueSensor().recordOf(kPeak_Pa * burst(kCount, kRate_Hz, 700e-6, 20e-6, 0.0), kRate_Hz);
    std::vector<double> values(record.begin(), record.end());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] += factor * 1e-7 * (double((i * 7919) % 13) - 6.0);
    Channel channel;
    channel.name = name;
    channel.role = role;
    channel.unit = "V";
    channel.sampleRate_Hz = kRate_Hz;
    channel.samples = RawSamples(std::move(values));
    return channel;
}

/// Two shots of the sensor, each beside another channel that recorded it three times as large.
CaptureSet recordings(ChannelRole role = ChannelRole::Dut)
{
    CaptureSet set;
    set.inputs.push_back({"/data/blast.csv", "blast.csv", "0123", "text"});
    set.shots.resize(2);
    for (Shot &shot : set.shots)
        shot.channels = {channelOf("side", ChannelRole::Other, 3.0), channelOf("blast", role, 1.0)};
    return set;
}

CalibrationSource calibration()
{
    return calibrationOf(MadeResults().text(), "results.json").value();
}

double largestOf(const ShotPressure &shot)
{
    return shot.record.pressure.pressure_Pa.cwiseAbs().maxCoeff();
}

/// The largest pressure of the first shot with these import settings.
double largestWith(const ImportSettings &import, ChannelRole role = ChannelRole::Dut)
{
    Recipe recipe;
    recipe.import = import;
    const auto prepared = prepareCaptures(recordings(role), recipe);
    const auto outcome = prepared.and_then([&](const PreparedCaptures &ready) {
        return correctRecordings(calibration(), ready.set, kTo150kHz);
    });
    if (!outcome)
        qWarning("%s", english(outcome.error().message).c_str());
    return outcome ? largestOf(outcome->shots.front()) : std::nan("");
}

} // namespace

class TestCorrectionRun : public QObject
{
    Q_OBJECT

private slots:
    void calibration_isReadFromItsFileOrFolder()
    {
        const ScratchFolder scratch;
        const std::string text = MadeResults().text();
        scratch.write("results.json", text.data(), text.size());
        const std::string folder = std::filesystem::path(scratch.file("x")).parent_path().string();
        for (const std::string &path : {scratch.file("results.json"), folder}) {
            const auto source = calibrationAt(path);
            QVERIFY(source.has_value());
            QCOMPARE(source->path, scratch.file("results.json"));
            QCOMPARE(source->file, std::string("results.json"));
            QCOMPARE(source->sha256, sha256Hex(text));
            QCOMPARE(source->text, text);
            QVERIFY(source->says.response.knot_Hz.size() > 20);
        }
        const auto none = calibrationAt(scratch.file("nothing"));
        QVERIFY(!none && none.error().kind == ErrorKind::FileUnreadable);
        QVERIFY(english(none.error().message).starts_with(scratch.file("nothing")));
    }

    /// The run of a project is corrected with as if it had been written and read.
    void textAndFile_giveTheSame()
    {
        const ScratchFolder scratch;
        const std::string text = MadeResults().text();
        const auto file = calibrationAt(scratch.write("results.json", text.data(), text.size()));
        const CalibrationSource made = calibration();
        QVERIFY(file.has_value());
        QCOMPARE(made.sha256, file->sha256);
        QCOMPARE(made.file, file->file);
        QVERIFY(made.path.empty());
        QVERIFY(made.says.response.atKnots == file->says.response.atKnots);
        QVERIFY(!calibrationOf("{}", "results.json"));
    }

    void everyIncludedShot_hasItsPressure()
    {
        CaptureSet set = recordings();
        set.shots[0].included = false;
        const auto outcome = correctRecordings(calibration(), set, kTo150kHz, {{}, {}, 50.0});
        QVERIFY2(outcome.has_value(), outcome ? "" : english(outcome.error().message).c_str());
        QCOMPARE(outcome->shots.size(), std::size_t(1));
        QCOMPARE(outcome->shots[0].shot, Index(2));
        QCOMPARE(outcome->shots[0].channel, std::string("blast"));
        QVERIFY(std::abs(largestOf(outcome->shots[0]) / kPeak_Pa - 1.0) < 1e-3);
        QVERIFY(outcome->isBoundStated);
        QCOMPARE(outcome->recordings.front().file, std::string("blast.csv"));
        QCOMPARE(outcome->calibration.sha256, calibration().sha256);
        QCOMPARE(outcome->filter.lowPass.band_Hz, 150e3);
    }

    /// What the recipe says of the recording is in its pressure: each of these was once left out.
    void importSettings_count()
    {
        QVERIFY(std::abs(largestWith({}) / kPeak_Pa - 1.0) < 1e-3);
        ImportSettings halved;
        halved.scale = 0.5;
        QVERIFY(std::abs(largestWith(halved) / kPeak_Pa - 0.5) < 1e-3);
        ImportSettings behindGain;
        behindGain.channelDetails["blast"].gain = 10.0;
        QVERIFY(std::abs(largestWith(behindGain) / kPeak_Pa - 0.1) < 1e-3);
        ImportSettings other;
        other.channels["side"] = "dut";
        QVERIFY(std::abs(largestWith(other) / kPeak_Pa - 3.0) < 1e-2);
        ImportSettings named;
        named.channels["blast"] = "dut";
        QVERIFY(std::abs(largestWith(named, ChannelRole::Other) / kPeak_Pa - 1.0) < 1e-3);
    }

    void invertedSensor_isTurned()
    {
        Recipe recipe;
        recipe.import.polarity = -1;
        const auto prepared = prepareCaptures(recordings(), recipe);
        const auto outcome = correctRecordings(calibration(), prepared->set, kTo150kHz);
        QVERIFY(outcome && outcome->shots[0].record.pressure.pressure_Pa.minCoeff() < -0.9e5);
    }

    void shotWithoutTheSensor_isNamed()
    {
        const auto outcome
            = correctRecordings(calibration(), recordings(ChannelRole::Other), kTo150kHz);
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().findingId, std::string("CAP-002"));
        QVERIFY(english(outcome.error().message).starts_with("Shot 1 has no channel of the DUT"));
    }

    void impossibleFilter_isRefused()
    {
        const auto outcome = correctRecordings(calibration(), recordings(), {9e6});
        QVERIFY(!outcome && outcome.error().kind == ErrorKind::Usage);
    }

    /// Of the sensor only: another channel at its rail says nothing of the pressure.
    void saturatedSensor_isNotCorrectable()
    {
        const CaptureSet set = recordings();
        const auto finding = [](const char *id, Severity severity, const char *channel) {
            Finding made;
            made.id = id;
            made.severity = severity;
            made.channel = channel;
            return made;
        };
        QVERIFY(areCorrectable({}, set));
        QVERIFY(areCorrectable({finding("CAP-008", Severity::Caution, "blast")}, set));
        QVERIFY(!areCorrectable({finding("CAP-007", Severity::Caution, "blast")}, set));
        QVERIFY(areCorrectable({finding("CAP-007", Severity::Caution, "side")}, set));
        QVERIFY(!areCorrectable({finding("CAP-006", Severity::Block, "")}, set));
    }

    void progress_growsToTheEnd_andStopIsHeard()
    {
        double last = 0.0;
        JobControl control;
        control.progress = [&](double fraction) {
            QVERIFY(fraction >= last);
            last = fraction;
        };
        QVERIFY(correctRecordings(calibration(), recordings(), kTo150kHz, {}, control));
        QCOMPARE(last, 1.0);
        std::stop_source stop;
        stop.request_stop();
        const auto stopped
            = correctRecordings(calibration(), recordings(), kTo150kHz, {}, {stop.get_token(), {}});
        QVERIFY(!stopped && stopped.error().kind == ErrorKind::Cancelled);
    }
};

DYNCAL_TEST(TestCorrectionRun)
#include "tst_correction_run.moc"
