// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_samples.h"

#include "core/capture/formats/hdf5/hdf5_describe.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

/// Reads one dataset along its time axis.
class Unpacker
{
public:
    Unpacker(hid_t dataset, const UnpackOrder &order)
        : m_dataset(dataset)
        , m_order(order)
        , m_space(H5Dget_space(dataset), &H5Sclose)
        , m_rank(H5Sget_simple_extent_ndims(m_space.id()))
        , m_bytes(static_cast<std::size_t>(bytesPerSample(order.type)))
    {
    }

    bool isAsOrdered() const
    {
        if (m_rank < 0 || m_rank > 2)
            return false;
        std::array<hsize_t, 2> shape{1, 1};
        H5Sget_simple_extent_dims(m_space.id(), shape.data(), nullptr);
        const auto axis = static_cast<std::size_t>(m_order.sampleAxis);
        return axis < shape.size() && shape[axis] == static_cast<hsize_t>(m_order.samples)
            && shape[1 - axis] == static_cast<hsize_t>(m_order.columns);
    }

    bool unpack(GuardedOutput &output)
    {
        const Index most = m_order.samplesPerPiece();
        for (Index begin = 0; begin < m_order.samples; begin += most) {
            const Index count = std::min(most, m_order.samples - begin);
            m_piece.resize(static_cast<std::size_t>(count * m_order.columns) * m_bytes);
            for (Index column = 0; column < m_order.columns; ++column) {
                if (!readColumn(begin, count, column))
                    return false;
            }
            output.write(m_piece);
        }
        return true;
    }

private:
    bool readColumn(Index begin, Index count, Index column)
    {
        const auto axis = static_cast<std::size_t>(m_order.sampleAxis);
        std::array<hsize_t, 2> first{};
        std::array<hsize_t, 2> extent{1, 1};
        first[axis] = static_cast<hsize_t>(begin);
        first[1 - axis] = static_cast<hsize_t>(column);
        extent[axis] = static_cast<hsize_t>(count);
        if (m_rank > 0
            && H5Sselect_hyperslab(
                   m_space.id(), H5S_SELECT_SET, first.data(), nullptr, extent.data(), nullptr)
                < 0)
            return false;
        const hsize_t size = static_cast<hsize_t>(count);
        const Hdf5Handle memory(H5Screate_simple(1, &size, nullptr), &H5Sclose);
        std::byte *target = m_piece.data() + static_cast<std::size_t>(column * count) * m_bytes;
        return H5Dread(m_dataset, sampleTypes(m_order.type).memory, memory.id(), m_space.id(),
                   H5P_DEFAULT, target)
            >= 0;
    }

    hid_t m_dataset;
    const UnpackOrder &m_order;
    Hdf5Handle m_space;
    int m_rank;
    std::size_t m_bytes;
    std::vector<std::byte> m_piece;
};

} // namespace

SampleTypes sampleTypes(SampleType type)
{
    switch (type) {
    case SampleType::Int16:
        return {H5T_STD_I16LE, H5T_NATIVE_INT16};
    case SampleType::Int32:
        return {H5T_STD_I32LE, H5T_NATIVE_INT32};
    case SampleType::Float32:
        return {H5T_IEEE_F32LE, H5T_NATIVE_FLOAT};
    case SampleType::Int8:
        return {H5T_STD_I8LE, H5T_NATIVE_INT8};
    case SampleType::UInt8:
        return {H5T_STD_U8LE, H5T_NATIVE_UINT8};
    case SampleType::UInt16:
        return {H5T_STD_U16LE, H5T_NATIVE_UINT16};
    case SampleType::Float64:
        break;
    }
    return {H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE};
}

Index UnpackOrder::samplesPerPiece() const
{
    return std::max<Index>(1, RawSamples::kBlock / std::max<Index>(columns, 1));
}

bool unpackDatasets(const std::string &path, const std::vector<UnpackOrder> &orders,
    std::size_t cacheBytes, GuardedOutput &output)
{
    const Hdf5Handle file = openHdf5File(path, cacheBytes);
    return file.valid() && std::all_of(orders.begin(), orders.end(), [&](const UnpackOrder &order) {
        const Hdf5Handle dataset(H5Oopen_by_addr(file.id(), order.address), &H5Oclose);
        if (!dataset.valid() || H5Iget_type(dataset.id()) != H5I_DATASET)
            return false;
        Unpacker unpacker(dataset.id(), order);
        return unpacker.isAsOrdered() && unpacker.unpack(output);
    });
}

bool writeSampleBlock(hid_t dataset, hid_t memoryType, hsize_t begin,
    std::span<const std::byte> samples, hsize_t count)
{
    const Hdf5Handle memory(H5Screate_simple(1, &count, nullptr), &H5Sclose);
    const Hdf5Handle target(H5Dget_space(dataset), &H5Sclose);
    return memory.valid() && target.valid()
        && H5Sselect_hyperslab(target.id(), H5S_SELECT_SET, &begin, nullptr, &count, nullptr) >= 0
        && H5Dwrite(dataset, memoryType, memory.id(), target.id(), H5P_DEFAULT, samples.data())
        >= 0;
}

} // namespace dyncal
