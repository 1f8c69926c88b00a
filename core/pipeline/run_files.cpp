// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/run_files.h"

#include "core/base/atomic_file.h"
#include "core/pipeline/model_export.h"
#include "core/pipeline/results_csv.h"
#include "core/pipeline/results_json.h"

#include <filesystem>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

void removeFilesIn(const fs::path &folder, const char *extension)
{
    std::error_code ignored;
    for (const fs::directory_entry &entry : fs::directory_iterator(folder, ignored)) {
        if (entry.is_regular_file(ignored) && entry.path().extension() == extension)
            fs::remove(entry.path(), ignored);
    }
}

/// Only in a folder that an earlier run wrote.
void removeEarlierRun(const fs::path &folder)
{
    std::error_code ignored;
    if (!fs::is_regular_file(folder / "recipe.json", ignored))
        return;
    for (const char *name : {"results.json", "certificate.pdf", "dcc.xml", "recipe.json"})
        fs::remove(folder / name, ignored);
    for (const std::string &name : modelFileNames())
        fs::remove(folder / "model" / name, ignored);
    removeFilesIn(folder / "csv", ".csv");
    removeFilesIn(folder / "plots", ".svg");
}

/// Writes file after file of one run; after a failure or a stop it writes no more.
class RunWriter
{
public:
    RunWriter(const std::string &folder, std::size_t files, const JobControl &control)
        : m_folder(folder)
        , m_count(files)
        , m_control(control)
    {
    }

    void write(const std::string &name, std::string_view bytes)
    {
        if (!m_problem && m_control.stopRequested())
            m_problem = Error{ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Cancelled."), {}}, {}, 0};
        const fs::path path = m_folder / name;
        if (!m_problem && path.has_parent_path())
            note(makeFolder(path.parent_path().string()));
        if (!m_problem)
            note(writeFileAtomically(path.string(), bytes));
        m_control.report(static_cast<double>(++m_written) / static_cast<double>(m_count));
    }

    const std::optional<Error> &problem() const { return m_problem; }

private:
    void note(const Result<void> &done)
    {
        if (!done)
            m_problem = done.error();
    }

    fs::path m_folder;
    std::size_t m_count = 1;
    std::size_t m_written = 0;
    const JobControl &m_control;
    std::optional<Error> m_problem;
};

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

} // namespace

Result<void> makeFolder(const std::string &folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (!error && fs::is_directory(folder, error))
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core", "The folder %1 cannot be made: %2."),
            {folder, error ? error.message() : "something else has this name"}});
}

Result<std::vector<std::string>> writeRunFiles(
    const RunFiles &run, const std::string &folder, const JobControl &control)
{
    const std::vector<CsvFile> tables = resultsCsv(run.outcome.results);
    const std::vector<ModelFile> model = modelFiles(run.outcome.results);
    const std::string json = resultsJson(run.outcome, run.recipe, run.createdUtc);
    if (!control.stopRequested())
        removeEarlierRun(folder);
    RunWriter writer(folder, tables.size() + model.size() + run.drawn.size() + 2, control);
    writer.write("recipe.json", recipeJson(run.recipe));
    for (const CsvFile &table : tables)
        writer.write("csv/" + table.name, table.text);
    for (const ModelFile &file : model)
        writer.write("model/" + file.name, file.bytes);
    for (const DrawnFile &file : run.drawn)
        writer.write(file.name, file.bytes);
    writer.write("results.json", json);
    if (writer.problem())
        return tl::unexpected<Error>(*writer.problem());
    return shownPaths(run, folder, !tables.empty(), !model.empty());
}

} // namespace dyncal
