// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_conditions.h"
#include "core/shock/shock_estimate.h"
#include "tests/support/test_program.h"

#include "core/base/number_text.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;

namespace {

constexpr double kRate_Hz = 1e7;
constexpr double kFullChain = 1e-12; ///< the same formulas in the same order
constexpr double kDistance_m = 0.8;
constexpr double kVelocity_m_s = 512.8;
constexpr double kDutArrival_s = 2.0e-3;

constexpr double kFront_samples = 10.0;

/// Side-wall record: a step of `height` at `arrival_s` on a baseline, a second one later.
Channel sideChannel(double arrival_s, const std::string &name = "Driven side")
{
    constexpr double kBaseline = 0.3;
    constexpr double kHeight = 1.7;
    constexpr double kDuration_s = 5e-3;
    constexpr double kReflection_s = 1.3e-3;
    std::vector<double> values(static_cast<std::size_t>(kDuration_s * kRate_Hz));
    for (std::size_t i = 0; i < values.size(); ++i) {
        // Straight, so that the crossings interpolated between samples are exact.
        const double position = static_cast<double>(i) - arrival_s * kRate_Hz;
        const double front = std::clamp(position / kFront_samples + 0.5, 0.0, 1.0);
        const double noise = 1e-4 * std::sin(1.7 * static_cast<double>(i * i % 1009));
        const bool reflected
            = static_cast<double>(i) > (arrival_s + kReflection_s + 1e-3) * kRate_Hz;
        values[i] = kBaseline + kHeight * front + (reflected ? 2.0 : 0.0) + noise;
    }
    Channel channel;
    channel.name = name;
    channel.role = ChannelRole::DrivenSide;
    channel.samples = RawSamples(std::move(values));
    channel.sampleRate_Hz = kRate_Hz;
    return channel;
}

/// Half of 0.85 of the 10-90 % rise time of the straight front.
constexpr double kTakenOff_s = 0.425 * 0.8 * kFront_samples / kRate_Hz;

/// What the arrivals give in a tube that slows no shock down, from places `distance_m` apart.
double seenVelocity_m_s(double distance_m)
{
    return distance_m / (kDistance_m / kVelocity_m_s + kTakenOff_s);
}

ShockSettings withoutAttenuation()
{
    ShockSettings settings;
    settings.attenuation = "none";
    return settings;
}

CaptureSet thesisSet(Index shotCount = 1)
{
    CaptureSet set;
    for (Index i = 0; i < shotCount; ++i) {
        Shot shot;
        shot.environment.p1_Pa = 101100.0;
        shot.environment.T1_K = 294.15;
        shot.environment.T4_K = 295.35;
        set.shots.push_back(shot);
    }
    set.tube["driven_length_m"] = "0.97";
    return set;
}

/// The thesis shot with a side sensor whose record shows the shock of `velocity_m_s`.
CaptureSet setWithSide(double velocity_m_s)
{
    CaptureSet set = thesisSet();
    set.shots[0].channels.push_back(sideChannel(kDutArrival_s - kDistance_m / velocity_m_s));
    set.tube["endflange_to_sensor2_m"] = numberText(kDistance_m);
    set.tube["u_endflange_to_sensor2_m"] = "0.0002";
    return set;
}

ShockSettings typedVelocity(double velocity_m_s)
{
    ShockSettings settings;
    settings.drivenGas = settings.driverGas = GasSettings(); // dry air, as in the thesis
    settings.velocity_m_s = velocity_m_s;
    return settings;
}

QStringList ids(const Findings &findings)
{
    QStringList list;
    for (const Finding &finding : findings)
        list << QString::fromStdString(finding.id);
    return list;
}

const Finding *findingWithId(const Findings &findings, const char *id)
{
    const auto found = std::find_if(
        findings.begin(), findings.end(), [&](const Finding &f) { return f.id == id; });
    return found != findings.end() ? &*found : nullptr;
}

double relativeError(double actual, double expected)
{
    return std::abs(actual - expected) / std::abs(expected);
}

const std::vector<DutArrival> kArrival{{1, kDutArrival_s}};

} // namespace

