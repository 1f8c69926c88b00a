// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/tdms/tdms_runs.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace dyncal {
namespace {

constexpr Index kWindow = 256 * 1024; ///< bytes read at once where pieces lie close together
constexpr Index kLargePiece = 4096; ///< bytes from which a piece is read on its own

std::uint64_t unsignedOf(Index value)
{
    return static_cast<std::uint64_t>(value);
}

/// Copies every `stride`-th element of N bytes.
template <std::size_t N>
void gather(const std::byte *source, Index stride, Index count, std::byte *target)
{
    for (Index i = 0; i < count; ++i)
        std::memcpy(target + i * static_cast<Index>(N), source + i * stride, N);
}

void gatherSamples(
    const std::byte *source, Index stride, Index count, Index bytes, std::byte *target)
{
    if (stride == bytes)
        std::memcpy(target, source, static_cast<std::size_t>(count * bytes));
    else if (bytes == 1)
        gather<1>(source, stride, count, target);
    else if (bytes == 2)
        gather<2>(source, stride, count, target);
    else if (bytes == 4)
        gather<4>(source, stride, count, target);
    else
        gather<8>(source, stride, count, target);
}

template <std::size_t N>
void swapEach(std::byte *samples, Index count)
{
    for (Index i = 0; i < count; ++i)
        std::reverse(
            samples + i * static_cast<Index>(N), samples + (i + 1) * static_cast<Index>(N));
}

void swapSamples(std::byte *samples, Index count, Index bytes)
{
    if (bytes == 2)
        swapEach<2>(samples, count);
    else if (bytes == 4)
        swapEach<4>(samples, count);
    else if (bytes == 8)
        swapEach<8>(samples, count);
}

/// Reads samples of one run; keeps a window of the file for those that lie between others.
class RunReader
{
public:
    RunReader(const SampleFile &file, const TdmsRun &run, Index sampleBytes)
        : m_file(file)
        , m_run(run)
        , m_bytes(sampleBytes)
    {
    }

    bool read(Index begin, Index count, std::byte *target)
    {
        m_end = offsetOf(begin + count - 1) + unsignedOf(m_bytes);
        for (Index done = 0; done < count;) {
            const Index within = (begin + done) % m_run.perChunk;
            const Index here = std::min(m_run.perChunk - within, count - done);
            if (!readPiece(offsetOf(begin + done), here, target + done * m_bytes))
                return false;
            done += here;
        }
        if (m_run.bigEndian != (std::endian::native == std::endian::big))
            swapSamples(target, count, m_bytes);
        return true;
    }

private:
    std::uint64_t offsetOf(Index sample) const
    {
        return m_run.offset + unsignedOf(sample / m_run.perChunk) * m_run.chunkStride
            + unsignedOf(sample % m_run.perChunk * m_run.stride);
    }

    bool readPiece(std::uint64_t offset, Index count, std::byte *target)
    {
        const bool close = m_run.stride == m_bytes;
        if (close && (count * m_bytes >= kLargePiece || m_run.chunks == 1))
            return m_file.read(offset, static_cast<std::size_t>(count * m_bytes), target);
        const Index rows = std::clamp<Index>(kWindow / m_run.stride, 1, count);
        for (Index done = 0; done < count; done += rows) {
            const Index here = std::min(rows, count - done);
            const std::byte *source = window(
                offset + unsignedOf(done * m_run.stride), (here - 1) * m_run.stride + m_bytes);
            if (source == nullptr)
                return false;
            gatherSamples(source, m_run.stride, here, m_bytes, target + done * m_bytes);
        }
        return true;
    }

    /// The bytes from `offset` on, or null. Reads more only if the next piece is near.
    const std::byte *window(std::uint64_t offset, Index bytes)
    {
        if (offset < m_windowBegin
            || offset + unsignedOf(bytes) > m_windowBegin + m_window.size()) {
            constexpr std::uint64_t kNear = kWindow / 4;
            const bool near = m_run.chunks > 1 && m_run.chunkStride <= kNear;
            const std::uint64_t wanted
                = near ? std::min(unsignedOf(kWindow), m_end - offset) : unsignedOf(bytes);
            m_window.resize(static_cast<std::size_t>(std::max(wanted, unsignedOf(bytes))));
            m_windowBegin = offset;
            if (!m_file.read(offset, m_window.size(), m_window.data()))
                return nullptr;
        }
        return m_window.data() + (offset - m_windowBegin);
    }

    const SampleFile &m_file;
    const TdmsRun &m_run;
    Index m_bytes;
    std::uint64_t m_end = 0; ///< of the bytes of the requested samples
    std::vector<std::byte> m_window;
    std::uint64_t m_windowBegin = 0;
};

bool goesOnWithin(const TdmsRun &last, const TdmsRun &run)
{
    return last.chunks == 1 && run.chunks == 1 && last.stride == run.stride
        && last.offset + unsignedOf(last.perChunk * last.stride) == run.offset;
}

} // namespace

void TdmsRuns::append(TdmsRun run)
{
    if (run.perChunk <= 0 || run.chunks <= 0)
        return;
    const bool closed = run.chunkStride == unsignedOf(run.perChunk * run.stride);
    if (run.chunks > 1 && closed) {
        run.perChunk *= run.chunks;
        run.chunks = 1;
    }
    const Index size = run.size();
    if (!mergeIntoLast(run)) {
        m_begins.push_back(m_size);
        m_runs.push_back(run);
    }
    m_size += size;
}

bool TdmsRuns::mergeIntoLast(const TdmsRun &run)
{
    if (m_runs.empty() || m_runs.back().bigEndian != run.bigEndian
        || run.offset <= m_runs.back().offset)
        return false;
    TdmsRun &last = m_runs.back();
    if (goesOnWithin(last, run)) {
        last.perChunk += run.perChunk;
        return true;
    }
    if (last.perChunk != run.perChunk || last.stride != run.stride)
        return false;
    const std::uint64_t step = last.chunks > 1 ? last.chunkStride : run.offset - last.offset;
    const bool onGrid = run.offset == last.offset + unsignedOf(last.chunks) * step
        && (run.chunks == 1 || run.chunkStride == step);
    if (!onGrid)
        return false;
    last.chunkStride = step;
    last.chunks += run.chunks;
    return true;
}

bool TdmsRuns::read(
    const SampleFile &file, Index sampleBytes, Index begin, Index count, std::byte *target) const
{
    const auto next = std::upper_bound(m_begins.begin(), m_begins.end(), begin);
    auto i = static_cast<std::size_t>(next - m_begins.begin()) - 1;
    for (Index done = 0; done < count; ++i) {
        const Index skip = begin + done - m_begins[i];
        const Index here = std::min(m_runs[i].size() - skip, count - done);
        if (!RunReader(file, m_runs[i], sampleBytes).read(skip, here, target + done * sampleBytes))
            return false;
        done += here;
    }
    return true;
}

} // namespace dyncal
