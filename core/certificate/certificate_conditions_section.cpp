// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_conditions_section.h"

#include "core/base/constants.h"
#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "core/certificate/certificate_words.h"
#include "core/pipeline/calibration_kind.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

constexpr int kDigitsOfTemperature = 5; ///< 294.15 K: four would move 21 °C by 0.05 K

/// Range of one recorded environmental quantity over the included shots; a ratio in percent.
Message environmentRange(const CalibrationResults &results, double Environment::*quantity,
    std::string_view unit, int digits = kDigitsOfSettings)
{
    const double scale = unit == "%" ? 100.0 : 1.0;
    std::optional<double> lowest;
    std::optional<double> highest;
    if (results.captures)
        for (const Shot &shot : results.captures->set.shots) {
            const double value = scale * shot.environment.*quantity;
            if (!shot.included || !std::isfinite(value))
                continue;
            lowest = std::min(lowest.value_or(value), value);
            highest = std::max(highest.value_or(value), value);
        }
    if (!lowest)
        return {DYNCAL_TEXT("core", "not determined (not recorded)"), {}};
    const std::string low = settingText(*lowest, unit, digits);
    const std::string high = settingText(*highest, unit, digits);
    return inNumbers(low == high ? low : low + " \xE2\x80\xA6 " + high);
}

ShotLevel levelOf(const CalibrationResults &results, Index shot)
{
    const auto position = static_cast<std::size_t>(shot - 1);
    if (!results.captures || shot < 1 || position >= results.captures->set.shots.size())
        return ShotLevel::None;
    return results.captures->set.shots[position].level;
}

/// The step, its U and the coverage factor k of U.
struct StepCells
{
    Message step;
    Message expanded{DYNCAL_TEXT("core", "not determined"), {}};
    Message k = dash();
};

std::optional<double> stepUncertainty_Pa(const ShockConditions &shot)
{
    const bool computed = shot.uncertainty && shot.step_Pa && !shot.stepTyped;
    return computed ? shot.uncertainty->u(StepResult::Step) : std::nullopt;
}

StepCells stepCells(const ShockConditions &shot, double coverage)
{
    StepCells cells{printed(shot.step_Pa, "Pa", {DYNCAL_TEXT("core", "not determined"), {}})};
    const auto u_Pa = stepUncertainty_Pa(shot);
    if (!u_Pa)
        return cells;
    const double k = printedCoverage(coverageFactor(
        shot.uncertainty->budget.dof[static_cast<Index>(StepResult::Step)], coverage));
    const RoundedValue rounded = roundedValue(*shot.step_Pa, k * *u_Pa, "Pa");
    if (rounded.u.empty()) // u is zero or not known
        return cells;
    cells.step = inNumbers(rounded.value + " " + rounded.unit);
    cells.expanded = inNumbers(rounded.u + " " + rounded.unit);
    cells.k = inNumbers(printedFactor(k));
    return cells;
}

/// The velocity with its U where that is known.
Message velocityCell(const ShockConditions &shot, double coverage)
{
    if (!shot.states)
        return dash();
    const double velocity_m_s = shot.states->velocity_m_s;
    const auto u_m_s = shot.uncertainty ? shot.uncertainty->u(StepResult::Velocity) : std::nullopt;
    if (!u_m_s)
        return printed(velocity_m_s, "m/s", dash());
    return printedWithUncertainty(velocity_m_s, *u_m_s, "m/s",
        printedCoverage(coverageFactor(
            shot.uncertainty->budget.dof[static_cast<Index>(StepResult::Velocity)], coverage)));
}

Message sourceOfStep(const ShockConditions &shot, const Recipe &recipe)
{
    if (!shot.step_Pa)
        return dash();
    if (recipe.response.isByTransducer())
        return {DYNCAL_TEXT("core", "of the reference"), {}};
    return shot.stepTyped ? Message{DYNCAL_TEXT("core", "stated"), {}}
                          : Message{DYNCAL_TEXT("core", "computed"), {}};
}

std::vector<Message> conditionsRow(
    const CalibrationResults &results, const ShockConditions &shot, const Recipe &recipe)
{
    const double coverage = recipe.uncertainty.coverage;
    const StepCells cells = stepCells(shot, coverage);
    const std::optional<GasState> driven
        = shot.states ? std::optional(shot.states->driven) : std::nullopt;
    return {inNumbers(std::to_string(shot.shot)), levelWord(levelOf(results, shot.shot)),
        setting(driven ? driven->pressure_Pa : kUnknown, "Pa"),
        inNumbers(
            settingText(driven ? driven->temperature_K : kUnknown, "K", kDigitsOfTemperature)),
        velocityCell(shot, coverage),
        printed(shot.states ? shot.states->mach : kUnknown, "", dash()), cells.step,
        sourceOfStep(shot, recipe), cells.expanded, cells.k, printed(shot.plateau_s, "s", dash())};
}

CertificateTable stepTable()
{
    CertificateTable table;
    table.id = "shock";
    table.caption = {DYNCAL_TEXT("core", "Pressure steps"), {}};
    table.columns
        = {{{DYNCAL_TEXT("core", "Shot"), {}}, true}, {{DYNCAL_TEXT("core", "Level"), {}}, false},
            {{DYNCAL_TEXT("core", "Initial pressure"), {}}, true},
            {{DYNCAL_TEXT("core", "Initial temperature"), {}}, true},
            {{DYNCAL_TEXT("core", "Shock velocity"), {}}, true},
            {{DYNCAL_TEXT("core", "Mach number"), {}}, true},
            {{DYNCAL_TEXT("core", "Pressure step"), {}}, true},
            {{DYNCAL_TEXT("core", "Step is"), {}}, false},
            {{DYNCAL_TEXT("core", "U of the step"), {}}, true},
            {{DYNCAL_TEXT("core", "k"), {}}, true}, {{DYNCAL_TEXT("core", "Plateau"), {}}, true}};
    return table;
}

