// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/core/capture/formats/bytes/binary_test_support.h"

namespace dyncal::testing::scope_bin {

struct Buffer
{
    std::uint16_t type = 1, bytesPerPoint = 4;
    std::vector<float> values{0.5F, -0.25F, 1e-3F, 7.0F};
    std::optional<std::uint64_t> bytes; ///< declared, if not what is there
};

struct Waveform
{
    std::uint32_t headerBytes = 140, type = 1, xUnit = 2, yUnit = 1, segment = 0;
    double interval_s = 1e-8, origin_s = -0.5e-3;
    QByteArray label = "1", date = "12 NOV 2025", time = "11:22:33";
    QByteArray frame = "DSO-X 3034T:MY12345678";
    std::vector<Buffer> buffers{1};
    std::optional<std::uint32_t> points;
};

inline QByteArray file(const QByteArray &tag, const std::vector<Waveform> &waveforms)
{
    const bool wide = tag.endsWith("03");
    ByteWriter out;
    out.text(tag);
    if (wide)
        out.put<std::uint64_t>(0);
    else
        out.put<std::uint32_t>(0);
    out.put(static_cast<std::uint32_t>(waveforms.size()));
    for (const Waveform &wave : waveforms) {
        const auto points = wave.points.value_or(
            wave.buffers.empty() ? 0 : static_cast<std::uint32_t>(wave.buffers[0].values.size()));
        out.put(wave.headerBytes).put(wave.type);
        out.put(static_cast<std::uint32_t>(wave.buffers.size())).put(points);
        out.put<std::uint32_t>(1).put(1e-3F).put(-0.5e-3).put(wave.interval_s).put(wave.origin_s);
        out.put(wave.xUnit).put(wave.yUnit).text(wave.date, 16).text(wave.time, 16);
        out.text(wave.frame, 24).text(wave.label, 16).put(0.0).put(wave.segment);
        out.zeros(static_cast<qsizetype>(wave.headerBytes) - 140);
        for (const Buffer &buffer : wave.buffers) {
            const std::uint64_t bytes = buffer.bytes.value_or(buffer.values.size() * sizeof(float));
            out.put<std::uint32_t>(wide ? 16 : 12).put(buffer.type).put(buffer.bytesPerPoint);
            if (wide)
                out.put(bytes);
            else
                out.put(static_cast<std::uint32_t>(bytes));
            out.putAll(buffer.values);
        }
    }
    return out.bytes();
}

} // namespace dyncal::testing::scope_bin
