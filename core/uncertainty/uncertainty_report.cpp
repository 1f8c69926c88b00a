// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/uncertainty_report.h"

#include "core/base/number_text.h"
#include "core/model_analysis/shot_lines.h"
#include "core/model_analysis/transducer_steps.h"
#include "core/uncertainty/model_values.h"
#include "core/uncertainty/pole_amplitudes.h"
#include "core/uncertainty/quantity_words.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dyncal {
namespace {

using Lines = std::vector<UncertaintyLine>;

bool isPerPressure(const ResponseResult &response)
{
    return response.sensitivity && response.unit == response.sensitivityUnit;
}

Lines together(Lines lines, const Lines &more)
{
    lines.insert(lines.end(), more.begin(), more.end());
    return lines;
}

/// Of one mean, with the chain's lines; u absent where that of the step or of a level is.
ReportedValue meanValue(const SensitivityMean &mean, const std::string &unit, const Lines &chain)
{
    ReportedValue reported{"sensitivity", mean.value, unit, {}, {}};
    if (!mean.u) {
        reported.missing
            = {DYNCAL_TEXT("core", "that of the pressure step or of a level is not known"), {}};
        return reported;
    }
    reported.lines = scaled(together(mean.lines, chain), std::abs(mean.value));
    combineLines(reported);
    return reported;
}

/// Relative to the level at the onset: its noise, of each shot.
std::optional<Lines> levelLines(const ResponseResult &response)
{
    Lines lines;
    for (const ShotSensitivity &shot : response.shots) {
        if (!std::isfinite(shot.uLevel_relative))
            return std::nullopt;
        lines.push_back(with(OverShots::Own,
            directLine(kLevelRelative,
                shot.uLevel_relative / static_cast<double>(response.shots.size()))));
        lines.back().shot = shot.shot;
    }
    return lines;
}

/// Whether every measured row has it: all of the sensitivity but the noise of the levels, which the
/// rows have as their own; against a transducer its chain, for its sensitivity is the rows' own.
bool isOfAllRows(const UncertaintyLine &line, const ResponseResult &response)
{
    return response.isByTransducer ? line.quantity == kReferenceGain
                                   : line.quantity != kLevelRelative;
}

/// What the chain does to a sensitivity: that of a table of its response is the rows' own.
Lines chainOfLevels(const ResponseResult &response, const Lines &chain)
{
    if (!response.isWithoutChain)
        return chain;
    return together(chain, {directLine(kChainLevel, response.u_chainLowest_relative)});
}

/// What every row of S(f) shares, and every value of the model.
std::optional<CommonLines> commonLines(const ResponseResult &response, const Lines &chain)
{
    if (!isPerPressure(response)) {
        const std::optional<Lines> lines = levelLines(response);
        return lines ? std::optional(CommonLines{*lines, *lines}) : std::nullopt;
    }
    const auto &mean = response.summary.mean;
    if (!mean || !mean->u)
        return std::nullopt;
    CommonLines common;
    for (const UncertaintyLine &line : mean->lines) {
        if (isOfAllRows(line, response))
            common.ofRows.push_back(line);
        if (line.quantity != kLevelRelative)
            common.ofModel.push_back(line);
    }
    common.ofRows = together(std::move(common.ofRows), chain);
    common.ofModel = together(std::move(common.ofModel), chain);
    return common;
}

/// Complete: with what the chain adds, which inputs of the step may be correlated with. `step`: as
/// the shot has it, null without.
ReportedValue shotValue(
    const ShotSensitivity &shot, const ShockConditions *step, double levelDof, const Lines &chain)
{
    ReportedValue reported{"sensitivity", shot.sensitivity.value_or(kUnknown), shot.unit};
    if (!shot.u || !shot.sensitivity || !step || !step->uncertainty)
        return reported;
    const Lines own
        = shotLines(shot, *step->uncertainty, levelDof > 0.0 ? levelDof : directLine({}, 0.0).dof);
    reported.lines = scaled(together(own, chain), std::abs(*shot.sensitivity));
    combineLines(reported);
    return reported;
}

/// Null where there is none, or where it has no u.
const ReportedValue *knownShot(const UncertaintyReport *report, std::size_t shot)
{
    const bool isKnown
        = report && shot < report->ofShots.size() && report->ofShots[shot].u.has_value();
    return isKnown ? &report->ofShots[shot] : nullptr;
}

/// Why the step of a shot has no u; empty where none can be told.
Message reasonOf(const ShockConditionsSet &shock)
{
    for (const ShockConditions &shot : shock.shots) {
        if (shot.uncertainty && shot.uncertainty->stepMissing)
            return *shot.uncertainty->stepMissing;
        if (!shot.uncertainty && shot.uncertaintyMissing)
            return *shot.uncertaintyMissing;
    }
    return {};
}

void judgeMissing(const UncertaintyReport &report, const ResponseResult &response,
    const ShockConditionsSet &shock, Findings &findings)
{
    if (!isPerPressure(response) || report.rows.isComplete())
        return;
    const Message reason = reasonOf(shock);
    findings.push_back({.id = "UNC-001",
        .severity = Severity::Caution,
        .message = *reason.text == '\0'
            ? Message{DYNCAL_TEXT("core",
                          "The sensitivity has no complete uncertainty: that of the level at the onset is not known. Refine the model, or choose an order whose level is known."),
                {}}
            : Message{
                DYNCAL_TEXT("core",
                    "The sensitivity has no complete uncertainty (%M1). State what is missing in uncertainty.budget or in the capture; without it no sensitivity is a result."),
                {}, {reason}}});
}

/// Of a free decay the resonance is the result.
void judgeUnknownResonance(const UncertaintyReport &report, Findings &findings)
{
    const ReportedValue *f0 = report.find("f0_hz");
    if (!f0 || f0->u || !std::isfinite(f0->value))
        return;
    findings.push_back({.id = "UNC-001",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "The resonance at %1 has no uncertainty, because the model was not refined: without it no resonance is a result. Take another order, or leave out of the window what is no free decay."),
            {numberWithUnit(f0->value, "Hz", 5)}}});
}

