// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_columns.h"

#include "core/capture/formats/hdf5/hdf5_helper.h"
#include "core/capture/formats/hdf5/hdf5_obstacle.h"
#include "core/capture/formats/hdf5/hdf5_samples.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace dyncal {
namespace {

/// The slowest filter unpacks some 60 MB/s, and pieces are a few MiB.
constexpr std::chrono::seconds kTimeToUnpack{5};
constexpr std::uint64_t kPieces = 24U << 20; ///< a piece being read, and the library's own memory
constexpr std::uint64_t kChunkCopies = 4; ///< filters double their buffers
constexpr double kPlaceBytes = 2.0 * sizeof(SampleExtent);
constexpr std::uint64_t kLeastCache = 16U << 20;
constexpr std::uint64_t kLargestCache = 192U << 20;
constexpr double kMaxUnpackedBytes = 4.0 * 1024 * 1024 * 1024;
constexpr double kInexactIntegers = 9007199254740992.0; ///< 2^53, or 2^53 + 1 rounded

RawSamples::Counts emptyCounts(SampleType type)
{
    switch (type) {
    case SampleType::Int16:
        return std::vector<std::int16_t>();
    case SampleType::Int32:
        return std::vector<std::int32_t>();
    case SampleType::Float32:
        return std::vector<float>();
    case SampleType::Int8:
        return std::vector<std::int8_t>();
    case SampleType::UInt8:
        return std::vector<std::uint8_t>();
    case SampleType::UInt16:
        return std::vector<std::uint16_t>();
    case SampleType::Float64:
        break;
    }
    return std::vector<double>();
}

/// Takes in what the helper unpacks for one dataset, which the budget allows.
class UnpackedDataset
{
public:
    explicit UnpackedDataset(const UnpackOrder &order)
        : m_order(order)
        , m_columns(static_cast<std::size_t>(order.columns), emptyCounts(order.type))
    {
        for (RawSamples::Counts &column : m_columns) // growing would take twice the memory
            std::visit(
                [&](auto &v) { v.reserve(static_cast<std::size_t>(order.samples)); }, column);
    }

    bool complete() const { return m_begin >= m_order.samples || m_order.columns == 0; }

    /// Takes the bytes of this dataset and returns the rest.
    std::span<const std::byte> take(std::span<const std::byte> bytes)
    {
        while (!bytes.empty() && !complete()) {
            const std::size_t wanted = pieceBytes() - m_inPiece;
            const std::size_t here = std::min(wanted, bytes.size());
            append(bytes.first(here));
            bytes = bytes.subspan(here);
            if (here == wanted)
                nextPiece();
        }
        return bytes;
    }

    std::vector<RawSamples> columns()
    {
        std::vector<RawSamples> samples;
        for (RawSamples::Counts &column : m_columns)
            samples.emplace_back(std::move(column));
        return samples;
    }

private:
    Index pieceSamples() const
    {
        return std::min(m_order.samplesPerPiece(), m_order.samples - m_begin);
    }
    std::size_t pieceBytes() const
    {
        return static_cast<std::size_t>(pieceSamples() * bytesPerSample(m_order.type));
    }

    /// The bytes of a sample may arrive in two parts.
    void append(std::span<const std::byte> bytes)
    {
        std::visit(
            [&](auto &values) {
                constexpr std::size_t kSize = sizeof(values[0]);
                const std::size_t before = static_cast<std::size_t>(m_begin) * kSize + m_inPiece;
                values.resize((before + bytes.size() + kSize - 1) / kSize);
                std::memcpy(std::as_writable_bytes(std::span(values)).data() + before, bytes.data(),
                    bytes.size());
            },
            m_columns[m_column]);
        m_inPiece += bytes.size();
    }

    void nextPiece()
    {
        const Index done = pieceSamples();
        m_inPiece = 0;
        if (++m_column == m_columns.size()) {
            m_column = 0;
            m_begin += done;
        }
    }

    UnpackOrder m_order;
    std::vector<RawSamples::Counts> m_columns;
    Index m_begin = 0; ///< first sample of the piece that is arriving
    std::size_t m_column = 0; ///< whose part of it is arriving
    std::size_t m_inPiece = 0; ///< bytes of that part that have arrived
};

/// Fulfils wishes: those in the file at once, the others together in one run of the helper.
class ColumnReader
{
public:
    ColumnReader(
        const Hdf5File &file, const std::vector<Hdf5Wish> &wishes, const JobControl &control)
        : m_file(file)
        , m_wishes(wishes)
        , m_control(control)
        , m_columns(wishes.size())
    {
    }

    Result<std::vector<std::vector<RawSamples>>> read()
    {
        for (std::size_t i = 0; i < m_wishes.size(); ++i) {
            const Result<void> done
                = m_wishes[i].dataset->storage == Hdf5Storage::Packed ? order(i) : findInFile(i);
            if (!done)
                return tl::unexpected(done.error());
        }
        if (const Result<void> unpacked = unpack(); !unpacked)
            return tl::unexpected(unpacked.error());
        return std::move(m_columns);
    }

private:
    tl::unexpected<Error> incomplete(std::size_t i) const
    {
        Hdf5Dataset dataset;
        dataset.obstacle = Hdf5Obstacle::Incomplete;
        return hdf5ObstacleError(m_file.path, m_wishes[i].name, dataset);
    }

