// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/recheck/earlier_run.h"

#include "core/base/ascii_text.h"
#include "core/base/content_hash.h"
#include "core/base/file_descriptor.h"
#include "core/base/json_text.h"
#include "core/base/writing/file_identity.h"
#include "core/base/writing/written_list.h"
#include "core/capture/natural_order.h"
#include "core/reference/reference_source.h"
#include "core/results/results_reading.h"

#include <fcntl.h>

#include <algorithm>
#include <filesystem>

namespace dyncal {
namespace {

namespace fs = std::filesystem;
using RunJson = nlohmann::json;

constexpr std::size_t kLargestResults = std::size_t(256) << 20U;
constexpr std::size_t kMostKeysNamed = 8;

std::optional<std::string> fileIn(const std::string &folder, const std::string &name)
{
    const FileDescriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    return opened.valid() ? textAt(opened.get(), name, kLargestResults) : std::nullopt;
}

std::string pathIn(const std::string &folder, const char *name)
{
    return (fs::path(folder) / name).string();
}

/// Where a results.json is.
struct ResultsPlace
{
    std::string folder;
    std::string name;

    std::string path() const { return pathIn(folder, name.c_str()); }
};

ResultsPlace placeOf(const std::string &path)
{
    std::error_code unknown;
    if (fs::is_directory(path, unknown))
        return {path, kResultsFile};
    const std::string folder = fs::path(path).parent_path().string();
    return {folder.empty() ? "." : folder, fs::path(path).filename().string()};
}

Result<std::string> resultsText(const ResultsPlace &place)
{
    if (std::optional<std::string> text = fileIn(place.folder, place.name))
        return std::move(*text);
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 cannot be read, or is larger than 256 MiB; check that it is the file of a run and that you may read it."),
            {place.path()}});
}

/// Empty, or what is wrong with results.json by the list of the run.
std::vector<Message> ofWrittenList(const ResultsPlace &place, const std::string &sha256)
{
    const auto file = fileIn(place.folder, kWrittenList);
    const auto list = file ? parseWrittenList(*file) : std::nullopt;
    const WrittenFile *entry = list ? listed(*list, place.name) : nullptr;
    if (!entry || entry->sha256 == sha256)
        return {};
    return {
        {DYNCAL_TEXT("core",
             "results.json is not the file that the run wrote (written.json lists another hash); what is compared is what it says now."),
            {}}};
}

/// Empty, or that recipe.json is another recipe than the one of the results.
std::vector<Message> ofRecipeFile(const std::string &folder, const RunJson &stated)
{
    const auto file = fileIn(folder, "recipe.json");
    if (!file || RunJson::parse(*file, nullptr, false) == stated)
        return {};
    return {
        {DYNCAL_TEXT("core",
             "recipe.json is not the recipe that the results were made with; the one that results.json holds is used."),
            {}}};
}

/// Dotted paths of the keys of `whole` that `stated` lacks.
void collectMissing(const RunJson &whole, const RunJson &stated, const std::string &path,
    std::vector<std::string> &missing)
{
    for (const auto &[key, value] : whole.items()) {
        std::string here = path;
        here.append(path.empty() ? "" : ".").append(key);
        if (!stated.contains(key))
            missing.push_back(here);
        else if (value.is_object() && stated[key].is_object())
            collectMissing(value, stated[key], here, missing);
    }
}

/// Empty, or which keys are newer than the recipe.
std::vector<Message> ofNewerKeys(const Recipe &recipe, const RunJson &stated)
{
    std::vector<std::string> missing;
    collectMissing(RunJson::parse(recipeJson(recipe)), stated, {}, missing);
    if (missing.empty())
        return {};
    return {{DYNCAL_TEXT("core",
                 "The recipe is from before %1 of today's keys, for which the defaults count: %2."),
        {std::to_string(missing.size()), commaList(missing, kMostKeysNamed)}}};
}

tl::unexpected<Error> withoutTable(
    const std::string &folder, const std::string &source, const std::string &sha256)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "The file %1 (SHA-256 %2) that the recipe of the results in %3 names is not there as it was, and no copy of it is in sources/; put it where the recipe says, seen from that folder."),
            {source, sha256, folder}});
}

/// The file that a section names: the copy that the run kept, else the one where the recipe says;
/// only that of the stated hash is the run's.
template <typename Settings>
Result<void> loadOfRun(const std::string &folder, Settings &settings)
{
    if (settings.source.empty())
        return {};
    settings.loaded = sourceAt(folder, keptSourceName(settings.source, settings.sha256));
    if (!settings.loaded || settings.loaded->sha256 != settings.sha256)
        loadSource(folder, settings);
    if (!settings.loaded || settings.loaded->sha256 != settings.sha256)
        return withoutTable(folder, settings.source, settings.sha256);
    return {};
}

