// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc_reading/certified_sensor.h"
#include "tests/fuzz/fuzz_reader.h"

#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    using namespace dyncal;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are bytes
    const auto contents = readDcc(std::string_view(reinterpret_cast<const char *>(data), size));
    if (!contents) {
        fuzz::require(contents.error().kind == ErrorKind::FileUnreadable);
        return 0;
    }
    const CertifiedSensor sensor = certifiedSensor(*contents);
    if (sensor.response)
        for (const double f_Hz : sensor.response->frequency_Hz)
            fuzz::require(f_Hz > 0.0);
    return 0;
}
