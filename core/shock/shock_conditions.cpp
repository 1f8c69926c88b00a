// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_conditions.h"

#include "core/base/number_text.h"
#include "core/shock/shock_velocity.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kVelocityUncertaintyLimit = 0.002; ///< SHK-003, relative
constexpr double kDriverPressureLimit = 0.10; ///< SHK-006, relative

Gas gasOf(const GasSettings &settings)
{
    return {settings.gamma, settings.molarMass_kg_mol};
}

std::optional<double> firstKnown(const std::optional<double> &typed, double recorded)
{
    if (typed)
        return typed;
    return std::isfinite(recorded) ? std::optional<double>(recorded) : std::nullopt;
}

Finding findingFor(Index shot, const char *id, Severity severity, Message message)
{
    Finding finding;
    finding.id = id;
    finding.severity = severity;
    finding.shot = shot;
    finding.message = std::move(message);
    return finding;
}

/// Everything about one shot that has to be worked on together.
struct ShotWork
{
    const CaptureSet &set;
    const Shot &shot;
    const ShockSettings &settings;
    ShockConditions conditions;
    Findings findings;

    bool atEndWall() const { return settings.dutPosition == kEndWall; }
    void report(const char *id, Severity severity, Message message)
    {
        findings.push_back(findingFor(conditions.shot, id, severity, std::move(message)));
    }
    /// A typed step stands whatever the velocity says, so nothing is blocked then.
    void reportProblem(const Error &error)
    {
        findings.push_back(findingFor(conditions.shot, error.findingId.c_str(),
            conditions.stepTyped ? Severity::Caution : Severity::Block, error.message));
    }
    void reportMissing(Message message)
    {
        if (!conditions.stepTyped)
            report("SHK-007", Severity::Info, std::move(message));
    }
};

void reportMissingPressureAndTemperature(ShotWork &work, bool hasPressure, bool hasTemperature)
{
    if (!hasPressure)
        work.reportMissing(Message{
            DYNCAL_TEXT("core",
                "The pressure step is not determined: the pressure p1 in the driven section is not "
                "recorded; enter p1 or the step itself."),
            {}});
    if (!hasTemperature)
        work.reportMissing(
            Message{DYNCAL_TEXT("core",
                        "The pressure step is not determined: the temperature T1 in the driven "
                        "section is not recorded; enter T1 or the step itself."),
                {}});
}

double stepOf(const ShockStates &states, bool atEndWall)
{
    const GasState &behind = atEndWall ? states.reflected : states.shocked;
    return behind.pressure_Pa - states.driven.pressure_Pa;
}

/// d ln(step) / d ln(W), by a central difference that stays above Mach 1.
double velocitySensitivity(const ShockStates &states, const Gas &gas, bool atEndWall)
{
    const double relative = std::min(1e-4, 0.5 * (1.0 - 1.0 / states.mach));
    const auto stepAt = [&](double factor) {
        const auto shifted = shockStates(gas, states.driven.pressure_Pa,
            states.driven.temperature_K, factor * states.velocity_m_s);
        return shifted ? stepOf(*shifted, atEndWall) : stepOf(states, atEndWall);
    };
    return (stepAt(1.0 + relative) - stepAt(1.0 - relative))
        / (2.0 * relative * stepOf(states, atEndWall));
}

void judgeDistance(ShotWork &work, double relativeUncertainty)
{
    if (relativeUncertainty <= kVelocityUncertaintyLimit)
        return;
    const double factor = velocitySensitivity(
        *work.conditions.states, gasOf(work.settings.drivenGas), work.atEndWall());
    work.report("SHK-003", Severity::Caution,
        Message{DYNCAL_TEXT("core",
                    "The distance alone makes the velocity uncertain by %1 %, which gives %2 % on "
                    "the pressure step (factor %3)."),
            {numberText(100.0 * relativeUncertainty, 2),
                numberText(100.0 * relativeUncertainty * factor, 2), numberText(factor, 3)}});
    work.findings.back().value = relativeUncertainty;
    work.findings.back().limit = kVelocityUncertaintyLimit;
}

void addPlateau(ShotWork &work)
{
    auto length_m = work.settings.drivenLength_m;
    if (!length_m)
        length_m = work.set.tubeNumber("driven_length_m");
    if (!length_m || !(*length_m > 0.0) || !work.atEndWall())
        return;
    work.conditions.plateau_s = plateauTime_s(*work.conditions.states, *length_m);
    work.report("SHK-005", Severity::Info,
        Message{DYNCAL_TEXT("core",
                    "The reflected shock's return from the contact surface reaches the end wall %1 "
                    "after the step (computed)."),
            {numberWithUnit(*work.conditions.plateau_s, "s", 3)}});
    work.findings.back().value = work.conditions.plateau_s;
}

void compareDriverPressure(ShotWork &work, double computed_Pa)
{
    const double recorded_Pa = work.shot.environment.p4_Pa;
    const double relative = (recorded_Pa - computed_Pa) / computed_Pa;
    if (!std::isfinite(relative) || std::abs(relative) <= kDriverPressureLimit)
        return;
    const char *text = relative < 0.0
        ? DYNCAL_TEXT("core",
            "Driver pressure %1 is %2 % below the %3 that the shock implies (both absolute): usual "
            "for a finite opening time.")
        : DYNCAL_TEXT("core",
            "Driver pressure %1 is %2 % above the %3 that the shock implies (both absolute): check "
            "whether the recorded value is right.");
    work.report("SHK-006", Severity::Info,
        Message{text,
            {numberWithUnit(recorded_Pa, "Pa", 3), numberText(100.0 * std::abs(relative), 2),
                numberWithUnit(computed_Pa, "Pa", 3)}});
    work.findings.back().value = relative;
    work.findings.back().limit = kDriverPressureLimit;
}

