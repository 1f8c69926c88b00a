// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/file_import.h"

#include <filesystem>

namespace dyncal {

namespace {

std::string baseName(const std::string &path)
{
    return std::filesystem::path(path).filename().string();
}

/// The value of the file where it differs from that of all files.
template <typename T>
std::optional<T> ownValue(const T &all, const T &own)
{
    return own == all ? std::nullopt : std::optional<T>(own);
}

std::string ownWord(const std::string &all, const std::string &own)
{
    return own == all ? std::string() : own;
}

template <typename Map>
Map ownEntries(const Map &all, const Map &own)
{
    Map entries;
    for (const auto &[name, value] : own) {
        const auto known = all.find(name);
        if (known == all.end() || !(known->second == value))
            entries.emplace(name, value);
    }
    return entries;
}

} // namespace

ImportSettings withOwnSettings(
    const ImportSettings &settings, const std::string &path, const ImportSettings &wanted)
{
    FileImport own;
    own.format = ownValue(settings.format, wanted.format);
    own.columns = wanted.columns == settings.columns ? own.columns : wanted.columns;
    own.columnsAre = ownWord(settings.columnsAre, wanted.columnsAre);
    own.channels = ownEntries(settings.channels, wanted.channels);
    own.channelDetails = ownEntries(settings.channelDetails, wanted.channelDetails);
    own.decimal = ownWord(settings.decimal, wanted.decimal);
    own.separator = ownWord(settings.separator, wanted.separator);
    if (wanted.sampleRate_Hz != settings.sampleRate_Hz)
        own.sampleRate_Hz = wanted.sampleRate_Hz;
    own.sampleRateReason = ownWord(settings.sampleRateReason, wanted.sampleRateReason);
    if (wanted.unit != settings.unit)
        own.unit = wanted.unit;
    own.scale = ownValue(settings.scale, wanted.scale);
    own.polarity = ownValue(settings.polarity, wanted.polarity);
    own.reference = ownWord(settings.reference, wanted.reference);
    if (wanted.skipRows != settings.skipRows)
        own.skipRows = wanted.skipRows;
    own.interpolateInvalid = ownValue(settings.interpolateInvalid, wanted.interpolateInvalid);
    own.maxExpansion = ownValue(settings.maxExpansion, wanted.maxExpansion);
    ImportSettings next = settings;
    next.files.erase(baseName(path));
    if (!(own == FileImport{}))
        next.files[baseName(path)] = own;
    return next;
}

ImportSettings withSettingsForAll(
    const ImportSettings &settings, const std::string &path, const ImportSettings &wanted)
{
    ImportSettings next = wanted;
    next.levels = settings.levels;
    next.exclude = settings.exclude;
    next.shots = settings.shots;
    next.files = settings.files;
    next.files.erase(baseName(path));
    return next;
}

} // namespace dyncal
