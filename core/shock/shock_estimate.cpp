// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_estimate.h"

#include "core/base/number_text.h"
#include "core/shock/gas_model.h"
#include "core/shock/settings_check.h"
#include "core/shock/shock_findings.h"
#include "core/shock/shock_work.h"
#include "core/shock/variable_shock.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

std::optional<double> firstKnown(const std::optional<double> &typed, double recorded)
{
    if (typed)
        return typed;
    return std::isfinite(recorded) ? std::optional<double>(recorded) : std::nullopt;
}

std::optional<double> length_m(
    const ShockWork &work, const std::optional<double> &typed, const char *attribute)
{
    const auto known = typed ? typed : work.set.tubeNumber(attribute);
    return known && *known > 0.0 ? known : std::nullopt;
}

void reportMissingPressureAndTemperature(ShockWork &work, bool hasPressure, bool hasTemperature)
{
    if (!hasPressure)
        work.reportMissing(Message{
            DYNCAL_TEXT("core",
                "The pressure step is not determined: the pressure p1 in the driven section is not recorded; enter p1 or the step itself."),
            {}});
    if (!hasTemperature)
        work.reportMissing(Message{
            DYNCAL_TEXT("core",
                "The pressure step is not determined: the temperature T1 in the driven section is not recorded; enter T1 or the step itself."),
            {}});
}

/// Plateau of a DUT in the side wall: until the reflected shock is back.
void addSideWall(ShockWork &work)
{
    const ShockStates &states = *work.conditions.states;
    const ShockSettings &settings = work.settings;
    if (settings.dutDiameter_m)
        work.conditions.sideWallLimit_Hz
            = sideWallLimit_Hz(*settings.dutDiameter_m, states.velocity_m_s);
    if (!settings.dutDistance_m)
        return;
    const double back_s = *settings.dutDistance_m
        * (1.0 / states.velocity_m_s + 1.0 / states.reflectedVelocity_m_s);
    work.conditions.plateau_s = std::max(back_s - settings.plateauGuard_s, 0.0);
    work.conditions.plateauEnd = PlateauEnd::ReflectedShock;
}

/// The levels behind the reflected shock, up to where the plateau's end may reach the sensor.
void readReturns(ShockWork &work, double atWall_s, double plateau_s)
{
    for (SeenArrival &seen : work.conditions.seen) {
        const Channel *channel = work.shot.channelCalled(seen.channel);
        const auto place
            = std::ranges::find(work.conditions.sightings, seen.channel, &Sighting::channel);
        if (!seen.found || !seen.found->back || channel == nullptr
            || place == work.conditions.sightings.end())
            continue;
        const double end_s = atWall_s + plateau_s
            + place->distance_m / work.conditions.states->reflected.soundSpeed_m_s;
        seen.found->back->level = levelBehindReturn(*channel, *seen.found->back, atWall_s, end_s);
    }
}

void addDiagram(
    ShockWork &work, const TubeWaves &waves, const std::optional<DutArrival> &dutArrival)
{
    ShockConditions &c = work.conditions;
    const bool atWall = dutArrival && work.atEndWall();
    const bool knowsFit = c.velocityFit && std::isfinite(c.velocityFit->arrivalAtWall_s);
    if (!knowsFit && !atWall)
        return;
    const double atWall_s = atWall ? dutArrival->time_s : c.velocityFit->arrivalAtWall_s;
    std::vector<TubeSensor> sensors;
    for (const Sighting &s : c.sightings)
        sensors.push_back({s.channel, s.distance_m, s.time_s, 0.0, 0.0});
    if (sensors.empty() || sensors.back().distance_m > 0.0)
        sensors.push_back({"end wall", 0.0, std::nullopt, 0.0, 0.0});
    c.diagram = tubeDiagram(
        waves, *c.states, atWall_s, std::move(sensors), c.plateau_s.value_or(waves.plateau_s));
    const auto p4_Pa = c.driver ? std::optional(c.driver->pressure_Pa) : std::nullopt;
    c.measured = work.before != nullptr && work.before->diagram
        ? besides(work.before->measured, *c.states, p4_Pa)
        : measuredPressures(work.shot, *c.states, c.sightings, atWall_s, waves.plateau_s,
            c.diagram->burst_s, p4_Pa);
    if (work.before == nullptr || !work.before->diagram)
        readReturns(work, atWall_s, waves.plateau_s);
}

