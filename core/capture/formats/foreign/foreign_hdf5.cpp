// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/foreign/foreign_hdf5.h"

#include "core/base/number_text.h"
#include "core/capture/formats/foreign/foreign_rate.h"
#include "core/capture/formats/hdf5/hdf5_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <set>

namespace dyncal {
namespace {

/// Names of the attributes in physical = scale * stored + offset, by convention.
struct ScaleNames
{
    const char *scale;
    const char *offset;
};
constexpr std::array<ScaleNames, 3> kScaleNames{
    {{"scale_factor", "add_offset"}, {"scale", "offset"}, {"YInc", "YOrg"}}};

bool states(const Hdf5Object &object, const ScaleNames &names)
{
    return object.attributes.contains(names.scale) || object.attributes.contains(names.offset);
}

/// Makes a channel from the attributes of one dataset.
class ChannelMaker
{
public:
    ChannelMaker(const std::string &path, const ForeignDataset &dataset, Findings &findings)
        : m_path(path)
        , m_dataset(dataset)
        , m_findings(findings)
    {
    }

    /// Everything but name, samples and timing.
    Result<Channel> make() const
    {
        Channel channel;
        channel.unit = unit();
        channel.quantity = textAttribute(*m_dataset.object, "long_name").value_or("");
        Result<std::vector<double>> scale = polynomial();
        if (!scale)
            return tl::unexpected(scale.error());
        channel.polynomial = std::move(*scale);
        warnOfFillValue();
        return channel;
    }

private:
    /// Keysight scopes describe the samples in the attributes of their group.
    const Hdf5Object *scopeGroup() const
    {
        const Hdf5Object *group = m_dataset.groups.front();
        const bool scope
            = group->attributes.contains("XInc") && group->attributes.contains("YUnits");
        return scope ? group : nullptr;
    }

    std::string unit() const
    {
        for (const char *name : {"units", "unit", "Units", "Unit", "unit_string"}) {
            const std::string text = textAttribute(*m_dataset.object, name).value_or("");
            if (!text.empty())
                return text;
        }
        const Hdf5Object *scope = scopeGroup();
        const std::string text
            = scope != nullptr ? textAttribute(*scope, "YUnits").value_or("") : std::string();
        return text == "Volt" ? "V" : text.empty() ? "1" : text;
    }

    Result<std::vector<double>> polynomial() const
    {
        std::vector<std::vector<double>> stated;
        for (const ScaleNames &names : kScaleNames) {
            const Hdf5Object *object = m_dataset.object;
            const bool scopeNames = std::string_view(names.scale) == "YInc";
            if (scopeNames)
                object = m_dataset.object->dataset.type < SampleType::Float32
                        || m_dataset.object->dataset.type > SampleType::Float64
                    ? scopeGroup()
                    : nullptr; // floating point samples of a scope are volts already
            if (object == nullptr || !states(*object, names))
                continue;
            if (isNoNumber(*object, names.scale) || isNoNumber(*object, names.offset))
                return notNumber();
            stated.push_back({numberAttribute(*object, names.offset).value_or(0.0),
                numberAttribute(*object, names.scale).value_or(1.0)});
            if (!std::isfinite(stated.back()[0]) || !std::isfinite(stated.back()[1]))
                return notNumber();
        }
        if (stated.empty())
            return std::vector<double>{0.0, 1.0};
        if (stated.size() > 1 && stated[0] != stated[1])
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "%1: %2 states scale and offset in two ways that differ; correct the attributes."),
                    {m_path, m_dataset.path}},
                "CAP-018");
        return stated.front();
    }

    tl::unexpected<Error> notNumber() const
    {
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1: scale, offset or poly of channel %2 is not a number; without it the counts have no unit."),
                {m_path, m_dataset.path}},
            "CAP-018");
    }

    void warnOfFillValue() const
    {
        for (const char *name : {"_FillValue", "missing_value"}) {
            const std::string value = textAttribute(*m_dataset.object, name).value_or("nan");
            if (value == "nan")
                continue;
            m_findings.push_back({.id = "CAP-006",
                .severity = Severity::Caution,
                .channel = m_dataset.path,
                .message
                = {DYNCAL_TEXT("core",
                       "%1: %2 marks missing samples by the value %3; such samples are read as they are, so look whether there are any."),
                    {m_path, m_dataset.path, value}}});
            return;
        }
    }

    const std::string &m_path;
    const ForeignDataset &m_dataset;
    Findings &m_findings;
};

/// The length to read when nothing is named: the longest that two datasets share, else the longest.
Index lengthToRead(const std::vector<const ChannelCandidate *> &candidates)
{
    std::map<Index, int> counts;
    for (const ChannelCandidate *candidate : candidates)
        ++counts[candidate->channels.samples];
    const auto shared = std::find_if(
        counts.rbegin(), counts.rend(), [](const auto &entry) { return entry.second > 1; });
    return shared != counts.rend() ? shared->first : counts.rbegin()->first;
}

