// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5_samples.h"

#include <algorithm>
#include <string>
#include <vector>

namespace dyncal {
namespace {

/// Deflate, the strongest standard filter, cannot shrink more than this.
constexpr hsize_t kMaxCompression = 1100;
constexpr hsize_t kSmallBytes = 1 << 16;

/// One dataset being read, and the words for errors about it.
class SampleReader
{
public:
    SampleReader(hid_t dataset, const std::string &path, const std::string &channel, SampleUse use)
        : m_dataset(dataset)
        , m_use(use)
        , m_path(path)
        , m_channel(channel)
        , m_type(H5Dget_type(dataset), &H5Tclose)
        , m_creation(H5Dget_create_plist(dataset), &H5Pclose)
    {
    }

    /// Number of samples, once everything the dataset claims has been believed.
    Result<hsize_t> checkedExtent(hsize_t &budgetBytes) const;

    /// Reads as the type that keeps every stored value.
    Result<StoredSamples> read(hsize_t size, const JobControl &control) const;

private:
    tl::unexpected<Error> wrongKind() const
    {
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1: channel %2 is no list of numbers; a channel is a one-dimensional dataset of "
                 "integers or floating point numbers."),
                {m_path, m_channel}},
            "CAP-018");
    }

    tl::unexpected<Error> incomplete() const
    {
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1: channel %2 claims more samples than the file holds; the copy is incomplete "
                 "or "
                 "damaged, copy it again."),
                {m_path, m_channel}},
            "CAP-018");
    }

    Result<void> checkFilters() const;
    bool claimsFit(hsize_t samples, hsize_t &budgetBytes) const;
    bool allChunksThere(hsize_t samples) const;

    template <typename T>
    Result<StoredSamples> readAs(
        hid_t memory, hsize_t size, bool exactType, const JobControl &control) const;

    hid_t m_dataset;
    SampleUse m_use;
    const std::string &m_path;
    const std::string &m_channel;
    Hdf5Handle m_type;
    Hdf5Handle m_creation;
};

Result<hsize_t> SampleReader::checkedExtent(hsize_t &budgetBytes) const
{
    const Hdf5Handle space(H5Dget_space(m_dataset), &H5Sclose);
    const bool known = m_type.valid() && m_creation.valid() && space.valid();
    const H5T_class_t typeClass = known ? H5Tget_class(m_type.id()) : H5T_NO_CLASS;
    if ((typeClass != H5T_INTEGER && typeClass != H5T_FLOAT)
        || H5Sget_simple_extent_ndims(space.id()) != 1)
        return wrongKind();
    hsize_t samples = 0;
    if (H5Sget_simple_extent_dims(space.id(), &samples, nullptr) != 1)
        return wrongKind();
    if (const Result<void> filters = checkFilters(); !filters)
        return tl::unexpected(filters.error());
    if (!claimsFit(samples, budgetBytes))
        return incomplete();
    return samples;
}

Result<void> SampleReader::checkFilters() const
{
    const int filters = H5Pget_nfilters(m_creation.id());
    for (int i = 0; i < filters; ++i) {
        unsigned int flags = 0;
        std::size_t values = 0;
        const H5Z_filter_t filter = H5Pget_filter2(m_creation.id(), static_cast<unsigned int>(i),
            &flags, &values, nullptr, 0, nullptr, nullptr);
        if (filter < 0 || H5Zfilter_avail(filter) <= 0)
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "%1: channel %2 is compressed with HDF5 filter %3, which is not installed "
                     "here; "
                     "save the file with deflate or without compression."),
                    {m_path, m_channel, std::to_string(filter)}},
                "CAP-018");
    }
    hsize_t chunk = 0;
    const bool tooLarge = filters > 0 && H5Pget_chunk(m_creation.id(), 1, &chunk) == 1
        && chunk > kHdf5ChunkCacheBytes / std::max<hsize_t>(H5Tget_size(m_type.id()), 1);
    if (tooLarge)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1: channel %2 is compressed in chunks of more than 64 MiB; save the file with "
                 "smaller chunks or without compression."),
                {m_path, m_channel}},
            "CAP-018");
    return {};
}

