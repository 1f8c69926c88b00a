// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/run_files.h"

#include "core/capture/capture_seal.h"
#include "core/reference/reference_source.h"
#include "core/results/model_export.h"
#include "core/results/publication.h"
#include "core/results/results_csv.h"
#include "core/results/results_json.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> kDocuments{
    "results.json", "recipe.json", "certificate.pdf", "dcc.xml", kBatchRecord};

bool isModelName(const std::string &name)
{
    return std::ranges::find(modelFileNames(), name) != modelFileNames().end();
}

constexpr std::array<std::string_view, 7> kTables{"components", "singular_values", "poles",
    "orders", "stability", "frequency_response", "model_curve"};
constexpr std::array<std::string_view, 4> kTablesOfShots{
    "response_", "spectrum_", "model_input_", "model_"};
/// Names from ui/report/report_figures.cpp; old names stay here, because folders may have them.
constexpr std::array<std::string_view, 21> kPlots{"raw-dut", "raw-driven-side", "raw-driver",
    "responses", "responses-start", "spectrum", "explained", "reconstruction", "residuals",
    "residual-autocovariance", "residual-spectrum", "average", "model-input", "singular-values",
    "bic", "model-data", "model-error", "pole-zero", "step", "magnitude", "phase"};
constexpr std::size_t kMostDigits = 9; // of the number of a shot

/// At least `least` digits; more only without leading zeros.
bool isNumber(std::string_view text, std::size_t least)
{
    return text.size() >= least && text.size() <= kMostDigits
        && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; })
        && (text.size() == least || text.front() != '0');
}

bool isTableName(std::string_view stem)
{
    return std::ranges::find(kTables, stem) != kTables.end()
        || std::ranges::any_of(kTablesOfShots, [&](std::string_view kind) {
               constexpr std::string_view kShot = "shot_";
               if (!stem.starts_with(kind))
                   return false;
               const std::string_view series = stem.substr(kind.size());
               return series == "average"
                   || (series.starts_with(kShot) && isNumber(series.substr(kShot.size()), 3));
           });
}

/// "01-raw-dut"
bool isPlotName(std::string_view stem)
{
    const std::size_t dash = std::min(stem.find('-'), stem.size());
    return isNumber(stem.substr(0, dash), 2) && dash < stem.size()
        && std::ranges::find(kPlots, stem.substr(dash + 1)) != kPlots.end();
}

/// Whether a run writes a file of this name. Exact, because files on a run's list are replaced and
/// removed, and a recording may lie in csv/ too.
bool isRunName(const std::string &name)
{
    const fs::path path(name);
    const std::string folder = path.parent_path().string();
    return std::ranges::find(kDocuments, name) != kDocuments.end() || isKeptSourceName(name)
        || (folder == "csv" && path.extension() == ".csv" && isTableName(path.stem().string()))
        || (folder == "plots" && path.extension() == ".svg" && isPlotName(path.stem().string()))
        || (folder == "model" && isModelName(path.filename().string()));
}

/// Run and export may share a folder.
bool isRunOrModelName(const std::string &name)
{
    return isRunName(name) || isModelName(name);
}

std::vector<std::string> recordingsOf(const CaptureSet &set)
{
    std::vector<std::string> paths;
    for (const InputFile &input : set.inputs)
        paths.push_back(input.path);
    return paths;
}

/// Documents are shown one by one, plots and tables as their folders.
std::vector<std::string> shownPaths(
    const RunFiles &run, const fs::path &folder, bool tables, bool model)
{
    std::vector<std::string> paths{
        (folder / "results.json").string(), (folder / "recipe.json").string()};
    for (const DrawnFile &file : run.drawn) {
        const fs::path parent = fs::path(file.name).parent_path();
        const fs::path shown = parent.empty() ? folder / file.name : folder / parent / "";
        if (paths.back() != shown.string())
            paths.push_back(shown.string());
    }
    if (tables)
        paths.push_back((folder / "csv" / "").string());
    if (model)
        paths.push_back((folder / "model" / "").string());
    return paths;
}

