// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5_capture.h"

#include "core/base/content_hash.h"
#include "core/base/number_text.h"
#include "core/capture/formats/guarded_run.h"
#include "core/capture/formats/hdf5_attributes.h"
#include "core/capture/formats/hdf5_handle.h"
#include "core/capture/formats/hdf5_layout.h"
#include "core/capture/formats/hdf5_samples.h"
#include "core/capture/natural_order.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <system_error>

namespace dyncal {
namespace {

constexpr std::string_view kSignature("\x89HDF\r\n\x1a\n", 8);

struct Members
{
    std::vector<std::string> names;
    bool complete = true; ///< false if a member is a link to somewhere else
};

herr_t collectMember(hid_t, const char *name, const H5L_info_t *info, void *data)
{
    Members &members = *static_cast<Members *>(data);
    if (info->type == H5L_TYPE_HARD)
        members.names.emplace_back(name);
    else
        members.complete = false;
    return 0;
}

/// Members of a group: as they were added where the file knows, otherwise in natural order. Links
/// to other places are not followed; a capture holds its data itself.
Members membersOf(hid_t group)
{
    Members members;
    const Hdf5Handle creation(H5Gget_create_plist(group), &H5Pclose);
    unsigned int order = 0;
    const bool tracked = creation.valid() && H5Pget_link_creation_order(creation.id(), &order) >= 0
        && (order & H5P_CRT_ORDER_TRACKED) != 0;
    const H5_index_t index = tracked ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
    if (H5Literate(group, index, H5_ITER_INC, nullptr, &collectMember, &members) < 0)
        members.complete = false;
    if (!tracked)
        std::sort(members.names.begin(), members.names.end(), &naturalLess);
    return members;
}

bool hasMember(hid_t group, const char *name)
{
    return H5Lexists(group, name, H5P_DEFAULT) > 0;
}

Hdf5Handle openGroup(hid_t parent, const char *name)
{
    if (!hasMember(parent, name))
        return {};
    return {H5Gopen2(parent, name, H5P_DEFAULT), &H5Gclose};
}

/// NaN means not recorded.
std::optional<double> finiteNumber(hid_t object, const char *name)
{
    const std::optional<double> value = readNumberAttribute(object, name);
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

class CaptureReader
{
public:
    CaptureReader(
        const std::string &path, hsize_t fileBytes, SampleUse use, const JobControl &control)
        : m_path(path)
        , m_budgetBytes(fileBytes)
        , m_use(use)
        , m_control(control)
    {
    }

    Result<CaptureSet> read(hid_t file)
    {
        if (const Result<void> head = checkHead(file); !head)
            return tl::unexpected(head.error());
        readSetup(file);
        if (const Result<void> shots = readShots(file); !shots)
            return tl::unexpected(shots.error());
        return std::move(m_set);
    }

private:
    tl::unexpected<Error> damaged(const char *text, std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), m_path);
        return fail(ErrorKind::FileUnreadable, {text, std::move(arguments)}, "CAP-018");
    }

