// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_capture_writer.h"

#include "core/base/content_hash.h"
#include "core/base/version.h"
#include "core/base/writing/pending_file.h"
#include "core/capture/capture_seal.h"
#include "core/capture/formats/hdf5/hdf5_columns.h"
#include "core/capture/formats/hdf5/hdf5_content.h"
#include "core/capture/formats/hdf5/hdf5_create.h"
#include "core/capture/formats/hdf5/hdf5_handle.h"
#include "core/capture/formats/hdf5/hdf5_layout.h"
#include "core/capture/formats/hdf5/hdf5_open.h"
#include "core/capture/formats/hdf5/hdf5_samples.h"
#include "core/capture/formats/hdf5/hdf5_scribe.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <set>

namespace dyncal {
namespace {

/// A name that HDF5 accepts for a member, in full.
std::string memberName(std::string name)
{
    std::replace(name.begin(), name.end(), '/', '|');
    std::replace(name.begin(), name.end(), '\0', '|');
    return name.empty() || name == "." ? "unnamed" : name;
}

/// A name that HDF5 accepts for a member and that is not yet used in this group.
std::string linkName(const std::string &name, std::set<std::string> &used)
{
    const std::string link = memberName(name);
    std::string unique = link;
    for (int copy = 2; !used.insert(unique).second; ++copy)
        unique = link + " (" + std::to_string(copy) + ")";
    return unique;
}

/// The member that stands for each sensor, listed or not: "a/b" and "a|b" are two.
std::map<std::string, std::string> sensorLinks(const CaptureSet &set)
{
    std::set<std::string> used;
    std::map<std::string, std::string> links;
    for (const auto &[id, attributes] : set.sensors) // first, as writeCatalogue names them
        links.emplace(id, linkName(id, used));
    for (const Shot &shot : set.shots)
        for (const Channel &channel : shot.channels)
            if (!channel.sensorId.empty() && !links.contains(channel.sensorId))
                links.emplace(channel.sensorId, linkName(channel.sensorId, used));
    return links;
}

std::string paddedNumber(std::size_t number)
{
    const std::string digits = std::to_string(number);
    return std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
}

/// A dataset that was written, and the hash of what it must hold.
struct WrittenChannel
{
    std::string path;
    std::string sha256;
};

/// What a complete file must say.
struct Written
{
    std::vector<WrittenChannel> channels;
    std::string list; ///< contentList
};

/// Writes one capture into an open file; if any function returns false the file is incomplete.
class CaptureWriter
{
public:
    CaptureWriter(const CaptureSet &set, const JobControl &control)
        : m_set(set)
        , m_control(control)
        , m_sensorLinks(sensorLinks(set))
    {
        for (const Shot &shot : set.shots) {
            for (const Channel &channel : shot.channels) {
                m_totalSamples += channel.samples.size();
                m_channels.push_back({{}, sha256OfSamples(channel.samples)});
            }
        }
    }

    bool write(hid_t file, const std::string &createdUtc, const std::string &title,
        const std::vector<ShotTruth> &truth)
    {
        Hdf5Scribe root(file, m_said);
        return root.valid() && writeHead(root, createdUtc, title) && writeSetup(root)
            && writeShots(root) && (truth.empty() || writeTruth(root, truth)) && writeContent(root)
            && root.close();
    }

    Written written() const { return {m_channels, contentList(m_said)}; }

private:
    bool writeHead(Hdf5Scribe &root, const std::string &createdUtc, const std::string &title)
    {
        return root.text("format", kCaptureFormatName)
            && root.integers("format_version", {kCaptureMajorVersion, kCaptureMinorVersion})
            && root.text("creator", std::string("dyncal ") + versionText())
            && root.text("created_utc", createdUtc)
            && root.text("uuid", contentUuid(createdUtc, title)) && root.text("title", title)
            && root.text("default", "shots");
    }

    bool writeContent(Hdf5Scribe &root)
    {
        const std::string list = contentList(m_said);
        return root.text(kContentList, list) && root.text(kContentHash, sha256Hex(list));
    }

    /// Derived from the content (UUID version 8), so that equal captures have equal UUIDs.
    std::string contentUuid(const std::string &createdUtc, const std::string &title) const
    {
        std::string content = createdUtc + '\n' + title;
        for (const Shot &shot : m_set.shots) {
            content.append("\n").append(shot.label);
            for (const Channel &channel : shot.channels)
                content.append("\n").append(channel.name);
        }
        for (const WrittenChannel &channel : m_channels)
            content.append("\n").append(channel.sha256);
        std::string hex = sha256Hex(content);
        hex[12] = '8';
        hex[16] = 'a';
        return hex.substr(0, 8) + '-' + hex.substr(8, 4) + '-' + hex.substr(12, 4) + '-'
            + hex.substr(16, 4) + '-' + hex.substr(20, 12);
    }