bool SampleReader::claimsFit(hsize_t samples, hsize_t &budgetBytes) const
{
    const H5D_layout_t layout = H5Pget_layout(m_creation.id());
    const hsize_t stored = H5Dget_storage_size(m_dataset);
    // Samples in other files (external or virtual) would bypass every check here.
    if (layout == H5D_VIRTUAL || H5Pget_external_count(m_creation.id()) > 0 || stored > budgetBytes)
        return false;
    budgetBytes -= stored;
    const hsize_t sampleBytes = H5Tget_size(m_type.id());
    const bool filtered = H5Pget_nfilters(m_creation.id()) > 0;
    const hsize_t credible = filtered ? stored * kMaxCompression + kSmallBytes : stored;
    if (sampleBytes == 0 || samples > credible / sampleBytes)
        return false;
    return layout != H5D_CHUNKED || allChunksThere(samples);
}

bool SampleReader::allChunksThere(hsize_t samples) const
{
    hsize_t chunk = 0;
    hsize_t written = 0;
    if (H5Pget_chunk(m_creation.id(), 1, &chunk) != 1 || chunk == 0)
        return false;
    const Hdf5Handle space(H5Dget_space(m_dataset), &H5Sclose);
    const hsize_t needed = samples / chunk + (samples % chunk != 0 ? 1 : 0);
    return space.valid() && H5Dget_num_chunks(m_dataset, space.id(), &written) >= 0
        && written >= needed;
}

Result<StoredSamples> SampleReader::read(hsize_t size, const JobControl &control) const
{
    const std::size_t bytes = H5Tget_size(m_type.id());
    if (H5Tget_class(m_type.id()) == H5T_FLOAT) {
        return bytes <= sizeof(float)
            ? readAs<float>(H5T_NATIVE_FLOAT, size, bytes == sizeof(float), control)
            : readAs<double>(H5T_NATIVE_DOUBLE, size, bytes == sizeof(double), control);
    }
    const bool isSigned = H5Tget_sign(m_type.id()) == H5T_SGN_2;
    const std::size_t signedBytes = isSigned ? bytes : bytes + 1;
    if (signedBytes <= 2)
        return readAs<std::int16_t>(H5T_NATIVE_INT16, size, isSigned && bytes == 2, control);
    if (signedBytes <= 4)
        return readAs<std::int32_t>(H5T_NATIVE_INT32, size, isSigned && bytes == 4, control);
    return readAs<double>(H5T_NATIVE_DOUBLE, size, false, control);
}

template <typename T>
Result<StoredSamples> SampleReader::readAs(
    hid_t memory, hsize_t size, bool exactType, const JobControl &control) const
{
    const bool keep = m_use == SampleUse::Keep;
    std::vector<T> values(keep ? size : std::min(size, kHdf5BlockSamples));
    const Hdf5Handle source(H5Dget_space(m_dataset), &H5Sclose);
    for (hsize_t begin = 0; begin < size; begin += kHdf5BlockSamples) {
        const hsize_t count = std::min(size - begin, kHdf5BlockSamples);
        if (control.stopRequested())
            return fail(
                ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Reading %1 was cancelled."), {m_path}});
        const Hdf5Handle block(H5Screate_simple(1, &count, nullptr), &H5Sclose);
        const bool selected
            = H5Sselect_hyperslab(source.id(), H5S_SELECT_SET, &begin, nullptr, &count, nullptr)
            >= 0;
        if (!selected
            || H5Dread(m_dataset, memory, block.id(), source.id(), H5P_DEFAULT,
                   &values[keep ? begin : 0])
                < 0)
            return incomplete();
    }
    return StoredSamples{RawSamples(std::move(values)), exactType};
}

} // namespace

SampleTypes sampleTypes(const RawSamples &samples)
{
    switch (samples.type()) {
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

Result<StoredSamples> readSampleDataset(hid_t dataset, const std::string &path,
    const std::string &channel, hsize_t &budgetBytes, SampleUse use, const JobControl &control)
{
    const SampleReader reader(dataset, path, channel, use);
    const Result<hsize_t> size = reader.checkedExtent(budgetBytes);
    if (!size)
        return tl::unexpected(size.error());
    return reader.read(*size, control);
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
