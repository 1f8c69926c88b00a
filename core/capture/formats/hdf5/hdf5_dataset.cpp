// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_dataset.h"

#include <algorithm>
#include <array>
#include <limits>

namespace dyncal {
namespace {

/// Memory for unpacking a chunk, in chunks: filters double their buffers, and the library keeps
/// one.
constexpr hsize_t kChunksInMemory = 4;
constexpr hsize_t kLargestDataset_bytes = hsize_t(4) << 30;

/// The library finds a chunk by walking over all; with more than this many the dataset is unpacked.
constexpr hsize_t kMaxLocatedChunks = 8192;

/// A standard type, the same in file and memory.
struct PlainType
{
    hid_t id;
    SampleType type;
    bool bigEndian;
};

std::array<PlainType, 14> plainTypes()
{
    return {{{H5T_STD_I16LE, SampleType::Int16, false}, {H5T_STD_I16BE, SampleType::Int16, true},
        {H5T_STD_I32LE, SampleType::Int32, false}, {H5T_STD_I32BE, SampleType::Int32, true},
        {H5T_IEEE_F32LE, SampleType::Float32, false}, {H5T_IEEE_F32BE, SampleType::Float32, true},
        {H5T_IEEE_F64LE, SampleType::Float64, false}, {H5T_IEEE_F64BE, SampleType::Float64, true},
        {H5T_STD_I8LE, SampleType::Int8, false}, {H5T_STD_I8BE, SampleType::Int8, true},
        {H5T_STD_U8LE, SampleType::UInt8, false}, {H5T_STD_U8BE, SampleType::UInt8, true},
        {H5T_STD_U16LE, SampleType::UInt16, false}, {H5T_STD_U16BE, SampleType::UInt16, true}}};
}

std::optional<PlainType> plainTypeOf(hid_t type)
{
    for (const PlainType &plain : plainTypes()) {
        if (H5Tequal(type, plain.id) > 0)
            return plain;
    }
    return std::nullopt;
}

/// The smallest of our types that keeps every value, or nearly (64 bit integers).
SampleType widenedType(hid_t type)
{
    const std::size_t bytes = H5Tget_size(type);
    if (H5Tget_class(type) == H5T_FLOAT)
        return bytes <= sizeof(float) ? SampleType::Float32 : SampleType::Float64;
    const bool isSigned = H5Tget_sign(type) == H5T_SGN_2;
    if (bytes == 1)
        return isSigned ? SampleType::Int8 : SampleType::UInt8;
    if (bytes == 2)
        return isSigned ? SampleType::Int16 : SampleType::UInt16;
    return bytes < 4 || (bytes == 4 && isSigned) ? SampleType::Int32 : SampleType::Float64;
}

std::string nameOfType(hid_t type)
{
    const std::string bits = std::to_string(8 * H5Tget_size(type));
    const std::string order
        = H5Tget_size(type) > 1 && H5Tget_order(type) == H5T_ORDER_BE ? " big-endian" : "";
    switch (H5Tget_class(type)) {
    case H5T_INTEGER:
        return std::string(H5Tget_sign(type) == H5T_SGN_NONE ? "uint" : "int") + bits + order;
    case H5T_FLOAT:
        return "float" + bits + order;
    case H5T_STRING:
        return "text";
    case H5T_COMPOUND:
        return "compound";
    case H5T_ENUM:
        return "enumeration";
    case H5T_REFERENCE:
        return "reference";
    default:
        return "other";
    }
}

/// One dataset, looked at step by step.
class DatasetMaker
{
public:
    DatasetMaker(hid_t dataset, const Hdf5FileFacts &file)
        : m_dataset(dataset)
        , m_file(file)
        , m_type(H5Dget_type(dataset), &H5Tclose)
        , m_creation(H5Dget_create_plist(dataset), &H5Pclose)
    {
    }

    std::optional<Hdf5Dataset> make()
    {
        if (!m_type.valid() || !m_creation.valid())
            return std::nullopt;
        m_made.typeText = nameOfType(m_type.id());
        if (findElsewhere()) { // even the shape may lie in the other file
            m_made.obstacle = isNumbers() ? Hdf5Obstacle::Elsewhere : Hdf5Obstacle::NotNumbers;
            return m_made;
        }
        m_space = Hdf5Handle(H5Dget_space(m_dataset), &H5Sclose);
        if (!m_space.valid() || H5Dget_storage_size(m_dataset) > m_file.bytes)
            return std::nullopt;
        m_made.obstacle = readShape() ? obstacle() : Hdf5Obstacle::Shape;
        if (m_made.obstacle == Hdf5Obstacle::None)
            place();
        return m_damaged ? std::nullopt : std::optional(m_made);
    }

private:
    bool isNumbers() const
    {
        const H5T_class_t typeClass = H5Tget_class(m_type.id());
        return typeClass == H5T_INTEGER || typeClass == H5T_FLOAT;
    }

