// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_findings.h"

#include "core/base/constants.h"
#include "core/base/contradiction.h"
#include "core/base/distributions.h"
#include "core/base/number_text.h"
#include "core/shock/pressure_units.h"
#include "core/shock/shock_uncertainty.h"
#include "core/shock/step_inputs.h"
#include "core/shock/variable_shock.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kVelocityUncertaintyLimit = 0.002; ///< SHK-003, relative
constexpr double kDriverPressureLimit = 0.10; ///< SHK-006, relative
constexpr double kScatterProbability = 0.01; ///< SHK-010
constexpr double kLowestAmbient_Pa = 87e3;
constexpr double kHighestAmbient_Pa = 108e3;
constexpr double kLowestLikely_Pa = 2000.0; ///< below, a typed p1 may be in another unit

void reportVelocityUncertainty(ShockWork &work, const char *text, double relative)
{
    const double factor = velocitySensitivity(work);
    work.findings.push_back({.id = "SHK-003",
        .severity = Severity::Caution,
        .shot = work.conditions.shot,
        .message = {text,
            {numberText(100.0 * relative, 2), numberText(100.0 * relative * factor, 2),
                numberText(factor, 3)}},
        .value = relative,
        .limit = kVelocityUncertaintyLimit});
}

/// The records alone place the attenuation outside what is assumed, by two u.
bool leavesItsRange(const VelocityFit &fit)
{
    if (!fit.attenuation || !fit.seenAttenuation_per_m)
        return false;
    const Interval &range = fit.attenuation->range_per_m;
    const double room = 2.0 * fit.u_seenAttenuation_per_m;
    return *fit.seenAttenuation_per_m > range.end + room
        || *fit.seenAttenuation_per_m < range.begin - room;
}

/// What makes a shock look too fast.
std::vector<FindingCause> beyondTheTube()
{
    return {
        FindingCause::Rate, FindingCause::Distance, FindingCause::Gas, FindingCause::Temperature};
}

const char *gasText(const GasContradiction &found)
{
    if (found.used.source == GasSource::RecordedConstants)
        return DYNCAL_TEXT("core",
            "The gas constants recorded in the capture give a speed of sound of %1 in the driven gas, the gas that it names gives %2: with that the pressure step would be %3 % different. The constants are used; choose the driven gas.");
    if (found.isTypedHumidity)
        return DYNCAL_TEXT("core",
            "With the humidity typed the driven gas has a speed of sound of %1, with the one recorded in the capture %2: with that the pressure step would be %3 % different. The typed one is used; correct it (shock.relative_humidity, 0 to 1), or leave it out.");
    if (found.isHumidity)
        return DYNCAL_TEXT("core",
            "The chosen driven gas has a speed of sound of %1, air of the known humidity %2: with that the pressure step would be %3 % different. The chosen gas is used; choose humid air or the recorded gas if that is what was in the tube.");
    if (found.other.source == GasSource::RecordedConstants)
        return DYNCAL_TEXT("core",
            "The chosen driven gas has a speed of sound of %1, the gas constants recorded in the capture give %2: with that the pressure step would be %3 % different. The chosen gas is used; check which one was in the tube.");
    return DYNCAL_TEXT("core",
        "The chosen driven gas has a speed of sound of %1, the gas named in the capture %2: with that the pressure step would be %3 % different. The chosen gas is used; check which one was in the tube.");
}

/// By what share another gas or state would change the step at the same velocity.
double changeOfStep(const ShockWork &work, const GasModel &gas, const SectionState &state)
{
    const ShockStates &states = *work.conditions.states;
    const auto others
        = shockStatesOf(gas, state.pressure_Pa, state.temperature_K, states.velocity_m_s);
    return others ? stepOf(*others, work.atEndWall()) / stepOf(states, work.atEndWall()) - 1.0
                  : kUnknown;
}

/// SHK-019: more than the tube can hold, or several times what was recorded.
bool isBeyondTheTube(ShockWork &work, double computed_Pa, double recorded_Pa)
{
    constexpr double kLargestRatio = 3.0; // no opening of a diaphragm gains as much
    const double largest_Pa = recorded_Pa > 0.0
        ? std::min(kLargestRatio * recorded_Pa, work.settings.largestDriverPressure_Pa)
        : work.settings.largestDriverPressure_Pa;
    if (computed_Pa <= largest_Pa)
        return false;
    work.findings.push_back({.id = "SHK-019",
        .severity = work.conditions.stepTyped ? Severity::Caution : Severity::Block,
        .shot = work.conditions.shot,
        .message
        = {DYNCAL_TEXT("core",
               "Such a shock needs a driver pressure of %1, more than the %2 that this tube can have had (three times the recorded one at most, and shock.largest_driver_pressure_pa): check sample rate, distances, gases and temperature."),
            {numberWithUnit(computed_Pa, "Pa", 3), numberWithUnit(largest_Pa, "Pa", 3)}},
        .value = computed_Pa,
        .limit = largest_Pa,
        .causes = beyondTheTube()});
    return true;
}

} // namespace

