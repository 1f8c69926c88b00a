// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_places.h"

#include <algorithm>

namespace dyncal {
namespace {

/// Beyond these no product of an extent, a number of blocks and a size overflows.
constexpr std::uint64_t kMostSamples = std::uint64_t(1) << 48;
constexpr std::uint64_t kMostColumns = std::uint64_t(1) << 12;

/// A dataset of at most two dimensions as a grid of blocks; missing dimensions have extent 1.
class BlockGrid
{
public:
    explicit BlockGrid(const Hdf5Dataset &dataset)
        : m_dataset(dataset)
    {
    }

    bool isSound() const
    {
        const bool known = m_dataset.blockShape.size() == m_dataset.shape.size()
            && std::all_of(m_dataset.blockShape.begin(), m_dataset.blockShape.end(),
                [](std::uint64_t extent) { return extent > 0 && extent <= kMostSamples; });
        if (!known || m_dataset.elements() == 0)
            return known;
        const std::uint64_t blocks = m_dataset.blockOffsets.size();
        return blocks % blocksAlong(0) == 0 && blocks / blocksAlong(0) == blocksAlong(1);
    }

    std::uint64_t extent(std::size_t d) const
    {
        return d < m_dataset.shape.size() ? m_dataset.shape[d] : 1;
    }
    std::uint64_t blockExtent(std::size_t d) const
    {
        return d < m_dataset.blockShape.size() ? m_dataset.blockShape[d] : 1;
    }
    std::uint64_t blocksAlong(std::size_t d) const
    {
        return extent(d) / blockExtent(d) + (extent(d) % blockExtent(d) != 0 ? 1 : 0);
    }
    std::uint64_t offset(std::uint64_t row, std::uint64_t column) const
    {
        return m_dataset.blockOffsets[row * blocksAlong(1) + column];
    }

private:
    const Hdf5Dataset &m_dataset;
};

/// Blocks that follow each other in the file are read in one go.
void append(SampleLayout &layout, const SampleExtent &extent, std::uint64_t step)
{
    if (!layout.extents.empty()) {
        SampleExtent &last = layout.extents.back();
        if (last.offset + static_cast<std::uint64_t>(last.count) * step == extent.offset) {
            last.count += extent.count;
            return;
        }
    }
    layout.extents.push_back(extent);
}

} // namespace

std::optional<Hdf5Extents> extentsOf(const Hdf5Wish &wish)
{
    const Hdf5Dataset &dataset = *wish.dataset;
    if (dataset.storage == Hdf5Storage::Nowhere || dataset.shape.size() > 2 || wish.sampleAxis < 0
        || wish.sampleAxis > 1)
        return std::nullopt;
    const BlockGrid grid(dataset);
    const auto axis = static_cast<std::size_t>(wish.sampleAxis);
    const std::uint64_t samples = grid.extent(axis);
    const std::uint64_t columns = grid.extent(1 - axis);
    if (samples > kMostSamples || columns > kMostColumns)
        return std::nullopt;
    return Hdf5Extents{static_cast<Index>(samples), static_cast<Index>(columns)};
}

std::optional<SampleLayout> layoutOfColumn(const Hdf5Wish &wish, Index column)
{
    const Hdf5Dataset &dataset = *wish.dataset;
    const BlockGrid grid(dataset);
    const std::optional<Hdf5Extents> extents = extentsOf(wish);
    if (!extents || !grid.isSound())
        return std::nullopt;
    const auto axis = static_cast<std::size_t>(wish.sampleAxis);
    const auto bytes = static_cast<std::uint64_t>(bytesPerSample(dataset.type));
    const std::uint64_t rowBytes = grid.blockExtent(1) * bytes;
    const std::uint64_t step = axis == 0 ? rowBytes : bytes;
    const std::uint64_t block = static_cast<std::uint64_t>(column) / grid.blockExtent(1 - axis);
    const std::uint64_t within = static_cast<std::uint64_t>(column) % grid.blockExtent(1 - axis);
    const std::uint64_t skip = within * (axis == 0 ? bytes : rowBytes);

    SampleLayout layout{dataset.type,
        dataset.bigEndian != 0 ? std::endian::big : std::endian::little,
        step == bytes ? 0 : static_cast<Index>(step), {}};
    const auto all = static_cast<std::uint64_t>(extents->samples);
    for (std::uint64_t i = 0, done = 0; done < all; ++i) {
        const std::uint64_t count = std::min(all - done, grid.blockExtent(axis));
        const std::uint64_t offset = axis == 0 ? grid.offset(i, block) : grid.offset(block, i);
        append(layout, {offset + skip, static_cast<Index>(count)}, step);
        done += count;
    }
    return layout;
}

} // namespace dyncal