    /// Names the other file that holds the samples, if one does.
    bool findElsewhere()
    {
        std::array<char, 1024> name{};
        if (H5Pget_layout(m_creation.id()) == H5D_VIRTUAL) {
            H5Pget_virtual_filename(m_creation.id(), 0, name.data(), name.size() - 1);
        } else if (H5Pget_external_count(m_creation.id()) > 0) {
            H5Pget_external(m_creation.id(), 0, name.size() - 1, name.data(), nullptr, nullptr);
        } else {
            return false;
        }
        m_made.elsewhere = name.data();
        return true;
    }

    bool readShape()
    {
        const H5S_class_t kind = H5Sget_simple_extent_type(m_space.id());
        std::array<hsize_t, H5S_MAX_RANK> extents{};
        const int rank = H5Sget_simple_extent_dims(m_space.id(), extents.data(), nullptr);
        if (rank >= 0)
            m_made.shape.assign(extents.begin(), extents.begin() + rank);
        return rank >= 0 && rank <= 2 && (kind == H5S_SCALAR || kind == H5S_SIMPLE);
    }

    Hdf5Obstacle obstacle()
    {
        if (!isNumbers())
            return Hdf5Obstacle::NotNumbers;
        if (const Hdf5Obstacle filter = filterObstacle(); filter != Hdf5Obstacle::None)
            return filter;
        return claimObstacle();
    }

    bool isFiltered() const { return H5Pget_nfilters(m_creation.id()) > 0; }

    Hdf5Obstacle filterObstacle()
    {
        const int filters = H5Pget_nfilters(m_creation.id());
        for (int i = 0; i < filters; ++i) {
            unsigned int flags = 0;
            std::size_t values = 0;
            const H5Z_filter_t filter = H5Pget_filter2(m_creation.id(),
                static_cast<unsigned int>(i), &flags, &values, nullptr, 0, nullptr, nullptr);
            m_made.missingFilter = filter;
            if (filter < 0 || H5Zfilter_avail(filter) <= 0)
                return Hdf5Obstacle::Filter;
        }
        const bool tooLarge = isFiltered() && readChunkShape()
            && chunkElements() > kHdf5LargestPackedChunk / H5Tget_size(m_type.id());
        return tooLarge ? Hdf5Obstacle::LargeChunk : Hdf5Obstacle::None;
    }

    bool readChunkShape()
    {
        std::array<hsize_t, H5S_MAX_RANK> extents{};
        const auto rank = static_cast<int>(m_made.shape.size());
        const bool known = H5Pget_chunk(m_creation.id(), rank, extents.data()) == rank;
        m_made.blockShape.assign(extents.begin(), extents.begin() + rank);
        const bool sound = known && rank > 0
            && std::find(m_made.blockShape.begin(), m_made.blockShape.end(), 0U)
                == m_made.blockShape.end();
        m_damaged = m_damaged || !sound;
        return sound;
    }

    /// A chunk has fewer than 2^32 bytes, or the library would not have opened it.
    hsize_t chunkElements() const
    {
        hsize_t product = 1;
        for (const hsize_t extent : m_made.blockShape)
            product *= extent;
        return product;
    }

    /// Compares what the dataset claims with what the file stores.
    Hdf5Obstacle claimObstacle()
    {
        const hsize_t bytes = H5Tget_size(m_type.id());
        const hsize_t stored = H5Dget_storage_size(m_dataset);
        if (bytes == 0 || (!isFiltered() && m_made.elements() > stored / bytes))
            return Hdf5Obstacle::Incomplete;
        const bool chunked = H5Pget_layout(m_creation.id()) == H5D_CHUNKED;
        if (chunked && !(readChunkShape() && allChunksThere()))
            return Hdf5Obstacle::Incomplete;
        return Hdf5Obstacle::None;
    }

    bool allChunksThere()
    {
        for (std::size_t d = 0; d < m_made.shape.size(); ++d) {
            const hsize_t along = gridExtent(d); // chunks that the file cannot list do not exist
            if (along > m_file.bytes || (along > 0 && m_neededChunks > m_file.bytes / along))
                return false;
            m_neededChunks *= along;
        }
        return H5Dget_num_chunks(m_dataset, m_space.id(), &m_chunks) >= 0
            && m_chunks >= m_neededChunks;
    }

    hsize_t gridExtent(std::size_t d) const
    {
        const hsize_t whole = m_made.shape[d] / m_made.blockShape[d];
        return whole + (m_made.shape[d] % m_made.blockShape[d] != 0 ? 1 : 0);
    }