void judgeGas(ShockWork &work, const SectionState &state)
{
    const auto found = gasContradiction(work.gasWays, state);
    if (!found)
        return;
    const double change = changeOfStep(work, found->otherModel, state);
    work.findings.push_back({.id = "SHK-015",
        .severity = Severity::Caution,
        .shot = work.conditions.shot,
        .message = {gasText(*found),
            {numberWithUnit(found->usedSpeed_m_s, "m/s", 5),
                numberWithUnit(found->otherSpeed_m_s, "m/s", 5), numberText(100.0 * change, 3)}},
        .value = change,
        .causes = {found->isHumidity ? FindingCause::Humidity : FindingCause::Gas}});
}

namespace {

/// SHK-020: a typed number of the driven gas's state beside another one that was recorded.
struct TypedBesides
{
    const char *text;
    const char *unit;
    double typed = 0.0;
    double recorded = kUnknown;
    double largest = 0.0; ///< difference that is let pass
    SectionState instead; ///< the state with what was recorded
    FindingCause cause;
};

void judgeBesides(ShockWork &work, const TypedBesides &found)
{
    const double difference = std::abs(found.typed - found.recorded);
    if (!(difference > found.largest))
        return;
    const double change = changeOfStep(work, *work.conditions.drivenGas, found.instead);
    work.findings.push_back({.id = "SHK-020",
        .severity = Severity::Caution,
        .shot = work.conditions.shot,
        .message = {found.text,
            {numberWithUnit(found.typed, found.unit, 6),
                numberWithUnit(found.recorded, found.unit, 6), numberText(100.0 * change, 3)}},
        .value = difference,
        .limit = found.largest,
        .causes = {FindingCause::Typed, found.cause}});
}

/// Of two readings with that u each, or of one with what is assumed where none is stated.
double largestDifference(double u, double least)
{
    return std::max(least, u > 0.0 ? kContradiction * std::sqrt(2.0) * u : 0.0);
}

} // namespace

void judgeTypedState(ShockWork &work, const SectionState &state)
{
    const Environment &around = work.shot.environment;
    SectionState instead = state;
    if (work.settings.p1_Pa) {
        instead.pressure_Pa = around.p1_Pa;
        judgeBesides(work,
            {DYNCAL_TEXT("core",
                 "p1 = %1 is typed, and the capture has recorded %2 in this shot: with that the pressure step would be %3 % different. The typed one is used; correct it, or leave it out (shock.p1_pa)."),
                "Pa", *work.settings.p1_Pa, around.p1_Pa,
                largestDifference(around.u_p1_Pa, kAssumedRelative_p1 * state.pressure_Pa), instead,
                FindingCause::Pressure});
    }
    instead = state;
    if (work.settings.T1_K) {
        instead.temperature_K = around.T1_K;
        judgeBesides(work,
            {DYNCAL_TEXT("core",
                 "T1 = %1 is typed, and the capture has recorded %2 in this shot: with that the pressure step would be %3 % different. The typed one is used; correct it, or leave it out (shock.t1_k)."),
                "K", *work.settings.T1_K, around.T1_K,
                largestDifference(around.u_T1_K, kAssumed_u_T1_K), instead,
                FindingCause::Temperature});
    }
}

void judgeVelocity(ShockWork &work, double relativeFromDistance)
{
    const auto &uncertainty = work.conditions.uncertainty;
    const auto u_m_s = uncertainty ? uncertainty->u(StepResult::Velocity) : std::nullopt;
    // The range of the attenuation is a statement on the tube, not something to mend in this shot.
    const double u_range_m_s
        = uncertainty ? uncertainty->contributionOf(kAttenuation, StepResult::Velocity) : 0.0;
    const double relative
        = std::sqrt(std::max(std::pow(u_m_s.value_or(0.0), 2) - u_range_m_s * u_range_m_s, 0.0))
        / work.conditions.states->velocity_m_s;
    if (relativeFromDistance > kVelocityUncertaintyLimit)
        reportVelocityUncertainty(work,
            DYNCAL_TEXT("core",
                "The distance alone makes the velocity uncertain by %1 %, which gives %2 % on the pressure step (factor %3)."),
            relativeFromDistance);
    else if (relative > kVelocityUncertaintyLimit)
        reportVelocityUncertainty(work,
            DYNCAL_TEXT("core",
                "Velocity uncertainty %1 % gives %2 % on the pressure step (factor %3); the budget says where it comes from."),
            relative);
}

