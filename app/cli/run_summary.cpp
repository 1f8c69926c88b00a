// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/run_summary.h"

#include "core/base/constants.h"
#include "core/base/foreign_text.h"
#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "core/model_analysis/stated_characteristics.h"
#include "core/pipeline/calibration_kind.h"
#include "core/results/publication.h"
#include "core/results/results_json.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr std::size_t kLabelWidth = 24;

void addLine(std::string &text, std::string label, const std::string &value)
{
    label.resize(std::max(kLabelWidth, label.size() + 1), ' ');
    text += label;
    text += value;
    text += '\n';
}

std::string percent(double value)
{
    return std::isfinite(value) ? fixedText(value, 2) + " %" : "unknown";
}

void addShots(std::string &text, const CalibrationResults &results)
{
    if (!results.captures)
        return;
    const std::vector<Shot> &shots = results.captures->set.shots;
    // A shot can be left out by its own data too (CAP-020), so the window stage has the last word.
    const auto used = results.window
        ? static_cast<std::ptrdiff_t>(results.window->responses.size())
        : std::count_if(shots.begin(), shots.end(), [](const Shot &shot) { return shot.included; });
    addLine(text, "Shots", std::to_string(used) + " of " + std::to_string(shots.size()) + " used");
}

void addModel(std::string &text, const CalibrationResults &results)
{
    if (const auto pole = sensorResonance(results.model.get(), results.assessment.get())) {
        addLine(text, "Natural frequency f0",
            roundedTextWithU(pole->frequency_Hz, uOf(results.uncertainty.get(), "f0_hz"), "Hz"));
        addLine(text, "Damping ratio zeta",
            roundedTextWithU(
                pole->dampingRatio, uOf(results.uncertainty.get(), "damping_ratio"), ""));
    } else {
        addLine(text, "Natural frequency f0", "none: the model has no oscillating sensor pole");
    }
}

/// Why there is no pressure step, and what a certificate cannot state without one.
void addMissingStep(std::string &text, const CalibrationResults &results)
{
    addLine(text, "Sensitivity", "not determined (no pressure step)");
    for (const Finding &finding : results.shock ? results.shock->findings : Findings()) {
        if (finding.id == "SHK-007")
            addLine(text, "", english(finding.message));
    }
    addLine(text, "Cannot be certified",
        "sensitivity and magnitude per unit of pressure; frequencies, damping and the response relative to the plateau need no pressure");
}

void addSensitivity(
    std::string &text, const ResponseResult &response, const CalibrationResults &results)
{
    if (!response.sensitivity) {
        addMissingStep(text, results);
        return;
    }
    // The prefix belongs to the numerator, so "V/Pa" becomes "uV/Pa".
    const UncertaintyReport *report = results.uncertainty.get();
    addLine(text, "Sensitivity",
        roundedTextWithU(
            *response.sensitivity, uOfSensitivity(report), presentable(response.sensitivityUnit)));
    for (std::size_t i = 0; i < response.shots.size(); ++i) {
        const ShotSensitivity &shot = response.shots[i];
        if (shot.sensitivity)
            addLine(text, "  shot " + std::to_string(shot.shot),
                roundedTextWithU(*shot.sensitivity, uOfShot(report, i), presentable(shot.unit)));
    }
}

void addFit(std::string &text, const SensorModel &model)
{
    if (model.diverges) {
        addLine(text, "Fit (FIT)", "none: the simulation of the model diverges");
        return;
    }
    addLine(text, "Fit (FIT)",
        percent(model.fit_percent) + " of attainable " + percent(model.fitAttainable_percent));
    if (model.fitListing_percent)
        addLine(text, "Fit as in the listing", percent(*model.fitListing_percent));
}

void addOrder(std::string &text, const SensorModel &model, const CalibrationResults &results,
    const Recipe &recipe)
{
    std::string order = std::to_string(model.order);
    if (results.decomposition) {
        const OrderSuggestion &suggestion = results.decomposition->suggestion;
        const bool asked = !recipe.realization.order.isAuto();
        order += asked ? " (as asked; suggested " + std::to_string(suggestion.order) + ")"
                       : " (suggested: " + english(suggestion.reason) + ")";
    }
    addLine(text, "Order", order);
}

/// "508 kHz", "above 4.00 MHz (...)": what the certificate says.
void addBands(std::string &text, const ResponseResult &response)
{
    const StatedCharacteristics found = statedCharacteristics(response);
    const auto add = [&text](const char *label, const StatedValue &edge) {
        addLine(text, label, (edge.value ? "up to " : "") + english(edge.words));
    };
    add("Within 5 %", found.within5percent_Hz);
    add("Within 10 %", found.within10percent_Hz);
    add("-3 dB", found.minus3dB_Hz);
}

void addFindings(std::string &text, const PipelineOutcome &outcome)
{
    const Findings findings = allFindings(outcome);
    const auto count = [&findings](Severity severity, const char *one, const char *several) {
        const auto number = std::count_if(findings.begin(), findings.end(),
            [severity](const Finding &finding) { return finding.severity == severity; });
        return std::to_string(number) + (number == 1 ? one : several);
    };
    addLine(text, "Findings",
        count(Severity::Block, " blocking", " blocking") + ", "
            + count(Severity::Caution, " caution", " cautions") + ", "
            + count(Severity::Info, " note", " notes"));
    if (!mayPublish(outcome))
        addLine(
            text, "Not written", "certificate, plots, tables and model, because of what blocks");
}

} // namespace

std::string runSummary(const PipelineOutcome &outcome, const Recipe &recipe)
{
    const CalibrationResults &results = outcome.results;
    const bool isDecay = calibrationKind(results, recipe) == CalibrationKind::FreeDecay;
    std::string text;
    addShots(text, results);
    if (results.model)
        addModel(text, results);
    if (isDecay && results.response)
        addLine(text, "Sensitivity", "none: a free decay gives frequencies and damping only");
    else if (results.response)
        addSensitivity(text, *results.response, results);
    if (results.model) {
        addFit(text, *results.model);
        addOrder(text, *results.model, results, recipe);
    }
    if (results.response && !isDecay)
        addBands(text, *results.response);
    addFindings(text, outcome);
    return text;
}

} // namespace dyncal
