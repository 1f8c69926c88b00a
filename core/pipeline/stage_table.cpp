// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/stage_table.h"

#include "core/consistency/consistency.h"
#include "core/decomposition/component_analysis.h"
#include "core/pipeline/comparison_stage.h"
#include "core/pipeline/early_stages.h"
#include "core/pipeline/model_stages.h"
#include "core/pipeline/nuisance_stage.h"
#include "core/realization/model/model_assessing.h"
#include "core/realization/nuisance/nuisance_modes.h"
#include "core/realization/order/order_findings.h"
#include "core/realization/order/order_scan.h"
#include "core/shock/shock_velocity.h"
#include "core/shock/step_monte_carlo.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <type_traits>

namespace dyncal {
namespace {

using R = CalibrationResults;
using Any = StageResult::Any;

/// A stage's result is what `compute` makes, kept in `member`.
template <auto member, auto compute>
constexpr StageResult kept()
{
    using T = typename std::remove_reference_t<decltype(std::declval<R &>().*member)>::element_type;
    return {[](const StageInputs &in) -> Result<Any> {
                auto made = compute(in);
                if (!made)
                    return tl::unexpected(std::move(made.error()));
                return std::make_shared<T>(std::move(*made));
            },
        [](const R &results) -> Any { return results.*member; },
        [](R &results, const Any &result) {
            results.*member = std::static_pointer_cast<T>(result);
        }};
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

Result<PreparedCaptures> captures(const StageInputs &in)
{
    return prepareCaptures(in.captures, in.recipe);
}

void readArrivals(const Recipe &recipe, Recipe &part)
{
    for (const ArrivalSensor &sensor : recipe.shock.arrivalSensors)
        part.shock.arrivalSensors.push_back({sensor.channel});
}

Result<RecordStarts> arrivals(const StageInputs &in)
{
    return detectStarts(in.results.captures->set, arrivalChannels(in.recipe.shock), in.control,
        in.recipe.checks.stepSigmas);
}

void readExpected(const Recipe &recipe, Recipe &part)
{
    part.shock = recipe.shock;
    part.window.start_s = recipe.window.start_s;
}

Result<ExpectedShock> expected(const StageInputs &in)
{
    return expectedShock(in.results.captures->set, *in.results.starts, in.recipe);
}

void readWindow(const Recipe &recipe, Recipe &part)
{
    part.window = recipe.window;
    part.window.excludeStretches.clear(); // only the fit leaves them out
    part.remap = recipe.remap;
    part.input.treatment = recipe.input.treatment;
}

Result<WindowResult> window(const StageInputs &in)
{
    return windowStage(in.results, in.recipe, in.control);
}

void readSpectrum(const Recipe &recipe, Recipe &part)
{
    part.spectrum = recipe.spectrum;
}

Result<SpectrumResult> spectrum(const StageInputs &in)
{
    return analyseSpectra(in.results.window->responses, in.recipe.spectrum, in.control);
}

void readComponents(const Recipe &recipe, Recipe &part)
{
    part.pca = recipe.pca;
}

Result<ComponentResult> components(const StageInputs &in)
{
    return analyseComponents(
        in.results.window->responses, in.recipe.pca, in.recipe.spectrum, in.control);
}

void readModelInput(const Recipe &recipe, Recipe &part)
{
    part.input = recipe.input;
    part.window.excludeStretches = recipe.window.excludeStretches;
    part.realization.nuisanceModes = recipe.realization.nuisanceModes;
    part.shock.frontDuration_s = recipe.shock.frontDuration_s;
    part.shock.u_frontDuration_s = recipe.shock.u_frontDuration_s;
}

Result<ModelInput> modelInput(const StageInputs &in)
{
    return separatedInput(in.results, in.recipe, in.control);
}

void readDecomposition(const Recipe &recipe, Recipe &part)
{
    part.realization.maxOrder = recipe.realization.maxOrder;
    part.realization.rows = recipe.realization.rows;
}

Result<DecompositionResult> decomposition(const StageInputs &in)
{
    return decompositionStage(*in.results.input, in.recipe.realization, in.control);
}

void readModel(const Recipe &recipe, Recipe &part)
{
    part.realization.order = recipe.realization.order;
    part.realization.refine = recipe.realization.refine;
}

Result<SensorModel> model(const StageInputs &in)
{
    return modelStage(in.results, in.recipe, orderOf(in.results, in.recipe), in.control);
}

void readShock(const Recipe &recipe, Recipe &part)
{
    part.uncertainty.correlations = recipe.uncertainty.correlations;
    part.uncertainty.budget = recipe.uncertainty.budget; // `shock` is in an earlier key
}

Result<ShockConditionsSet> shock(const StageInputs &in)
{
    return shockOfModel(in.results, in.recipe, *in.results.model);
}

void readResponse(const Recipe &recipe, Recipe &part)
{
    part.response = recipe.response;
}

void readReference(const Recipe &recipe, Recipe &part)
{
    part.comparison = recipe.comparison;
    if (part.comparison.loaded) // the key must change with the file
        part.comparison.sha256 = part.comparison.loaded->sha256;
    part.response.reference = recipe.response.reference;
    part.chain = recipe.chain;
    if (part.chain.loaded)
        part.chain.sha256 = part.chain.loaded->sha256;
}

Result<ReferenceStageResult> reference(const StageInputs &in)
{
    return referenceStage(
        in.results.captures->set, *in.results.window, *in.results.shock, in.recipe);
}

Result<ResponseResult> response(const StageInputs &in)
{
    return responseStage(in.results, in.recipe, *in.results.model, *in.results.shock);
}

Result<ConsistencyResult> checks(const StageInputs &in)
{
    return compareWays(in.results.captures->set, in.recipe.shock, *in.results.shock,
        *in.results.response, uncertaintyRequest(in.recipe.uncertainty).stated);
}

Result<ModelAssessment> assessment(const StageInputs &in)
{
    return assessModel(*in.results.input, *in.results.model, in.recipe.realization, in.control);
}

void readUncertainty(const Recipe &recipe, Recipe &part)
{
    part.uncertainty.cmc = recipe.uncertainty.cmc;
}

Result<UncertaintyReport> uncertainty(const StageInputs &in)
{
    return uncertaintyOfResponse(in.results, in.recipe, *in.results.response);
}

Result<ComparisonResult> comparison(const StageInputs &in)
{
    return comparisonStage(in.results, in.recipe);
}

void readEvidence(const Recipe &recipe, Recipe &part)
{
    part.realization.stableFrequency = recipe.realization.stableFrequency;
    part.realization.stableDamping = recipe.realization.stableDamping;
}

Result<OrderEvidence> evidence(const StageInputs &in)
{
    return gatherOrderEvidence(sensorOnly(*in.results.input), in.results.decomposition->hankel,
        in.results.decomposition->suggestion, in.recipe.realization, in.control);
}

void readMonteCarlo(const Recipe &recipe, Recipe &part)
{
    part.uncertainty = recipe.uncertainty;
}

Result<StepMonteCarloSet> monteCarlo(const StageInputs &in)
{
    return stepMonteCarlo(*in.results.shock, in.recipe.uncertainty, in.control);
}

Result<dyncal::ChainMonteCarlo> chainMonteCarlo(const StageInputs &in)
{
    return drawnChain(in.results, in.recipe, in.control);
}

using enum StageId;

// Evidence serves every order: model and response do not count for it.
constexpr std::array<Stage, kStageCount> kStages{{
    {Captures, DYNCAL_TEXT("core", "captures"), 6, 40, "CAP-", Captures, Captures, true,
        readCaptures, kept<&R::captures, captures>(), of<&R::captures>},
    {Arrivals, DYNCAL_TEXT("core", "arrivals"), 1, 110, "", Captures, Captures, false, readArrivals,
        kept<&R::starts, arrivals>(), saidElsewhere},
    {Expected, DYNCAL_TEXT("core", "expected shock"), 1, 30, "", Arrivals, Shock, false,
        readExpected, kept<&R::expected, expected>(), saidElsewhere},
    {Window, DYNCAL_TEXT("core", "window"), 7, 50, "WIN-", Expected, Window, true, readWindow,
        kept<&R::window, window>(), of<&R::window>},
    {Spectrum, DYNCAL_TEXT("core", "spectrum"), 1, 110, "SPC-", Window, Spectrum, true,
        readSpectrum, kept<&R::spectrum, spectrum>(), of<&R::spectrum>},
    {Components, DYNCAL_TEXT("core", "components"), 1, 300, "PCA-", Spectrum, Components, true,
        readComponents, kept<&R::components, components>(), of<&R::components>},
    {ModelInput, DYNCAL_TEXT("core", "model input"), 6, 10, "MIN-", Components, ModelInput, true,
        readModelInput, kept<&R::input, modelInput>(), of<&R::input>},
    {Decomposition, DYNCAL_TEXT("core", "decomposition"), 4, 100, "ORD-", ModelInput, Decomposition,
        true, readDecomposition, kept<&R::decomposition, decomposition>(), saidElsewhere},
    {Model, DYNCAL_TEXT("core", "model"), 9, 10, "MOD-", Decomposition, Model, true, readModel,
        kept<&R::model, model>(), ofModel},
    {Shock, DYNCAL_TEXT("core", "shock"), 8, 1, "SHK-", Model, Shock, true, readShock,
        kept<&R::shock, shock>(), of<&R::shock>},
    {Reference, DYNCAL_TEXT("core", "reference transducer"), 5, 1, "", Shock, Comparison, true,
        readReference, kept<&R::reference, reference>(), saidElsewhere},
    {Response, DYNCAL_TEXT("core", "response"), 11, 30, "RSP-", Reference, Model, true,
        readResponse, kept<&R::response, response>(), of<&R::response>},
    {Checks, DYNCAL_TEXT("core", "checks"), 4, 10, "CHK-", Response, Checks, true, readNothing,
        kept<&R::checks, checks>(), of<&R::checks>},
    {Assessment, DYNCAL_TEXT("core", "model assessment"), 3, 10, "", Model, Model, true,
        readNothing, kept<&R::assessment, assessment>(), saidElsewhere},
    {Uncertainty, DYNCAL_TEXT("core", "uncertainty"), 9, 20, "UNC-", Response, Uncertainty, true,
        readUncertainty, kept<&R::uncertainty, uncertainty>(), of<&R::uncertainty>},
    {Comparison, DYNCAL_TEXT("core", "comparison"), 3, 5, "CMP-", Uncertainty, Comparison, true,
        readNothing, kept<&R::comparison, comparison>(), of<&R::comparison>},
    {Evidence, DYNCAL_TEXT("core", "evidence"), 1, 160, "", Decomposition, Decomposition, false,
        readEvidence, kept<&R::evidence, evidence>(), ofEvidence},
    {MonteCarlo, DYNCAL_TEXT("core", "Monte Carlo"), 1, 50, "", Shock, Shock, true, readMonteCarlo,
        kept<&R::monteCarlo, monteCarlo>(), of<&R::monteCarlo>},
    {ChainMonteCarlo, DYNCAL_TEXT("core", "Monte Carlo of the chain"), 5, 2000, "", Uncertainty,
        Uncertainty, false, readMonteCarlo, kept<&R::chainMonteCarlo, chainMonteCarlo>(),
        of<&R::chainMonteCarlo>},
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
    return stageOf(id).result.get(results) != nullptr;
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
