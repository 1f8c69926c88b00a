// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/import_settings.h"

#include <algorithm>
#include <filesystem>

namespace dyncal {
namespace {

template <typename T>
void replace(T &value, const std::optional<T> &own)
{
    if (own)
        value = *own;
}

template <typename T>
void replace(std::optional<T> &value, const std::optional<T> &own)
{
    if (own)
        value = own;
}

void replace(std::string &value, const std::string &own)
{
    if (!own.empty())
        value = own;
}

} // namespace

ImportSettings settingsOfFile(const ImportSettings &settings, const std::string &path)
{
    ImportSettings merged = settings;
    const auto found = settings.files.find(std::filesystem::path(path).filename().string());
    if (found == settings.files.end())
        return merged;
    const FileImport &own = found->second;
    replace(merged.format, own.format);
    if (!own.columns.empty())
        merged.columns = own.columns;
    replace(merged.columnsAre, own.columnsAre);
    for (const auto &[name, role] : own.channels)
        merged.channels[name] = role;
    for (const auto &[name, details] : own.channelDetails)
        merged.channelDetails[name] = details;
    replace(merged.decimal, own.decimal);
    replace(merged.separator, own.separator);
    replace(merged.sampleRate_Hz, own.sampleRate_Hz);
    replace(merged.sampleRateReason, own.sampleRateReason);
    replace(merged.unit, own.unit);
    replace(merged.scale, own.scale);
    replace(merged.polarity, own.polarity);
    replace(merged.reference, own.reference);
    replace(merged.skipRows, own.skipRows);
    replace(merged.interpolateInvalid, own.interpolateInvalid);
    replace(merged.maxExpansion, own.maxExpansion);
    return merged;
}

const std::map<std::string, std::string> *rolesOfShot(const ImportSettings &settings, Index shot)
{
    const auto found = std::ranges::find(settings.shots, shot, &ShotImport::shot);
    return found == settings.shots.end() ? nullptr : &found->channels;
}

} // namespace dyncal