/// One line that is more than 80 % of the variance of the sensitivity.
void judgeDominant(const UncertaintyReport &report, Findings &findings)
{
    constexpr double kDominant_percent = 80.0;
    if (!report.sensitivity || !report.sensitivity->u)
        return;
    for (const UncertaintyLine &line : report.sensitivity->lines) {
        const double share = report.sensitivity->sharePercent(line);
        if (share > kDominant_percent)
            findings.push_back({.id = "UNC-002",
                .shot = line.shot,
                .message
                = {DYNCAL_TEXT("core",
                       "%1 % of the variance of the sensitivity come from one source, %M1: to know it better is what makes the uncertainty smaller."),
                    {numberText(share, 2)}, {sourceWords(line.quantity)}},
                .value = share,
                .limit = kDominant_percent});
    }
}

} // namespace

const ReportedValue *UncertaintyReport::find(const std::string &of) const
{
    const auto found = std::ranges::find(ofModel, of, &ReportedValue::of);
    return found == ofModel.end() ? nullptr : &*found;
}

double uOfSensitivity(const UncertaintyReport *report)
{
    return report && report->sensitivity ? report->sensitivity->u.value_or(kUnknown) : kUnknown;
}

double uOfShot(const UncertaintyReport *report, std::size_t shot)
{
    const ReportedValue *found = knownShot(report, shot);
    return found ? *found->u : kUnknown;
}

double kOfShot(const UncertaintyReport *report, std::size_t shot)
{
    const ReportedValue *found = knownShot(report, shot);
    return found ? found->k : kUnknown;
}

double uOf(const UncertaintyReport *report, const std::string &of)
{
    const ReportedValue *found = report ? report->find(of) : nullptr;
    return found ? found->u.value_or(kUnknown) : kUnknown;
}

const ReportedValue *levelOf(const UncertaintyReport *report, std::size_t level)
{
    return report && level < report->perLevel.size() ? &report->perLevel[level] : nullptr;
}

UncertaintyReport reportUncertainty(const ModelInput &input, const SensorModel &model,
    const ModelAssessment &assessment, const ResponseResult &response,
    const ShockConditionsSet &shock, const std::vector<StatedUncertainty> &stated)
{
    UncertaintyReport report;
    report.chain = chainEffects(stated);
    const Lines &chain = report.chain.ofSensitivity;
    const Lines ofLevels = chainOfLevels(response, chain);
    if (response.summary.mean)
        report.sensitivity = meanValue(*response.summary.mean, response.sensitivityUnit, ofLevels);
    for (const SensitivityMean &level : response.summary.perLevel)
        report.perLevel.push_back(meanValue(level, response.sensitivityUnit, ofLevels));
    for (const ShotSensitivity &shot : response.shots)
        report.ofShots.push_back(
            shotValue(shot, shock.ofShot(shot.shot), model.draft.noise.dof, ofLevels));
    const std::vector<ModelVariation> variations = modelVariations(input, model);
    report.ofModel
        = modelValues(model, assessment, response, variations, input.treatment, report.chain);
    report.amplitudes = poleAmplitudes(model, assessment, variations, response.front);
    const std::optional<CommonLines> common = commonLines(response, chain);
    report.rows = rowUncertainty(response, common, model, variations, input.treatment);
    if (response.atMarks)
        report.rowsAtMarks
            = rowUncertainty(*response.atMarks, common, model, variations, input.treatment);
    if (isStepTreatment(input.treatment)) {
        judgeMissing(report, response, shock, report.findings);
        judgeDominant(report, report.findings);
    } else {
        judgeUnknownResonance(report, report.findings);
    }
    return report;
}

} // namespace dyncal