    Result<void> checkHead(hid_t file)
    {
        if (readTextAttribute(file, "format") != kCaptureFormatName)
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "%1 is an HDF5 file but no capture: its root lacks the attribute format = "
                     "\"dyncal-capture\". Export the recording as LVM or CSV, or write it in the "
                     "capture layout."),
                    {m_path}},
                "CAP-001");
        const std::vector<double> version = readNumbersAttribute(file, "format_version");
        if (version.empty() || version[0] != kCaptureMajorVersion)
            return damaged(
                DYNCAL_TEXT("core",
                    "%1 has capture layout version %2; this program reads version 1. Use a newer "
                    "version of the program."),
                {version.empty() ? "?" : numberText(version[0])});
        if (version.size() > 1 && version[1] > kCaptureMinorVersion)
            m_set.findings.push_back({"CAP-021", Severity::Info, 0, {}, {},
                {DYNCAL_TEXT("core",
                     "%1 was written by a newer version (capture layout 1.%2); what this version "
                     "does not know was left out."),
                    {m_path, numberText(version[1])}},
                version[1], static_cast<double>(kCaptureMinorVersion)});
        return {};
    }

    void readSetup(hid_t file)
    {
        const Hdf5Handle setup = openGroup(file, "setup");
        if (!setup.valid())
            return;
        if (const Hdf5Handle tube = openGroup(setup.id(), "tube"); tube.valid())
            m_set.tube = readAttributes(tube.id());
        m_set.sensors = readCatalogue(setup.id(), "sensors");
        m_set.instruments = readCatalogue(setup.id(), "instruments");
    }

    static std::map<std::string, Attributes> readCatalogue(hid_t setup, const char *name)
    {
        std::map<std::string, Attributes> entries;
        const Hdf5Handle catalogue = openGroup(setup, name);
        if (!catalogue.valid())
            return entries;
        for (const std::string &member : membersOf(catalogue.id()).names) {
            const Hdf5Handle group = openGroup(catalogue.id(), member.c_str());
            if (group.valid())
                entries[member] = readAttributes(group.id());
        }
        return entries;
    }

    Result<void> readShots(hid_t file)
    {
        const Hdf5Handle shots = openGroup(file, "shots");
        const Members members = shots.valid() ? membersOf(shots.id()) : Members();
        if (members.names.empty())
            return damaged(DYNCAL_TEXT("core",
                               "%1 holds no shots; a capture has at least one group in /shots."),
                {});
        for (std::size_t i = 0; i < members.names.size(); ++i) {
            const Hdf5Handle group = openGroup(shots.id(), members.names[i].c_str());
            if (!group.valid() || !members.complete)
                return damaged(
                    DYNCAL_TEXT("core",
                        "%1: shot %2 cannot be opened; the file is damaged, or its shots "
                        "lie in other files."),
                    {members.names[i]});
            if (const Result<void> shot = readShot(group.id(), members.names[i]); !shot)
                return shot;
            m_control.report(
                static_cast<double>(i + 1) / static_cast<double>(members.names.size()));
        }
        return {};
    }

    Result<void> readShot(hid_t group, const std::string &number)
    {
        Shot shot;
        shot.label = readTextAttribute(group, "label").value_or(number);
        shot.level = shotLevelFromName(readTextAttribute(group, "level").value_or(""));
        shot.included = readNumberAttribute(group, "valid").value_or(1.0) != 0.0;
        shot.excludeReason = readTextAttribute(group, "reject_reason").value_or("");
        if (!shot.included && shot.excludeReason.empty())
            shot.excludeReason = "marked as not valid in the file";
        shot.notes = readAttributes(group);
        std::erase_if(shot.notes, [](const auto &note) {
            return isLayoutShotAttribute(note.first) || note.second.empty();
        });
        shot.environment = readEnvironment(group);
        const Hdf5Handle channels = openGroup(group, "channels");
        const Members members = channels.valid() ? membersOf(channels.id()) : Members();
        if (members.names.empty() || !members.complete)
            return damaged(
                DYNCAL_TEXT("core",
                    "%1: shot %2 has no channels of its own; a shot holds its samples in "
                    "its group channels."),
                {number});
        for (const std::string &name : members.names) {
            Result<Channel> channel = readChannel(channels.id(), name, number);
            if (!channel)
                return tl::unexpected(channel.error());
            shot.channels.push_back(std::move(*channel));
        }
        m_set.shots.push_back(std::move(shot));
        return {};
    }

    static Environment readEnvironment(hid_t shot)
    {
        Environment environment;
        const Hdf5Handle group = openGroup(shot, "environment");
        for (const EnvironmentEntry &entry : kEnvironmentEntries) {
            const std::optional<double> value
                = group.valid() ? readNumberAttribute(group.id(), entry.name) : std::nullopt;
            if (value)
                environment.*entry.value = *value;
        }
        return environment;
    }

    Result<Channel> readChannel(hid_t group, const std::string &link, const std::string &shot)
    {
        const std::string place = link + " of shot " + shot;
        const Hdf5Handle dataset(H5Dopen2(group, link.c_str(), H5P_DEFAULT), &H5Dclose);
        if (!dataset.valid())
            return damaged(
                DYNCAL_TEXT("core", "%1: channel %2 is no dataset of samples."), {place});
        const Result<StoredSamples> stored
            = readSampleDataset(dataset.id(), m_path, place, m_budgetBytes, m_use, m_control);
        if (!stored)
            return tl::unexpected(stored.error());
        Channel channel;
        channel.name = readTextAttribute(dataset.id(), "name").value_or(link);
        channel.samples = stored->samples;
        channel.sha256 = sha256OfSamples(channel.samples);
        readChannelAttributes(dataset.id(), channel);
        if (const Result<void> scaled = readCalibration(dataset.id(), place, channel); !scaled)
            return tl::unexpected(scaled.error());
        if (const Result<void> same = checkHash(dataset.id(), place, channel, stored->exactType);
            !same)
            return tl::unexpected(same.error());
        return channel;
    }

    void readChannelAttributes(hid_t dataset, Channel &channel) const
    {
        channel.sampleRate_Hz
            = std::max(finiteNumber(dataset, "sample_rate_Hz").value_or(0.0), 0.0);
        channel.t0_s = finiteNumber(dataset, "t0_s").value_or(0.0);
        channel.unit = readTextAttribute(dataset, "unit").value_or("");
        channel.quantity = readTextAttribute(dataset, "quantity").value_or("");
        channel.reference
            = referenceFromName(readTextAttribute(dataset, "pressure_reference").value_or(""));
        channel.adcBits = static_cast<int>(
            std::clamp(finiteNumber(dataset, "adc_bits").value_or(0.0), 0.0, 64.0));
        channel.adcMin = finiteNumber(dataset, "adc_min");
        channel.adcMax = finiteNumber(dataset, "adc_max");
        channel.sensorId = readTextAttribute(dataset, "sensor").value_or("");
        if (channel.sensorId.starts_with(kSensorFolder))
            channel.sensorId.erase(0, kSensorFolder.size());
        channel.role = channelRoleFromName(
            readTextAttribute(dataset, "role").value_or(sensorRole(channel.sensorId)));
    }

    std::string sensorRole(const std::string &sensorId) const
    {
        const auto sensor = m_set.sensors.find(sensorId);
        if (sensor == m_set.sensors.end())
            return {};
        const auto role = sensor->second.find("role");
        return role != sensor->second.end() ? role->second : std::string();
    }

    Result<void> readCalibration(hid_t dataset, const std::string &place, Channel &channel) const
    {
        std::vector<double> coefficients = readNumbersAttribute(dataset, "poly");
        if (coefficients.empty())
            coefficients = {readNumberAttribute(dataset, "offset").value_or(0.0),
                readNumberAttribute(dataset, "scale").value_or(1.0)};
        for (const double coefficient : coefficients) {
            if (!std::isfinite(coefficient))
                return damaged(
                    DYNCAL_TEXT("core",
                        "%1: scale, offset or poly of channel %2 is not a number; without it the "
                        "counts have no unit."),
                    {place});
        }
        channel.polynomial = std::move(coefficients);
        return {};
    }

    Result<void> checkHash(
        hid_t dataset, const std::string &place, const Channel &channel, bool exactType)
    {
        const std::string expected = readTextAttribute(dataset, "raw_sha256").value_or("");
        if (expected.empty() || expected == channel.sha256 || m_use == SampleUse::Rehearse)
            return {};
        if (exactType)
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "%1: the samples of channel %2 are not those that were recorded (their "
                     "SHA-256 "
                     "differs from the one in the file); take an unchanged copy."),
                    {m_path, place}},
                "CAP-015");
        m_set.findings.push_back({"CAP-015", Severity::Caution, 0, channel.name, {},
            {DYNCAL_TEXT("core",
                 "%1: the samples of channel %2 are stored in a type for which the SHA-256 in the "
                 "file was not checked."),
                {m_path, place}},
            {}, {}});
        return {};
    }

    const std::string &m_path;
    hsize_t m_budgetBytes;
    SampleUse m_use;
    const JobControl &m_control;
    CaptureSet m_set;
};