class TestShockConditions : public QObject
{
    Q_OBJECT

private slots:
    void typedVelocity_thesisEnvironment_endWallStep();
    void typedVelocity_sideWall_stepOfIncidentShock();
    void typedStep_withoutAnythingElse_standsWithoutFindings();
    void typedStep_withVelocity_keepsStatesAndPlateau();
    void recipeValues_win_overEnvironment();
    void measuredVelocity_tubeAttribute_recoversVelocity();
    void measuredVelocity_recipeSensors_winOverTube();
    void measuredVelocity_threeSensorsOnALine_exact();
    void measuredVelocity_sideWall_needsTwoSensors();
    void missing_velocity_namesWhatIsMissing();
    void missing_distance_namesTheDistance();
    void missing_pressureAndTemperature_bothNamed();
    void missing_inEveryShot_saidOnce();
    void missing_dutArrival_named();
    void quietSideChannel_namedAsMissing();
    void swappedChannels_blockWithSentence();
    void slowVelocity_blocksShotWithSHK001();
    void slowVelocity_typedStep_isCautionOnly();
    void celsius_blocksWithSHK004();
    void distanceUncertainty_large_cautionWithFactor();
    void driverPressure_farFromComputed_info();
    void pressureOfAGauge_caution();
    void driver_computed_region4();
    void disabled_nothingDetermined();
    void excludedShots_areLeftOutAndNumbersKept();
    void settings_nonsense_usage();
};

void TestShockConditions::typedVelocity_thesisEnvironment_endWallStep()
{
    const auto result = estimateShockConditions(thesisSet(), {}, typedVelocity(512.82));
    QVERIFY(result.has_value());
    QCOMPARE(result->shots.size(), std::size_t(1));
    const ShockConditions &c = result->shots[0];
    QCOMPARE(c.shot, Index(1));
    QVERIFY(c.states.has_value());
    QVERIFY(std::abs(*c.step_Pa - 434576.931) < 6e-4); // metrology table, printed to 1 mPa
    QVERIFY(!c.stepTyped);
    QVERIFY(std::abs(*c.plateau_s - 1.626e-3) < 5e-7);
    QCOMPARE(ids(result->findings), QStringList({"SHK-005"}));
    QCOMPARE(english(result->findings[0].message),
        std::string(
            "The reflected shock's return from the contact surface reaches the end wall 1.63 ms after the step (computed)."));
}

void TestShockConditions::typedVelocity_sideWall_stepOfIncidentShock()
{
    ShockSettings settings = typedVelocity(512.82);
    settings.dutPosition = "side-wall";
    const auto result = estimateShockConditions(thesisSet(), {}, settings);
    QVERIFY(std::abs(*result->shots[0].step_Pa - (245274.331 - 101100.0)) < 6e-4);
    QVERIFY(!result->shots[0].plateau_s.has_value()); // the formula is the end wall's
}

void TestShockConditions::typedStep_withoutAnythingElse_standsWithoutFindings()
{
    CaptureSet set;
    set.shots.resize(2);
    ShockSettings settings;
    settings.step_Pa = PerShot({4.2e5, 4.2e5}); // one number for both would be told
    const auto result = estimateShockConditions(set, {}, settings);
    for (const ShockConditions &c : result->shots) {
        QCOMPARE(*c.step_Pa, 4.2e5);
        QVERIFY(c.stepTyped);
        QVERIFY(!c.states.has_value());
    }
    QVERIFY(result->findings.empty());
}

void TestShockConditions::typedStep_withVelocity_keepsStatesAndPlateau()
{
    ShockSettings settings = typedVelocity(512.8);
    settings.step_Pa = 4.2e5;
    const auto result = estimateShockConditions(thesisSet(), {}, settings);
    QCOMPARE(*result->shots[0].step_Pa, 4.2e5);
    QVERIFY(result->shots[0].states.has_value());
    QVERIFY(result->shots[0].plateau_s.has_value());
}