/// Plateau, x-t diagram, resonances and pressures read from the records.
void addTube(ShockWork &work, const std::optional<DutArrival> &dutArrival)
{
    ShockConditions &c = work.conditions;
    const auto driven_m = length_m(work, work.settings.drivenLength_m, "driven_length_m");
    const auto driver_m = length_m(work, work.settings.driverLength_m, "driver_length_m");
    const Gas driverGas = c.driverGas ? c.driverGas->constants : Gas{};
    auto whole_m = work.settings.tubeLength_m;
    if (!whole_m && driven_m && driver_m)
        whole_m = *driven_m + *driver_m;
    c.resonances = tubeResonances(*c.states, c.driver, driverGas,
        {whole_m, driven_m, driver_m,
            length_m(work, work.settings.innerDiameter_m, "inner_diameter_m"),
            work.settings.wallSoundSpeed_m_s});
    if (!work.atEndWall())
        addSideWall(work);
    if (!driven_m)
        return;
    const TubeWaves waves = tubeWaves(*c.states, {*driven_m, driver_m, c.driver, driverGas});
    if (work.atEndWall()) {
        c.plateau_s = std::max(waves.plateau_s - work.settings.plateauGuard_s, 0.0);
        c.plateauEnd = waves.plateauEnd;
    }
    addDiagram(work, waves, dutArrival);
}

/// Eq 3.10 holds for constant heat capacities only, and Cramer's formula ends at 102 kPa, so moist
/// air in the driver is treated as `air` with the recipe's constants.
Result<GasModel> driverModel(GasSettings settings, double T4_K)
{
    if (settings.substance == "humid-air")
        settings.substance = "air";
    settings.heatCapacity = kConstantHeatCapacity;
    return gasModel(settings, {0.0, T4_K, 0.0, 0.0});
}

bool isDriverGasStated(const ShockWork &work)
{
    return work.settings.driverGas.substance != kAutoGas || work.set.tube.contains("driver_gas")
        || work.set.tube.contains("gamma4");
}

void addDriver(ShockWork &work)
{
    const auto T4_K = firstKnown(work.settings.T4_K, work.shot.environment.T4_K);
    if (!T4_K)
        return;
    auto driver = driverModel(chosenDriverGas(work.settings, work.set), *T4_K);
    if (!driver) {
        work.done = tl::unexpected(driver.error());
        return;
    }
    const auto p4_Pa = driverPressure_Pa(
        *work.conditions.states, work.conditions.drivenGas->constants, driver->constants, *T4_K);
    if (!p4_Pa) { // region 4 carries no result of the calibration
        const Error &error = p4_Pa.error();
        if (error.findingId.empty() && isDriverGasStated(work)) {
            judgeUnreachable(work, error);
            return;
        }
        work.findings.push_back({.id = error.findingId.empty() ? "SHK-006" : error.findingId,
            .severity = Severity::Caution,
            .shot = work.conditions.shot,
            .message = error.message,
            .correction = kelvinFor("shock.t4_k", *T4_K)});
        return;
    }
    work.conditions.driver = gasAtRest(driver->constants, *p4_Pa, *T4_K);
    work.conditions.expandedDriver
        = expandedDriver(*work.conditions.states, driver->constants, *p4_Pa, *T4_K);
    work.conditions.driverGas = std::move(*driver);
    judgeDriverPressure(work, *p4_Pa);
}

/// The velocity where the state follows from a pressure (eqs 3.1 and 3.10 inverted): p2, of which
/// the rise is `share` times what is typed, or so large a share of p4.
Result<double> velocityFromPressure(
    const ShockWork &work, double p1_Pa, double T1_K, double share = 1.0)
{
    const ShockSettings &settings = work.settings;
    const Gas &gas = work.conditions.drivenGas->constants;
    if (settings.stateFrom == "p2")
        return velocityOfShockedPressure_m_s(*work.conditions.drivenGas, p1_Pa, T1_K,
            p1_Pa + share * (settings.p2_Pa.value_or(0.0) - p1_Pa));
    const double T4_K = firstKnown(settings.T4_K, work.shot.environment.T4_K).value_or(T1_K);
    const auto driver = driverModel(chosenDriverGas(settings, work.set), T4_K);
    if (!driver)
        return tl::unexpected(driver.error());
    return velocityOfDriverPressure_m_s(gas, p1_Pa, T1_K, driver->constants,
        share * settings.p4_Pa.value_or(work.shot.environment.p4_Pa), T4_K);
}

/// What a usual error of that pressure makes of the velocity, relative: no u of a result, but what
/// the ways of the records are compared with.
double assumedOfPressure(const ShockWork &work, const SectionState &state, double velocity_m_s)
{
    const double error
        = work.settings.stateFrom == "p2" ? kAssumedRelativeRise : kAssumedRelativeDriver;
    const auto other
        = velocityFromPressure(work, state.pressure_Pa, state.temperature_K, 1.0 + error);
    return std::max(kAssumedRelativeVelocity,
        other ? std::abs(*other / velocity_m_s - 1.0) : kAssumedRelativeVelocity);
}