void judgeFit(ShockWork &work, const VelocityEstimate &estimate)
{
    if (estimate.usesUncorrectedDut) {
        const double perMicrosecond
            = 100e-6 * work.conditions.states->velocity_m_s / estimate.distance_m;
        work.findings.push_back({.id = "SHK-008",
            .severity = Severity::Caution,
            .shot = work.conditions.shot,
            .message
            = {DYNCAL_TEXT("core",
                   "The DUT marks the arrival at the end wall by its detected start, which its own delay makes late: a microsecond is %1 % of the velocity and %2 % of the step. Use two side sensors, or a model of each shot instead of the average."),
                {numberText(perMicrosecond, 2),
                    numberText(perMicrosecond * velocitySensitivity(work), 2)}}});
    }
    const auto &fit = work.conditions.velocityFit;
    if (!fit || !fit->chiSquare)
        return;
    const double probability = chiSquareSurvival(*fit->chiSquare, static_cast<double>(fit->dof));
    if (probability >= kScatterProbability)
        return;
    Finding finding{.id = "SHK-010",
        .severity = Severity::Caution,
        .shot = work.conditions.shot,
        .message
        = {DYNCAL_TEXT("core",
               "The arrivals scatter about their line more than their stated uncertainties allow (chi-square %1, degrees of freedom %2): check distances, delays and arrivals, or let the velocity change along the tube."),
            {numberText(*fit->chiSquare, 3), std::to_string(fit->dof)}},
        .value = probability,
        .limit = kScatterProbability,
        .causes = {FindingCause::Distance, FindingCause::Delay}};
    if (leavesItsRange(*fit)) {
        const Interval &range = fit->attenuation->range_per_m;
        finding.message = {
            DYNCAL_TEXT("core",
                "The arrivals show a velocity that falls by %1 % per metre along the tube, outside the range of %2 to %3 % per metre that is assumed (shock.attenuation_per_m): widen the range if the tube does that, else check distances, delays and arrivals."),
            {numberText(100.0 * *fit->seenAttenuation_per_m, 2), numberText(100.0 * range.begin, 2),
                numberText(100.0 * range.end, 2)}};
        finding.causes.insert(finding.causes.begin(), FindingCause::Attenuation);
    }
    work.findings.push_back(std::move(finding));
}

void judgeStates(ShockWork &work)
{
    const double mach = work.conditions.states->mach;
    if (mach <= work.settings.largestMach)
        return;
    work.findings.push_back({.id = "SHK-019",
        .severity = work.conditions.stepTyped ? Severity::Caution : Severity::Block,
        .shot = work.conditions.shot,
        .message
        = {DYNCAL_TEXT("core",
               "The velocity is Mach %1; a shock in this tube reaches Mach %2 at most (shock.largest_mach): check sample rate, distances, gas and temperature."),
            {numberText(mach, 3), numberText(work.settings.largestMach, 3)}},
        .value = mach,
        .limit = work.settings.largestMach,
        .causes = beyondTheTube()});
}

std::optional<double> typedStatePressure_Pa(const ShockSettings &settings)
{
    if (settings.stateFrom == "velocity")
        return std::nullopt;
    return settings.stateFrom == "p2" ? settings.p2_Pa : settings.p4_Pa;
}

void judgeSharedNumbers(const ShockSettings &settings, Index shots, Findings &findings)
{
    if (shots < 2)
        return;
    const auto report = [&](const char *text, double value, const char *unit) {
        findings.push_back({.id = "SHK-018",
            .severity = Severity::Caution,
            .message = {text, {numberWithUnit(value, unit, 4), std::to_string(shots)}},
            .causes = {FindingCause::Typed}});
    };
    if (settings.velocity_m_s.common)
        report(
            DYNCAL_TEXT("core",
                "The velocity %1 is typed once and serves all %2 shots: type one for each shot, or none where it is measured."),
            *settings.velocity_m_s.common, "m/s");
    if (settings.step_Pa.common)
        report(
            DYNCAL_TEXT("core",
                "The pressure step %1 is typed once and serves all %2 shots: type one for each shot, or none where it is computed."),
            *settings.step_Pa.common, "Pa");
    for (const ArrivalSensor &sensor : settings.arrivalSensors)
        if (sensor.arrival_s && sensor.shotArrival_s.empty())
            report(
                DYNCAL_TEXT("core",
                    "One arrival time, %1, is typed for a sensor and serves all %2 shots: type one for each shot, or none where the record shows it."),
                *sensor.arrival_s, "s");
    if (const auto pressure_Pa = typedStatePressure_Pa(settings))
        report(
            DYNCAL_TEXT("core",
                "The pressure %1 is typed once, and the state of all %2 shots follows from it: take the velocity, which is measured in each shot."),
            *pressure_Pa, "Pa");
}

