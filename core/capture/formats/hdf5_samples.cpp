// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5_samples.h"

#include <algorithm>

namespace dyncal {
namespace {

struct SampleTypes
{
    hid_t stored;
    hid_t memory;
    hsize_t size;
};

SampleTypes sampleTypes(const RawSamples &samples)
{
    switch (samples.counts().index()) {
    case 0:
        return {H5T_STD_I16LE, H5T_NATIVE_INT16, 2};
    case 1:
        return {H5T_STD_I32LE, H5T_NATIVE_INT32, 4};
    case 2:
        return {H5T_IEEE_F32LE, H5T_NATIVE_FLOAT, 4};
    default:
        return {H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, 8};
    }
}

} // namespace

bool forgetTimes(hid_t creationProperties)
{
    return H5Pset_obj_track_times(creationProperties, false) >= 0;
}

Hdf5Handle createSampleDataset(hid_t group, const std::string &name, const RawSamples &samples)
{
    const hsize_t extent = static_cast<hsize_t>(samples.size());
    const hsize_t chunk = std::min(extent, kHdf5BlockSamples);
    const Hdf5Handle space(H5Screate_simple(1, &extent, nullptr), &H5Sclose);
    const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), &H5Pclose);
    if (!space.valid() || !creation.valid() || !forgetTimes(creation.id()))
        return {};
    if (chunk > 0 && H5Pset_chunk(creation.id(), 1, &chunk) < 0)
        return {};
    return {H5Dcreate2(group, name.c_str(), sampleTypes(samples).stored, space.id(), H5P_DEFAULT,
                creation.id(), H5P_DEFAULT),
        &H5Dclose};
}

bool writeSampleBlock(hid_t dataset, const RawSamples &samples, hsize_t begin, hsize_t count)
{
    const SampleTypes types = sampleTypes(samples);
    const Hdf5Handle memory(H5Screate_simple(1, &count, nullptr), &H5Sclose);
    const Hdf5Handle target(H5Dget_space(dataset), &H5Sclose);
    return memory.valid() && target.valid()
        && H5Sselect_hyperslab(target.id(), H5S_SELECT_SET, &begin, nullptr, &count, nullptr) >= 0
        && H5Dwrite(dataset, types.memory, memory.id(), target.id(), H5P_DEFAULT,
               samples.bytes().data() + begin * types.size)
        >= 0;
}

} // namespace dyncal