void addDriver(ShotWork &work)
{
    const auto T4_K = firstKnown(work.settings.T4_K, work.shot.environment.T4_K);
    if (!T4_K)
        return;
    const Gas driver = gasOf(work.settings.driverGas);
    const auto p4_Pa
        = driverPressure_Pa(*work.conditions.states, gasOf(work.settings.drivenGas), driver, *T4_K);
    if (!p4_Pa) { // region 4 carries no result of the calibration
        Error error = p4_Pa.error();
        work.report(error.findingId.empty() ? "SHK-006" : error.findingId.c_str(),
            Severity::Caution, std::move(error.message));
        return;
    }
    work.conditions.driver = gasAtRest(driver, *p4_Pa, *T4_K);
    compareDriverPressure(work, *p4_Pa);
}

void addStates(ShotWork &work, const VelocityEstimate &estimate)
{
    const auto p1_Pa = firstKnown(work.settings.p1_Pa, work.shot.environment.p1_Pa);
    const auto T1_K = firstKnown(work.settings.T1_K, work.shot.environment.T1_K);
    reportMissingPressureAndTemperature(work, p1_Pa.has_value(), T1_K.has_value());
    if (estimate.missing)
        work.reportMissing(*estimate.missing);
    work.conditions.arrival_s = estimate.arrival_s;
    work.conditions.distance_m = estimate.distance_m;
    if (estimate.problem) {
        work.reportProblem(*estimate.problem);
        return;
    }
    if (!p1_Pa || !T1_K || !estimate.velocity_m_s)
        return;
    auto states
        = shockStates(gasOf(work.settings.drivenGas), *p1_Pa, *T1_K, *estimate.velocity_m_s);
    if (!states) {
        work.reportProblem(states.error());
        return;
    }
    work.conditions.states = std::move(*states);
    if (!work.conditions.stepTyped)
        work.conditions.step_Pa = stepOf(*work.conditions.states, work.atEndWall());
    judgeDistance(work, estimate.relativeDistanceUncertainty);
    addPlateau(work);
    addDriver(work);
}

Result<void> checkSettings(const ShockSettings &settings)
{
    if (settings.dutPosition != kEndWall && settings.dutPosition != kSideWall)
        return fail(ErrorKind::Usage,
            Message{DYNCAL_TEXT("core",
                        "The DUT's position is '%1'; it must be 'end-wall' or 'side-wall'."),
                {settings.dutPosition}});
    if (settings.step_Pa && !(std::isfinite(*settings.step_Pa) && *settings.step_Pa != 0.0))
        return fail(ErrorKind::Usage,
            Message{DYNCAL_TEXT("core",
                        "The typed pressure step is %1 Pa; it must be a number other than 0."),
                {numberText(*settings.step_Pa)}});
    for (const ArrivalSensor &sensor : settings.arrivalSensors) {
        if (!(sensor.distanceToEndWall_m > 0.0 && std::isfinite(sensor.distanceToEndWall_m)))
            return fail(ErrorKind::Usage,
                Message{DYNCAL_TEXT("core",
                            "The arrival sensor '%1' has a distance to the end wall of %2 m; it "
                            "must be above 0."),
                    {sensor.channel, numberText(sensor.distanceToEndWall_m)}});
    }
    return {};
}

/// The same thing missing in every shot is said once.
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

std::optional<double> arrivalOf(const std::vector<DutArrival> &arrivals, Index shot)
{
    const auto found = std::find_if(
        arrivals.begin(), arrivals.end(), [&](const DutArrival &a) { return a.shot == shot; });
    return found != arrivals.end() ? std::optional<double>(found->time_s) : std::nullopt;
}

} // namespace

const ShockConditions *ShockConditionsSet::ofShot(Index shot) const
{
    const auto found = std::find_if(
        shots.begin(), shots.end(), [&](const ShockConditions &s) { return s.shot == shot; });
    return found != shots.end() ? &*found : nullptr;
}

Result<ShockConditionsSet> estimateShockConditions(
    const CaptureSet &set, const std::vector<DutArrival> &arrivals, const ShockSettings &settings)
{
    if (auto checked = checkSettings(settings); !checked)
        return tl::unexpected(checked.error());
    ShockConditionsSet result;
    for (Index i = 0; i < std::ssize(set.shots); ++i) {
        const Shot &shot = set.shots[static_cast<std::size_t>(i)];
        if (!shot.included)
            continue;
        ShotWork work{set, shot, settings, {}, {}};
        work.conditions.shot = i + 1;
        if (settings.enabled) {
            work.conditions.step_Pa = settings.step_Pa;
            work.conditions.stepTyped = settings.step_Pa.has_value();
            addStates(work, estimateVelocity(set, shot, arrivalOf(arrivals, i + 1), settings));
        }
        result.shots.push_back(std::move(work.conditions));
        result.findings.insert(result.findings.end(), work.findings.begin(), work.findings.end());
    }
    result.findings = withoutRepetition(result.findings, std::ssize(result.shots));
    return result;
}

} // namespace dyncal