    bool writeSetup(Hdf5Scribe &root)
    {
        Hdf5Scribe setup = root.group("setup");
        if (!setup.valid())
            return false;
        Hdf5Scribe tube = setup.group("tube");
        return tube.valid() && tube.attributes(m_set.tube) && tube.close()
            && writeCatalogue(setup, "sensors", m_set.sensors)
            && writeCatalogue(setup, "instruments", m_set.instruments) && setup.close();
    }

    static bool writeCatalogue(
        Hdf5Scribe &setup, const char *name, const std::map<std::string, Attributes> &entries)
    {
        Hdf5Scribe catalogue = setup.group(name);
        std::set<std::string> used;
        const bool written = catalogue.valid()
            && std::all_of(entries.begin(), entries.end(), [&](const auto &entry) {
                   Hdf5Scribe group = catalogue.group(linkName(entry.first, used));
                   return group.valid() && group.attributes(entry.second) && group.close();
               });
        return written && catalogue.close();
    }

    bool writeShots(Hdf5Scribe &root)
    {
        Hdf5Scribe shots = root.group("shots");
        if (!shots.valid())
            return false;
        for (std::size_t i = 0; i < m_set.shots.size(); ++i) {
            const std::string number = paddedNumber(i + 1);
            Hdf5Scribe group = shots.group(number);
            m_folder = "/shots/" + number + "/channels/";
            if (!group.valid() || !writeShot(group, m_set.shots[i]) || !group.close())
                return false;
        }
        return shots.close();
    }

    bool writeShot(Hdf5Scribe &group, const Shot &shot)
    {
        const bool described = group.text("label", shot.label)
            && group.text("level", shotLevelName(shot.level))
            && group.byte("valid", shot.included ? 1 : 0)
            && group.text("reject_reason", shot.excludeReason) && writeOrigin(group, shot)
            && group.attributes(ownNotes(shot)) && writeEnvironment(group, shot.environment);
        Hdf5Scribe channels = described ? group.group("channels") : Hdf5Scribe();
        if (!channels.valid())
            return false;
        std::set<std::string> used;
        return std::all_of(shot.channels.begin(), shot.channels.end(), [&](const Channel &channel) {
            return writeChannel(channels, channel, linkName(channel.name, used));
        }) && channels.close();
    }

    static Attributes ownNotes(const Shot &shot)
    {
        Attributes notes = shot.notes;
        std::erase_if(notes, [](const auto &note) { return isLayoutShotAttribute(note.first); });
        return notes;
    }

    bool writeOrigin(Hdf5Scribe &group, const Shot &shot)
    {
        if (shot.input < 0 || shot.input >= static_cast<Index>(m_set.inputs.size()))
            return true;
        const InputFile &input = m_set.inputs[static_cast<std::size_t>(shot.input)];
        return group.text("imported_from", input.file) && group.text("import_sha256", input.sha256);
    }

    static bool writeEnvironment(Hdf5Scribe &shot, const Environment &environment)
    {
        Hdf5Scribe group = shot.group("environment");
        return group.valid()
            && std::all_of(kEnvironmentEntries.begin(), kEnvironmentEntries.end(),
                [&](const EnvironmentEntry &entry) {
                    return group.number(entry.name, environment.*entry.value);
                })
            && group.close();
    }

    bool writeChannel(Hdf5Scribe &channels, const Channel &channel, const std::string &link)
    {
        m_channels[m_channel].path = m_folder + link;
        Hdf5Scribe dataset = channels.dataset(link, channel.samples);
        const bool written = dataset.valid() && writeSamples(dataset.id(), channel.samples)
            && (link == channel.name || dataset.text("name", channel.name))
            && writeChannelAttributes(dataset, channel) && dataset.close();
        ++m_channel;
        return written;
    }

    bool writeSamples(hid_t dataset, const RawSamples &samples)
    {
        const hid_t type = sampleTypes(samples.type()).memory;
        bool written = true;
        const auto writeBlock = [&](std::span<const std::byte> block, Index begin, Index count) {
            written = !m_control.stopRequested()
                && writeSampleBlock(
                    dataset, type, static_cast<hsize_t>(begin), block, static_cast<hsize_t>(count));
            m_doneSamples += count;
            m_control.report(
                static_cast<double>(m_doneSamples) / static_cast<double>(m_totalSamples));
        };
        for (Index begin = 0; written && begin < samples.size(); begin += RawSamples::kBlock) {
            const Index end = std::min(samples.size(), begin + RawSamples::kBlock);
            const bool read = samples.visitBlocks(begin, end, [&](auto values, Index first) {
                writeBlock(std::as_bytes(values), first, std::ssize(values));
            });
            written = written && read;
        }
        return written;
    }

