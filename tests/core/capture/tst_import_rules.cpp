// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/content_hash.h"
#include "core/capture/capture_check.h"
#include "core/capture/import_rules.h"
#include "tests/support/test_program.h"

#include "core/base/number_text.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

Channel channel(const char *name, std::vector<double> values, double rate_Hz = 1e6)
{
    Channel c;
    c.name = name;
    c.samples = RawSamples(RawSamples::Counts(std::move(values)));
    c.sampleRate_Hz = rate_Hz;
    c.sha256 = sha256OfSamples(c.samples);
    return c;
}

CaptureSet set(std::vector<std::vector<Channel>> shots)
{
    CaptureSet s;
    for (auto &channels : shots) {
        Shot shot;
        shot.channels = std::move(channels);
        s.shots.push_back(std::move(shot));
    }
    return s;
}

std::vector<double> ramp(int count, double step = 1.0)
{
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(i * step);
    return values;
}

const Finding *find(const Findings &findings, const std::string &id)
{
    const auto found = std::find_if(
        findings.begin(), findings.end(), [&](const Finding &f) { return f.id == id; });
    return found != findings.end() ? &*found : nullptr;
}

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

} // namespace

class TestImportRules : public QObject
{
    Q_OBJECT

private slots:
    void oneChannel_isTheDut()
    {
        const auto done = applyImportSettings(set({{channel("x", ramp(9))}}), {});
        QVERIFY(done && done->shots[0].channelWithRole(ChannelRole::Dut));
    }

    void twoChannelsWithoutRole_stayOther()
    {
        const auto done
            = applyImportSettings(set({{channel("x", ramp(9)), channel("y", ramp(9))}}), {});
        QVERIFY(done && !done->shots[0].channelWithRole(ChannelRole::Dut));
        QVERIFY(find(checkCaptures(*done), "CAP-002"));
    }

    void roleOfOneShot_winsThereAlone()
    {
        const auto pair = [] {
            return std::vector<Channel>{channel("x", ramp(9)), channel("y", ramp(9))};
        };
        const CaptureSet shots = set({pair(), pair(), pair()});
        ImportSettings settings;
        settings.channels = {{"x", "dut"}, {"y", "driven_side"}};
        settings.polarity = -1; // of the DUT, whichever channel that is
        settings.shots = {{2, {{"x", "driven_side"}, {"y", "dut"}}}};
        const auto done = applyImportSettings(shots, settings);
        QVERIFY(done.has_value());
        for (std::size_t i = 0; i < 3; ++i) {
            const std::string dut = i == 1 ? "y" : "x";
            QCOMPARE(done->shots[i].channelWithRole(ChannelRole::Dut)->name, dut);
            QCOMPARE(done->shots[i].channelWithRole(ChannelRole::DrivenSide)->name,
                std::string(i == 1 ? "x" : "y"));
            QCOMPARE(done->shots[i].channelWithRole(ChannelRole::Dut)->polarity, -1.0);
        }
        settings.shots = {{2, {{"y", "dut"}}}}; // the DUT of all shots gives way there
        const auto oneName = applyImportSettings(shots, settings);
        QVERIFY(oneName.has_value());
        QCOMPARE(oneName->shots[1].channelWithRole(ChannelRole::Dut)->name, std::string("y"));
        const auto refused = [&](std::vector<ShotImport> list, const char *words) {
            settings.shots = std::move(list);
            const auto result = applyImportSettings(shots, settings);
            return !result && result.error().kind == ErrorKind::Usage
                && english(result.error().message).find(words) != std::string::npos;
        };
        QVERIFY(refused({{4, {{"x", "dut"}}}}, "the shots are 1 to 3"));
        QVERIFY(refused({{1, {{"x", "dut"}}}, {1, {{"y", "dut"}}}}, "names shot 1 twice"));
        QVERIFY(refused({{1, {{"z", "dut"}}}}, "import.shots[1].channels names a channel 'z'"));
    }

    void recipeRole_replacesTheFiles()
    {
        CaptureSet s = set({{channel("x", ramp(9)), channel("y", ramp(9))}});
        s.shots[0].channels[0].role = ChannelRole::Dut;
        ImportSettings settings;
        settings.channels = {{"y", "dut"}};
        const auto done = applyImportSettings(s, settings);
        QVERIFY(done.has_value());
        QCOMPARE(done->shots[0].channelWithRole(ChannelRole::Dut)->name, std::string("y"));
        QCOMPARE(done->shots[0].channels[0].role, ChannelRole::Other);
    }