void addUncertainty(ShockWork &work, const SectionState &state, const VelocityEstimate &estimate)
{
    ShockConditions &c = work.conditions;
    if (!work.request.evaluate)
        return;
    const Environment &around = work.shot.environment;
    const GasWay &gas = work.gasWays.front();
    StepMeasurement measurement{gas.settings, state, estimate, {}, work.atEndWall(), around.u_p1_Pa,
        around.u_T1_K, gas.humidity.u, gas.humidity.distribution, work.recorded,
        c.stepTyped ? c.step_Pa : std::nullopt};
    if (estimate.fit && estimate.sightings.empty())
        measurement.counters = work.settings.counters;
    if (work.settings.stateFrom != "velocity") {
        c.uncertaintyMissing = Message{
            DYNCAL_TEXT("core", "Not evaluated where the state follows from a pressure."), {}};
        measurement.uAssumedVelocity_relative
            = assumedOfPressure(work, state, *estimate.velocity_m_s);
        c.measurement = std::move(measurement);
        return;
    }
    auto uncertainty = evaluateStep(measurement, work.request);
    if (!uncertainty) {
        c.uncertaintyMissing = uncertainty.error().message;
        if (uncertainty.error().kind == ErrorKind::Usage)
            work.done = tl::unexpected(uncertainty.error());
        return;
    }
    if (uncertainty->stepMissing)
        c.uncertaintyMissing = uncertainty->stepMissing;
    c.uncertainty = std::move(*uncertainty);
    c.measurement = std::move(measurement);
}

/// The driven gas at p1, T1; where it cannot be made a finding says what is missing. `state` gets
/// the humidity.
std::optional<GasModel> drivenModel(ShockWork &work, SectionState &state)
{
    work.gasWays = waysToDrivenGas(work.settings, work.set, work.shot.environment);
    const GasWay &way = work.gasWays.front();
    state.relativeHumidity = way.humidity.value;
    state.carbonDioxide = work.settings.carbonDioxide;
    auto gas = gasModel(way.settings, state);
    if (gas && way.source == GasSource::RecordedConstants && gas->source == kTypedConstants)
        gas->source = "recorded";
    if (gas)
        return std::move(*gas);
    if (gas.error().kind == ErrorKind::Usage)
        work.done = tl::unexpected(gas.error());
    else
        work.reportProblem(gas.error());
    return std::nullopt;
}

/// What follows once velocity, p1 and T1 are known.
void addShockedStates(ShockWork &work, const VelocityEstimate &estimate, const SectionState &state,
    const std::optional<DutArrival> &dutArrival)
{
    const double T1_K = state.temperature_K;
    auto states = shockStatesOf(
        *work.conditions.drivenGas, state.pressure_Pa, T1_K, *estimate.velocity_m_s);
    if (!states) {
        const bool isTemperature = states.error().findingId == "SHK-004";
        if (states.error().kind == ErrorKind::Usage)
            work.done = tl::unexpected(states.error());
        else
            work.reportProblem(
                states.error(), isTemperature ? kelvinFor("shock.t1_k", T1_K) : std::nullopt);
        return;
    }
    work.conditions.states = *states;
    judgeStates(work);
    judgeGas(work, state);
    judgeTypedState(work, state);
    if (!work.conditions.stepTyped)
        work.conditions.step_Pa = stepOf(*work.conditions.states, work.atEndWall());
    addUncertainty(work, state, estimate);
    judgeVelocity(work, estimate.relativeDistanceUncertainty);
    judgeFit(work, estimate);
    const Index before = std::ssize(work.findings);
    addDriver(work);
    addTube(work, dutArrival);
    if (work.conditions.plateau_s) {
        reportPlateau(work); // its findings come before the driver's
        std::rotate(work.findings.begin() + before, work.findings.end() - 1, work.findings.end());
    }
}

void readArrivals(ShockWork &work, const std::optional<DutArrival> &dutArrival)
{
    if (work.before != nullptr)
        work.conditions.seen = work.before->seen;
    else
        work.conditions.seen = seenArrivals(work.set, work.conditions.shot, work.settings,
            work.starts, dutArrival ? std::optional(dutArrival->time_s) : std::nullopt);
}

/// What the arrivals say where another velocity is used, to be compared with it.
void recordBesides(ShockWork &work, const std::optional<DutArrival> &dutArrival)
{
    auto recorded = recordedVelocity(
        work.set, work.conditions.shot, dutArrival, work.conditions.seen, work.settings);
    if (recorded.fit)
        work.recorded = std::move(recorded);
}