/// What a certificate or table of the recipe states belongs to what the run can be repeated with.
template <typename Settings>
void keepSource(const Settings &settings, std::vector<FolderFile> &files)
{
    if (!settings.loaded)
        return;
    const std::string name = keptSourceName(settings.source, settings.loaded->sha256);
    if (std::ranges::find(files, name, &FolderFile::name) == files.end())
        files.push_back({name, settings.loaded->content});
}

} // namespace

FolderRequest runFolder(
    const std::string &folder, const CaptureSet &set, std::vector<std::string> settings)
{
    std::vector<std::string> names{"csv/", "plots/", "model/", "sources/"};
    names.insert(names.end(), kDocuments.begin(), kDocuments.end());
    return {folder, "run", isRunName, std::move(names), recordingsOf(set), std::move(settings),
        isRunOrModelName, [set] { return checkStillWhole(set); }};
}

Result<std::vector<std::string>> writeRunFiles(
    const RunFiles &run, FolderWrite &folder, const JobControl &control)
{
    if (!run.drawn.empty() && !mayPublish(run.outcome))
        return writeRunFiles(
            {run.outcome, run.recipe, run.createdUtc, {}, run.record, run.chosen}, folder, control);
    const CalibrationResults shown
        = mayPublish(run.outcome) ? run.outcome.results : CalibrationResults();
    const std::vector<CsvFile> tables = resultsCsv(shown);
    const std::vector<ModelFile> model = modelFiles(shown);
    const std::map<std::string, std::string> layout = keptTemplateFiles(run.chosen);
    const Recipe kept = withKeptTemplate(run.recipe, run.chosen);
    const std::string recipe = recipeJson(kept);
    const std::string json = resultsJson(run.outcome, kept, run.createdUtc);
    std::vector<FolderFile> files{{"recipe.json", recipe}};
    keepSource(run.recipe.chain, files);
    if (run.recipe.comparison.enabled)
        keepSource(run.recipe.comparison, files);
    for (const auto &[name, bytes] : layout)
        files.push_back({name, bytes});
    for (const CsvFile &table : tables)
        files.push_back({"csv/" + table.name, table.text});
    for (const ModelFile &file : model)
        files.push_back({"model/" + file.name, file.bytes});
    for (const DrawnFile &file : run.drawn)
        files.push_back({file.name, file.bytes});
    if (!run.record.empty())
        files.push_back({kBatchRecord, run.record});
    files.push_back({"results.json", json});
    if (const Result<void> written = folder.commit(files, control); !written)
        return tl::unexpected<Error>(written.error());
    return shownPaths(run, folder.folder(), !tables.empty(), !model.empty());
}

FolderRequest modelFolder(
    const std::string &folder, const CaptureSet &set, std::vector<std::string> settings)
{
    return {folder, "export", isModelName, modelFileNames(), recordingsOf(set), std::move(settings),
        isRunOrModelName, [set] { return checkStillWhole(set); }};
}

Result<std::vector<std::string>> writeModelFiles(const CalibrationResults &results,
    const std::vector<std::string> &formats, FolderWrite &folder, const JobControl &control)
{
    const std::vector<ModelFile> model = modelFiles(results);
    if (model.empty()) {
        return fail(ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "The model of order %1 diverges, so there is nothing to export; choose another order."),
                {std::to_string(results.model->order)}},
            "MOD-001");
    }
    std::vector<FolderFile> files;
    std::vector<std::string> paths;
    for (const ModelFile &file : model) {
        if (std::ranges::find(formats, file.format) == formats.end())
            continue;
        files.push_back({file.name, file.bytes});
        paths.push_back((fs::path(folder.folder()) / file.name).string());
    }
    if (const Result<void> written = folder.commit(files, control); !written)
        return tl::unexpected<Error>(written.error());
    return paths;
}

} // namespace dyncal