std::vector<ChannelCandidate> named(
    std::vector<ChannelCandidate> candidates, const ImportSettings &settings)
{
    std::vector<ChannelCandidate> chosen;
    for (ChannelCandidate &candidate : candidates) {
        std::erase_if(candidate.columns, [&](std::size_t column) {
            return !settings.channels.contains(candidate.channels.names[column]);
        });
        if (!candidate.columns.empty())
            chosen.push_back(std::move(candidate));
    }
    return chosen;
}

/// Whether there are numbers that cannot be read: the file is at fault, not the kind of data.
bool isDamaged(const ChannelCandidate &candidate)
{
    switch (candidate.dataset.object->dataset.obstacle) {
    case Hdf5Obstacle::None:
    case Hdf5Obstacle::NotNumbers:
    case Hdf5Obstacle::Shape:
        return candidate.dataset.object->tooManyAttributes != 0;
    default:
        return true;
    }
}

/// Whether the settings name this dataset, which has no channels.
bool isNamed(const ChannelCandidate &candidate, const ImportSettings &settings)
{
    return std::any_of(settings.channels.begin(), settings.channels.end(), [&](const auto &entry) {
        const std::string &name = entry.first;
        const std::string wanted = name.substr(0, name.find_first_of("[("));
        return wanted == candidate.dataset.path || wanted == candidate.dataset.name;
    });
}

/// Fails with the first dataset that is wanted and cannot be read.
Result<void> checkWanted(
    const std::vector<ChannelCandidate> &candidates, const ImportSettings &settings)
{
    const auto usable = [](const ChannelCandidate &c) { return !c.channels.names.empty(); };
    const bool any = std::any_of(candidates.begin(), candidates.end(), usable);
    const auto missing
        = std::find_if(candidates.begin(), candidates.end(), [&](const ChannelCandidate &c) {
              return !usable(c) && (isNamed(c, settings) || (!any && isDamaged(c)));
          });
    if (missing == candidates.end())
        return {};
    return fail(ErrorKind::FileUnreadable, missing->channels.whyNot, "CAP-018");
}

Findings damagedDatasets(const std::vector<ChannelCandidate> &candidates)
{
    constexpr std::size_t kMost = 8; // of one kind are enough
    Findings findings;
    for (const ChannelCandidate &candidate : candidates) {
        if (candidate.channels.names.empty() && isDamaged(candidate) && findings.size() < kMost)
            findings.push_back({.id = "CAP-018",
                .severity = Severity::Caution,
                .channel = candidate.dataset.path,
                .message = candidate.channels.whyNot});
    }
    return findings;
}

tl::unexpected<Error> nothingToRead(const std::string &path,
    const std::vector<ChannelCandidate> &candidates, const ImportSettings &settings)
{
    std::string names;
    for (const ChannelCandidate &candidate : candidates) {
        for (const std::string &name : candidate.channels.names)
            names.append(names.empty() ? "" : ", ").append(name);
    }
    if (names.empty())
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 is an HDF5 file without a dataset of samples (one-dimensional numbers, or a table of at most 64 columns)."),
                {path}},
            "CAP-001");
    if (settings.channels.empty())
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 holds times, but no samples that belong to them (%2); if one of these is a record, name it in import.channels."),
                {path, names}},
            "CAP-001");
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core", "%1 has none of the datasets that import.channels names; it has %2."),
            {path, names}});
}

/// The channels to read: those named, or else what is most likely the record.
std::vector<ChannelCandidate> chosenOf(const std::vector<ChannelCandidate> &candidates,
    const ImportSettings &settings, const TimingFinder &timing)
{
    if (!settings.channels.empty())
        return named(candidates, settings);
    const auto isRecord
        = [](const ChannelCandidate &candidate) { return candidate.channels.names.size() == 1; };
    const bool records = std::any_of(candidates.begin(), candidates.end(), isRecord);
    std::vector<const ChannelCandidate *> eligible;
    for (const ChannelCandidate &candidate : candidates) {
        if (!candidate.channels.names.empty() && (isRecord(candidate) || !records))
            eligible.push_back(&candidate);
    }
    if (eligible.empty())
        return {};
    const Index length = lengthToRead(eligible);
    std::erase_if(eligible,
        [&](const ChannelCandidate *candidate) { return candidate->channels.samples != length; });
    std::vector<ChannelCandidate> chosen;
    for (const ChannelCandidate *candidate : eligible) {
        if (eligible.size() == 1 || !timing.isTimes(candidate->dataset))
            chosen.push_back(*candidate);
    }
    return chosen;
}