    /// Finds where the numbers lie, or that they must be unpacked.
    void place()
    {
        const std::optional<PlainType> plain = plainTypeOf(m_type.id());
        m_made.type = plain ? plain->type : widenedType(m_type.id());
        m_made.bigEndian = plain && plain->bigEndian;
        m_made.fidelity = fidelity(plain.has_value());
        if (plain && !isFiltered() && locate()) {
            m_made.storage = Hdf5Storage::InFile;
            return;
        }
        m_made.storage = Hdf5Storage::Packed;
        findUnpackedSize();
        m_made.blockShape.clear();
        m_made.blockOffsets.clear();
        if (m_made.unpackedBytes > m_file.allowedBytes)
            m_made.obstacle = Hdf5Obstacle::OverBudget;
        else if (m_made.elements() > kLargestDataset_bytes / sizeof(double))
            m_made.obstacle = Hdf5Obstacle::TooLarge;
        if (m_made.obstacle != Hdf5Obstacle::None)
            m_made.storage = Hdf5Storage::Nowhere;
        m_made.allowedBytes = m_file.allowedBytes;
    }

    /// The larger of the samples as delivered and, with filters, all unpacked chunks (at least the
    /// copies that one chunk needs). All factors are below the file's size or 2^32.
    void findUnpackedSize()
    {
        const auto delivered = static_cast<hsize_t>(bytesPerSample(m_made.type));
        m_made.unpackedBytes = m_made.elements() * delivered;
        if (!isFiltered())
            return;
        m_made.chunkBytes = chunkElements() * H5Tget_size(m_type.id());
        const std::uint64_t chunks = std::max(m_neededChunks, kChunksInMemory);
        constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
        const std::uint64_t all
            = m_made.chunkBytes > kMost / chunks ? kMost : chunks * m_made.chunkBytes;
        m_made.unpackedBytes = std::max(m_made.unpackedBytes, all);
    }

    Hdf5Fidelity fidelity(bool plain) const
    {
        const bool wideInteger = H5Tget_class(m_type.id()) == H5T_INTEGER
            && H5Tget_size(m_type.id()) > sizeof(std::int32_t);
        if (wideInteger)
            return Hdf5Fidelity::MayRound;
        return plain ? Hdf5Fidelity::Exact : Hdf5Fidelity::Widened;
    }

    bool locate()
    {
        if (m_made.elements() == 0) {
            m_made.blockShape.assign(m_made.shape.size(), 1);
            return true;
        }
        switch (H5Pget_layout(m_creation.id())) {
        case H5D_CONTIGUOUS:
            m_made.blockShape = m_made.shape;
            m_made.blockOffsets = {H5Dget_offset(m_dataset)};
            return m_made.blockOffsets.front() != HADDR_UNDEF;
        case H5D_CHUNKED: // versions of the library differ in whether the user block counts
            return m_file.userBlockBytes == 0 && m_chunks <= kMaxLocatedChunks && locateChunks();
        default:
            return false;
        }
    }

    bool locateChunks()
    {
        const hsize_t columns = m_made.shape.size() == 2 ? gridExtent(1) : 1;
        m_made.blockOffsets.assign(gridExtent(0) * columns, HADDR_UNDEF);
        const hsize_t chunkBytes = chunkElements() * H5Tget_size(m_type.id());
        for (hsize_t i = 0; i < m_chunks; ++i) {
            std::array<hsize_t, H5S_MAX_RANK> begin{};
            unsigned int mask = 0;
            haddr_t address = HADDR_UNDEF;
            hsize_t size = 0;
            if (H5Dget_chunk_info(m_dataset, m_space.id(), i, begin.data(), &mask, &address, &size)
                    < 0
                || size != chunkBytes)
                return false;
            const hsize_t row = begin[0] / m_made.blockShape[0];
            const hsize_t column = m_made.shape.size() == 2 ? begin[1] / m_made.blockShape[1] : 0;
            if (row < gridExtent(0) && column < columns) // else left from a longer time
                m_made.blockOffsets[row * columns + column] = address;
        }
        return std::find(m_made.blockOffsets.begin(), m_made.blockOffsets.end(), HADDR_UNDEF)
            == m_made.blockOffsets.end();
    }

    hid_t m_dataset;
    const Hdf5FileFacts &m_file;
    Hdf5Handle m_type;
    Hdf5Handle m_creation;
    Hdf5Handle m_space;
    hsize_t m_chunks = 0;
    hsize_t m_neededChunks = 1; ///< for the extents
    bool m_damaged = false; ///< its statements are impossible
    Hdf5Dataset m_made;
};

} // namespace

std::optional<Hdf5Dataset> describeDataset(hid_t dataset, const Hdf5FileFacts &file)
{
    return DatasetMaker(dataset, file).make();
}

} // namespace dyncal