void TestShockConditions::recipeValues_win_overEnvironment()
{
    ShockSettings settings = typedVelocity(512.8);
    settings.p1_Pa = 50550.0;
    settings.T1_K = 280.0;
    settings.drivenLength_m = 1.94;
    const auto result = estimateShockConditions(thesisSet(), {}, settings);
    const auto expected = shockStates(Gas{}, 50550.0, 280.0, 512.8);
    QVERIFY(relativeError(*result->shots[0].step_Pa, expected->reflected.pressure_Pa - 50550.0)
        < kFullChain);
    QVERIFY(
        relativeError(*result->shots[0].plateau_s, plateauTime_s(*expected, 1.94)) < kFullChain);
}

void TestShockConditions::measuredVelocity_tubeAttribute_recoversVelocity()
{
    // Noise of 1e-4 on 1.7 V over 10 samples moves crossing and rise by some 1e-3 samples of 15600.
    constexpr double kCrossing = 1e-7;
    const auto result
        = estimateShockConditions(setWithSide(kVelocity_m_s), kArrival, withoutAttenuation());
    const ShockConditions &c = result->shots[0];
    QVERIFY(c.states.has_value());
    QVERIFY2(relativeError(c.states->velocity_m_s, seenVelocity_m_s(kDistance_m)) < kCrossing,
        qPrintable(QString::number(c.states->velocity_m_s, 'g', 12)));
    QCOMPARE(c.distance_m, kDistance_m);
    QVERIFY(std::abs(*c.arrival_s - (kDutArrival_s - kDistance_m / kVelocity_m_s - kTakenOff_s))
        < 1e-9);
    QVERIFY(findingWithId(result->findings, "SHK-003") == nullptr); // 0.025 %
}

void TestShockConditions::measuredVelocity_recipeSensors_winOverTube()
{
    CaptureSet set = setWithSide(kVelocity_m_s);
    ShockSettings settings = withoutAttenuation();
    settings.arrivalSensors = {{"driven_side", kDistance_m * 1.01, 0.0}}; // by role
    const auto byRole = estimateShockConditions(set, kArrival, settings);
    QVERIFY(
        relativeError(byRole->shots[0].states->velocity_m_s, seenVelocity_m_s(kDistance_m * 1.01))
        < 1e-7);
    settings.arrivalSensors = {{"Driven side", kDistance_m * 1.02, 0.0}}; // by name
    const auto byName = estimateShockConditions(set, kArrival, settings);
    QVERIFY(
        relativeError(byName->shots[0].states->velocity_m_s, seenVelocity_m_s(kDistance_m * 1.02))
        < 1e-7);
}

void TestShockConditions::measuredVelocity_threeSensorsOnALine_exact()
{
    CaptureSet set = thesisSet();
    ShockSettings settings = withoutAttenuation();
    for (const double distance_m : {0.2, 0.8, 0.5}) {
        const std::string name = "toa" + numberText(distance_m);
        set.shots[0].channels.push_back(
            sideChannel(kDutArrival_s - distance_m / kVelocity_m_s, name));
        settings.arrivalSensors.push_back(
            {.channel = name, .distanceToEndWall_m = distance_m, .delay_s = 0.0});
    }
    const auto result = estimateShockConditions(set, kArrival, settings);
    QVERIFY(relativeError(result->shots[0].states->velocity_m_s, kVelocity_m_s) < 1e-7);
    QCOMPARE(result->shots[0].distance_m, 0.8); // the farthest one is the one reported
}

void TestShockConditions::measuredVelocity_sideWall_needsTwoSensors()
{
    CaptureSet set = setWithSide(kVelocity_m_s);
    ShockSettings settings = withoutAttenuation();
    settings.dutPosition = "side-wall";
    const auto one = estimateShockConditions(set, kArrival, settings);
    QVERIFY(!one->shots[0].step_Pa.has_value());
    QCOMPARE(ids(one->findings), QStringList({"SHK-007"}));
    set.shots[0].channels.push_back(sideChannel(kDutArrival_s - 0.4 / kVelocity_m_s, "near"));
    settings.arrivalSensors = {{"Driven side", kDistance_m, 0.0}, {"near", 0.4, 0.0}};
    const auto two = estimateShockConditions(set, {}, settings);
    QVERIFY(two->shots[0].states.has_value());
    QVERIFY(relativeError(two->shots[0].states->velocity_m_s, kVelocity_m_s) < 1e-6);
}