Findings leftOut(const std::string &path, const std::vector<ChannelCandidate> &candidates,
    const std::vector<ChannelCandidate> &chosen, const TimingFinder &timing)
{
    std::set<std::string> taken;
    for (const ChannelCandidate &dataset : chosen)
        taken.insert(dataset.dataset.path);
    std::string names;
    for (const ChannelCandidate &candidate : candidates) {
        if (!candidate.channels.names.empty() && !taken.contains(candidate.dataset.path)
            && !timing.isTimes(candidate.dataset))
            names.append(names.empty() ? "" : ", ").append(candidate.dataset.path);
    }
    if (names.empty())
        return {};
    return {{.id = "CAP-026",
        .severity = Severity::Info,
        .message
        = {DYNCAL_TEXT("core",
               "%1: %2 is of another length or kind than the channels and was left out; name the channels to have it."),
            {path, names}}}};
}

/// Channels of the chosen datasets, described and with their samples.
Result<CaptureSet> shotOf(const Hdf5File &file, const std::vector<ChannelCandidate> &chosen,
    const TimingFinder &timing, const JobControl &control)
{
    std::vector<Hdf5Wish> wishes;
    for (const ChannelCandidate &choice : chosen)
        wishes.push_back({&choice.dataset.object->dataset, choice.dataset.object->address,
            choice.dataset.path, choice.channels.sampleAxis});
    const auto columns = hdf5Columns(file, wishes, control);
    if (!columns)
        return tl::unexpected(columns.error());
    CaptureSet set;
    Shot &shot = set.shots.emplace_back();
    shot.label = std::filesystem::path(file.path).stem().string();
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const ChannelCandidate &choice = chosen[i];
        Result<Channel> channel = ChannelMaker(file.path, choice.dataset, set.findings).make();
        if (!channel)
            return tl::unexpected(channel.error());
        const SampleTiming found
            = timing.timingOf(choice.dataset, choice.channels.samples, set.findings);
        channel->sampleRate_Hz = found.rate_Hz;
        channel->t0_s = found.t0_s;
        for (const std::size_t column : choice.columns) {
            channel->name = choice.channels.names[column];
            channel->samples = (*columns)[i][column];
            shot.channels.push_back(*channel);
        }
    }
    return set;
}

} // namespace

ChannelCandidate candidateOf(ForeignDataset dataset, ForeignChannels channels)
{
    std::vector<std::size_t> columns(channels.names.size());
    std::iota(columns.begin(), columns.end(), std::size_t(0));
    return {std::move(dataset), std::move(channels), std::move(columns)};
}

Result<CaptureSet> readCandidates(const Hdf5File &file, const std::vector<ForeignDataset> &all,
    const std::vector<ChannelCandidate> &candidates, const ImportSettings &settings,
    const JobControl &control)
{
    const Result<TimingFinder> timing = TimingFinder::make(file, all, control);
    if (!timing)
        return tl::unexpected(timing.error());
    if (const Result<void> wanted = checkWanted(candidates, settings); !wanted)
        return tl::unexpected(wanted.error());
    const std::vector<ChannelCandidate> chosen = chosenOf(candidates, settings, *timing);
    if (chosen.empty())
        return nothingToRead(file.path, candidates, settings);
    Result<CaptureSet> set = shotOf(file, chosen, *timing, control);
    if (set && settings.channels.empty()) {
        for (const Findings &more :
            {leftOut(file.path, candidates, chosen, *timing), damagedDatasets(candidates)})
            set->findings.insert(set->findings.end(), more.begin(), more.end());
    }
    return set;
}

int recogniseForeignHdf5(const std::string &, std::string_view head)
{
    constexpr int kProbably = 60;
    return hasHdf5Signature(head) ? kProbably : 0;
}

Result<CaptureSet> readForeignHdf5(
    const std::string &path, const ImportSettings &settings, const JobControl &control)
{
    const Result<Hdf5File> file = openHdf5(path, settings.maxExpansion, control);
    if (!file)
        return tl::unexpected(file.error());
    return readForeignHdf5(*file, settings, control);
}

Result<CaptureSet> readForeignHdf5(
    const Hdf5File &file, const ImportSettings &settings, const JobControl &control)
{
    const std::vector<ForeignDataset> all = datasetsOf(file.tree);
    std::vector<ChannelCandidate> candidates;
    for (const ForeignDataset &dataset : all)
        candidates.push_back(candidateOf(dataset, channelsOf(dataset, file.path)));
    Result<CaptureSet> set = readCandidates(file, all, candidates, settings, control);
    const Index lost = linksNotFollowed(file.tree);
    if (set && lost > 0)
        set->findings.push_back({.id = "CAP-026",
            .severity = Severity::Info,
            .message
            = {DYNCAL_TEXT("core",
                   "%1: %2 links that lead to other files or places, or cannot be opened, were not followed."),
                {file.path, std::to_string(lost)}},
            .value = static_cast<double>(lost)});
    return set;
}

} // namespace dyncal
