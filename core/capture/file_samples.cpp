// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/file_samples.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>

namespace dyncal {
namespace {

std::int64_t nanosecondsOf(const timespec &time)
{
    constexpr std::int64_t kNanoseconds = 1'000'000'000;
    return time.tv_sec * kNanoseconds + time.tv_nsec;
}

SampleFile::State stateOf(const struct stat &status)
{
    return {static_cast<std::uint64_t>(status.st_size), nanosecondsOf(status.st_mtim),
        nanosecondsOf(status.st_ctim)};
}

/// Reverses the bytes of every sample.
void swapBytes(std::byte *samples, Index count, Index size)
{
    for (Index i = 0; i < count; ++i)
        std::reverse(samples + i * size, samples + (i + 1) * size);
}

class FileSource : public SampleSource
{
public:
    FileSource(std::shared_ptr<const SampleFile> file, SampleLayout layout)
        : m_file(std::move(file))
        , m_layout(std::move(layout))
        , m_bytes(bytesPerSample(m_layout.type))
        , m_stride(m_layout.stride == 0 ? m_bytes : m_layout.stride)
    {
    }

    /// Number of samples, if all of them lie within the file.
    std::optional<Index> claim()
    {
        if (m_stride < m_bytes)
            return {};
        Index total = 0;
        for (const SampleExtent &extent : m_layout.extents) {
            if (!liesWithin(extent))
                return {};
            m_begins.push_back(total);
            total += extent.count;
        }
        return total;
    }

    bool read(Index begin, Index count, std::byte *target) const override
    {
        auto next = std::upper_bound(m_begins.begin(), m_begins.end(), begin);
        std::size_t i = static_cast<std::size_t>(next - m_begins.begin()) - 1;
        for (Index done = 0; done < count; ++i) {
            const SampleExtent &extent = m_layout.extents[i];
            const Index skip = begin + done - m_begins[i];
            const Index here = std::min(extent.count - skip, count - done);
            if (here > 0
                && !readPiece(extent.offset + static_cast<std::uint64_t>(skip * m_stride), here,
                    target + done * m_bytes))
                return false;
            done += here;
        }
        if (m_layout.byteOrder != std::endian::native)
            swapBytes(target, count, m_bytes);
        return true;
    }

    bool isUnchanged() const override { return m_file->unchanged(); }

private:
    bool liesWithin(const SampleExtent &extent) const
    {
        if (extent.count < 0 || extent.offset > m_file->size())
            return false;
        const std::uint64_t room = m_file->size() - extent.offset;
        const auto sample = static_cast<std::uint64_t>(m_bytes);
        const auto fitting
            = room < sample ? 0 : (room - sample) / static_cast<std::uint64_t>(m_stride) + 1;
        return static_cast<std::uint64_t>(extent.count) <= fitting;
    }

    bool readPiece(std::uint64_t offset, Index count, std::byte *target) const
    {
        if (m_stride == m_bytes)
            return m_file->read(offset, static_cast<std::size_t>(count * m_bytes), target);
        constexpr Index kBufferBytes = 1 << 20;
        const Index rows = std::clamp<Index>(kBufferBytes / m_stride, 1, count);
        std::vector<std::byte> buffer(static_cast<std::size_t>((rows - 1) * m_stride + m_bytes));
        for (Index done = 0; done < count; done += rows) {
            const Index here = std::min(rows, count - done);
            const Index bytes = (here - 1) * m_stride + m_bytes;
            if (!m_file->read(offset + static_cast<std::uint64_t>(done * m_stride),
                    static_cast<std::size_t>(bytes), buffer.data()))
                return false;
            for (Index k = 0; k < here; ++k)
                std::memcpy(target + (done + k) * m_bytes, buffer.data() + k * m_stride,
                    static_cast<std::size_t>(m_bytes));
        }
        return true;
    }

    std::shared_ptr<const SampleFile> m_file;
    SampleLayout m_layout;
    Index m_bytes;
    Index m_stride;
    std::vector<Index> m_begins; ///< first sample of each extent
};

} // namespace

SampleFile::SampleFile(int descriptor, const State &state)
    : m_descriptor(descriptor)
    , m_state(state)
{
}

SampleFile::~SampleFile()
{
    ::close(m_descriptor);
}

Result<std::shared_ptr<const SampleFile>> SampleFile::open(const std::string &path)
{
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    struct stat status
    {
    };
    if (descriptor >= 0 && ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode))
        return std::shared_ptr<const SampleFile>(new SampleFile(descriptor, stateOf(status)));
    if (descriptor < 0 && (errno == EMFILE || errno == ENFILE))
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 cannot be opened because the system allows no more open files; read fewer recordings at once, or raise the limit (ulimit -n)."),
                {path}},
            "CAP-018");
    if (descriptor >= 0)
        ::close(descriptor);
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 cannot be opened; check that you may read it and that no other program holds it."),
            {path}},
        "CAP-018");
}

bool SampleFile::unchanged() const
{
    struct stat status
    {
    };
    return ::fstat(m_descriptor, &status) == 0 && stateOf(status) == m_state;
}

bool SampleFile::read(std::uint64_t offset, std::size_t bytes, std::byte *target) const
{
    while (bytes > 0) {
        const ssize_t got = ::pread(m_descriptor, target, bytes, static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return false;
        target += got;
        offset += static_cast<std::uint64_t>(got);
        bytes -= static_cast<std::size_t>(got);
    }
    return unchanged(); // checked after reading, so that the bytes are those of the opened file
}

std::optional<RawSamples> samplesInFile(std::shared_ptr<const SampleFile> file, SampleLayout layout)
{
    const SampleType type = layout.type;
    auto source = std::make_shared<FileSource>(std::move(file), std::move(layout));
    const std::optional<Index> size = source->claim();
    if (!size)
        return {};
    return RawSamples(std::move(source), type, *size);
}

} // namespace dyncal