    void unknownChannel_isRefusedWithTheKnownOnes()
    {
        ImportSettings settings;
        settings.channels = {{"z", "dut"}};
        const auto done
            = applyImportSettings(set({{channel("x", ramp(9)), channel("y", ramp(9))}}), settings);
        QVERIFY(!done);
        QCOMPARE(done.error().kind, ErrorKind::Usage);
        QVERIFY(english(done.error().message).find("'x', 'y'") != std::string::npos);
    }

    void missingRate_isRefusedUnlessGiven()
    {
        ImportSettings settings;
        QVERIFY(!applyImportSettings(set({{channel("x", ramp(9), 0.0)}}), settings));
        settings.sampleRate_Hz = 5e4;
        const auto done = applyImportSettings(set({{channel("x", ramp(9), 0.0)}}), settings);
        QVERIFY(done && done->shots[0].channels[0].sampleRate_Hz == 5e4);
        QVERIFY(!find(done->findings, "CAP-025"));
    }

    void missingRate_isExplainedByTheReaderOfThatFile()
    {
        CaptureSet two = set({{channel("x", ramp(9), 1e6)}, {channel("x", ramp(9), 0.0)}});
        two.inputs.resize(2);
        two.inputs[0].path = "a.mat";
        two.inputs[1].path = "b.mat";
        two.shots[1].input = 1;
        const auto said = [](const char *file, const char *ofChannel) {
            return Finding{.id = "CAP-003",
                .severity = Severity::Caution,
                .channel = ofChannel,
                .message = {"%1: fs and dt contradict each other.", {file}}};
        };
        const auto blockedBy = [&](const Findings &findings) {
            two.findings = findings;
            const auto done = applyImportSettings(two, {});
            return done ? std::string() : english(done.error().message);
        };
        QCOMPARE(
            blockedBy({said("b.mat", "")}), std::string("b.mat: fs and dt contradict each other."));
        QCOMPARE(blockedBy({said("b.mat", "x")}),
            std::string("b.mat: fs and dt contradict each other."));
        for (const Finding &other : {said("a.mat", ""), said("b.mat", "y")})
            QVERIFY(blockedBy({other}).find("states no sample rate") != std::string::npos);
        ImportSettings settings;
        settings.sampleRate_Hz = 1e6;
        two.findings = {said("b.mat", "")};
        QVERIFY(applyImportSettings(two, settings).has_value());
    }

    void rateThatNoRecordingHas_isRefused_data()
    {
        QTest::addColumn<double>("rate_Hz");
        QTest::addColumn<bool>("credible");
        for (const double rate_Hz : {0.1, 1.0 / 10.0, 1e12, 1.0 / 1e-12})
            QTest::addRow("%g Hz", rate_Hz) << rate_Hz << true;
        for (const double rate_Hz : {1e-300, 5e-324, 0.0999, 1.001e12, 1e300, 1.7e308})
            QTest::addRow("%g Hz", rate_Hz) << rate_Hz << false;
    }

    void rateThatNoRecordingHas_isRefused()
    {
        QFETCH(double, rate_Hz);
        QFETCH(bool, credible);
        ImportSettings typed;
        typed.sampleRate_Hz = rate_Hz;
        const auto ofFile = applyImportSettings(set({{channel("x", ramp(9), rate_Hz)}}), {});
        const auto ofRecipe = applyImportSettings(set({{channel("x", ramp(9), 0.0)}}), typed);
        for (const auto *done : {&ofFile, &ofRecipe}) {
            QCOMPARE(done->has_value(), credible);
            if (credible)
                continue;
            QCOMPARE(done->error().findingId, std::string("CAP-003"));
            QCOMPARE(done->error().kind, ErrorKind::DataBlocked);
            const std::string sentence = english(done->error().message);
            const std::string found = numberText(rate_Hz, 6) + " Hz";
            for (const char *part : {found.c_str(), "100 mHz to 1000 GHz"})
                QVERIFY2(sentence.find(part) != std::string::npos, sentence.c_str());
            QVERIFY2(sentence.find("inf") == std::string::npos, sentence.c_str());
        }
        typed.sampleRate_Hz = 1e6; // with a reason the file may be as wrong as it likes
        typed.sampleRateReason = "the times are nonsense";
        QVERIFY(applyImportSettings(set({{channel("x", ramp(9), rate_Hz)}}), typed));
    }

