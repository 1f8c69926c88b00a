// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_analysis_json.h"

#include "core/decomposition/component_result.h"
#include "core/decomposition/residual_analysis.h"
#include "core/results/results_order_json.h"
#include "core/results/results_shock_json.h"
#include "core/results/shared_spectrum.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

using Json = JsonRecord::Json;

constexpr Index kMostSpectrumPoints = 4096;

const char *combineName(CombineMethod combine)
{
    return combine == CombineMethod::Stacked ? "stacked" : "pca-average";
}

void addDecibels(JsonRecord &section, const SpectrumResult &result)
{
    const SharedSpectrum shared = sharedSpectrum(result.perShot, kMostSpectrumPoints);
    Json lists = Json::array();
    bool complete = true;
    for (const Eigen::VectorXd &psd : shared.psd) {
        Json list = Json::array();
        for (const double value : psd)
            list.push_back(finiteOrNull(10.0 * std::log10(value)));
        complete = complete && psd.allFinite() && (psd.array() > 0.0).all();
        lists.push_back(std::move(list));
    }
    section.numbers("frequency_hz", shared.frequency_Hz, "There is no spectrum.");
    section.set("psd_db", std::move(lists));
    if (!complete)
        section.set("psd_db_reason",
            "null where a shot's own spectrum has no value at the frequency, or no power.");
}

Json resonanceJson(const Resonance &resonance)
{
    JsonRecord record;
    record.number("frequency_hz", resonance.frequency_Hz, "Not determined.");
    record.number("prominence_db", resonance.prominence_dB, "Not determined.");
    record.number("q", resonance.q, "The peak's half-power width is not resolved.");
    Json perShot = Json::array();
    bool complete = true;
    for (const std::optional<double> &frequency : resonance.perShot_Hz) {
        perShot.push_back(frequency ? finiteOrNull(*frequency) : Json(nullptr));
        complete = complete && frequency;
    }
    record.set("per_shot_hz", std::move(perShot));
    if (!complete)
        record.set("per_shot_hz_reason", "null where the peak does not stand out in the shot.");
    return record.take();
}

void addResiduals(JsonRecord &section, const ComponentResult &components)
{
    const auto count = static_cast<Index>(components.residuals.size());
    Eigen::VectorXd rms(count);
    Eigen::VectorXd whiteness(count);
    Json peaks = Json::array();
    for (Index i = 0; i < count; ++i) {
        const ResidualAnalysis &residual = components.residuals[static_cast<std::size_t>(i)];
        rms[i] = residual.rms;
        whiteness[i] = residual.whiteness_p;
        peaks.push_back(residual.peaks_Hz);
    }
    const char *reason = "One shot leaves no residual.";
    section.numbers("residual_rms", rms, reason);
    section.numbers("residual_whiteness_p", whiteness, reason);
    if (count > 0)
        section.set("residual_peaks_hz", std::move(peaks));
    else
        section.missing("residual_peaks_hz", reason);
}

} // namespace

void addSpectrum(JsonRecord &root, const ResultsContext &context)
{
    const auto result = context.results().spectrum;
    if (!result) {
        root.missing("spectrum", context.whyMissing());
        return;
    }
    JsonRecord section;
    addDecibels(section, *result);
    Json resonances = Json::array();
    for (const Resonance &resonance : result->resonances)
        resonances.push_back(resonanceJson(resonance));
    section.set("resonances", std::move(resonances));
    addCandidates(section, context);
    root.set("spectrum", section.take());
}

void addComponents(JsonRecord &root, const ResultsContext &context)
{
    const auto result = context.results().components;
    if (!result) {
        root.missing("pca", context.whyMissing());
        return;
    }
    JsonRecord section;
    section.numbers("explained_cumulative_percent",
        result->principal ? result->principal->explainedCumulative_percent : Eigen::VectorXd(),
        "One shot has no principal components.");
    section.set("components_kept", result->kept);
    addResiduals(section, *result);
    root.set("pca", section.take());
}

void addModelInput(JsonRecord &root, const ResultsContext &context)
{
    const auto input = context.results().input;
    if (!input) {
        root.missing("input", context.whyMissing());
        return;
    }
    JsonRecord section;
    section.set("treatment", responseTreatmentName(input->treatment));
    section.set("combine", combineName(input->combine));
    section.number("sample_rate_hz", input->sampleRate_Hz, "Not determined.");
    section.set("samples", input->samples);
    section.number("offset_s", input->offset_s, "Not determined.");
    section.number("samples_per_period", input->samplesPerPeriod, "No resonance is known.");
    section.number("lost_response_percent", input->lostResponse_percent,
        "The energy of the ringing before the input could not be told from the noise.");
    Json stretches = Json::array();
    for (const ExcludedStretch &stretch : input->leftOut)
        stretches.push_back({{"shot", stretch.shot}, {"from_s", stretch.from_s},
            {"to_s", stretch.to_s}, {"reason", stretch.reason}});
    section.set("excluded_stretches", std::move(stretches));
    root.set("input", section.take());
}

void addRealization(JsonRecord &root, const ResultsContext &context)
{
    const auto result = context.results().decomposition;
    if (!result) {
        root.missing("realization", context.whyMissing());
        return;
    }
    const HankelDecomposition &hankel = result->hankel;
    const Index shown = std::min(hankel.singularValues.size(), context.recipe.realization.maxOrder);
    JsonRecord section;
    section.set("rows", hankel.rows);
    section.set("columns", hankel.columns);
    section.numbers(
        "singular_values", hankel.singularValues.head(shown), "The decomposition is empty.");
    section.set("converged", std::min(hankel.converged, shown));
    section.number("noise_floor_p95", hankel.noiseFloor_p95,
        "There is too little record before the start to know the noise.");
    if (result->suggestion.order > 0)
        section.set("suggested_order", result->suggestion.order);
    else
        section.missing("suggested_order", english(result->suggestion.reason));
    section.set("suggestion_reason", english(result->suggestion.reason));
    addOrderEvidence(section, context);
    root.set("realization", section.take());
}

} // namespace dyncal