void TestShockConditions::missing_velocity_namesWhatIsMissing()
{
    const auto result = estimateShockConditions(thesisSet(), kArrival, {});
    QVERIFY(!result->shots[0].step_Pa.has_value());
    QVERIFY(!result->shots[0].states.has_value());
    QCOMPARE(ids(result->findings), QStringList({"SHK-007"}));
    QCOMPARE(result->findings[0].severity, Severity::Info);
    const std::string text = english(result->findings[0].message);
    QVERIFY2(text.find("The pressure step is not determined: the shock velocity is unknown") == 0,
        text.c_str());
}

void TestShockConditions::missing_distance_namesTheDistance()
{
    CaptureSet set = setWithSide(kVelocity_m_s);
    for (const char *useless : {"", "unknown", "0", "-0.8"}) {
        set.tube["endflange_to_sensor2_m"] = useless;
        const auto result = estimateShockConditions(set, kArrival, {});
        QVERIFY(!result->shots[0].step_Pa.has_value());
        QVERIFY(english(result->findings.at(0).message).find("distance") != std::string::npos);
    }
}

void TestShockConditions::missing_pressureAndTemperature_bothNamed()
{
    CaptureSet set;
    set.shots.resize(1);
    const auto result = estimateShockConditions(set, {}, typedVelocity(512.8));
    QCOMPARE(ids(result->findings), QStringList({"SHK-007", "SHK-007"}));
    QVERIFY(english(result->findings[0].message).find("p1") != std::string::npos);
    QVERIFY(english(result->findings[1].message).find("T1") != std::string::npos);
    QVERIFY(!result->shots[0].step_Pa.has_value());
}

void TestShockConditions::missing_inEveryShot_saidOnce()
{
    const auto all = estimateShockConditions(thesisSet(3), {}, {});
    QCOMPARE(ids(all->findings), QStringList({"SHK-007"}));
    QCOMPARE(all->findings[0].shot, Index(0));
    CaptureSet set = thesisSet(3);
    set.shots[1].environment.T1_K = std::nan("");
    const auto one = estimateShockConditions(set, {}, typedVelocity(512.8));
    const Finding *missing = findingWithId(one->findings, "SHK-007");
    QVERIFY(missing != nullptr);
    QCOMPARE(missing->shot, Index(2));
    QVERIFY(one->ofShot(1)->step_Pa.has_value());
    QVERIFY(!one->ofShot(2)->step_Pa.has_value());
    QVERIFY(one->ofShot(3)->step_Pa.has_value());
    QVERIFY(one->ofShot(4) == nullptr);
}

void TestShockConditions::missing_dutArrival_named()
{
    const auto result = estimateShockConditions(setWithSide(kVelocity_m_s), {}, {});
    QVERIFY(!result->shots[0].step_Pa.has_value());
    QVERIFY(
        english(result->findings.at(0).message).find("arrival at the DUT") != std::string::npos);
    QVERIFY(result->shots[0].arrival_s.has_value());
}

void TestShockConditions::quietSideChannel_namedAsMissing()
{
    CaptureSet set = setWithSide(kVelocity_m_s);
    set.shots[0].channels[0].samples = RawSamples(std::vector<double>(50000, 0.0));
    const auto result = estimateShockConditions(set, kArrival, {});
    QVERIFY(!result->shots[0].step_Pa.has_value());
    QVERIFY(english(result->findings.at(0).message).find("'Driven side'") != std::string::npos);
    ShockSettings settings;
    settings.arrivalSensors = {{"no such channel", 0.8, 0.0}};
    const auto unknown = estimateShockConditions(set, kArrival, settings);
    QVERIFY(
        english(unknown->findings.at(0).message).find("'no such channel'") != std::string::npos);
}

