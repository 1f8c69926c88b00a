// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/delimited_text.h"

#include "core/base/ascii_text.h"
#include "core/capture/file_kind.h"
#include "core/capture/formats/text/shot_columns.h"
#include "core/capture/formats/text/table_import.h"
#include "core/capture/formats/text/text_bytes.h"
#include "core/capture/formats/text/text_dialect.h"
#include "core/capture/formats/text/text_source.h"
#include "core/capture/formats/text/text_table.h"
#include "core/capture/formats/text/time_words.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace dyncal {
namespace {

/// More than dialectOf() needs, unless cells can be read in two ways.
constexpr std::uint64_t kHeadBytes = 1 << 20;

/// What each column becomes: a role, or nothing if it is not wanted.
std::vector<std::optional<ChannelRole>> rolesOf(
    const ImportSettings &settings, Index columns, std::optional<Index> timeColumn)
{
    const bool onlyNamed = std::any_of(settings.columns.begin(), settings.columns.end(),
        [](const auto &entry) { return entry.first != "time"; });
    std::vector<std::optional<ChannelRole>> roles(static_cast<std::size_t>(columns));
    if (!onlyNamed)
        std::fill(roles.begin(), roles.end(), ChannelRole::Other);
    for (const auto &[role, column] : settings.columns)
        roles[static_cast<std::size_t>(column)] = channelRoleFromName(role);
    if (timeColumn)
        roles[static_cast<std::size_t>(*timeColumn)].reset();
    return roles;
}

std::string stemOf(const std::string &path)
{
    return std::filesystem::path(path).stem().string();
}

/// Takes the samples of column i.
Channel channelOf(ImportedTable &table, std::size_t i, ChannelRole role)
{
    Channel channel;
    channel.name = table.titles[i].name;
    channel.role = role;
    channel.unit = table.titles[i].unit.empty() ? "1" : table.titles[i].unit;
    channel.samples = RawSamples(std::move(table.columns[i]));
    channel.sampleRate_Hz = table.time.sampleRate_Hz;
    channel.t0_s = table.time.first_s;
    return channel;
}

Shot shotOf(const std::string &path, const ImportSettings &settings, ImportedTable &table)
{
    Shot shot;
    shot.label = stemOf(path);
    const auto columns = static_cast<Index>(table.columns.size());
    const auto roles = rolesOf(settings, columns, table.time.column);
    for (std::size_t i = 0; i < roles.size(); ++i)
        if (roles[i])
            shot.channels.push_back(channelOf(table, i, *roles[i]));
    return shot;
}

/// One shot for each of these columns. The channel has the same name in all of them, so that what
/// is said of the sensor is said once.
std::vector<Shot> shotsOf(
    const std::string &path, const std::vector<Index> &shotOfColumn, ImportedTable &table)
{
    std::vector<Shot> shots;
    for (std::size_t i = 0; i < shotOfColumn.size(); ++i) {
        if (shotOfColumn[i] == 0)
            continue;
        Shot shot;
        shot.label = stemOf(path) + ", " + table.titles[i].name;
        shot.channels.push_back(channelOf(table, i, ChannelRole::Dut));
        shot.channels.front().name = kShotColumnChannel;
        shots.push_back(std::move(shot));
    }
    return shots;
}

/// The shots with at least one column of samples.
std::vector<Shot> shotsOf(
    const std::string &path, const ImportSettings &settings, ImportedTable &table)
{
    if (areColumnsShots(settings))
        return shotsOf(path,
            shotsOfColumns(settings, static_cast<Index>(table.columns.size()), table.time.column),
            table);
    Shot shot = shotOf(path, settings, table);
    return shot.channels.empty() ? std::vector<Shot>() : std::vector<Shot>{std::move(shot)};
}

} // namespace

int recogniseDelimitedText(const std::string &path, std::string_view head)
{
    constexpr std::array<std::string_view, 6> kExtensions{
        ".csv", ".tsv", ".txt", ".dat", ".asc", ".prn"};
    const std::string text = textOfBytes(std::string(head));
    if (!isPlainText(text) || !dialectOf(text, {}))
        return 0;
    const std::string extension = lowerCase(std::filesystem::path(path).extension().string());
    const bool known
        = std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
    return known ? 60 : 40;
}

Result<CaptureSet> readDelimitedText(
    const std::string &path, const ImportSettings &settings, const JobControl &control)
{
    const Result<TextSource> text = openText(path);
    if (!text)
        return tl::unexpected(text.error());
    std::vector<char> buffer;
    std::optional<std::string_view> head
        = text->read(0, std::min(text->size(), kHeadBytes), buffer);
    std::optional<TextDialect> dialect = head ? dialectOf(*head, settings) : std::nullopt;
    if (dialect && !dialect->ambiguous.empty()) { // only the whole text can resolve it
        head = text->read(0, text->size(), buffer);
        dialect = head ? dialectOf(*head, settings) : std::nullopt;
    }
    if (!dialect)
        return noRowsOfNumbers(path);
    Result<ImportedTable> table
        = importTable({path, *head, true, &*text}, *dialect, settings, control);
    if (!table)
        return tl::unexpected(table.error());
    CaptureSet set;
    set.findings = std::move(table->findings);
    set.shots = shotsOf(path, settings, *table);
    if (set.shots.empty())
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core", "%1 has a column of times but no column of samples."), {path}},
            "CAP-018");
    return set;
}

} // namespace dyncal
