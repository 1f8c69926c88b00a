// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/capture_seal.h"

#include "core/base/allowed_threads.h"
#include "core/base/content_hash.h"

#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <future>
#include <system_error>
#include <unordered_map>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

Error cancelled()
{
    return {ErrorKind::Cancelled, {}, {}, 0};
}

Error changedFile(const InputFile &input)
{
    return {ErrorKind::FileUnreadable,
        {DYNCAL_TEXT(
             "core", "%1 changed since it was opened; open it again, or take an unchanged copy."),
            {input.path}},
        "CAP-015", 0};
}

/// For less than this a thread costs more time than it saves.
constexpr double kWorthAThread = 1 << 20; // bytes
constexpr auto kThreadWhereThereIsOne = std::launch::async | std::launch::deferred;

/// Computes the hashes and counts the bytes done.
class Sealer
{
public:
    Sealer(CaptureSet &set, const JobControl &control)
        : m_set(set)
        , m_control(control)
    {
        for (const InputFile &input : set.inputs)
            m_totalBytes += input.sha256.empty() ? static_cast<double>(input.bytes) : 0.0;
        for (const Shot &shot : set.shots) {
            for (const Channel &channel : shot.channels)
                m_totalBytes += channel.sha256.empty() ? bytesOf(channel.samples) : 0.0;
        }
    }

    /// Samples and files at the same time: they are mostly the same bytes, read from the disk once.
    Result<void> run()
    {
        constexpr std::chrono::milliseconds kReport{50};
        const bool isAlone = m_totalBytes < kWorthAThread || allowedThreads() < 2;
        const auto when = isAlone ? std::launch::deferred : kThreadWhereThereIsOne;
        std::future<Result<void>> files = std::async(when, [this] { return sealInputs(); });
        const Result<void> channels = sealChannels();
        m_givenUp = !channels;
        while (files.wait_for(kReport) == std::future_status::timeout)
            report();
        const Result<void> inputs = files.get();
        report();
        return channels ? inputs : channels;
    }

private:
    static double bytesOf(const RawSamples &samples)
    {
        return static_cast<double>(samples.size() * bytesPerSample(samples.type()));
    }

    /// Counts the bytes and says whether to go on.
    bool advance(std::uintmax_t bytes)
    {
        m_doneBytes += bytes;
        return !m_control.stopRequested() && !m_givenUp;
    }

    void report() const
    {
        const auto done = static_cast<double>(m_doneBytes.load());
        m_control.report(m_totalBytes > 0.0 ? std::min(done / m_totalBytes, 1.0) : 1.0);
    }

    Result<void> sealChannels()
    {
        for (std::size_t i = 0; i < m_set.shots.size(); ++i) {
            for (Channel &channel : m_set.shots[i].channels) {
                if (const auto done = sealChannel(static_cast<Index>(i) + 1, channel); !done)
                    return done;
            }
        }
        return {};
    }

    Result<void> sealInputs()
    {
        for (InputFile &input : m_set.inputs) {
            if (const auto done = sealInput(input); !done)
                return done;
        }
        return {};
    }

    Result<void> sealChannel(Index shot, Channel &channel)
    {
        if (channel.sha256.empty()) {
            Result<std::string> hash = hashOf(shot, channel);
            if (!hash)
                return tl::unexpected(hash.error());
            channel.sha256 = std::move(*hash);
        }
        if (channel.statedSha256.empty() || channel.statedSha256 == channel.sha256)
            return {};
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 is damaged: the samples of shot %2, channel '%3' are not those that were recorded (their SHA-256 differs from the one in the file); take an unchanged copy."),
                {pathOf(shot, channel), std::to_string(shot), channel.name}},
            "CAP-018", shot);
    }

    Result<std::string> hashOf(Index shot, const Channel &channel)
    {
        Sha256 hash;
        const RawSamples &samples = channel.samples;
        const Index width = bytesPerSample(samples.type());
        for (Index begin = 0; begin < samples.size(); begin += RawSamples::kBlock) {
            const Index end = std::min(begin + RawSamples::kBlock, samples.size());
            const bool readable = samples.visitBlocks(
                begin, end, [&](auto values, Index) { hash.add(std::as_bytes(values)); });
            if (!readable)
                return tl::unexpected(unreadable(shot, channel));
            if (!advance(static_cast<std::uintmax_t>(width * (end - begin))))
                return tl::unexpected(cancelled());
            report();
        }
        return hash.hex();
    }

    Result<void> sealInput(InputFile &input)
    {
        if (!input.sha256.empty())
            return {};
        std::uintmax_t counted = 0;
        const auto goOn = [&](std::uintmax_t done) {
            const std::uintmax_t more = done - counted;
            counted = done;
            return advance(more);
        };
        input.sha256 = sha256OfFile(input.path, goOn);
        if (m_control.stopRequested() || m_givenUp)
            return tl::unexpected(cancelled());
        if (input.sha256.empty() || !isUnchanged(input))
            return tl::unexpected(changedFile(input));
        return {};
    }

    const InputFile *fileOf(Index shot, const Channel &channel) const
    {
        const auto input = static_cast<std::size_t>(
            inputOf(m_set.shots[static_cast<std::size_t>(shot - 1)], channel));
        return input < m_set.inputs.size() ? &m_set.inputs[input] : nullptr;
    }

    std::string pathOf(Index shot, const Channel &channel) const
    {
        const InputFile *input = fileOf(shot, channel);
        return input ? input->path : std::string("The capture");
    }

    Error unreadable(Index shot, const Channel &channel) const
    {
        const InputFile *input = fileOf(shot, channel);
        if (input && !isUnchanged(*input))
            return changedFile(*input);
        return {ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1: the samples of shot %2, channel '%3' cannot be read any more; check the drive or the network, or copy the file again."),
                {pathOf(shot, channel), std::to_string(shot), channel.name}},
            "CAP-018", shot};
    }

    CaptureSet &m_set;
    const JobControl &m_control;
    double m_totalBytes = 0.0;
    std::atomic<std::uintmax_t> m_doneBytes = 0;
    std::atomic<bool> m_givenUp = false; ///< the samples have failed already
};

