// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/stage_table.h"

#include "core/realization/order/order_findings.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace dyncal {
namespace {

using R = CalibrationResults;

template <auto member>
bool has(const R &results)
{
    return results.*member != nullptr;
}

template <auto member>
Findings of(const R &results)
{
    return (results.*member)->findings;
}

/// The stages that use this one's result report its findings.
Findings saidElsewhere(const R &)
{
    return {};
}

/// Findings of all orders, and of the model's order compared with them (MOD-007).
Findings ofEvidence(const R &results)
{
    Findings findings = results.evidence->findings;
    if (results.model) {
        const Findings ofModel = judgeOtherShots(*results.model, *results.evidence);
        findings.insert(findings.end(), ofModel.begin(), ofModel.end());
    }
    return findings;
}

/// With those of the assessment, which are about the model too: people read them in one place.
Findings ofModel(const R &results)
{
    Findings findings = results.model->findings;
    if (results.assessment)
        findings.insert(findings.end(), results.assessment->findings.begin(),
            results.assessment->findings.end());
    return findings;
}

void readNothing(const Recipe &, Recipe &) { } // an earlier key has all that it reads

void readCaptures(const Recipe &recipe, Recipe &part)
{
    part.import = recipe.import;
    part.checks = recipe.checks;
}

void readArrivals(const Recipe &recipe, Recipe &part)
{
    for (const ArrivalSensor &sensor : recipe.shock.arrivalSensors)
        part.shock.arrivalSensors.push_back({sensor.channel});
}

void readExpected(const Recipe &recipe, Recipe &part)
{
    part.shock = recipe.shock;
    part.window.start_s = recipe.window.start_s;
}

void readWindow(const Recipe &recipe, Recipe &part)
{
    part.window = recipe.window;
    part.window.excludeStretches.clear(); // only the fit leaves them out
    part.remap = recipe.remap;
    part.input.treatment = recipe.input.treatment;
}

void readSpectrum(const Recipe &recipe, Recipe &part)
{
    part.spectrum = recipe.spectrum;
}

void readComponents(const Recipe &recipe, Recipe &part)
{
    part.pca = recipe.pca;
}

void readModelInput(const Recipe &recipe, Recipe &part)
{
    part.input = recipe.input;
    part.window.excludeStretches = recipe.window.excludeStretches;
    part.realization.nuisanceModes = recipe.realization.nuisanceModes;
}

void readDecomposition(const Recipe &recipe, Recipe &part)
{
    part.realization.maxOrder = recipe.realization.maxOrder;
    part.realization.rows = recipe.realization.rows;
}

void readModel(const Recipe &recipe, Recipe &part)
{
    part.realization.order = recipe.realization.order;
    part.realization.refine = recipe.realization.refine;
}

void readShock(const Recipe &recipe, Recipe &part)
{
    part.uncertainty.budget = recipe.uncertainty.budget; // `shock` is in an earlier key
}

void readResponse(const Recipe &recipe, Recipe &part)
{
    part.response = recipe.response;
}

void readEvidence(const Recipe &recipe, Recipe &part)
{
    part.realization.stableFrequency = recipe.realization.stableFrequency;
    part.realization.stableDamping = recipe.realization.stableDamping;
}

void readMonteCarlo(const Recipe &recipe, Recipe &part)
{
    part.uncertainty = recipe.uncertainty;
}

using enum StageId;

// Evidence serves every order: model and response do not count for it.
constexpr std::array<Stage, kStageCount> kStages{{
    {Captures, "captures", 3, 40, "CAP-", Captures, readCaptures, has<&R::captures>,
        of<&R::captures>},
    {Arrivals, "arrivals", 1, 110, "", Captures, readArrivals, has<&R::starts>, saidElsewhere},
    {Expected, "expected shock", 1, 30, "", Arrivals, readExpected, has<&R::expected>,
        saidElsewhere},
    {Window, "window", 1, 50, "WIN-", Expected, readWindow, has<&R::window>, of<&R::window>},
    {Spectrum, "spectrum", 1, 110, "SPC-", Window, readSpectrum, has<&R::spectrum>,
        of<&R::spectrum>},
    {Components, "components", 1, 300, "PCA-", Spectrum, readComponents, has<&R::components>,
        of<&R::components>},
    {ModelInput, "model input", 1, 10, "MIN-", Components, readModelInput, has<&R::input>,
        of<&R::input>},
    {Decomposition, "decomposition", 1, 100, "ORD-", ModelInput, readDecomposition,
        has<&R::decomposition>, saidElsewhere},
    {Model, "model", 1, 10, "MOD-", Decomposition, readModel, has<&R::model>, ofModel},
    {Shock, "shock", 1, 1, "SHK-", Model, readShock, has<&R::shock>, of<&R::shock>},
    {Response, "response", 2, 30, "RSP-", Shock, readResponse, has<&R::response>, of<&R::response>},
    {Assessment, "model assessment", 1, 10, "", Model, readNothing, has<&R::assessment>,
        saidElsewhere},
    {Evidence, "evidence", 1, 160, "", Decomposition, readEvidence, has<&R::evidence>, ofEvidence},
    {MonteCarlo, "Monte Carlo", 1, 50, "", Shock, readMonteCarlo, has<&R::monteCarlo>,
        of<&R::monteCarlo>},
}};

constexpr bool isInOrder()
{
    for (std::size_t i = 0; i < kStages.size(); ++i) {
        if (kStages[i].id != static_cast<StageId>(i) || kStages[i].follows > kStages[i].id)
            return false;
    }
    return true;
}
static_assert(isInOrder());

/// Whether one of the first `count` findings says the same of the same channel as `finding`.
bool isTold(const Findings &findings, std::size_t count, const Finding &finding)
{
    return !finding.channel.empty()
        && std::any_of(findings.begin(), findings.begin() + static_cast<std::ptrdiff_t>(count),
            [&](const Finding &told) {
                return told.id == finding.id && told.shot == finding.shot
                    && told.channel == finding.channel && told.severity >= finding.severity;
            });
}

} // namespace

const Stage &stageOf(StageId id)
{
    return kStages[static_cast<std::size_t>(id)];
}

const char *stageName(StageId id)
{
    return stageOf(id).name;
}

std::optional<StageId> stageOfFinding(const std::string &id)
{
    for (const Stage &stage : kStages) {
        if (*stage.findings != '\0' && id.starts_with(stage.findings))
            return stage.id;
    }
    return std::nullopt;
}

bool hasResult(const CalibrationResults &results, StageId id)
{
    return stageOf(id).isThere(results);
}

Findings findingsOf(const CalibrationResults &results, StageId id)
{
    return hasResult(results, id) ? stageOf(id).findingsOf(results) : Findings();
}

Findings allFindings(const CalibrationResults &results)
{
    Findings all;
    for (const Stage &stage : kStages) {
        const std::size_t earlier = all.size();
        for (const Finding &finding : findingsOf(results, stage.id)) {
            if (!isTold(all, earlier, finding))
                all.push_back(finding);
        }
    }
    return all;
}

double progressAfter(StageId id, StageId last)
{
    double done = 0.0;
    double all = 0.0;
    for (const Stage &stage : kStages) {
        done += stage.id <= std::min(id, last) ? stage.cost_ms : 0.0;
        all += stage.id <= last ? stage.cost_ms : 0.0;
    }
    return done / all;
}

} // namespace dyncal
