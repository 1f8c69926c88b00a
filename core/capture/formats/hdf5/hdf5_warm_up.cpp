// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_warm_up.h"

#include "core/base/free_memory.h"
#include "core/capture/formats/hdf5/hdf5_create.h"
#include "core/capture/formats/hdf5/hdf5_describe.h"
#include "core/capture/formats/hdf5/hdf5_scribe.h"

#include <cstddef>
#include <string>
#include <vector>

namespace dyncal {
namespace {

constexpr std::size_t kGrowth = std::size_t(1) << 16U;
constexpr std::size_t kPlenty = std::size_t(64) << 20U;
constexpr int kTexts = 12; ///< more than an object's header takes, as in our captures

Hdf5Handle memoryAccess()
{
    Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose);
    const bool usable = access.valid() && H5Pset_fapl_core(access.id(), kGrowth, false) >= 0
        && H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110) >= 0;
    return usable ? std::move(access) : Hdf5Handle();
}

void fill(hid_t file)
{
    Hdf5Tree tree;
    Hdf5Scribe root(file, tree);
    Hdf5Scribe group = root.group("shots");
    Hdf5Scribe channel = group.dataset("dut", RawSamples(std::vector<std::int16_t>{0, 1, 2, 3}));
    for (Hdf5Scribe *object : {&root, &group, &channel})
        for (int i = 0; i < kTexts; ++i)
            object->text(std::string("text").append(std::to_string(i)), "value");
    channel.number("rate", 1.0);
    channel.numbers("range", {-1.0, 1.0});
}

std::vector<std::byte> smallFile()
{
    const Hdf5Handle access = memoryAccess();
    const Hdf5Handle file(H5Fcreate("small", H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), &H5Fclose);
    if (!file.valid())
        return {};
    fill(file.id());
    H5Fflush(file.id(), H5F_SCOPE_GLOBAL);
    const ssize_t size = H5Fget_file_image(file.id(), nullptr, 0);
    std::vector<std::byte> bytes(static_cast<std::size_t>(size > 0 ? size : 0));
    H5Fget_file_image(file.id(), bytes.data(), bytes.size());
    return bytes;
}

} // namespace

void warmHdf5Up()
{
    [[maybe_unused]] static const bool done = [] {
        if (!isMemoryLeft(kPlenty)) // the library crashes without memory
            return false;
        std::vector<std::byte> bytes = smallFile();
        const Hdf5Handle access = memoryAccess();
        if (bytes.empty() || H5Pset_file_image(access.id(), bytes.data(), bytes.size()) < 0)
            return false;
        const Hdf5Handle file(H5Fopen("small", H5F_ACC_RDONLY, access.id()), &H5Fclose);
        return file.valid()
            && describeHdf5(file.id(), Hdf5Depth::Everything, ExpansionBudget(0)).has_value();
    }();
}

} // namespace dyncal