    Result<void> findInFile(std::size_t i)
    {
        const std::optional<Hdf5Extents> extents = extentsOf(m_wishes[i]);
        if (!extents)
            return incomplete(i);
        for (Index column = 0; column < extents->columns; ++column) {
            std::optional<SampleLayout> layout = layoutOfColumn(m_wishes[i], column);
            const double placesBytes = static_cast<double>(kBytesOfChannel)
                + static_cast<double>(layout ? layout->extents.size() : 0) * kPlaceBytes;
            std::optional<RawSamples> samples
                = layout ? samplesInFile(m_file.file, std::move(*layout)) : std::nullopt;
            if (!samples)
                return incomplete(i);
            if (const Result<void> allowed = allow(i, placesBytes); !allowed)
                return allowed;
            m_columns[i].push_back(std::move(*samples));
        }
        return {};
    }

    Result<void> order(std::size_t i)
    {
        const std::optional<Hdf5Extents> extents = extentsOf(m_wishes[i]);
        if (!extents)
            return incomplete(i);
        const Hdf5Wish &wish = m_wishes[i];
        m_orders.push_back({wish.address, wish.dataset->type, wish.sampleAxis, extents->samples,
            extents->columns, wish.dataset->chunkBytes});
        m_ordered.push_back(i);
        const double bytes = static_cast<double>(extents->samples)
            * static_cast<double>(extents->columns)
            * static_cast<double>(bytesPerSample(wish.dataset->type));
        if (const Result<void> allowed = allow(i, bytes); !allowed)
            return allowed;
        m_unpackedBytes += bytes;
        if (m_unpackedBytes <= kMaxUnpackedBytes)
            return {};
        Hdf5Dataset dataset;
        dataset.obstacle = Hdf5Obstacle::TooLarge;
        return hdf5ObstacleError(m_file.path, wish.name, dataset);
    }

    /// Takes from the budget what this dataset needs: `bytes` to hold, or more for its chunks.
    Result<void> allow(std::size_t i, double bytes)
    {
        const auto whole = static_cast<std::uint64_t>(std::min(bytes, 0x1p62));
        const std::uint64_t needed = std::max(whole, m_wishes[i].dataset->unpackedBytes);
        m_wanted += std::min(needed, std::uint64_t(1) << 62);
        if (m_file.budget->take(needed))
            return {};
        const Expanding what = m_wanted > needed ? Expanding::ChannelsUpTo : Expanding::Channel;
        return m_file.budget->exceededBy(m_file.path, what, m_wishes[i].name, m_wanted);
    }

    /// What the helper needs for the largest chunk.
    GuardedLimits limits() const
    {
        std::uint64_t chunk = 0;
        for (const UnpackOrder &order : m_orders)
            chunk = std::max(chunk, std::min(order.chunkBytes, m_file.budget->allowed()));
        return {kPieces + cacheBytes() + kChunkCopies * chunk, kTimeToUnpack};
    }

    std::size_t cacheBytes() const
    {
        return std::clamp(m_file.budget->allowed() / kChunkCopies, kLeastCache, kLargestCache);
    }

    Result<void> unpack()
    {
        if (m_orders.empty())
            return {};
        std::vector<UnpackedDataset> unpacked(m_orders.begin(), m_orders.end());
        auto current = unpacked.begin();
        double received = 0.0;
        const auto receive = [&](std::span<const std::byte> bytes) {
            received += static_cast<double>(bytes.size());
            m_control.report(received / std::max(m_unpackedBytes, 1.0));
            for (; current != unpacked.end(); ++current) {
                bytes = current->take(bytes);
                if (!current->complete())
                    break;
            }
            return bytes.empty();
        };
        const auto work = [&](GuardedOutput &output) {
            (void)unpackDatasets(m_file.path, m_orders, cacheBytes(), output);
        };
        const Result<void> ran = runHdf5Helper(m_file.path, work, receive, limits(), m_control);
        return ran ? keep(unpacked) : ran;
    }

    Result<void> keep(std::vector<UnpackedDataset> &unpacked)
    {
        for (std::size_t k = 0; k < unpacked.size(); ++k) {
            const std::size_t i = m_ordered[k];
            if (!m_file.file->unchanged())
                return incomplete(i);
            if (!unpacked[k].complete())
                return notUnpacked(i);
            m_columns[i] = unpacked[k].columns();
            if (m_wishes[i].dataset->fidelity == Hdf5Fidelity::MayRound && wasRounded(i))
                return rounded(i);
        }
        return {};
    }

    tl::unexpected<Error> notUnpacked(std::size_t i) const
    {
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1: channel %2 cannot be unpacked: a compressed piece of it is damaged or larger than it declares; copy the file again."),
                {m_file.path, m_wishes[i].name}},
            "CAP-018");
    }

    bool wasRounded(std::size_t i) const
    {
        return std::any_of(m_columns[i].begin(), m_columns[i].end(), [](const RawSamples &samples) {
            bool rounded = false;
            samples.visitBlocks(0, samples.size(), [&](auto values, Index) {
                for (const auto value : values)
                    rounded = rounded || std::abs(static_cast<double>(value)) >= kInexactIntegers;
            });
            return rounded;
        });
    }

    tl::unexpected<Error> rounded(std::size_t i) const
    {
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1: channel %2 holds integers of more than 53 bits, which would be rounded; save them as 32 bit integers with scale and offset, or as floating point numbers."),
                {m_file.path, m_wishes[i].name}},
            "CAP-018");
    }

    const Hdf5File &m_file;
    const std::vector<Hdf5Wish> &m_wishes;
    const JobControl &m_control;
    std::vector<std::vector<RawSamples>> m_columns;
    std::vector<UnpackOrder> m_orders;
    std::vector<std::size_t> m_ordered; ///< the wish of each order
    double m_unpackedBytes = 0.0;
    std::uint64_t m_wanted = 0; ///< for the budget's sentence
};

} // namespace

Result<std::vector<std::vector<RawSamples>>> hdf5Columns(
    const Hdf5File &file, const std::vector<Hdf5Wish> &wishes, const JobControl &control)
{
    return ColumnReader(file, wishes, control).read();
}

} // namespace dyncal
