// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_create.h"

#include "core/capture/formats/hdf5/hdf5_samples.h"

#include <algorithm>

namespace dyncal {
namespace {

bool forgetTimes(hid_t creationProperties)
{
    return H5Pset_obj_track_times(creationProperties, false) >= 0;
}

} // namespace

Hdf5Handle createFile(const std::string &path)
{
    const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), &H5Pclose);
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose);
    // The newest format has checksums on its metadata.
    const bool usable = creation.valid() && access.valid() && forgetTimes(creation.id())
        && H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110) >= 0;
    if (!usable)
        return {};
    return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), &H5Fclose};
}

Hdf5Handle createGroup(hid_t parent, const std::string &name)
{
    const Hdf5Handle creation(H5Pcreate(H5P_GROUP_CREATE), &H5Pclose);
    const bool usable = creation.valid() && forgetTimes(creation.id())
        && H5Pset_link_creation_order(creation.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED)
            >= 0;
    if (!usable)
        return {};
    return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT), &H5Gclose};
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
    return {H5Dcreate2(group, name.c_str(), sampleTypes(samples.type()).stored, space.id(),
                H5P_DEFAULT, creation.id(), H5P_DEFAULT),
        &H5Dclose};
}

} // namespace dyncal
