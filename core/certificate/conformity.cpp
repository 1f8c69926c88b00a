// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/conformity.h"

#include "core/base/distributions.h"
#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "core/model_analysis/transducer_steps.h"
#include "core/uncertainty/reported_value.h"
#include "core/uncertainty/row_uncertainty.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace dyncal {
namespace {

using LowLines = std::vector<UncertaintyLine>;

constexpr double kRoundingOfEnds = 1e-9;
constexpr double kWidestStep = 1.2801; ///< third octaves, rounded as ISO 266 does: 1.6 to 1.25

/// The response at low frequency, with what its u has beside that of all rows, relative to it.
struct LowFrequency
{
    double value = kUnknown;
    LowLines lines;
};

/// The noise of the levels, which make the sensitivity but no row.
std::optional<LowLines> linesOfLevels(const ResponseResult &response)
{
    LowLines lines;
    for (const ShotSensitivity &shot : response.shots) {
        if (!std::isfinite(shot.uLevel_relative))
            return std::nullopt;
        lines.push_back(directLine(
            kLevelRelative, shot.uLevel_relative / static_cast<double>(response.shots.size())));
    }
    return lines;
}

/// Against a transducer rows and sensitivity rest on its calibration at different frequencies.
void addReference(const ResponseResult &response, LowLines &lines)
{
    if (response.isByTransducer && response.summary.mean)
        for (const UncertaintyLine &line : response.summary.mean->lines)
            if (line.quantity != kReferenceGain && line.quantity != kLevelRelative)
                lines.push_back(line);
}

std::optional<LowFrequency> lowFrequency(const ResponseResult &response)
{
    std::optional<LowLines> lines = linesOfLevels(response);
    if (lines && response.isWithoutChain)
        lines->push_back(directLine(kChainLevel, response.u_chainLowest_relative));
    const bool isRelative = response.unit == "1";
    if (!lines || lines->empty() || (!isRelative && !response.sensitivity))
        return std::nullopt;
    if (isRelative)
        return LowFrequency{1.0, *std::move(lines)};
    if (response.isByTransducer && !(response.summary.mean && response.summary.mean->u))
        return std::nullopt;
    addReference(response, *lines);
    return LowFrequency{std::abs(*response.sensitivity), *std::move(lines)};
}

JudgedRow ratioOf(const ResponseResult &response, Index row, const LowFrequency &low)
{
    const double S = response.magnitude[row];
    JudgedRow judged;
    judged.frequency_Hz = response.frequency_Hz[row];
    judged.deviation = S / low.value - 1.0;
    if (!std::isfinite(S))
        return judged;
    std::vector<UncertaintyLine> lines = magnitudeOfRow(response, {}, row).lines;
    const LowLines ofLow = scaled(low.lines, S);
    lines.insert(lines.end(), ofLow.begin(), ofLow.end());
    const CombinedUncertainty all = combined(scaled(lines, 1.0 / low.value));
    judged.u = all.u;
    judged.dof = all.dof;
    return judged;
}

bool isClaimed(double f_Hz, const DecisionSettings &decision)
{
    return f_Hz >= (1.0 - kRoundingOfEnds) * decision.from_Hz
        && f_Hz <= (1.0 + kRoundingOfEnds) * decision.to_Hz;
}

void addRatios(const ResponseResult &response, const LowFrequency &low,
    const DecisionSettings &decision, std::vector<JudgedRow> &rows)
{
    for (Index row = 0; row < response.magnitude.size(); ++row)
        if (isClaimed(response.frequency_Hz[row], decision))
            rows.push_back(ratioOf(response, row, low));
}

/// Ascending, those at the marked frequencies among them.
std::vector<JudgedRow> rowsOfClaim(
    const ResponseResult &response, const LowFrequency &low, const DecisionSettings &decision)
{
    std::vector<JudgedRow> rows;
    addRatios(response, low, decision, rows);
    if (response.atMarks)
        addRatios(*response.atMarks, low, decision, rows);
    std::ranges::sort(rows, {}, &JudgedRow::frequency_Hz);
    return rows;
}

std::string hertz(double frequency_Hz)
{
    return settingText(frequency_Hz, "Hz");
}

std::optional<Message> leavesBand(const ResponseResult &response, const DecisionSettings &decision)
{
    if (decision.from_Hz >= (1.0 - kRoundingOfEnds) * response.fLow_Hz
        && decision.to_Hz <= (1.0 + kRoundingOfEnds) * response.fHigh_Hz)
        return std::nullopt;
    return Message{
        DYNCAL_TEXT("core", "no statement: the response was measured from %1 to %2 only"),
        {hertz(response.fLow_Hz), hertz(response.fHigh_Hz)}};
}

bool isKnown(const JudgedRow &row)
{
    return std::isfinite(row.deviation) && std::isfinite(row.u);
}

std::optional<Message> withheldRow(const std::vector<JudgedRow> &rows)
{
    const auto withheld = std::ranges::find_if_not(rows, isKnown);
    if (withheld == rows.end())
        return std::nullopt;
    return Message{
        DYNCAL_TEXT("core", "no statement: at %1 no value with a complete uncertainty is stated"),
        {hertz(withheld->frequency_Hz)}};
}

std::optional<Message> gapBetween(
    const std::vector<JudgedRow> &rows, const DecisionSettings &decision)
{
    std::vector<double> at_Hz{decision.from_Hz};
    for (const JudgedRow &row : rows)
        at_Hz.push_back(row.frequency_Hz);
    at_Hz.push_back(decision.to_Hz);
    for (std::size_t i = 1; i < at_Hz.size(); ++i)
        if (rows.empty() || at_Hz[i] > kWidestStep * at_Hz[i - 1])
            return Message{
                DYNCAL_TEXT("core",
                    "no statement: between %1 and %2 the response has no value; a third of an octave is the widest step"),
                {hertz(at_Hz[i - 1]), hertz(at_Hz[i])}};
    return std::nullopt;
}

Message nothingKnown()
{
    return {
        DYNCAL_TEXT("core",
            "no statement: no response over frequency, or its level at low frequency, is known"),
        {}};
}

/// The first reason there is.
std::optional<Message> whyNotJudged(const ResponseResult &response,
    const std::vector<JudgedRow> &rows, const DecisionSettings &decision)
{
    if (const auto why = leavesBand(response, decision))
        return why;
    const auto why = withheldRow(rows);
    return why ? why : gapBetween(rows, decision);
}

double limitOf(const DecisionSettings &decision)
{
    return 0.01 * decision.within_percent;
}

bool isAcceptedBy(const DecisionSettings &decision, const JudgedRow &row)
{
    const double size = std::abs(row.deviation);
    if (decision.rule == DecisionRule::Risk)
        return row.risk <= 0.01 * decision.maxRisk_percent;
    const double guard = decision.rule == DecisionRule::GuardBand ? row.expanded() : 0.0;
    return size <= limitOf(decision) - guard;
}

/// How near a row is to being rejected: by what its rule compares, then by its deviation.
std::pair<double, double> strainOf(const JudgedRow &row, DecisionRule rule)
{
    const double size = std::abs(row.deviation);
    if (rule == DecisionRule::Risk)
        return {row.risk, size};
    return {rule == DecisionRule::GuardBand ? size + row.expanded() : size, row.u};
}

ConformityResult without(Message why)
{
    ConformityResult result;
    result.why = std::move(why);
    return result;
}

ConformityResult verdictOfAll(const std::vector<JudgedRow> &rows, DecisionRule rule)
{
    ConformityResult result;
    result.rows = static_cast<Index>(rows.size());
    result.worst = *std::ranges::max_element(
        rows, {}, [rule](const JudgedRow &row) { return strainOf(row, rule); });
    const bool all = std::ranges::all_of(rows, &JudgedRow::isAccepted);
    result.verdict = all ? ConformityVerdict::Conforms : ConformityVerdict::DoesNotConform;
    return result;
}

/// Between its rows the response is known by the model: a resonance may lie there.
std::optional<Message> modelBetween(const ResponseResult &response, const LowFrequency &low,
    const DecisionSettings &decision, const ConformityResult &judged)
{
    const double guard = decision.rule == DecisionRule::GuardBand ? judged.worst->expanded() : 0.0;
    const ResponseCurve &curve = response.modelCurve;
    for (Index i = 0; i < curve.magnitude.size(); ++i) {
        const double deviation = curve.magnitude[i] / low.value - 1.0;
        if (isClaimed(curve.frequency_Hz[i], decision)
            && std::abs(deviation) > limitOf(decision) - guard)
            return Message{
                DYNCAL_TEXT("core",
                    "no statement: every judged row is accepted, but between them, at %1, the model deviates by %2 %; ask for rows there (response.frequencies)"),
                {hertz(curve.frequency_Hz[i]), numberText(100.0 * deviation, 3)}};
    }
    return std::nullopt;
}

} // namespace