tl::unexpected<Error> notHdf5(const std::string &path)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 cannot be opened as HDF5: it is incomplete, damaged or in use by another program; "
             "copy it again or close the other program."),
            {path}},
        "CAP-018");
}

Result<CaptureSet> readOpened(
    const std::string &path, hsize_t fileBytes, SampleUse use, const JobControl &control)
{
    constexpr std::size_t kCacheSlots = 521; // the library's default
    constexpr double kPreemption = 0.75; // the library's default
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose);
    H5Pset_cache(access.id(), 0, kCacheSlots, kHdf5ChunkCacheBytes, kPreemption);
    const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), &H5Fclose);
    if (!file.valid())
        return notHdf5(path);
    return CaptureReader(path, fileBytes, use, control).read(file.id());
}

/// Generous for honest files: the slowest filter reads some 60 MB/s and blocks are a few MiB.
GuardedLimits limitsFor(std::uintmax_t fileBytes)
{
    constexpr std::uintmax_t kBytesPerSecond = 5'000'000;
    constexpr std::uintmax_t kBaseMemoryBytes = 512U << 20;
    return {
        kBaseMemoryBytes + 4 * fileBytes, std::chrono::seconds(10 + fileBytes / kBytesPerSecond)};
}

} // namespace

int recogniseHdf5Capture(const std::string &, std::string_view head)
{
    // The signature may lie behind a user block of 512 bytes or more (MATLAB 7.3).
    for (std::size_t offset = 0; offset < head.size(); offset = offset == 0 ? 512 : 2 * offset) {
        if (head.substr(offset).starts_with(kSignature))
            return head.find(kCaptureFormatName) != std::string_view::npos ? 100 : 60;
    }
    return 0;
}

Result<CaptureSet> readHdf5Capture(
    const std::string &path, const ImportSettings &, const JobControl &control)
{
    const std::scoped_lock lock(hdf5Mutex());
    silenceHdf5();
    std::error_code error;
    const std::uintmax_t fileBytes = std::filesystem::file_size(path, error);
    if (error)
        return notHdf5(path);
    const auto rehearsal = [&] { (void)readOpened(path, fileBytes, SampleUse::Rehearse, {}); };
    switch (rehearse(rehearsal, limitsFor(fileBytes), control.stop)) {
    case GuardedOutcome::Finished:
        return readOpened(path, fileBytes, SampleUse::Keep, control);
    case GuardedOutcome::Stopped:
        return fail(
            ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Reading %1 was cancelled."), {path}});
    case GuardedOutcome::NotStarted:
        return fail(ErrorKind::Internal,
            {DYNCAL_TEXT("core",
                 "%1 was not read because the system could not start a helper process; close other "
                 "programs."),
                {path}});
    case GuardedOutcome::Died:
        break;
    }
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 is damaged so badly that the HDF5 library fails on it; take another copy."),
            {path}},
        "CAP-018");
}

} // namespace dyncal
