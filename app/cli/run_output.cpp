// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/run_output.h"

#include "core/base/atomic_file.h"
#include "core/pipeline/results_csv.h"
#include "core/pipeline/results_json.h"
#include "ui/report/report_output.h"

#include <QApplication>
#include <QHashSeed>
#include <QLocale>

#include <array>
#include <filesystem>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

/// Qt's remarks about its platform are no answer to the operator.
void ignoreMessage(QtMsgType, const QMessageLogContext &, const QString &) { }

/// Drawing needs an application object but no display, and must come out the same on every
/// machine: no display scaling, no locale, no random order of hashes.
Result<std::vector<std::string>> drawReport(const CalibrationResults &results, const Recipe &recipe,
    const std::string &createdUtc, const std::string &folder)
{
    if (QCoreApplication::instance()) { // the workbench exports: its language must not show
        const QLocale shown;
        QLocale::setDefault(QLocale::c());
        auto drawn = writeReport(results, recipe, createdUtc, folder);
        QLocale::setDefault(shown);
        return drawn;
    }
    for (const char *name : {"QT_SCALE_FACTOR", "QT_SCREEN_SCALE_FACTORS", "QT_FONT_DPI",
             "QT_STYLE_OVERRIDE", "QT_QPA_PLATFORMTHEME"})
        qunsetenv(name);
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qInstallMessageHandler(ignoreMessage);
    QHashSeed::setDeterministicGlobalSeed();
    QLocale::setDefault(QLocale::c());
    int argc = 1;
    std::array<char, 7> name{"dyncal"};
    std::array<char *, 2> argv{name.data(), nullptr};
    const QApplication application(argc, argv.data());
    return writeReport(results, recipe, createdUtc, folder);
}

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
    removeFilesIn(folder / "csv", ".csv");
    removeFilesIn(folder / "plots", ".svg");
}

/// Whether there was anything to write.
Result<bool> writeCsv(const CalibrationResults &results, const fs::path &folder)
{
    const std::vector<CsvFile> files = resultsCsv(results);
    if (files.empty())
        return false;
    if (const Result<void> made = makeFolder(folder.string()); !made)
        return tl::unexpected<Error>(made.error());
    for (const CsvFile &file : files) {
        const Result<void> written = writeFileAtomically((folder / file.name).string(), file.text);
        if (!written)
            return tl::unexpected<Error>(written.error());
    }
    return true;
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

Result<std::vector<std::string>> writeRun(const PipelineOutcome &outcome, const Recipe &recipe,
    const std::string &createdUtc, const std::string &folder)
{
    const fs::path root(folder);
    removeEarlierRun(root);
    const std::string recipePath = (root / "recipe.json").string();
    const std::string resultsPath = (root / "results.json").string();
    std::vector<std::string> paths{resultsPath, recipePath};
    if (const auto written = writeFileAtomically(recipePath, recipeJson(recipe)); !written)
        return tl::unexpected<Error>(written.error());
    const Result<bool> tables = writeCsv(outcome.results, root / "csv");
    if (!tables)
        return tl::unexpected<Error>(tables.error());
    if (!outcome.error) {
        const auto drawn = drawReport(outcome.results, recipe, createdUtc, folder);
        if (!drawn)
            return drawn;
        paths.insert(paths.end(), drawn->begin(), drawn->end());
    }
    const std::string json = resultsJson(outcome, recipe, createdUtc);
    if (const auto written = writeFileAtomically(resultsPath, json); !written)
        return tl::unexpected<Error>(written.error());
    if (*tables)
        paths.push_back((root / "csv" / "").string());
    return paths;
}

} // namespace dyncal