/// The steps of a calibration that knows at least one, or whose stage is not computed yet.
void addSteps(const CalibrationResults &results, const Recipe &recipe, CertificateSection &section)
{
    CertificateTable table = stepTable();
    const ShockConditionsSet *steps = stepsUsed(results, recipe);
    bool stepMissing = !steps || steps->shots.empty();
    bool stepUncertain = false;
    if (steps)
        for (const ShockConditions &shot : steps->shots) {
            table.rows.push_back(conditionsRow(results, shot, recipe));
            stepMissing = stepMissing || !shot.step_Pa;
            stepUncertain = stepUncertain || stepUncertainty_Pa(shot);
        }
    if (!table.rows.empty())
        section.tables.push_back(std::move(table));
    const bool isByTransducer = calibrationKind(results, recipe) == CalibrationKind::Transducer;
    if (stepUncertain && isByTransducer)
        section.notes.push_back(
            {DYNCAL_TEXT("core",
                 "U of the step is its expanded uncertainty with the coverage factor k of the same line, for a coverage probability of about %1 %: that of the reference transducer's certificate, its chain and the noise of its level. It is contained in the uncertainty of the sensitivity."),
                {numberText(100.0 * recipe.uncertainty.coverage, 4)}});
    else if (stepUncertain)
        section.notes.push_back(
            {DYNCAL_TEXT("core",
                 "U of the step is its expanded uncertainty with the coverage factor k of the same line, for a coverage probability of about %1 %. It follows from the uncertainties of the shock velocity, the initial pressure and temperature and the gas, and holds for an ideal shock tube. It is contained in the uncertainties of the sensitivity and of the magnitudes of the frequency response."),
                {numberText(100.0 * recipe.uncertainty.coverage, 4)}});
    const auto hasStates = [](const ShockConditions &shot) { return shot.states.has_value(); };
    if (steps && std::ranges::any_of(steps->shots, hasStates))
        section.notes.push_back(
            {DYNCAL_TEXT("core",
                 "The initial pressure is absolute: the item was under it before the step."),
                {}});
    if (stepMissing)
        section.notes.push_back(
            {DYNCAL_TEXT("core",
                 "The pressure step is not determined for every shot: neither a step nor a shock velocity with initial pressure and temperature was given. A sensitivity in the unit of pressure cannot be stated for those shots."),
                {}});
}

Message stepUnknown()
{
    return {
        DYNCAL_TEXT("core",
            "No pressure step is determined: neither a step nor a shock velocity with initial pressure and temperature was given. No sensitivity in the unit of pressure can be stated."),
        {}};
}

Message stepNotWanted()
{
    return {
        DYNCAL_TEXT("core",
            "No pressure step is determined, as the laboratory chose not to evaluate the shock wave. No sensitivity in the unit of pressure can be stated."),
        {}};
}

/// The gas that the pressure step rests on, of the first shot that has one.
void addMedium(const CalibrationResults &results, const Recipe &recipe, CertificateSection &section)
{
    const ShockConditionsSet *steps = stepsUsed(results, recipe);
    if (!steps)
        return;
    const auto found = std::ranges::find_if(
        steps->shots, [](const ShockConditions &shot) { return shot.drivenGas && shot.states; });
    if (found == steps->shots.end())
        return;
    const GasModel &gas = *found->drivenGas;
    section.fields.push_back({"medium", {DYNCAL_TEXT("core", "Gas before the item"), {}},
        {DYNCAL_TEXT("core", "%V1, ratio of specific heats %L2, molar mass %L3"),
            {gas.name, fixedText(gas.constants.gamma, 4),
                fixedText(1000.0 * gas.constants.molarMass_kg_mol, 3) + " g/mol"}},
        false});
}

} // namespace

CertificateSection conditionsSection(const CalibrationResults &results, const Recipe &recipe)
{
    CertificateSection section;
    section.id = "conditions";
    section.title = {DYNCAL_TEXT("core", "Conditions"), {}};
    section.fields = {
        {"ambient_temperature", {DYNCAL_TEXT("core", "Ambient temperature"), {}},
            environmentRange(results, &Environment::ambientT_K, "K", kDigitsOfTemperature), false},
        {"ambient_pressure", {DYNCAL_TEXT("core", "Ambient pressure"), {}},
            environmentRange(results, &Environment::ambientPressure_Pa, "Pa"), false},
        {"relative_humidity", {DYNCAL_TEXT("core", "Relative humidity"), {}},
            environmentRange(results, &Environment::relativeHumidity, "%"), false}};
    addMedium(results, recipe, section);
    switch (calibrationKind(results, recipe)) {
    case CalibrationKind::ComputedStep:
    case CalibrationKind::TypedStep:
    case CalibrationKind::Transducer:
        addSteps(results, recipe, section);
        break;
    case CalibrationKind::UnknownStep:
        section.notes.push_back(recipe.shock.enabled ? stepUnknown() : stepNotWanted());
        break;
    case CalibrationKind::FreeDecay:
        break;
    }
    return section;
}

} // namespace dyncal
