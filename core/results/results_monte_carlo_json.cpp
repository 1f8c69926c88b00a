// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_monte_carlo_json.h"

#include "core/monte_carlo/chain_monte_carlo.h"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace dyncal {
namespace {

using DrawnJson = JsonRecord::Json;

constexpr const char *kUndefined = "It does not exist in some of the trials, see undefined_trials.";
constexpr const char *kNothingDrawn
    = "Nothing was drawn: no value of a step response has an uncertainty, or it is a free decay.";
constexpr const char *kNoMoment
    = "With one or two degrees of freedom it does not exist (JCGM 101, 6.4.9.4); the interval stands.";
constexpr const char *kNoRow = "The row is withheld, or a part of its uncertainty is not known.";

constexpr const char *kNoRowOrMoment
    = "The row is withheld, a part of its uncertainty is not known, or its draws have one or two degrees of freedom, with which it does not exist.";

void addDrawn(JsonRecord &record, const DrawnQuantity &drawn)
{
    record.set("undefined_trials", drawn.undefined);
    const char *whyNoMoment = drawn.undefined > 0 ? kUndefined : kNoMoment;
    record.number("mean", drawn.mean, whyNoMoment);
    record.number("u", drawn.u, whyNoMoment);
    record.number("low", drawn.low, kUndefined);
    record.number("high", drawn.high, kUndefined);
    record.number("shortest_low", drawn.shortestLow, kUndefined);
    record.number("shortest_high", drawn.shortestHigh, kUndefined);
    record.number("expanded", drawn.expanded, kUndefined);
}

DrawnJson valueJson(const DrawnValue &one)
{
    JsonRecord record;
    record.set("of", one.of);
    record.set("unit", one.unit.empty() ? "1" : one.unit);
    record.set("value", one.value);
    addDrawn(record, one.drawn);
    record.number("u_gum", one.gum.u, "Not known.");
    record.number("k_gum", one.gum.k, "Not known.");
    record.number("low_gum", one.gum.low, "Not known.");
    record.number("high_gum", one.gum.high, "Not known.");
    record.number("tolerance", one.gum.tolerance, "Not known.");
    record.number("d_low", one.gum.d_low, kUndefined);
    record.number("d_high", one.gum.d_high, kUndefined);
    record.text("largest_input", one.gum.largest, "None is more than half of the variance.");
    record.set("validated", one.gum.validated);
    return record.take();
}

Eigen::VectorXd column(
    const std::vector<DrawnRow> &rows, const std::function<double(const DrawnRow &)> &of)
{
    Eigen::VectorXd values(std::ssize(rows));
    for (std::size_t i = 0; i < rows.size(); ++i)
        values[static_cast<Index>(i)] = of(rows[i]);
    return values;
}

/// true, false, or null where there is nothing to compare.
void addFlags(JsonRecord &record, const std::string &key, const std::vector<DrawnRow> &rows,
    bool DrawnRow::*has, const std::function<bool(const DrawnRow &)> &of)
{
    DrawnJson list = DrawnJson::array();
    for (const DrawnRow &row : rows)
        list.push_back(row.*has ? DrawnJson(of(row)) : DrawnJson());
    record.set(key, std::move(list));
    if (!std::ranges::all_of(rows, has))
        record.set(key + "_reason", kNoRow);
}

DrawnJson covariancesJson(const std::vector<DrawnRow> &rows)
{
    Eigen::MatrixX3d covariance(std::ssize(rows), 3);
    for (std::size_t i = 0; i < rows.size(); ++i)
        covariance.row(static_cast<Index>(i)) << rows[i].varRe, rows[i].covReIm, rows[i].varIm;
    return rowsOf(covariance);
}

void addColumns(JsonRecord &record, const std::string &of, const std::vector<DrawnRow> &rows,
    DrawnQuantity DrawnRow::*drawn, GumValidation DrawnRow::*gum)
{
    const auto add
        = [&](const char *name, const std::function<double(const DrawnRow &)> &value,
              const char *why = kNoRow) { record.numbers(of + name, column(rows, value), why); };
    add(
        "_mean", [=](const DrawnRow &row) { return (row.*drawn).mean; }, kNoRowOrMoment);
    add(
        "_u", [=](const DrawnRow &row) { return (row.*drawn).u; }, kNoRowOrMoment);
    add("_low", [=](const DrawnRow &row) { return (row.*drawn).low; });
    add("_high", [=](const DrawnRow &row) { return (row.*drawn).high; });
    add("_expanded", [=](const DrawnRow &row) { return (row.*drawn).expanded; });
    add("_expanded_gum", [=](const DrawnRow &row) { return (row.*gum).expanded(); });
    add("_tolerance", [=](const DrawnRow &row) { return (row.*gum).tolerance; });
}

DrawnJson rowsJson(const std::vector<DrawnRow> &rows)
{
    JsonRecord record;
    record.numbers(
        "frequency_hz", column(rows, [](const DrawnRow &row) { return row.frequency_Hz; }), kNoRow);
    addColumns(record, "magnitude", rows, &DrawnRow::magnitude, &DrawnRow::gumMagnitude);
    addFlags(record, "magnitude_validated", rows, &DrawnRow::withMagnitude,
        [](const DrawnRow &row) { return row.gumMagnitude.validated; });
    addColumns(record, "phase_rad", rows, &DrawnRow::phase, &DrawnRow::gumPhase);
    addFlags(record, "phase_rad_validated", rows, &DrawnRow::withPhase,
        [](const DrawnRow &row) { return row.gumPhase.validated; });
    record.set("covariance_re_im", covariancesJson(rows));
    record.set("covariance_re_im_reason",
        "var Re, covariance, var Im of all that the row's U has; null where withheld, or where its draws have no variance.");
    addFlags(record, "bivariate", rows, &DrawnRow::withPhase,
        [](const DrawnRow &row) { return row.isBivariate; });
    return record.take();
}

DrawnJson refitsJson(const RefitCheck &check)
{
    JsonRecord record;
    record.set("n", check.refits);
    record.set("failed", check.failed);
    record.set("agree", check.agrees());
    DrawnJson values = DrawnJson::array();
    for (const RefittedValue &one : check.values) {
        JsonRecord value;
        value.set("of", one.of);
        value.number("u_refits", one.u_refits, "It does not exist in some refit.");
        value.number("u_draws", one.u_draws, "It does not exist in some draw.");
        value.number("shift", one.shift, "It does not exist in some refit or draw.");
        value.set("agrees", one.agrees);
        values.push_back(value.take());
    }
    record.set("quantities", std::move(values));
    return record.take();
}

DrawnJson sectionJson(const ChainMonteCarlo &drawn)
{
    JsonRecord record;
    record.set("trials", drawn.trials);
    record.set("seed", drawn.seed);
    record.set("coverage", drawn.coverage);
    record.set("adaptive", drawn.isAdaptive);
    if (drawn.isAdaptive)
        record.set("stable", drawn.isStable);
    else
        record.missing("stable", "The number of trials is that of the recipe.");
    record.set("validated", drawn.isValidated());
    DrawnJson quantities = DrawnJson::array();
    for (const DrawnValue &one : drawn.values)
        quantities.push_back(valueJson(one));
    record.set("quantities", std::move(quantities));
    record.set("rows", rowsJson(drawn.rows));
    record.set("marked", rowsJson(drawn.rowsAtMarks));
    if (drawn.refits.refits > 0)
        record.set("refits", refitsJson(drawn.refits));
    else
        record.missing(
            "refits", "Fewer than 2000 trials, or the model was not refined, or there is no step.");
    return record.take();
}

} // namespace

void addChainMonteCarlo(JsonRecord &root, const ResultsContext &context)
{
    const auto &drawn = context.results().chainMonteCarlo;
    const std::string missing = !drawn ? context.whyMissing()
        : drawn->trials == 0           ? kNothingDrawn
                                       : "";
    if (!missing.empty()) {
        root.missing("monte_carlo", missing);
        root.missing("gum_validated_by_monte_carlo", missing);
        return;
    }
    root.set("monte_carlo", sectionJson(*drawn));
    root.set("gum_validated_by_monte_carlo", drawn->isValidated());
}

} // namespace dyncal