    void rateThatContradictsTheFile_needsAReason()
    {
        const CaptureSet s = set({{channel("x", ramp(9), 1e8)}, {channel("x", ramp(9), 1e8)}});
        ImportSettings settings;
        settings.sampleRate_Hz = 1e7;
        const auto refused = applyImportSettings(s, settings);
        QCOMPARE(refused.error().findingId, std::string("CAP-003"));
        QCOMPARE(refused.error().kind, ErrorKind::DataBlocked);
        const std::string sentence = english(refused.error().message);
        QVERIFY(sentence.find("100 MHz") != std::string::npos);
        QVERIFY(sentence.find("10 MHz") != std::string::npos);
        settings.sampleRateReason = "the recorder was set to 10 MHz";
        const auto replaced = applyImportSettings(s, settings);
        QCOMPARE(replaced->shots[1].channels[0].sampleRate_Hz, 1e7);
        QCOMPARE(replaced->findings.size(), std::size_t(1)); // for both shots
        QCOMPARE(replaced->findings[0].id, std::string("CAP-025"));
        QCOMPARE(replaced->findings[0].severity, Severity::Caution);
        QVERIFY(english(replaced->findings[0].message).find("was set to") != std::string::npos);
    }

    void rateWithinTheLimit_isAnInfo()
    {
        const CaptureSet s = set({{channel("x", ramp(9), 1e6)}});
        ImportSettings settings;
        settings.sampleRate_Hz = 1.0009e6; // 0.09 %
        QCOMPARE(applyImportSettings(s, settings)->findings[0].severity, Severity::Info);
        CheckSettings checks;
        checks.rateMismatch_percent = 0.05;
        QCOMPARE(
            applyImportSettings(s, settings, checks).error().findingId, std::string("CAP-003"));
        settings.sampleRate_Hz = 1e6;
        QVERIFY(applyImportSettings(s, settings)->findings.empty());
    }

    void unitScalePolarity_actOnTheDutOnly()
    {
        CaptureSet s = set({{channel("dut", ramp(9)), channel("side", ramp(9))}});
        s.shots[0].channels[0].role = ChannelRole::Dut;
        ImportSettings settings;
        settings.unit = "kPa";
        settings.scale = 2.5;
        settings.polarity = -1;
        settings.reference = "absolute";
        const auto done = applyImportSettings(s, settings);
        const Channel &dut = done->shots[0].channels[0];
        QCOMPARE(physicalValues(dut, 2, 1)[0], -5000.0);
        QCOMPARE(dut.unit, std::string("Pa"));
        QCOMPARE(dut.recordedUnit, std::string("kPa"));
        QCOMPARE(dut.reference, PressureReference::Absolute);
        QCOMPARE(physicalValues(done->shots[0].channels[1], 2, 1)[0], 2.0);
    }

    void units_becomeSi_data()
    {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("value"); ///< that a recorded 2 becomes
        QTest::addColumn<QString>("si");
        QTest::newRow("Pa") << "Pa" << 2.0 << "Pa";
        QTest::newRow("hPa") << "hPa" << 200.0 << "Pa";
        QTest::newRow("kPa") << "kPa" << 2e3 << "Pa";
        QTest::newRow("MPa") << "MPa" << 2e6 << "Pa";
        QTest::newRow("bar") << "bar" << 2e5 << "Pa";
        QTest::newRow("mbar") << "mbar" << 200.0 << "Pa";
        QTest::newRow("psi") << "psi" << 13789.514 << "Pa"; // 4.448221615 N / (25.4 mm)^2 each
        QTest::newRow("V") << "V" << 2.0 << "V";
        QTest::newRow("mV") << "mV" << 2e-3 << "V";
        QTest::newRow("uV") << "uV" << 2e-6 << "V";
        QTest::newRow("kV") << "kV" << 2e3 << "V";
        QTest::newRow("other") << "m/s^2" << 2.0 << "m/s^2";
    }

    void units_becomeSi()
    {
        QFETCH(QString, unit);
        QFETCH(double, value);
        QFETCH(QString, si);
        CaptureSet s = set({{channel("dut", ramp(9)), channel("side", ramp(9))}});
        s.shots[0].channels[1].unit = unit.toStdString();
        const auto done = applyImportSettings(s, {});
        const Channel &side = done->shots[0].channels[1];
        QCOMPARE(physicalValues(side, 2, 1)[0], value);
        QCOMPARE(QString::fromStdString(side.unit), si);
        QCOMPARE(side.recordedUnit.empty(), unit == si);
    }

    void psiOfTheScenario_isPascal()
    {
        CaptureSet s = set({{channel("dut", {0.0, 77.7})}});
        ImportSettings settings;
        settings.unit = "psi";
        const auto done = applyImportSettings(s, settings);
        const double read_Pa = physicalValues(done->shots[0].channels[0], 1, 1)[0];
        QVERIFY(std::abs(read_Pa / 0.5357e6 - 1.0) < 1e-3); // 77.7 psi = 0.536 MPa
    }

