// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What our process makes of whatever a helper process may hand over, the library left out: an input
// is a described file as bytes. Seeds are HDF5 files; the mutator has them described first.

#include "core/capture/formats/foreign/foreign_hdf5.h"
#include "core/capture/formats/foreign/mat73.h"
#include "core/capture/formats/hdf5/hdf5_capture_reader.h"
#include "core/capture/formats/hdf5/hdf5_open.h"
#include "tests/fuzz/fuzz_reader.h"
#include "tests/support/scratch_folder.h"

#include <algorithm>
#include <cstring>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t *data, std::size_t size, std::size_t maxSize);

namespace {

const dyncal::testing::ScratchFolder &folder()
{
    static const dyncal::testing::ScratchFolder instance;
    return instance;
}

/// A seed as the helper describes it; anything else as it is.
std::vector<std::byte> described(const std::uint8_t *data, std::size_t size)
{
    if (dyncal::hasHdf5Signature({reinterpret_cast<const char *>(data), size})) {
        if (const auto file
            = dyncal::openHdf5(folder().write("seed.h5", data, size), dyncal::kUsualExpansion, {}))
            return dyncal::packed(file->tree);
    }
    const auto bytes = std::as_bytes(std::span(data, size));
    return {bytes.begin(), bytes.end()};
}

/// Samples that only the helper can unpack are the other target's.
bool needsHelper(const dyncal::Hdf5Tree &tree)
{
    return std::any_of(tree.objects.begin(), tree.objects.end(),
        [](const auto &object) { return object.dataset.storage == dyncal::Hdf5Storage::Packed; });
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    constexpr std::size_t kFileBytes = 1 << 16;
    static const std::string path
        = folder().write("samples", std::string(kFileBytes, '\x01').data(), kFileBytes);
    auto tree = dyncal::unpackedTree(described(data, size));
    if (!tree || needsHelper(*tree))
        return 0;
    const auto samples = dyncal::SampleFile::open(path);
    dyncal::fuzz::require(samples.has_value());
    const dyncal::Hdf5File file{
        path, *samples, std::move(*tree), std::make_shared<dyncal::ExpansionBudget>(kFileBytes)};
    dyncal::fuzz::requireSound(dyncal::readHdf5Capture(file, {}));
    dyncal::fuzz::requireSound(dyncal::readForeignHdf5(file, {}, {}));
    dyncal::fuzz::requireSound(dyncal::readMat73(file, {}, {}));
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(
    std::uint8_t *data, std::size_t size, std::size_t maxSize, unsigned)
{
    const std::vector<std::byte> bytes = described(data, size);
    const std::size_t kept = std::min(bytes.size(), maxSize);
    std::memcpy(data, bytes.data(), kept);
    return LLVMFuzzerMutate(data, kept, maxSize);
}
