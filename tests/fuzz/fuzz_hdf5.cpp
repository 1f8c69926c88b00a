// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The whole way of a file: the helper process with the library, then one of the three readers that
// share it, chosen by the last byte (which the format does not look at). A file of its own and not
// one in memory only: libhdf5 resolves the path, and /proc/self/fd/N resolves to nothing.

#include "core/capture/formats/foreign_hdf5.h"
#include "core/capture/formats/hdf5_capture.h"
#include "core/capture/formats/mat73.h"
#include "tests/fuzz/fuzz_reader.h"
#include "tests/support/scratch_folder.h"

#include <array>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const dyncal::testing::ScratchFolder folder;
    constexpr std::array<dyncal::fuzz::Reader, 3> kReaders{
        &dyncal::readHdf5Capture, &dyncal::readForeignHdf5, &dyncal::readMat73};
    const std::size_t choice = size > 0 ? data[size - 1] : 0;
    const std::string path = folder.write("x.h5", data, size);
    dyncal::fuzz::requireSound(kReaders[choice % kReaders.size()](path, {}, {}));
    return 0;
}
