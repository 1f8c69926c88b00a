// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#if __has_include(<hdf5.h>)
#include <hdf5.h>
#else
#include <hdf5/serial/hdf5.h>
#endif

#include <QtGlobal>

#include <string>
#include <vector>

namespace dyncal::testing {

/// How a dataset is stored.
struct StoredAs
{
    hid_t type = -1;
    std::vector<hsize_t> chunk; ///< empty = contiguous
    bool shuffle = false;
    int deflate = 0;
    bool checksum = false;
    bool compact = false;
};

/// Writes HDF5 files with the library alone, as other programs do. Every call must succeed.
class Hdf5TestFile
{
public:
    explicit Hdf5TestFile(const std::string &path, hsize_t userBlock = 0, bool newest = false)
    {
        H5dont_atexit(); // as in the product; see silenceHdf5()
        const hid_t creation = checked(H5Pcreate(H5P_FILE_CREATE));
        const hid_t access = checked(H5Pcreate(H5P_FILE_ACCESS));
        checked(H5Pset_userblock(creation, userBlock));
        if (newest)
            checked(H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST));
        m_file = checked(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access));
        H5Pclose(creation);
        H5Pclose(access);
    }
    Hdf5TestFile(const Hdf5TestFile &) = delete;
    Hdf5TestFile &operator=(const Hdf5TestFile &) = delete;
    ~Hdf5TestFile() { checked(H5Fclose(m_file)); }

    hid_t id() const { return m_file; }

    void group(const std::string &path) const
    {
        H5Gclose(checked(H5Gcreate2(m_file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)));
    }

    /// A dataset without data.
    void claim(const std::string &path, const std::vector<hsize_t> &shape, const StoredAs &as) const
    {
        H5Dclose(create(path, shape, as));
    }

    /// `values` lie in memory as the native type `memory`.
    void dataset(const std::string &path, const std::vector<hsize_t> &shape, const StoredAs &as,
        hid_t memory, const void *values) const
    {
        const hid_t created = create(path, shape, as);
        checked(H5Dwrite(created, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
        H5Dclose(created);
    }

    void doubles(const std::string &path, const std::vector<double> &values) const
    {
        dataset(path, {values.size()}, {H5T_IEEE_F64LE, {}}, H5T_NATIVE_DOUBLE, values.data());
    }

    void number(const std::string &object, const std::string &name, double value) const
    {
        const hid_t space = checked(H5Screate(H5S_SCALAR));
        const hid_t attribute = checked(H5Acreate_by_name(m_file, object.c_str(), name.c_str(),
            H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
        checked(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value));
        H5Aclose(attribute);
        H5Sclose(space);
    }

    void text(const std::string &object, const std::string &name, const std::string &value) const
    {
        const hid_t type = checked(H5Tcopy(H5T_C_S1));
        checked(H5Tset_size(type, value.size() + 1));
        const hid_t space = checked(H5Screate(H5S_SCALAR));
        const hid_t attribute = checked(H5Acreate_by_name(m_file, object.c_str(), name.c_str(),
            type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
        checked(H5Awrite(attribute, type, value.c_str()));
        H5Aclose(attribute);
        H5Sclose(space);
        H5Tclose(type);
    }

private:
    template <typename T>
    static T checked(T result)
    {
        if (result < 0)
            qFatal("libhdf5 refused to write a test file");
        return result;
    }

    hid_t create(
        const std::string &path, const std::vector<hsize_t> &shape, const StoredAs &as) const
    {
        const hid_t space
            = checked(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr));
        const hid_t creation = checked(H5Pcreate(H5P_DATASET_CREATE));
        const hid_t links = checked(H5Pcreate(H5P_LINK_CREATE));
        checked(H5Pset_create_intermediate_group(links, 1));
        if (!as.chunk.empty())
            checked(H5Pset_chunk(creation, static_cast<int>(as.chunk.size()), as.chunk.data()));
        if (as.compact)
            checked(H5Pset_layout(creation, H5D_COMPACT));
        if (as.shuffle)
            checked(H5Pset_shuffle(creation));
        if (as.deflate > 0)
            checked(H5Pset_deflate(creation, static_cast<unsigned int>(as.deflate)));
        if (as.checksum)
            checked(H5Pset_fletcher32(creation));
        const hid_t created = checked(
            H5Dcreate2(m_file, path.c_str(), as.type, space, links, creation, H5P_DEFAULT));
        H5Sclose(space);
        H5Pclose(creation);
        H5Pclose(links);
        return created;
    }

    hid_t m_file;
};

} // namespace dyncal::testing
