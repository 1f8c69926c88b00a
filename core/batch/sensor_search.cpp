// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/sensor_search.h"

#include "core/base/text_encoding.h"
#include "core/capture/natural_order.h"
#include "core/capture/opening/folder_files.h"
#include "core/capture/opening/format_registry.h"

#include <algorithm>
#include <filesystem>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kOwnRecipe = "recipe.json";
constexpr std::string_view kRecipeOfFile = ".recipe.json";

bool isRecording(const std::string &path)
{
    return formatOf(path, ImportSettings()).has_value();
}

Message noRecording()
{
    return {
        DYNCAL_TEXT("core",
            "The folder holds files but no recording; readable are: %1. Put recordings there, or move it out of what is planned."),
        {readableFormatsText()}};
}

Message isLink()
{
    return {
        DYNCAL_TEXT("core",
            "This is a link to a folder, which is not followed; plan the folder that it leads to."),
        {}};
}

Message isInRoot()
{
    return {
        DYNCAL_TEXT("core",
            "Recordings lie directly in the folder that is planned and belong to no sensor; put them into a folder of their own, or give --each-file."),
        {}};
}

Message badName()
{
    return {
        DYNCAL_TEXT("core", "The name is no valid UTF-8, so no plan can hold it; rename it."), {}};
}

/// Walks through the folders and collects what it finds.
class SensorSearcher
{
public:
    explicit SensorSearcher(const SensorSearch &search)
        : m_search(search)
    {
        for (const std::string &path : search.settings)
            m_settings.push_back(fs::weakly_canonical(path, m_ignored));
    }

    Result<std::vector<FoundSensor>> search()
    {
        if (const auto listed = filesOfFolder(m_search.root); !listed)
            return tl::unexpected<Error>(listed.error());
        addFolder(m_search.root);
        for (fs::recursive_directory_iterator entry(m_search.root, m_options, m_ignored), end;
             entry != end; entry.increment(m_ignored))
            visit(entry);
        std::ranges::sort(m_found, naturalLess, &FoundSensor::id);
        return std::move(m_found);
    }

private:
    void visit(fs::recursive_directory_iterator &entry)
    {
        if (!entry->is_directory(m_ignored))
            return;
        if (entry->path().filename().string().starts_with('.'))
            entry.disable_recursion_pending();
        else if (entry->is_symlink(m_ignored))
            add({{}, entry->path().string(), {}, {}, isLink()});
        else
            addFolder(entry->path().string());
    }

    void addFolder(const std::string &folder)
    {
        const Result<std::vector<std::string>> listed = filesOfFolder(folder);
        if (!listed)
            return add({{}, folder, {}, {}, listed.error().message});
        const bool hasOther = std::ranges::any_of(
            *listed, [this](const std::string &file) { return !isSetting(file); });
        if (hasOther && m_search.eachFile)
            addFiles(*listed);
        else if (hasOther)
            addSensor(folder, *listed);
    }

    void addFiles(const std::vector<std::string> &files)
    {
        for (const std::string &file : files)
            if (!isSetting(file) && isRecording(file))
                add({{}, file, {file},
                    existing(fs::path(file).replace_extension("").string()
                        + std::string(kRecipeOfFile))});
    }

    void addSensor(const std::string &folder, const std::vector<std::string> &files)
    {
        const bool isAny = std::ranges::any_of(files,
            [this](const std::string &file) { return !isSetting(file) && isRecording(file); });
        const bool isRoot = folder == m_search.root;
        if (isRoot && !isAny)
            return; // what else lies there is nobody's
        FoundSensor sensor{{}, folder, files, existing((fs::path(folder) / kOwnRecipe).string())};
        if (!isAny || isRoot)
            sensor.obstacle = isAny ? isInRoot() : noRecording();
        add(std::move(sensor));
    }

    void add(FoundSensor sensor)
    {
        sensor.id = fs::path(sensor.source).lexically_relative(m_search.root).generic_string();
        const bool isNamed = isUtf8(sensor.source)
            && std::ranges::all_of(sensor.files, [](const std::string &f) { return isUtf8(f); });
        if (!isNamed) {
            sensor.id = utf8Text(sensor.id);
            sensor.source = utf8Text(sensor.source);
            sensor.obstacle = badName();
        }
        m_found.push_back(std::move(sensor));
    }

    bool isSetting(const std::string &file) const
    {
        const std::string name = fs::path(file).filename().string();
        std::error_code unknown;
        return name == kOwnRecipe || name.ends_with(kRecipeOfFile)
            || std::ranges::find(m_settings, fs::weakly_canonical(file, unknown))
            != m_settings.end();
    }

    static std::string existing(const std::string &path)
    {
        std::error_code unknown;
        return fs::exists(path, unknown) ? path : std::string();
    }

    const fs::directory_options m_options = fs::directory_options::skip_permission_denied;
    const SensorSearch &m_search;
    std::vector<fs::path> m_settings;
    std::vector<FoundSensor> m_found;
    std::error_code m_ignored; // what cannot be listed is found again by its own folder
};

} // namespace

Result<std::vector<FoundSensor>> findSensors(const SensorSearch &search)
{
    return SensorSearcher(search).search();
}

} // namespace dyncal
