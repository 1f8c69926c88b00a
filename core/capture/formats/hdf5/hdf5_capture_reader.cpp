// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_capture_reader.h"

#include "core/base/number_text.h"
#include "core/capture/formats/hdf5/hdf5_columns.h"
#include "core/capture/formats/hdf5/hdf5_content.h"
#include "core/capture/formats/hdf5/hdf5_layout.h"
#include "core/capture/formats/hdf5/hdf5_obstacle.h"
#include "core/capture/formats/hdf5/hdf5_open.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

/// NaN means not recorded.
std::optional<double> finiteNumber(const Hdf5Object &object, const std::string &name)
{
    const std::optional<double> value = numberAttribute(object, name);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

PressureReference referenceFromName(const std::string &name)
{
    for (const PressureReference reference :
        {PressureReference::Gauge, PressureReference::Absolute}) {
        if (name == pressureReferenceName(reference))
            return reference;
    }
    return PressureReference::Unknown;
}

/// A dataset of samples and the channel it becomes.
struct Place
{
    std::size_t shot;
    std::size_t channel;
};

/// Turns the description of a file into a capture. Links to other places are not followed: a
/// capture holds its own data.
class CaptureReader
{
public:
    CaptureReader(const Hdf5File &file, const JobControl &control)
        : m_file(file)
        , m_control(control)
    {
    }

    Result<CaptureSet> read()
    {
        if (const Result<void> head = checkHead(m_file.root()); !head)
            return tl::unexpected(head.error());
        checkWhatItSays();
        readSetup();
        if (const Result<void> shots = readShots(); !shots)
            return tl::unexpected(shots.error());
        if (const Result<void> samples = readSamples(); !samples)
            return tl::unexpected(samples.error());
        return std::move(m_set);
    }

private:
    tl::unexpected<Error> damaged(const char *text, std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), m_file.path);
        return fail(ErrorKind::FileUnreadable, {text, std::move(arguments)}, "CAP-018");
    }

    const Hdf5Object *target(const Hdf5Link &link) const
    {
        return link.target < 0 ? nullptr
                               : &m_file.tree.objects[static_cast<std::size_t>(link.target)];
    }

    const Hdf5Object *groupIn(const Hdf5Object &parent, const std::string &name) const
    {
        const Hdf5Object *member = memberOf(m_file.tree, parent, name);
        return member != nullptr && member->isDataset == 0 ? member : nullptr;
    }

    static bool holdsAll(const Hdf5Object &group)
    {
        return std::all_of(group.links.begin(), group.links.end(),
            [](const Hdf5Link &link) { return link.target != Hdf5Link::kElsewhere; });
    }

    /// Findings about changes come first: they concern the whole file.
    void checkWhatItSays()
    {
        for (Finding &finding : checkContent(m_file.tree, m_file.path))
            m_set.findings.push_back(std::move(finding));
    }

    Result<void> checkHead(const Hdf5Object &root)
    {
        if (textAttribute(root, "format") != kCaptureFormatName && statesContent(root.attributes))
            return damaged(
                DYNCAL_TEXT("core",
                    "%1 is damaged: it states the hashes of a capture, but its attribute format does not say that it is one; take an unchanged copy."),
                {});
        if (textAttribute(root, "format") != kCaptureFormatName)
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "%1 is an HDF5 file but no capture: its root lacks the attribute format = \"dyncal-capture\". Export the recording as LVM or CSV, or write it in the capture layout."),
                    {m_file.path}},
                "CAP-001");
        const std::vector<double> version = numbersAttribute(root, "format_version");
        if (version.empty() || version[0] != kCaptureMajorVersion)
            return damaged(
                DYNCAL_TEXT("core",
                    "%1 has capture layout version %2; this program reads version 1. Use a newer version of the program."),
                {version.empty() ? "?" : numberText(version[0])});
        if (version.size() > 1 && version[1] > kCaptureMinorVersion)
            m_set.findings.push_back({.id = "CAP-021",
                .severity = Severity::Info,
                .message
                = {DYNCAL_TEXT("core",
                       "%1 was written by a newer version (capture layout 1.%2); what this version does not know was left out."),
                    {m_file.path, numberText(version[1])}},
                .value = version[1],
                .limit = static_cast<double>(kCaptureMinorVersion)});
        return {};
    }

    void readSetup()
    {
        const Hdf5Object *setup = groupIn(m_file.root(), "setup");
        if (setup == nullptr)
            return;
        if (const Hdf5Object *tube = groupIn(*setup, "tube"))
            m_set.tube = attributeTexts(*tube);
        m_set.sensors = readCatalogue(*setup, "sensors");
        m_set.instruments = readCatalogue(*setup, "instruments");
    }

    std::map<std::string, Attributes> readCatalogue(
        const Hdf5Object &setup, const std::string &name) const
    {
        std::map<std::string, Attributes> entries;
        const Hdf5Object *catalogue = groupIn(setup, name);
        if (catalogue == nullptr)
            return entries;
        for (const Hdf5Link &link : catalogue->links) {
            const Hdf5Object *group = target(link);
            if (group != nullptr && group->isDataset == 0)
                entries[link.name] = attributeTexts(*group);
        }
        return entries;
    }

    Result<void> readShots()
    {
        const Hdf5Object *shots = groupIn(m_file.root(), "shots");
        if (shots == nullptr || shots->links.empty())
            return damaged(DYNCAL_TEXT("core",
                               "%1 holds no shots; a capture has at least one group in /shots."),
                {});
        for (const Hdf5Link &link : shots->links) {
            const Hdf5Object *group = target(link);
            if (group == nullptr || group->isDataset != 0)
                return damaged(
                    DYNCAL_TEXT("core",
                        "%1: shot %2 cannot be opened; the file is damaged, or its shots lie in other files."),
                    {link.name});
            if (const Result<void> shot = readShot(*group, link.name); !shot)
                return shot;
        }
        return {};
    }

    Result<void> readShot(const Hdf5Object &group, const std::string &number)
    {
        Shot &shot = m_set.shots.emplace_back();
        shot.label = textAttribute(group, "label").value_or(number);
        shot.level = shotLevelFromName(textAttribute(group, "level").value_or(""));
        shot.included = numberAttribute(group, "valid").value_or(1.0) != 0.0;
        shot.excludeReason = textAttribute(group, "reject_reason").value_or("");
        if (!shot.included && shot.excludeReason.empty())
            shot.excludeReason = "marked as not valid in the file";
        shot.notes = attributeTexts(group);
        std::erase_if(shot.notes, [](const auto &note) {
            return isLayoutShotAttribute(note.first) || note.second.empty();
        });
        shot.environment = readEnvironment(group);
        const Hdf5Object *channels = groupIn(group, "channels");
        if (channels == nullptr || channels->links.empty() || !holdsAll(*channels))
            return damaged(
                DYNCAL_TEXT("core",
                    "%1: shot %2 has no channels of its own; a shot holds its samples in its group channels."),
                {number});
        for (const Hdf5Link &link : channels->links) {
            Result<Channel> channel = readChannel(link, number);
            if (!channel)
                return tl::unexpected(channel.error());
            shot.channels.push_back(std::move(*channel));
        }
        return attributesThere(group, "shot " + number);
    }

    /// Fails if attributes were left out: nobody would notice a missing label or scale.
    Result<void> attributesThere(const Hdf5Object &object, const std::string &name) const
    {
        if (object.tooManyAttributes == 0)
            return {};
        return damaged(
            DYNCAL_TEXT("core",
                "%1: %2 has more than 1024 attributes, which no capture has; the file is damaged."),
            {name});
    }

    Environment readEnvironment(const Hdf5Object &shot) const
    {
        Environment environment;
        const Hdf5Object *group = groupIn(shot, "environment");
        for (const EnvironmentEntry &entry : kEnvironmentEntries) {
            const std::optional<double> value
                = group != nullptr ? numberAttribute(*group, entry.name) : std::nullopt;
            if (value)
                environment.*entry.value = *value;
        }
        return environment;
    }

    /// Everything of the channel but its samples, which are read for all channels together.
    Result<Channel> readChannel(const Hdf5Link &link, const std::string &shot)
    {
        const std::string place = link.name + " of shot " + shot;
        const Hdf5Object *object = target(link);
        if (object == nullptr || object->isDataset == 0)
            return damaged(
                DYNCAL_TEXT("core", "%1: channel %2 is no dataset of samples."), {place});
        Hdf5Dataset dataset = object->dataset;
        if (dataset.obstacle == Hdf5Obstacle::None && dataset.shape.size() != 1)
            dataset.obstacle = Hdf5Obstacle::Shape;
        if (dataset.obstacle != Hdf5Obstacle::None)
            return hdf5ObstacleError(m_file.path, place, dataset);
        m_wishes.push_back({&object->dataset, object->address, place, 0});
        m_places.push_back({m_set.shots.size() - 1, m_set.shots.back().channels.size()});
        Channel channel;
        channel.name = textAttribute(*object, "name").value_or(link.name);
        readChannelAttributes(*object, channel);
        const Result<void> scaled = readCalibration(*object, place, channel).and_then([&] {
            return attributesThere(*object, "channel " + place);
        });
        if (!scaled)
            return tl::unexpected(scaled.error());
        return channel;
    }

    void readChannelAttributes(const Hdf5Object &dataset, Channel &channel)
    {
        channel.sampleRate_Hz
            = std::max(finiteNumber(dataset, "sample_rate_Hz").value_or(0.0), 0.0);
        channel.t0_s = finiteNumber(dataset, "t0_s").value_or(0.0);
        channel.unit = textAttribute(dataset, "unit").value_or("");
        channel.quantity = textAttribute(dataset, "quantity").value_or("");
        channel.reference
            = referenceFromName(textAttribute(dataset, "pressure_reference").value_or(""));
        channel.adcBits = static_cast<int>(
            std::clamp(finiteNumber(dataset, "adc_bits").value_or(0.0), 0.0, 64.0));
        channel.adcMin = finiteNumber(dataset, "adc_min");
        channel.adcMax = finiteNumber(dataset, "adc_max");
        channel.sensorId = textAttribute(dataset, "sensor").value_or("");
        if (channel.sensorId.starts_with(kSensorFolder))
            channel.sensorId.erase(0, kSensorFolder.size());
        channel.role = channelRoleFromName(
            textAttribute(dataset, "role").value_or(sensorRole(channel.sensorId)));
        readStatedHash(dataset, channel);
    }

    /// The hash is of the samples in their recorded type.
    void readStatedHash(const Hdf5Object &dataset, Channel &channel)
    {
        const std::string stated = textAttribute(dataset, "raw_sha256").value_or("");
        if (dataset.dataset.fidelity == Hdf5Fidelity::Exact)
            channel.statedSha256 = stated;
        else if (!stated.empty())
            m_set.findings.push_back({.id = "CAP-015",
                .severity = Severity::Caution,
                .channel = channel.name,
                .message
                = {DYNCAL_TEXT("core",
                       "%1: the samples of channel %2 are stored in a type for which the SHA-256 in the file was not checked."),
                    {m_file.path, channel.name}}});
    }

    std::string sensorRole(const std::string &sensorId) const
    {
        const auto sensor = m_set.sensors.find(sensorId);
        if (sensor == m_set.sensors.end())
            return {};
        const auto role = sensor->second.find("role");
        return role != sensor->second.end() ? role->second : std::string();
    }

    Result<void> readCalibration(
        const Hdf5Object &dataset, const std::string &place, Channel &channel) const
    {
        bool isNumber = true;
        std::vector<double> coefficients = numbersAttribute(dataset, "poly");
        if (coefficients.empty()) {
            for (const char *name : {"poly", "offset", "scale"})
                isNumber = isNumber && !isNoNumber(dataset, name);
            coefficients = {numberAttribute(dataset, "offset").value_or(0.0),
                numberAttribute(dataset, "scale").value_or(1.0)};
        }
        for (const double coefficient : coefficients)
            isNumber = isNumber && std::isfinite(coefficient);
        if (!isNumber)
            return damaged(
                DYNCAL_TEXT("core",
                    "%1: scale, offset or poly of channel %2 is not a number; without it the counts have no unit."),
                {place});
        channel.polynomial = std::move(coefficients);
        return {};
    }

    Result<void> readSamples()
    {
        const auto columns = hdf5Columns(m_file, m_wishes, m_control);
        if (!columns)
            return tl::unexpected(columns.error());
        for (std::size_t i = 0; i < m_places.size(); ++i) {
            const Place &place = m_places[i];
            m_set.shots[place.shot].channels[place.channel].samples = (*columns)[i].front();
        }
        return {};
    }

    const Hdf5File &m_file;
    const JobControl &m_control;
    CaptureSet m_set;
    std::vector<Hdf5Wish> m_wishes;
    std::vector<Place> m_places; ///< of each wish
};

} // namespace

int recogniseHdf5Capture(const std::string &path, std::string_view head)
{
    if (!hasHdf5Signature(head))
        return 0;
    constexpr int kCertain = 100;
    if (head.find(kCaptureFormatName) != std::string_view::npos)
        return kCertain;
    const Hdf5Attributes root = hdf5RootAttributes(path); // it may lie anywhere in the file
    const auto format = root.find("format");
    const bool isNamed = format != root.end() && format->second.text == kCaptureFormatName;
    return isNamed || statesContent(root) ? kCertain : 0;
}

Result<CaptureSet> readHdf5Capture(
    const std::string &path, const ImportSettings &settings, const JobControl &control)
{
    const Result<Hdf5File> file = openHdf5(path, settings.maxExpansion, control);
    if (!file)
        return tl::unexpected(file.error());
    return readHdf5Capture(*file, control);
}

Result<CaptureSet> readHdf5Capture(const Hdf5File &file, const JobControl &control)
{
    return CaptureReader(file, control).read();
}

} // namespace dyncal