double probabilityOutside(double deviation, double u, double dof, double limit)
{
    if (u == 0.0)
        return std::abs(deviation) <= limit ? 0.0 : 1.0;
    return studentSurvival((limit - deviation) / u, dof)
        + studentSurvival((limit + deviation) / u, dof);
}

void judgeRow(const DecisionSettings &decision, JudgedRow &row)
{
    constexpr double kCoverage = 0.95;
    row.k = statedFactor(coverageFactor(row.dof, kCoverage));
    row.risk = probabilityOutside(row.deviation, row.u, row.dof, limitOf(decision));
    row.isAccepted = isAcceptedBy(decision, row);
}

ConformityResult judgeConformity(const ResponseResult &response, const DecisionSettings &decision)
{
    const std::optional<LowFrequency> low = lowFrequency(response);
    if (!low || response.magnitude.size() == 0)
        return without(nothingKnown());
    std::vector<JudgedRow> rows = rowsOfClaim(response, *low, decision);
    if (const auto why = whyNotJudged(response, rows, decision))
        return without(*why);
    for (JudgedRow &row : rows)
        judgeRow(decision, row);
    ConformityResult result = verdictOfAll(rows, decision.rule);
    if (result.verdict != ConformityVerdict::Conforms)
        return result;
    const auto between = modelBetween(response, *low, decision, result);
    return between ? without(*between) : result;
}

} // namespace dyncal
