// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/shock_stage.h"

#include "core/base/number_text.h"
#include "core/project/nearest_word.h"
#include "core/shock/channel_order.h"
#include "core/shock/peak_tracking.h"
#include "core/shock/reading_check.h"
#include "core/shock/shock_estimate.h"
#include "core/shock/shock_uncertainty.h"
#include "core/shock/uncertainty_settings.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

/// With a misspelt name the usual uncertainty would silently be used, so a finding reports it.
Findings unknownQuantities(const std::vector<BudgetEntry> &budget)
{
    Findings findings;
    for (const BudgetEntry &entry : budget) {
        if (std::ranges::find(statedQuantities(), entry.quantity) == statedQuantities().end())
            findings.push_back({.id = "SHK-013",
                .severity = Severity::Caution,
                .message = {entry.quantity.starts_with("attenuation")
                        ? DYNCAL_TEXT("core",
                            "The uncertainty of '%1' in uncertainty.budget is used for nothing: what is known of the attenuation is the range shock.attenuation_per_m.")
                        : DYNCAL_TEXT("core",
                            "The uncertainty of '%1' in uncertainty.budget is used for nothing; the nearest quantity that counts is '%2'."),
                    {entry.quantity, nearestKey(entry.quantity, statedQuantities())}}});
    }
    return findings;
}

/// A correlation counts between two quantities of the budget.
Findings uselessCorrelations(const UncertaintySettings &settings)
{
    const auto isStated = [&](const std::string &quantity) {
        return std::ranges::find(settings.budget, quantity, &BudgetEntry::quantity)
            != settings.budget.end();
    };
    Findings findings;
    for (const CorrelationEntry &entry : settings.correlations)
        if (entry.quantity == entry.with || !isStated(entry.quantity) || !isStated(entry.with))
            findings.push_back({.id = "SHK-013",
                .severity = Severity::Caution,
                .message
                = {DYNCAL_TEXT("core",
                       "The correlation of '%1' with '%2' in uncertainty.correlations is used for nothing: it needs two quantities whose u stands in uncertainty.budget."),
                    {entry.quantity, entry.with}}});
    return findings;
}

/// When the DUTs felt the shock, as known before the window is cut.
std::vector<DutArrival> startsOfDuts(
    const CaptureSet &set, const RecordStarts &starts, const std::vector<double> &typed_s)
{
    std::vector<DutArrival> arrivals;
    for (Index shot = 1; shot <= std::ssize(set.shots); ++shot) {
        const auto at = static_cast<std::size_t>(shot - 1);
        const Channel *dut = set.shots[at].channelWithRole(ChannelRole::Dut);
        const DetectedStart *start = starts.of(set, shot, dut);
        if (!set.shots[at].included || dut == nullptr)
            continue;
        if (!typed_s.empty())
            arrivals.push_back({shot, typed_s[std::min(at, typed_s.size() - 1)]});
        else if (start != nullptr)
            arrivals.push_back({shot, start->time_s});
    }
    return arrivals;
}

} // namespace

Result<ExpectedShock> expectedShock(
    const CaptureSet &set, const RecordStarts &starts, const Recipe &recipe)
{
    ExpectedShock expected;
    if (!recipe.shock.enabled)
        return expected;
    const std::vector<DutArrival> arrivals = startsOfDuts(set, starts, recipe.window.start_s);
    auto conditions = estimateShockConditions(set, arrivals, recipe.shock, {}, {}, {&starts});
    if (conditions)
        expected.conditions = std::move(*conditions);
    if (recipe.shock.dutPosition == kEndWall)
        expected.findings = checkChannelOrder(set, arrivals, starts);
    return expected;
}

std::vector<DutArrival> dutArrivals(const WindowResult &window, const SensorModel &model)
{
    std::vector<DutArrival> arrivals;
    for (const WindowedResponse &response : window.responses) {
        DutArrival arrival{response.shot, response.start_s, 0.0, false};
        for (const SeriesFit &fit : model.series) {
            if (fit.shot != response.shot || !std::isfinite(fit.onset_s))
                continue;
            arrival.time_s = response.start_s + fit.onset_s;
            arrival.u_time_s = std::isfinite(fit.u_onset_s) ? fit.u_onset_s : 0.0;
            arrival.delayCorrected = true;
        }
        arrivals.push_back(arrival);
    }
    return arrivals;
}

Result<ShockConditionsSet> shockStage(const CaptureSet &set, const ShockConditionsSet &expected,
    const WindowResult &window, const SpectrumResult &spectrum, const SensorModel &model,
    const Recipe &recipe)
{
    if (!recipe.shock.enabled)
        return ShockConditionsSet{};
    auto shock = estimateShockConditions(set, dutArrivals(window, model), recipe.shock,
        uncertaintyRequest(recipe.uncertainty), {}, {nullptr, &expected});
    if (!shock)
        return shock;
    const Findings misread = checkReadings(window.responses, *shock, recipe.checks);
    shock->findings.insert(shock->findings.end(), misread.begin(), misread.end());
    for (const Findings &useless :
        {unknownQuantities(recipe.uncertainty.budget), uselessCorrelations(recipe.uncertainty)})
        shock->findings.insert(shock->findings.end(), useless.begin(), useless.end());
    shock->followedPeaks = followPeaks(spectrum, window, *shock);
    const Findings moving = judgePeaks(shock->followedPeaks);
    shock->findings.insert(shock->findings.end(), moving.begin(), moving.end());
    return shock;
}

} // namespace dyncal
