// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// An input is both files of a recording: the description up to its end tag, then the samples.

#include "core/capture/formats/instruments/rohde_bin.h"
#include "tests/fuzz/fuzz_reader.h"
#include "tests/support/scratch_folder.h"

#include <algorithm>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const dyncal::testing::ScratchFolder folder;
    constexpr std::string_view kEnd = "</Database>";
    const std::string_view bytes(reinterpret_cast<const char *>(data), size);
    const std::size_t end = bytes.find(kEnd);
    const std::size_t split = end == std::string_view::npos ? size : end + kEnd.size();
    const std::string path = folder.write("x.bin", data, split);
    folder.write("x.Wfm.bin", data + split, size - split);
    dyncal::fuzz::requireSound(dyncal::readRohdeBin(path, {}, {}));
    return 0;
}