    bool writeChannelAttributes(Hdf5Scribe &dataset, const Channel &channel)
    {
        return dataset.number("sample_rate_Hz", channel.sampleRate_Hz)
            && dataset.number("t0_s", channel.t0_s) && writeCalibration(dataset, channel)
            && dataset.text("unit", channel.unit) && dataset.text("quantity", channel.quantity)
            && dataset.text("role", channelRoleName(channel.role))
            && dataset.text("pressure_reference", pressureReferenceName(channel.reference))
            && dataset.text("sensor",
                channel.sensorId.empty()
                    ? ""
                    : std::string(kSensorFolder) + m_sensorLinks.at(channel.sensorId))
            && dataset.integer("adc_bits", channel.adcBits)
            && (!channel.adcMin || dataset.number("adc_min", *channel.adcMin))
            && (!channel.adcMax || dataset.number("adc_max", *channel.adcMax))
            && dataset.text("raw_sha256", m_channels[m_channel].sha256);
    }

    /// The layout has no polarity and no operator's factor, so both are multiplied into the
    /// coefficients and every reader gets the same physical values.
    static bool writeCalibration(Hdf5Scribe &dataset, const Channel &channel)
    {
        std::vector<double> coefficients = channel.polynomial;
        coefficients.resize(std::max<std::size_t>(coefficients.size(), 2), 0.0);
        for (double &coefficient : coefficients)
            coefficient *= channel.polarity * channel.userScale;
        if (coefficients.size() > 2)
            return dataset.numbers("poly", coefficients);
        return dataset.number("scale", coefficients[1])
            && dataset.number("offset", coefficients[0]);
    }

    static bool writeTruth(Hdf5Scribe &root, const std::vector<ShotTruth> &truth)
    {
        Hdf5Scribe group = root.group("truth");
        for (std::size_t i = 0; group.valid() && i < truth.size(); ++i) {
            Hdf5Scribe shot = group.group("shot_" + paddedNumber(i + 1));
            const bool written = shot.valid()
                && std::all_of(truth[i].begin(), truth[i].end(),
                    [&](const auto &entry) { return shot.number(entry.first, entry.second); });
            if (!written || !shot.close())
                return false;
        }
        return group.valid() && group.close();
    }

    const CaptureSet &m_set;
    const JobControl &m_control;
    std::map<std::string, std::string> m_sensorLinks;
    Hdf5Tree m_said;
    std::vector<WrittenChannel> m_channels; ///< of every shot, in order
    std::size_t m_channel = 0; ///< position of the channel being written
    std::string m_folder; ///< where the channels of the shot being written go
    Index m_totalSamples = 0;
    Index m_doneSamples = 0;
};

/// Reads back what has just been written, as any reader would: a full disk is not always reported
/// when it happens.
bool readsBack(const std::string &path, const Written &written)
{
    const std::vector<WrittenChannel> &channels = written.channels;
    const Result<Hdf5File> file = openHdf5(path, kUsualExpansion, {});
    return file && contentList(file->tree) == written.list
        && std::all_of(channels.begin(), channels.end(), [&](const WrittenChannel &channel) {
               const Hdf5Object *object = objectAt(file->tree, channel.path);
               if (object == nullptr || object->dataset.obstacle != Hdf5Obstacle::None)
                   return false;
               const auto samples
                   = hdf5Columns(*file, {{&object->dataset, object->address, channel.path, 0}}, {});
               return samples && sha256OfSamples(samples->front().front()) == channel.sha256;
           });
}

/// What was written; empty if anything went wrong.
std::optional<Written> writeFile(Hdf5Handle file, CaptureWriter writer,
    const std::string &createdUtc, const std::string &title, const std::vector<ShotTruth> &truth)
{
    const bool written = writer.write(file.id(), createdUtc, title, truth)
        && H5Fflush(file.id(), H5F_SCOPE_GLOBAL) >= 0;
    if (!file.close() || !written)
        return std::nullopt;
    return writer.written();
}

tl::unexpected<Error> notWritten(const std::string &path, const JobControl &control)
{
    if (control.stopRequested())
        return fail(ErrorKind::Cancelled,
            {DYNCAL_TEXT("core", "Writing %1 was cancelled; nothing was left behind."), {path}});
    return fail(ErrorKind::Internal,
        {DYNCAL_TEXT("core",
             "%1 could not be written completely and was not created; check the space on the disk and the free memory."),
            {path}});
}

} // namespace

Result<void> writeHdf5Capture(const CaptureSet &set, const CaptureTarget &target,
    const std::string &createdUtc, const std::string &title, const std::vector<ShotTruth> &truth,
    const JobControl &control)
{
    Result<PendingFile> pending = PendingFile::create(
        target.path, {target.replace ? Existing::Rule::Replaced : Existing::Rule::Refused});
    if (!pending)
        return tl::unexpected<Error>(pending.error());
    std::unique_lock lock(hdf5Mutex());
    silenceHdf5();
    Hdf5Handle file = createFile(pending->openPath());
    if (!file.valid())
        return notWritten(target.path, control);
    const auto written
        = writeFile(std::move(file), CaptureWriter(set, control), createdUtc, title, truth);
    lock.unlock();
    if (const Result<void> whole = checkStillWhole(set); !whole && !control.stopRequested())
        return whole;
    if (!written || !readsBack(pending->openPath(), *written))
        return notWritten(target.path, control);
    return pending->commit();
}

} // namespace dyncal
