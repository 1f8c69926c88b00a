// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/interrupt.h"
#include "app/cli/calibration.h"
#include "app/cli/console.h"
#include "app/cli/recipe_options.h"
#include "app/cli/verbs.h"

#include "core/base/foreign_text.h"
#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "core/results/comparison_json.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

namespace dyncal {
namespace {

struct CompareOptions
{
    std::vector<std::string> files;
    RecipeOptions recipe;
    std::vector<std::string> orders;
    bool json = false;
};

Result<std::vector<Index>> parseOrders(const std::vector<std::string> &texts)
{
    std::vector<Index> orders;
    for (const std::string &text : texts) {
        const std::optional<Index> order = typedOrder(text);
        if (!order) {
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT(
                     "core", "--orders holds \"%1\"; it needs whole numbers from 1, as in 2,3,50."),
                    {text}});
        }
        orders.push_back(*order);
    }
    return orders;
}

using Row = std::vector<std::string>;

Row rowOf(const ComparedOrder &compared)
{
    const std::string none = "-";
    const std::string bic = compared.bic ? numberText(std::round(*compared.bic), 8) : none;
    if (!compared.model)
        return {std::to_string(compared.order), "not possible", none, none, none, none, none, none,
            bic};
    const SensorModel &model = *compared.model;
    const auto main = sensorResonance(model.diverges ? nullptr : &model, compared.assessment.get());
    const auto percent
        = [&none](double value) { return std::isfinite(value) ? fixedText(value, 3) : none; };
    return {std::to_string(compared.order),
        model.diverges ? "diverges" : percent(model.fit_percent),
        percent(model.fitAttainable_percent),
        main ? roundedTextWithU(main->frequency_Hz, main->u_frequency_Hz, "Hz") : none,
        main ? roundedTextWithU(main->dampingRatio, main->u_dampingRatio, "") : none,
        std::to_string(countPoles(model, PoleClass::Unstable)),
        std::to_string(countPoles(model, PoleClass::Nyquist)),
        std::isfinite(compared.whiteness_p) ? numberText(compared.whiteness_p, 2) : none, bic};
}

void printTable(const std::vector<Row> &rows)
{
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const Row &row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], row[i].size());
    }
    for (const Row &row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i)
            line += std::string(widths[i] - row[i].size() + (i > 0 ? 2 : 0), ' ') + row[i];
        std::cout << line << '\n';
    }
}

void print(const CalibrationResults &results, const std::vector<ComparedOrder> &orders)
{
    std::vector<Row> rows{{"order", "FIT %", "attainable %", "f0 (noise)", "zeta (noise)",
        "unstable", "Nyquist", "whiteness p", "BIC"}};
    for (const ComparedOrder &compared : orders)
        rows.push_back(rowOf(compared));
    printTable(rows);
    for (const ComparedOrder &compared : orders)
        if (!compared.note.empty())
            std::cout << "order " << compared.order << ": " << presentableInBrief(compared.note)
                      << '\n';
    std::cout << english(results.decomposition->suggestion.reason) << '\n';
}

Result<std::vector<ComparedOrder>> compareWithProgress(
    const CalibrationResults &results, const Recipe &recipe, const std::vector<Index> &orders)
{
    ProgressLine progress("Comparing");
    return compareOrders(results, recipe,
        orders.empty() ? defaultCandidates(results, recipe) : orders,
        {interruptToken(), progress.sink()});
}

/// An order that the data do not allow is wrong usage, reported once after the table.
int conclude(const PipelineOutcome &outcome, const std::vector<ComparedOrder> &orders)
{
    const int code = reportOutcome(outcome);
    const auto failed = std::find_if(orders.begin(), orders.end(),
        [](const ComparedOrder &compared) { return compared.error.has_value(); });
    return failed == orders.end() ? code : report(*failed->error);
}

int compare(const CompareOptions &options)
{
    const auto orders = parseOrders(options.orders);
    if (!orders)
        return report(orders.error());
    const Result<Recipe> recipe = options.recipe.read();
    if (!recipe)
        return report(recipe.error());
    const Result<CaptureSet> set = readForCalibration(options.files, *recipe);
    if (!set)
        return report(set.error());
    const PipelineOutcome outcome = calibrate(*set, *recipe, StageId::Decomposition);
    if (outcome.error)
        return reportOutcome(outcome);
    const auto compared = compareWithProgress(outcome.results, *recipe, *orders);
    if (!compared)
        return report(compared.error());
    if (options.json)
        std::cout << comparisonJson(outcome.results, *compared);
    else
        print(outcome.results, *compared);
    return conclude(outcome, *compared);
}

} // namespace

void addCompare(CLI::App &program, VerbAction &action)
{
    const auto options = std::make_shared<CompareOptions>();
    CLI::App *verb = program.add_subcommand(
        "compare", "Put models of several orders beside each other; nothing is written");
    verb->add_option("files", options->files, "Captures of one sensor, or folders of captures")
        ->required()
        ->type_name("FILE");
    options->recipe.declare(*verb);
    verb->add_option("--orders", options->orders,
            "Orders; without them the suggested one, those of the recipe and a high one")
        ->delimiter(',')
        ->type_name("N,N,...");
    verb->add_flag("--json", options->json, "As JSON");
    verb->footer("Example:\n  dyncal compare example.h5 --orders 2,3,50,100\n"
                 "  dyncal compare shots/ --recipe recipe.json --json");
    verb->callback([options, &action] { action = [options] { return compare(*options); }; });
}

} // namespace dyncal