void judgeUnreachable(ShockWork &work, const Error &error)
{
    work.findings.push_back({.id = "SHK-019",
        .severity = work.conditions.stepTyped ? Severity::Caution : Severity::Block,
        .shot = work.conditions.shot,
        .message = error.message,
        .causes = beyondTheTube()});
}

void judgeDriverPressure(ShockWork &work, double computed_Pa)
{
    const double recorded_Pa = work.settings.p4_Pa.value_or(work.shot.environment.p4_Pa);
    if (isBeyondTheTube(work, computed_Pa, recorded_Pa))
        return;
    constexpr double kImpossible = 5.0; // no diaphragm and no opening time loses as much
    const double relative = (recorded_Pa - computed_Pa) / computed_Pa;
    if (!std::isfinite(relative) || std::abs(relative) <= kDriverPressureLimit)
        return;
    if (recorded_Pa > kImpossible * computed_Pa) {
        work.findings.push_back({.id = "SHK-006",
            .severity = Severity::Caution,
            .shot = work.conditions.shot,
            .message
            = {DYNCAL_TEXT("core",
                   "With p1 = %1 the shock implies a driver pressure of %2, a fifth or less of the %3 that are stated (all absolute): p1 is a gauge pressure or in another unit, or the driver gas is another; the step goes with p1."),
                {numberWithUnit(work.conditions.states->driven.pressure_Pa, "Pa", 4),
                    numberWithUnit(computed_Pa, "Pa", 3), numberWithUnit(recorded_Pa, "Pa", 3)}},
            .value = relative,
            .limit = kImpossible - 1.0,
            .causes = {FindingCause::Pressure, FindingCause::Gas}});
        return;
    }
    const char *text = relative < 0.0
        ? DYNCAL_TEXT("core",
            "Driver pressure %1 is %2 % below the %3 that the shock implies (both absolute): usual for a finite opening time.")
        : DYNCAL_TEXT("core",
            "Driver pressure %1 is %2 % above the %3 that the shock implies (both absolute): check whether the recorded value is right.");
    work.findings.push_back({.id = "SHK-006",
        .severity = Severity::Info,
        .shot = work.conditions.shot,
        .message = {text,
            {numberWithUnit(recorded_Pa, "Pa", 3), numberText(100.0 * std::abs(relative), 2),
                numberWithUnit(computed_Pa, "Pa", 3)}},
        .value = relative,
        .limit = kDriverPressureLimit});
}

void judgeTypedPressure(ShockWork &work, double p1_Pa)
{
    if (!work.settings.p1_Pa || p1_Pa > kLowestLikely_Pa)
        return;
    for (const char *unit : {"psi", "bar", "kPa", "mbar"}) {
        const double fitting_Pa = p1_Pa * *pascalsPer(unit);
        if (fitting_Pa < kLowestAmbient_Pa || fitting_Pa > kHighestAmbient_Pa)
            continue;
        work.findings.push_back({.id = "SHK-011",
            .severity = Severity::Caution,
            .shot = work.conditions.shot,
            .message
            = {DYNCAL_TEXT("core",
                   "p1 = %1 Pa? Pressures are in pascals here: %1 %2 are %3 Pa, about ambient."),
                {numberText(p1_Pa, 6), unit, numberText(fitting_Pa, 6)}},
            .correction
            = Correction{.label = {DYNCAL_TEXT("core", "Use %1 Pa"), {numberText(fitting_Pa, 6)}},
                .key = "shock.p1_pa",
                .value = numberText(fitting_Pa)},
            .causes = {FindingCause::Pressure, FindingCause::Typed}});
        return;
    }
}

void reportPlateau(ShockWork &work)
{
    const char *text = DYNCAL_TEXT("core",
        "The reflected shock's return from the contact surface reaches the end wall %1 after the step (computed).");
    if (work.conditions.plateauEnd == PlateauEnd::DriverRarefaction)
        text = DYNCAL_TEXT("core",
            "The expansion reflected at the driver's end reaches the end wall %1 after the step (computed), before the contact surface's wave: a longer driver section would help.");
    if (work.conditions.plateauEnd == PlateauEnd::ReflectedShock)
        text = DYNCAL_TEXT(
            "core", "The reflected shock passes the DUT %1 after the step (computed).");
    work.findings.push_back({.id = "SHK-005",
        .severity = Severity::Info,
        .shot = work.conditions.shot,
        .message = {text, {numberWithUnit(*work.conditions.plateau_s, "s", 3)}},
        .value = work.conditions.plateau_s});
}

} // namespace dyncal