    void channelDetails_scaleGainAndSensitivityGivePascal()
    {
        // 2 V at the recorder, amplified 10 times, doubled by a divider: 0.4 V at a sensor of
        // 20 nV/Pa are 20 MPa.
        CaptureSet s = set({{channel("dut", ramp(9)), channel("side", ramp(9))}});
        ImportSettings settings;
        ChannelImport &side = settings.channelDetails["side"];
        side.scale = 2.0;
        side.gain = 10.0;
        side.sensitivity = 2e-8;
        side.polarity = -1;
        side.reference = "gauge";
        settings.channels = {{"side", "driven_side"}, {"dut", "dut"}};
        const auto done = applyImportSettings(s, settings);
        const Channel &channel = done->shots[0].channels[1];
        QCOMPARE(physicalValues(channel, 2, 1)[0], -2e7);
        QCOMPARE(channel.unit, std::string("Pa"));
        QCOMPARE(channel.reference, PressureReference::Gauge);
        QCOMPARE(channel.role, ChannelRole::DrivenSide);
        QCOMPARE(physicalValues(done->shots[0].channels[0], 2, 1)[0], 2.0);
    }

    void sensitivity_isPerSiUnit()
    {
        CaptureSet s = set({{channel("dut", ramp(9))}});
        ImportSettings settings;
        settings.channelDetails["dut"].unit = "mV";
        settings.channelDetails["dut"].sensitivity = 1e-6; // 1 uV/Pa, so 2 mV are 2 kPa
        const auto done = applyImportSettings(s, settings);
        QCOMPARE(physicalValues(done->shots[0].channels[0], 2, 1)[0], 2000.0);
    }

    void sensitivityOfAPressure_isRefused()
    {
        CaptureSet s = set({{channel("dut", ramp(9))}});
        s.shots[0].channels[0].unit = "bar";
        ImportSettings settings;
        settings.channelDetails["dut"].sensitivity = 1e-6;
        const auto done = applyImportSettings(s, settings);
        QCOMPARE(done.error().kind, ErrorKind::Usage);
        QVERIFY(english(done.error().message).find("bar") != std::string::npos);
    }

    void channelDetails_winOverTheDutsKeys()
    {
        CaptureSet s = set({{channel("dut", ramp(9))}});
        ImportSettings settings;
        settings.unit = "psi";
        settings.scale = 7.0;
        settings.channelDetails["dut"].unit = "kPa";
        const Channel dut = applyImportSettings(s, settings)->shots[0].channels[0];
        QCOMPARE(dut.recordedUnit, std::string("kPa"));
        QCOMPARE(physicalValues(dut, 2, 1)[0], 14000.0); // the scale is not said of the channel
    }

    void files_haveSettingsOfTheirOwn()
    {
        CaptureSet s = set({{channel("x", ramp(9)), channel("y", ramp(9, 2.0))},
            {channel("x", ramp(9)), channel("y", ramp(9, 2.0))}});
        s.inputs = {{"dir/a.csv", "a.csv", "1", "text"}, {"dir/b.csv", "b.csv", "2", "text"}};
        s.shots[1].input = 1;
        ImportSettings settings;
        settings.channels = {{"x", "dut"}};
        settings.files["b.csv"].channels = {{"y", "dut"}, {"x", "driven_side"}};
        settings.files["b.csv"].unit = "mV";
        settings.files["b.csv"].sampleRate_Hz = 2e6;
        settings.files["b.csv"].sampleRateReason = "known";
        const auto done = applyImportSettings(s, settings);
        QVERIFY2(done.has_value(), done ? "" : english(done.error().message).c_str());
        QCOMPARE(done->shots[0].channelWithRole(ChannelRole::Dut)->name, std::string("x"));
        QCOMPARE(done->shots[1].channelWithRole(ChannelRole::Dut)->name, std::string("y"));
        QCOMPARE(done->shots[1].channelWithRole(ChannelRole::DrivenSide)->name, std::string("x"));
        QCOMPARE(physicalValues(*done->shots[1].channelWithRole(ChannelRole::Dut), 2, 1)[0], 4e-3);
        QCOMPARE(done->shots[0].channels[0].sampleRate_Hz, 1e6);
        QCOMPARE(done->shots[1].channels[0].sampleRate_Hz, 2e6);
    }