void TestShockConditions::swappedChannels_blockWithSentence()
{
    const std::vector<DutArrival> early{{1, kDutArrival_s - kDistance_m / kVelocity_m_s - 3.1e-4}};
    CaptureSet set = setWithSide(kVelocity_m_s);
    Channel dut;
    dut.name = "PXI 0";
    dut.role = ChannelRole::Dut;
    set.shots[0].channels.push_back(dut);
    const auto result = estimateShockConditions(set, early, {});
    QVERIFY(!result->shots[0].step_Pa.has_value());
    QCOMPARE(ids(result->findings), QStringList({"SHK-001"}));
    QCOMPARE(result->findings[0].severity, Severity::Block);
    QCOMPARE(english(result->findings[0].message),
        std::string(
            "The shock reaches 'Driven side' 310 \xC2\xB5s after 'PXI 0', which is farther down the tube: check whether the two channels are swapped (CAP-010), and their distances."));
}

void TestShockConditions::slowVelocity_blocksShotWithSHK001()
{
    CaptureSet set = thesisSet(2);
    const auto result = estimateShockConditions(set, {}, typedVelocity(51.28));
    QVERIFY(result.has_value());
    QCOMPARE(ids(result->findings), QStringList({"SHK-001", "SHK-001", "SHK-018"}));
    QCOMPARE(result->findings[1].shot, Index(2));
    QCOMPARE(result->findings[0].severity, Severity::Block);
    QVERIFY(!result->shots[0].step_Pa.has_value());
}

void TestShockConditions::slowVelocity_typedStep_isCautionOnly()
{
    ShockSettings settings = typedVelocity(51.28);
    settings.step_Pa = 4.2e5;
    const auto result = estimateShockConditions(thesisSet(), {}, settings);
    QCOMPARE(result->findings.at(0).severity, Severity::Caution);
    QCOMPARE(*result->shots[0].step_Pa, 4.2e5);
}

void TestShockConditions::celsius_blocksWithSHK004()
{
    ShockSettings settings = typedVelocity(512.8);
    settings.T1_K = 21.0;
    const auto result = estimateShockConditions(thesisSet(), {}, settings);
    QCOMPARE(ids(result->findings), QStringList({"SHK-004"}));
    QCOMPARE(result->findings[0].severity, Severity::Block);
    QVERIFY(english(result->findings[0].message).find("294.15 K") != std::string::npos);
}

void TestShockConditions::distanceUncertainty_large_cautionWithFactor()
{
    CaptureSet set = setWithSide(kVelocity_m_s);
    set.tube["u_endflange_to_sensor2_m"] = numberText(kDistance_m * 0.0033);
    ShockSettings settings = withoutAttenuation();
    settings.drivenGas = GasSettings(); // the thesis' dry air
    const auto result = estimateShockConditions(set, kArrival, settings);
    const Finding *finding = findingWithId(result->findings, "SHK-003");
    QVERIFY(finding != nullptr);
    QCOMPARE(finding->severity, Severity::Caution);
    QVERIFY(relativeError(*finding->value, 0.0033) < 1e-9);
    // The factor d ln(p5 - p1) / d ln W at the thesis point is 4.65354.
    QCOMPARE(english(finding->message),
        std::string(
            "The distance alone makes the velocity uncertain by 0.33 %, which gives 1.5 % on the pressure step (factor 4.65)."));
}

void TestShockConditions::driverPressure_farFromComputed_info()
{
    CaptureSet set = thesisSet();
    set.shots[0].environment.p4_Pa = 0.596e6;
    const auto low = estimateShockConditions(set, {}, typedVelocity(512.8));
    const Finding *finding = findingWithId(low->findings, "SHK-006");
    QVERIFY(finding != nullptr);
    QCOMPARE(finding->severity, Severity::Info);
    QCOMPARE(english(finding->message),
        std::string(
            "Driver pressure 596 kPa is 13 % below the 685 kPa that the shock implies (both absolute): usual for a finite opening time."));
    set.shots[0].environment.p4_Pa = 0.670e6;
    const auto near = estimateShockConditions(set, {}, typedVelocity(512.8));
    QVERIFY(findingWithId(near->findings, "SHK-006") == nullptr);
}