/// Inputs that repeat an earlier one byte by byte, each with its first shot.
Findings equalInputs(const CaptureSet &set)
{
    Findings findings;
    std::unordered_map<std::string, const InputFile *> earlier; // by hash
    for (std::size_t i = 0; i < set.inputs.size(); ++i) {
        const InputFile &input = set.inputs[i];
        const auto [twin, isNew] = earlier.try_emplace(input.sha256, &input);
        if (isNew)
            continue;
        const auto shot = std::find_if(set.shots.begin(), set.shots.end(),
            [&](const Shot &s) { return comesFrom(s, static_cast<Index>(i)); });
        const Index number = shot != set.shots.end() ? shot - set.shots.begin() + 1 : 0;
        findings.push_back({.id = "CAP-011",
            .severity = Severity::Caution,
            .shot = number,
            .message
            = {DYNCAL_TEXT("core",
                   "%1 and %2 hold identical data; a shot counted twice makes the scatter look smaller than it is. Take one of them out."),
                {twin->second->path, input.path}}});
    }
    return findings;
}

std::int64_t inNanoseconds(const timespec &time)
{
    constexpr std::int64_t kNanoseconds = 1'000'000'000;
    return time.tv_sec * kNanoseconds + time.tv_nsec;
}

} // namespace

InputFile stampedInput(const std::string &path, const std::string &format)
{
    InputFile input;
    input.path = path;
    input.file = fs::path(path).filename().string();
    input.format = format;
    struct stat status
    {
    };
    if (::stat(path.c_str(), &status) != 0)
        return input;
    input.bytes = static_cast<std::uintmax_t>(status.st_size);
    // A copy that keeps times restores the time of the content (mtime), never that of the entry
    // (ctime).
    input.changed_ns = std::max(inNanoseconds(status.st_mtim), inNanoseconds(status.st_ctim));
    return input;
}

bool isUnchanged(const InputFile &input)
{
    if (input.bytes == 0 && input.changed_ns == 0)
        return true;
    const InputFile now = stampedInput(input.path, input.format);
    return now.bytes == input.bytes && now.changed_ns == input.changed_ns;
}

Result<void> checkStillWhole(const CaptureSet &set)
{
    for (const Shot &shot : set.shots) {
        for (const Channel &channel : shot.channels) {
            if (channel.samples.isWhole())
                continue;
            const auto input = static_cast<std::size_t>(inputOf(shot, channel));
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "%1 was changed, moved or removed while it was in use, or can no longer be read, so nothing was made of it; leave it where it is and start again, or take an unchanged copy."),
                    {input < set.inputs.size() ? set.inputs[input].path : channel.name}},
                "CAP-015");
        }
    }
    return {};
}

void reportUnexpected(CaptureSet &set)
{
    for (const InputFile &input : set.inputs) {
        if (!input.expectedSha256 || input.sha256.empty() || *input.expectedSha256 == input.sha256)
            continue;
        addOnce(set.findings,
            {.id = "CAP-015",
                .severity = Severity::Block,
                .message
                = {DYNCAL_TEXT("core",
                       "%1 changed since it was imported. The results are of the new data and cannot be certified in this project."),
                    {input.file}}});
    }
}

Result<CaptureSet> sealCaptures(CaptureSet set, const JobControl &control)
{
    if (const Result<void> done = Sealer(set, control).run(); !done)
        return tl::unexpected(done.error());
    for (Finding &finding : equalInputs(set))
        addOnce(set.findings, std::move(finding));
    reportUnexpected(set);
    return set;
}

} // namespace dyncal