    void fileThatIsNoInput_isRefusedWithTheKnownOnes()
    {
        CaptureSet s = set({{channel("x", ramp(9))}});
        s.inputs = {{"dir/a.csv", "a.csv", "1", "text"}};
        ImportSettings settings;
        settings.files["b.csv"].unit = "V";
        const auto done = applyImportSettings(s, settings);
        QCOMPARE(done.error().kind, ErrorKind::Usage);
        QVERIFY(english(done.error().message).find("'a.csv'") != std::string::npos);
        settings.files = {{"a.csv", {}}};
        settings.files["a.csv"].channels = {{"z", "dut"}};
        QVERIFY(english(applyImportSettings(s, settings).error().message).find("'z'")
            != std::string::npos);
    }

    void settingsOfFile_replaceOnlyWhatIsGiven()
    {
        ImportSettings all;
        all.decimal = ",";
        all.skipRows = 3;
        all.columns = {{"time", 0}, {"dut", 1}};
        all.files["b.csv"].skipRows = 0;
        all.files["b.csv"].columns = {{"dut", 4}};
        const ImportSettings own = settingsOfFile(all, "some/where/b.csv");
        QCOMPARE(own.skipRows.value(), Index(0));
        QCOMPARE(own.decimal, std::string(","));
        const std::map<std::string, Index> columns{{"dut", 4}};
        QVERIFY(own.columns == columns);
        QCOMPARE(settingsOfFile(all, "a.csv").skipRows.value(), Index(3));
    }

    void interpolation_fillsShortGapsOnly()
    {
        std::vector<double> values = ramp(20);
        values[5] = values[6] = kNaN;
        for (std::size_t i = 10; i < 14; ++i)
            values[i] = kNaN;
        ImportSettings settings;
        settings.interpolateInvalid = 2;
        const auto done = applyImportSettings(set({{channel("x", values)}}), settings);
        const Channel &dut = done->shots[0].channels[0];
        QCOMPARE(dut.samples.at(5), 5.0);
        QCOMPARE(dut.samples.at(6), 6.0);
        QVERIFY(std::isnan(dut.samples.at(11)));
        QCOMPARE(find(done->findings, "CAP-022")->value.value_or(0), 2.0);
        QCOMPARE(find(checkCaptures(*done), "CAP-006")->value.value_or(0), 4.0);
    }

    void interpolation_keepsTheTypeOfTheSamples()
    {
        Channel x = channel("x", {});
        x.samples = RawSamples(
            RawSamples::Counts(std::vector<float>{0.0F, 1.0F, static_cast<float>(kNaN), 3.0F}));
        ImportSettings settings;
        settings.interpolateInvalid = 1;
        const auto done = applyImportSettings(set({{x}}), settings);
        const RawSamples &samples = done->shots[0].channels[0].samples;
        QCOMPARE(samples.type(), SampleType::Float32);
        QCOMPARE(samples.at(2), 2.0);
    }

    void interpolation_leavesGapsAtTheEnds()
    {
        std::vector<double> values = ramp(10);
        values.front() = values.back() = kNaN;
        ImportSettings settings;
        settings.interpolateInvalid = 5;
        const auto done = applyImportSettings(set({{channel("x", values)}}), settings);
        QVERIFY(std::isnan(done->shots[0].channels[0].samples.at(0)));
        QVERIFY(std::isnan(done->shots[0].channels[0].samples.at(9)));
    }

    void exclusion_keepsTheReasonAndOneShot()
    {
        const CaptureSet two = set({{channel("x", ramp(9))}, {channel("x", ramp(9, 2.0))}});
        ImportSettings settings;
        settings.exclude = {{2, "diaphragm held"}};
        const auto done = applyImportSettings(two, settings);
        QVERIFY(done && !done->shots[1].included);
        QCOMPARE(done->shots[1].excludeReason, std::string("diaphragm held"));
        QVERIFY(find(checkCaptures(*done), "CAP-017"));
        settings.exclude = {{1, "a"}, {2, "b"}};
        QCOMPARE(applyImportSettings(two, settings).error().kind, ErrorKind::DataBlocked);
        settings.exclude = {{3, "c"}};
        QCOMPARE(applyImportSettings(two, settings).error().kind, ErrorKind::Usage);
    }

    void levels_mustMatchTheShots()
    {
        ImportSettings settings;
        settings.levels = {"low", "high"};
        const CaptureSet two = set({{channel("x", ramp(9))}, {channel("x", ramp(9, 2.0))}});
        QCOMPARE(applyImportSettings(two, settings)->shots[1].level, ShotLevel::High);
        settings.levels = {"low"};
        QVERIFY(!applyImportSettings(two, settings));
    }
};

DYNCAL_TEST(TestImportRules)
#include "tst_import_rules.moc"
