// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5_capture.h"

#include "core/base/content_hash.h"
#include "core/base/durable_file.h"
#include "core/base/version.h"
#include "core/capture/formats/hdf5_attributes.h"
#include "core/capture/formats/hdf5_create.h"
#include "core/capture/formats/hdf5_handle.h"
#include "core/capture/formats/hdf5_layout.h"
#include "core/capture/formats/hdf5_open.h"
#include "core/capture/formats/hdf5_samples.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>

namespace dyncal {
namespace {

/// A name that HDF5 takes for a member.
std::string memberName(std::string name)
{
    std::replace(name.begin(), name.end(), '/', '|');
    return name.empty() || name == "." ? "unnamed" : name;
}

/// A name that HDF5 takes for a member and that is not used yet in this group.
std::string linkName(const std::string &name, std::set<std::string> &used)
{
    const std::string link = memberName(name);
    std::string unique = link;
    for (int copy = 2; !used.insert(unique).second; ++copy)
        unique = link + " (" + std::to_string(copy) + ")";
    return unique;
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

/// Writes one capture into an open file; any false means that the file is not complete.
class CaptureWriter
{
public:
    CaptureWriter(const CaptureSet &set, const JobControl &control)
        : m_set(set)
        , m_control(control)
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
        return writeHead(file, createdUtc, title) && writeSetup(file) && writeShots(file)
            && (truth.empty() || writeTruth(file, truth));
    }

    const std::vector<WrittenChannel> &channels() const { return m_channels; }

private:
    bool writeHead(hid_t file, const std::string &createdUtc, const std::string &title)
    {
        return writeTextAttribute(file, "format", kCaptureFormatName)
            && writeIntegersAttribute(
                file, "format_version", {kCaptureMajorVersion, kCaptureMinorVersion})
            && writeTextAttribute(file, "creator", std::string("dyncal ") + versionText())
            && writeTextAttribute(file, "created_utc", createdUtc)
            && writeTextAttribute(file, "uuid", contentUuid(createdUtc, title))
            && writeTextAttribute(file, "title", title)
            && writeTextAttribute(file, "default", "shots");
    }

    /// Derived from the content (UUID version 8), so that the same capture has the same one.
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

    bool writeSetup(hid_t file)
    {
        Hdf5Handle setup = createGroup(file, "setup");
        if (!setup.valid())
            return false;
        Hdf5Handle tube = createGroup(setup.id(), "tube");
        return tube.valid() && writeAttributes(tube.id(), m_set.tube) && tube.close()
            && writeCatalogue(setup.id(), "sensors", m_set.sensors)
            && writeCatalogue(setup.id(), "instruments", m_set.instruments) && setup.close();
    }

    static bool writeCatalogue(
        hid_t setup, const char *name, const std::map<std::string, Attributes> &entries)
    {
        Hdf5Handle catalogue = createGroup(setup, name);
        std::set<std::string> used;
        const bool written = catalogue.valid()
            && std::all_of(entries.begin(), entries.end(), [&](const auto &entry) {
                   Hdf5Handle group = createGroup(catalogue.id(), linkName(entry.first, used));
                   return group.valid() && writeAttributes(group.id(), entry.second)
                       && group.close();
               });
        return written && catalogue.close();
    }

    bool writeShots(hid_t file)
    {
        Hdf5Handle shots = createGroup(file, "shots");
        if (!shots.valid())
            return false;
        for (std::size_t i = 0; i < m_set.shots.size(); ++i) {
            const std::string number = paddedNumber(i + 1);
            Hdf5Handle group = createGroup(shots.id(), number);
            m_folder = "/shots/" + number + "/channels/";
            if (!group.valid() || !writeShot(group.id(), m_set.shots[i]) || !group.close())
                return false;
        }
        return shots.close();
    }

    bool writeShot(hid_t group, const Shot &shot)
    {
        const bool described = writeTextAttribute(group, "label", shot.label)
            && writeTextAttribute(group, "level", shotLevelName(shot.level))
            && writeByteAttribute(group, "valid", shot.included ? 1 : 0)
            && writeTextAttribute(group, "reject_reason", shot.excludeReason)
            && writeOrigin(group, shot) && writeAttributes(group, ownNotes(shot))
            && writeEnvironment(group, shot.environment);
        Hdf5Handle channels = described ? createGroup(group, "channels") : Hdf5Handle();
        if (!channels.valid())
            return false;
        std::set<std::string> used;
        return std::all_of(shot.channels.begin(), shot.channels.end(), [&](const Channel &channel) {
            return writeChannel(channels.id(), channel, linkName(channel.name, used));
        }) && channels.close();
    }

    static Attributes ownNotes(const Shot &shot)
    {
        Attributes notes = shot.notes;
        std::erase_if(notes, [](const auto &note) { return isLayoutShotAttribute(note.first); });
        return notes;
    }

    bool writeOrigin(hid_t group, const Shot &shot)
    {
        if (shot.input < 0 || shot.input >= static_cast<Index>(m_set.inputs.size()))
            return true;
        const InputFile &input = m_set.inputs[static_cast<std::size_t>(shot.input)];
        return writeTextAttribute(group, "imported_from", input.file)
            && writeTextAttribute(group, "import_sha256", input.sha256);
    }

    static bool writeEnvironment(hid_t shot, const Environment &environment)
    {
        Hdf5Handle group = createGroup(shot, "environment");
        return group.valid()
            && std::all_of(kEnvironmentEntries.begin(), kEnvironmentEntries.end(),
                [&](const EnvironmentEntry &entry) {
                    return writeNumberAttribute(group.id(), entry.name, environment.*entry.value);
                })
            && group.close();
    }

    bool writeChannel(hid_t group, const Channel &channel, const std::string &link)
    {
        m_channels[m_channel].path = m_folder + link;
        Hdf5Handle dataset = createSampleDataset(group, link, channel.samples);
        const bool written = dataset.valid() && writeSamples(dataset.id(), channel.samples)
            && (link == channel.name || writeTextAttribute(dataset.id(), "name", channel.name))
            && writeChannelAttributes(dataset.id(), channel) && dataset.close();
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

    bool writeChannelAttributes(hid_t dataset, const Channel &channel)
    {
        return writeNumberAttribute(dataset, "sample_rate_Hz", channel.sampleRate_Hz)
            && writeNumberAttribute(dataset, "t0_s", channel.t0_s)
            && writeCalibration(dataset, channel)
            && writeTextAttribute(dataset, "unit", channel.unit)
            && writeTextAttribute(dataset, "quantity", channel.quantity)
            && writeTextAttribute(dataset, "role", channelRoleName(channel.role))
            && writeTextAttribute(
                dataset, "pressure_reference", pressureReferenceName(channel.reference))
            && writeTextAttribute(dataset, "sensor",
                channel.sensorId.empty()
                    ? ""
                    : std::string(kSensorFolder) + memberName(channel.sensorId))
            && writeIntegerAttribute(dataset, "adc_bits", channel.adcBits)
            && (!channel.adcMin || writeNumberAttribute(dataset, "adc_min", *channel.adcMin))
            && (!channel.adcMax || writeNumberAttribute(dataset, "adc_max", *channel.adcMax))
            && writeTextAttribute(dataset, "raw_sha256", m_channels[m_channel].sha256);
    }

    /// The layout has no polarity and no operator's factor: they go into the coefficients, so that
    /// every reader gets the same physical values.
    static bool writeCalibration(hid_t dataset, const Channel &channel)
    {
        std::vector<double> coefficients = channel.polynomial;
        coefficients.resize(std::max<std::size_t>(coefficients.size(), 2), 0.0);
        for (double &coefficient : coefficients)
            coefficient *= channel.polarity * channel.userScale;
        if (coefficients.size() > 2)
            return writeNumbersAttribute(dataset, "poly", coefficients);
        return writeNumberAttribute(dataset, "scale", coefficients[1])
            && writeNumberAttribute(dataset, "offset", coefficients[0]);
    }

    static bool writeTruth(hid_t file, const std::vector<ShotTruth> &truth)
    {
        Hdf5Handle group = createGroup(file, "truth");
        for (std::size_t i = 0; group.valid() && i < truth.size(); ++i) {
            Hdf5Handle shot = createGroup(group.id(), "shot_" + paddedNumber(i + 1));
            const bool written = shot.valid()
                && std::all_of(truth[i].begin(), truth[i].end(), [&](const auto &entry) {
                       return writeNumberAttribute(shot.id(), entry.first, entry.second);
                   });
            if (!written || !shot.close())
                return false;
        }
        return group.valid() && group.close();
    }

    const CaptureSet &m_set;
    const JobControl &m_control;
    std::vector<WrittenChannel> m_channels; ///< of every shot, in order
    std::size_t m_channel = 0; ///< position of the channel being written
    std::string m_folder; ///< where the channels of the shot being written go
    Index m_totalSamples = 0;
    Index m_doneSamples = 0;
};

/// Reads back what has just been written, as any reader would: a full disk is not always reported
/// when it happens.
bool readsBack(const std::string &path, const std::vector<WrittenChannel> &channels)
{
    const Result<Hdf5File> file = openHdf5(path, {});
    return file
        && std::all_of(channels.begin(), channels.end(), [&](const WrittenChannel &channel) {
               const Hdf5Object *object = objectAt(file->tree, channel.path);
               if (object == nullptr || object->dataset.obstacle != Hdf5Obstacle::None)
                   return false;
               const auto samples
                   = hdf5Columns(*file, {{&object->dataset, object->address, channel.path, 0}}, {});
               return samples && sha256OfSamples(samples->front().front()) == channel.sha256;
           });
}

/// The channels written; empty if anything went wrong.
std::optional<std::vector<WrittenChannel>> writeFile(Hdf5Handle file, CaptureWriter writer,
    const std::string &createdUtc, const std::string &title, const std::vector<ShotTruth> &truth)
{
    const bool written = writer.write(file.id(), createdUtc, title, truth)
        && H5Fflush(file.id(), H5F_SCOPE_GLOBAL) >= 0;
    if (!file.close() || !written)
        return std::nullopt;
    return writer.channels();
}

/// Invalid if it cannot be created; then nothing is left behind.
Hdf5Handle createTemporary(const std::string &path)
{
    std::error_code error;
    const bool isNew = !std::filesystem::exists(path, error); // else maybe another writer's
    Hdf5Handle file = createFile(path);
    if (!file.valid() && isNew)
        std::filesystem::remove(path, error);
    return file;
}

} // namespace

Result<void> writeHdf5Capture(const CaptureSet &set, const std::string &path,
    const std::string &createdUtc, const std::string &title, const std::vector<ShotTruth> &truth,
    const JobControl &control)
{
    std::error_code error;
    if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core", "%1 is not a regular file; give the name of a capture file."),
                {path}});
    // A fixed name: what a killed run left behind is overwritten, not collected.
    const std::string temporary = path + ".part";
    std::unique_lock lock(hdf5Mutex());
    silenceHdf5();
    Hdf5Handle file = createTemporary(temporary);
    if (!file.valid())
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT(
                 "core", "Cannot create %1; check that the folder exists and may be written to."),
                {path}});
    const auto written
        = writeFile(std::move(file), CaptureWriter(set, control), createdUtc, title, truth);
    lock.unlock();
    if (written && readsBack(temporary, *written) && moveIntoPlace(temporary, path))
        return {};
    std::filesystem::remove(temporary, error);
    if (control.stopRequested())
        return fail(ErrorKind::Cancelled,
            {DYNCAL_TEXT("core", "Writing %1 was cancelled; nothing was left behind."), {path}});
    return fail(ErrorKind::Internal,
        {DYNCAL_TEXT("core",
             "%1 could not be written completely and was not created; check the space on the "
             "disk."),
            {path}});
}

} // namespace dyncal