Result<void> loadTables(const std::string &folder, Recipe &recipe)
{
    return loadOfRun(folder, recipe.chain).and_then([&]() -> Result<void> {
        return recipe.comparison.enabled ? loadOfRun(folder, recipe.comparison) : Result<void>();
    });
}

/// The recipe of the results, with the tables it names.
Result<Recipe> recipeOfRun(const std::string &folder, const RunJson &stated)
{
    Result<Recipe> recipe = parseRecipe(jsonText(stated));
    if (!recipe)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core", "The recipe that %1 holds cannot be used: %2"),
                {pathIn(folder, kResultsFile), english(recipe.error().message)}});
    if (const Result<void> loaded = loadTables(folder, *recipe); !loaded)
        return tl::unexpected<Error>(loaded.error());
    return recipe;
}

Result<std::vector<RecordedInput>> recordedInputs(const RunJson &results, const std::string &name)
{
    std::vector<RecordedInput> inputs;
    for (const RunJson &one : valueAt(results, "inputs")) {
        inputs.push_back({textAt(one, "file"), textAt(one, "sha256")});
        if (!isSha256Hex(inputs.back().sha256))
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core",
                     "%1 states no SHA-256 of its recording %2, so that cannot be known again; repeat the run from the recording."),
                    {name, inputs.back().file}});
    }
    if (inputs.empty())
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "%1 names no recordings (inputs), so there is nothing to compute it again from."),
                {name}});
    return inputs;
}

template <typename Value>
void append(std::vector<Value> &list, std::vector<Value> more)
{
    list.insert(list.end(), more.begin(), more.end());
}

bool holdsResults(const fs::path &folder)
{
    std::error_code unknown;
    return fs::is_regular_file(folder / kResultsFile, unknown);
}

/// The given folder and all below that hold results.
std::vector<std::string> foundFolders(const std::string &folder)
{
    std::vector<std::string> found;
    std::error_code ignored; // what cannot be listed holds nothing that could be read
    if (holdsResults(folder))
        found.push_back(folder);
    for (fs::recursive_directory_iterator
             entry(folder, fs::directory_options::skip_permission_denied, ignored),
         end;
         entry != end; entry.increment(ignored)) {
        if (!entry->is_directory(ignored) || entry->is_symlink(ignored))
            continue;
        if (entry->path().filename().string().starts_with('.'))
            entry.disable_recursion_pending();
        else if (holdsResults(entry->path()))
            found.push_back(entry->path().string());
    }
    return found;
}

} // namespace

Result<std::vector<std::string>> runFoldersBelow(const std::string &folder)
{
    std::error_code unknown;
    if (!fs::is_directory(folder, unknown))
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 is no folder; give the folder that dyncal run or dyncal batch wrote, or one above it."),
                {folder}});
    std::vector<std::string> found = foundFolders(folder);
    if (found.empty())
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "There is no results.json in %1 nor below it; give the folder that dyncal run or dyncal batch wrote, or one above it."),
                {folder}});
    std::ranges::sort(found, naturalLess);
    return found;
}

static Result<EarlierResults> readAt(const ResultsPlace &place)
{
    const Result<std::string> text = resultsText(place);
    if (!text)
        return tl::unexpected<Error>(text.error());
    Result<RunJson> results = parseResults(*text, place.path());
    if (!results)
        return tl::unexpected<Error>(results.error());
    std::string sha256 = sha256Hex(*text);
    std::vector<Message> remarks = ofWrittenList(place, sha256);
    return EarlierResults{place.path(), std::move(*results), std::move(sha256), std::move(remarks)};
}

Result<EarlierResults> readEarlierResults(const std::string &path)
{
    return readAt(placeOf(path));
}

Result<EarlierRun> readEarlierRun(const std::string &folder)
{
    Result<EarlierResults> read = readAt({folder, kResultsFile});
    if (!read)
        return tl::unexpected<Error>(read.error());
    const RunJson &stated = valueAt(read->results, "recipe");
    Result<Recipe> recipe = recipeOfRun(folder, stated);
    if (!recipe)
        return tl::unexpected<Error>(recipe.error());
    Result<std::vector<RecordedInput>> inputs = recordedInputs(read->results, read->file);
    if (!inputs)
        return tl::unexpected<Error>(inputs.error());
    append(read->remarks, ofRecipeFile(folder, stated));
    append(read->remarks, ofNewerKeys(*recipe, stated));
    return EarlierRun{folder, std::move(read->results), std::move(*recipe), std::move(*inputs),
        std::move(read->remarks)};
}

} // namespace dyncal