void addStates(ShockWork &work, const std::optional<DutArrival> &dutArrival)
{
    const auto p1_Pa = firstKnown(work.settings.p1_Pa, work.shot.environment.p1_Pa);
    const auto T1_K = firstKnown(work.settings.T1_K, work.shot.environment.T1_K);
    const bool fromVelocity = work.settings.stateFrom == "velocity";
    VelocityEstimate estimate;
    readArrivals(work, dutArrival);
    if (fromVelocity)
        estimate = estimateVelocity(
            work.set, work.conditions.shot, dutArrival, work.conditions.seen, work.settings);
    if (!fromVelocity || (estimate.velocity_m_s && estimate.sightings.empty()))
        recordBesides(work, dutArrival);
    reportMissingPressureAndTemperature(work, p1_Pa.has_value(), T1_K.has_value());
    if (estimate.missing)
        work.reportMissing(*estimate.missing);
    work.conditions.arrival_s = estimate.arrival_s;
    work.conditions.distance_m = estimate.distance_m;
    work.conditions.sightings = work.recorded ? work.recorded->sightings : estimate.sightings;
    work.conditions.velocityFit = estimate.fit;
    if (estimate.problem) {
        work.reportProblem(*estimate.problem, estimate.correction);
        return;
    }
    if (!p1_Pa || !T1_K || (fromVelocity && !estimate.velocity_m_s))
        return;
    judgeTypedPressure(work, *p1_Pa);
    SectionState state{*p1_Pa, *T1_K, 0.0, 0.0};
    work.conditions.drivenGas = drivenModel(work, state);
    if (!work.conditions.drivenGas)
        return;
    if (!fromVelocity) {
        const auto velocity_m_s = velocityFromPressure(work, *p1_Pa, *T1_K);
        if (!velocity_m_s) {
            work.reportProblem(velocity_m_s.error());
            return;
        }
        estimate.velocity_m_s = *velocity_m_s;
    }
    addShockedStates(work, estimate, state, dutArrival);
}

/// An input that is missing in every shot gives one finding, not one per shot.
Findings withoutRepetition(const Findings &findings, Index shotCount)
{
    Findings shorter;
    for (const Finding &finding : findings) {
        const auto same = [&](const Finding &other) {
            return other.id == finding.id && other.message == finding.message;
        };
        const bool everywhere = finding.id == "SHK-007" && shotCount > 1
            && std::count_if(findings.begin(), findings.end(), same) == shotCount;
        if (!everywhere) {
            shorter.push_back(finding);
        } else if (std::none_of(shorter.begin(), shorter.end(), same)) {
            shorter.push_back(finding);
            shorter.back().shot = 0;
        }
    }
    return shorter;
}

std::optional<DutArrival> arrivalOf(const std::vector<DutArrival> &arrivals, Index shot)
{
    const auto found = std::find_if(
        arrivals.begin(), arrivals.end(), [&](const DutArrival &a) { return a.shot == shot; });
    return found != arrivals.end() ? std::optional(*found) : std::nullopt;
}

} // namespace

Result<ShockConditionsSet> estimateShockConditions(const CaptureSet &set,
    const std::vector<DutArrival> &arrivals, const ShockSettings &settings,
    const UncertaintyRequest &request, const JobControl &control, const KnownReadings &known)
{
    if (auto checked = checkShockSettings(settings, set.shots.size()); !checked)
        return tl::unexpected(checked.error());
    RecordStarts found;
    if (settings.enabled && known.starts == nullptr && known.before == nullptr) {
        auto starts = detectStarts(set, arrivalChannels(settings), control);
        if (!starts)
            return tl::unexpected(starts.error());
        found = std::move(*starts);
    }
    ShockConditionsSet result;
    for (Index i = 0; i < std::ssize(set.shots); ++i) {
        const Shot &shot = set.shots[static_cast<std::size_t>(i)];
        if (!shot.included)
            continue;
        const ShockConditions *before = known.before ? known.before->ofShot(i + 1) : nullptr;
        ShockWork work{
            set, shot, settings, request, known.starts ? *known.starts : found, before, {}, {}, {}};
        work.conditions.shot = i + 1;
        if (settings.enabled) {
            work.conditions.step_Pa = settings.step_Pa.of(i + 1);
            work.conditions.stepTyped = work.conditions.step_Pa.has_value();
            addStates(work, arrivalOf(arrivals, i + 1));
            if (work.conditions.stepTyped && !work.conditions.uncertainty && request.evaluate)
                work.conditions.uncertainty
                    = uncertaintyOfTypedStep(*work.conditions.step_Pa, request);
        }
        if (!work.done)
            return tl::unexpected(work.done.error());
        result.shots.push_back(std::move(work.conditions));
        result.findings.insert(result.findings.end(), work.findings.begin(), work.findings.end());
    }
    result.findings = withoutRepetition(result.findings, std::ssize(result.shots));
    if (settings.enabled)
        judgeSharedNumbers(settings, std::ssize(result.shots), result.findings);
    return result;
}

} // namespace dyncal
