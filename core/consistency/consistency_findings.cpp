// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/consistency_findings.h"

#include "core/base/number_text.h"
#include "core/shock/shock_findings.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace dyncal {
namespace {

constexpr int kDigits = 4;
constexpr double kLeastChanceTogether = 1e-4; ///< of all differences, where nothing is wrong

/// Where nothing explains the contradiction: all that acts on the quantity.
std::vector<FindingCause> everythingOn(Compared of)
{
    using C = FindingCause;
    switch (of) {
    case Compared::Mach:
        return {C::Rate, C::Distance, C::Gas, C::Temperature};
    case Compared::P2Rise:
    case Compared::P5Rise:
        return {C::Pressure, C::Scale, C::Distance};
    case Compared::Sensitivity:
        return {C::Scale, C::Pressure};
    case Compared::Velocity:
    case Compared::Step:
        return {C::Typed};
    default:
        return {C::Order};
    }
}

/// The explanations that move this comparison at all.
std::vector<FindingCause> causesOf(const WayComparison &check, const ComparedShots &shots,
    const std::vector<ExplainedBy> &explained)
{
    std::vector<FindingCause> causes;
    for (const ExplainedBy &cause : explained) {
        for (std::size_t row = 0; row < shots.rows().size(); ++row) {
            const auto [shot, way] = shots.rows()[row];
            const WayComparison &head = shots.ways()[shot]->made()[way];
            if (cause.moves[row] && head.of == check.of && head.shot == check.shot
                && head.channel == check.channel && head.a == check.a
                && std::ranges::find(causes, cause.cause) == causes.end())
                causes.push_back(cause.cause);
        }
    }
    return causes.empty() ? everythingOn(check.of) : causes;
}

const char *textOf(const WayComparison &check)
{
    switch (check.of) {
    case Compared::Velocity:
        return DYNCAL_TEXT("core",
            "The velocity stated for this shot is %1, the arrivals give %2: they differ by %3 times their combined uncertainty. Check what was typed, the distances and the sample rate.");
    case Compared::Mach:
        if (check.a == Way::StepRatio)
            return DYNCAL_TEXT("core",
                "The ratio of the reflected to the incident step at '%4' belongs to Mach %1, the velocity over the speed of sound is Mach %2: they differ by %3 times their combined uncertainty. The ratio needs no clock and no sensitivity; check sample rate, distances, gas and temperature.");
        return DYNCAL_TEXT("core",
            "The ratio of the velocities of the incident and the reflected shock at '%4' belongs to Mach %1, the velocity over the speed of sound is Mach %2: they differ by %3 times their combined uncertainty. The ratio needs no clock; check sample rate, distances, gas and temperature.");
    case Compared::P2Rise:
        return DYNCAL_TEXT("core",
            "The pressure behind the shock rises by %1 at '%4' and should by %2: they differ by %3 times their combined uncertainty. Check p1, the velocity, and unit and sensitivity of the sensor.");
    case Compared::P5Rise:
        return DYNCAL_TEXT("core",
            "The pressure behind the reflected shock is %1 above p1 at '%4' and should be %2: they differ by %3 times their combined uncertainty. Check p1, the velocity, and unit and sensitivity of the sensor.");
    case Compared::Step:
        return DYNCAL_TEXT("core",
            "The typed pressure step of this shot is %1, the velocity gives %2: they differ by %3 times their combined uncertainty. Check what was typed.");
    default:
        return DYNCAL_TEXT("core",
            "The sensitivity of this shot is %1, the card of the sensor states %2: they differ by %3 times their combined uncertainty. Check scale and unit of the recording, p1 and the card.");
    }
}

const char *idOf(Compared of)
{
    switch (of) {
    case Compared::Mach:
        return "CHK-001";
    case Compared::Velocity:
    case Compared::Step:
        return "CHK-002";
    case Compared::P2Rise:
    case Compared::P5Rise:
        return "SHK-002";
    default:
        return "CHK-003";
    }
}

bool isSaidHere(Compared of)
{
    return of != Compared::Arrival && of != Compared::Shots && of != Compared::P4
        && of != Compared::Levels;
}

/// The velocity of all shots is one typed number, or follows from one typed pressure.
bool isVelocityTypedOnce(const ShockSettings &settings)
{
    return settings.stateFrom == "velocity" ? settings.velocity_m_s.common.has_value()
                                            : typedStatePressure_Pa(settings).has_value();
}

/// One number typed for several shots, which the records contradict, is no number of this shot.
Severity severityOf(const WayComparison &check, const ShockSettings &settings, std::size_t shots)
{
    const bool typedOnce
        = (check.of == Compared::Velocity && check.a == Way::Typed && isVelocityTypedOnce(settings))
        || (check.of == Compared::Step && settings.step_Pa.common);
    return typedOnce && shots > 1 ? Severity::Block : Severity::Caution;
}

Finding findingOf(const WayComparison &check, const ComparedShots &shots,
    const std::vector<ExplainedBy> &explained, const ShockSettings &settings)
{
    return {.id = idOf(check.of),
        .severity = severityOf(check, settings, shots.ways().size()),
        .shot = check.shot,
        .channel = check.channel,
        .message = {textOf(check),
            {numberWithUnit(check.value_a, check.unit, kDigits),
                numberWithUnit(check.value_b, check.unit, kDigits),
                numberText(std::abs(check.difference() / check.u), 2), check.channel}},
        .value = check.difference() / check.u,
        .limit = kContradiction,
        .causes = causesOf(check, shots, explained)};
}

/// The farthest off of every quantity and shot.
std::vector<const WayComparison *> worstOfEach(const std::vector<WayComparison> &checks)
{
    std::vector<const WayComparison *> worst;
    for (const WayComparison &check : checks) {
        if (check.agrees() || !isSaidHere(check.of))
            continue;
        const auto same = std::ranges::find_if(worst, [&](const WayComparison *other) {
            return std::string_view(idOf(other->of)) == idOf(check.of) && other->shot == check.shot;
        });
        if (same == worst.end())
            worst.push_back(&check);
        else if (std::abs((*same)->e_n()) < std::abs(check.e_n()))
            *same = &check;
    }
    return worst;
}

bool contradicts(const std::vector<WayComparison> &checks, Compared of)
{
    return std::ranges::any_of(
        checks, [&](const WayComparison &check) { return check.of == of && !check.agrees(); });
}

/// In percent; what is smaller than any list of causes can tell has no digits.
std::string chanceText(double chance)
{
    constexpr double kLeastTold = 1e-8;
    return chance < kLeastTold ? "< " + numberText(100.0 * kLeastTold, 1)
                               : numberText(100.0 * chance, 1);
}

/// None contradicts alone, and still all together are unlikely: a small fault in many shots, or
/// many that are too small for one comparison.
Finding together(const ComparedShots &shots, const std::vector<ExplainedBy> &explained,
    const std::vector<WayComparison> &checks, bool doShotsScatter)
{
    std::vector<FindingCause> causes(explained.size());
    std::ranges::transform(explained, causes.begin(), &ExplainedBy::cause);
    if (doShotsScatter)
        causes.insert(causes.begin(), FindingCause::Shots);
    const bool isAlone
        = !doShotsScatter && std::ranges::all_of(checks, [](const WayComparison &check) {
              return check.agrees() || check.of == Compared::Levels;
          });
    const char *text = !isAlone
        ? DYNCAL_TEXT("core",
            "Beside what other findings say, all %1 comparisons together leave a chi-square of %2, which happens by chance in %3 % of calibrations: look at the largest differences, and at the causes named.")
        : causes.empty()
        ? DYNCAL_TEXT("core",
            "No comparison contradicts alone, but all %1 together leave a chi-square of %2, which happens by chance in %3 % of calibrations, and no single fault explains it: look at the largest differences.")
        : DYNCAL_TEXT("core",
            "No comparison contradicts alone, but all %1 together leave a chi-square of %2, which happens by chance in %3 % of calibrations: look at the largest differences, and at the causes named.");
    return {.id = "CHK-005",
        .severity = Severity::Caution,
        .message = {text,
            {std::to_string(shots.rows().size()), numberText(shots.chiSquare(), 3),
                chanceText(shots.chance())}},
        .value = shots.chance(),
        .limit = kLeastChanceTogether,
        .causes = causes};
}

Finding wrongOrder()
{
    return {.id = "CHK-004",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "The levels named for the shots are not in the order of their pressure steps: check which recording belongs to which shot (import.levels)."),
            {}},
        .causes = {FindingCause::Order}};
}

} // namespace

Findings judgeConsistency(const ComparedShots &shots, const std::vector<WayComparison> &checks,
    const ShockSettings &settings, bool doShotsScatter)
{
    Findings findings;
    const auto worst = worstOfEach(checks);
    const bool unlikely = shots.chance() < kLeastChanceTogether;
    const std::vector<ExplainedBy> explained
        = worst.empty() && !unlikely ? std::vector<ExplainedBy>() : explanations(shots);
    for (const WayComparison *check : worst)
        findings.push_back(findingOf(*check, shots, explained, settings));
    if (worst.empty() && unlikely)
        findings.push_back(together(shots, explained, checks, doShotsScatter));
    if (contradicts(checks, Compared::Levels))
        findings.push_back(wrongOrder());
    return findings;
}

} // namespace dyncal