/// p1 of 150 Pa read from a gauge: every pressure behind it is a share of the true one.
void TestShockConditions::pressureOfAGauge_caution()
{
    CaptureSet set = thesisSet();
    set.shots[0].environment.p4_Pa = 0.670e6;
    set.shots[0].environment.p1_Pa = 150.0;
    const auto gauge = estimateShockConditions(set, {}, typedVelocity(512.8));
    const Finding *finding = findingWithId(gauge->findings, "SHK-006");
    QVERIFY(finding != nullptr);
    QCOMPARE(finding->severity, Severity::Caution);
    const std::vector causes{FindingCause::Pressure, FindingCause::Gas};
    QCOMPARE(finding->causes, causes);
    set.shots[0].environment.p1_Pa = thesisSet().shots[0].environment.p1_Pa;
    set.shots[0].environment.p4_Pa = 4.0 * 0.685e6;
    const auto lossy = estimateShockConditions(set, {}, typedVelocity(512.8));
    QCOMPARE(findingWithId(lossy->findings, "SHK-006")->severity, Severity::Info);
}

void TestShockConditions::driver_computed_region4()
{
    const auto result = estimateShockConditions(thesisSet(), {}, typedVelocity(512.82));
    const auto &driver = result->shots[0].driver;
    QVERIFY(driver.has_value());
    QVERIFY(std::abs(driver->pressure_Pa - 684846.955) < 6e-4);
    QVERIFY(std::abs(driver->density_kg_m3 - 8.07813107) < 6e-9);
    CaptureSet set = thesisSet();
    set.shots[0].environment.T4_K = std::nan("");
    QVERIFY(!estimateShockConditions(set, {}, typedVelocity(512.8))->shots[0].driver.has_value());
    ShockSettings celsius = typedVelocity(512.8);
    celsius.T4_K = 22.2; // no result depends on region 4: said, not blocked
    const auto warned = estimateShockConditions(thesisSet(), {}, celsius);
    QCOMPARE(findingWithId(warned->findings, "SHK-004")->severity, Severity::Caution);
    QVERIFY(warned->shots[0].step_Pa.has_value());
}

void TestShockConditions::disabled_nothingDetermined()
{
    ShockSettings settings = typedVelocity(512.8);
    settings.enabled = false;
    settings.step_Pa = 4.2e5;
    const auto result = estimateShockConditions(thesisSet(2), {}, settings);
    QCOMPARE(result->shots.size(), std::size_t(2));
    QVERIFY(!result->shots[0].step_Pa.has_value());
    QVERIFY(result->findings.empty());
}

void TestShockConditions::excludedShots_areLeftOutAndNumbersKept()
{
    CaptureSet set = thesisSet(3);
    set.shots[1].included = false;
    const auto result = estimateShockConditions(set, {}, typedVelocity(512.8));
    QCOMPARE(result->shots.size(), std::size_t(2));
    QCOMPARE(result->shots[1].shot, Index(3));
    QVERIFY(result->ofShot(2) == nullptr);
}

void TestShockConditions::settings_nonsense_usage()
{
    ShockSettings position;
    position.dutPosition = "roof";
    ShockSettings step;
    step.step_Pa = 0.0;
    ShockSettings sensor;
    sensor.arrivalSensors = {{"Driven side", -0.8, 0.0}};
    for (const ShockSettings &settings : {position, step, sensor}) {
        const auto result = estimateShockConditions(thesisSet(), {}, settings);
        QVERIFY(!result.has_value());
        QCOMPARE(result.error().kind, ErrorKind::Usage);
    }
}

DYNCAL_TEST(TestShockConditions)
#include "tst_shock_conditions.moc"
