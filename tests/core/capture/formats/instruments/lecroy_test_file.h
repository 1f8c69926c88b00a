// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/core/capture/formats/bytes/binary_test_support.h"

namespace dyncal::testing::lecroy {

/// What a generated file is to be.
struct Recipe
{
    std::endian order = std::endian::little;
    bool words = true;
    QByteArray layout = "LECROY_2_3";
    QByteArray prefix; ///< of a transfer
    QByteArray instrument = "LECROYHDO6104", label, unit = "V", horizontalUnit = "S";
    std::int32_t textBytes = 0, wave2Bytes = 0;
    std::vector<std::int16_t> counts{-100, 0, 100, 127, -128, 7};
    std::int32_t segments = 1;
    std::vector<double> triggers; ///< pairs time, offset
    float gain = 0.001F, offset = -0.25F;
    std::optional<float> acquisitionOffset;
    float interval = 1e-9F;
    double horizontalOffset = -2.5e-6;
    std::int16_t recordType = 0, source = 1, bits = 8;
    std::int32_t firstValid = 0, firstPoint = 0, sparsing = 1;
    std::int16_t risSweeps = 1;
    std::optional<std::int32_t> count, wave1Bytes, triggerBytes, lastValid, descriptorBytes;
};

/// Puts a field at its place in the descriptor.
template <typename T>
void place(QByteArray &block, const Recipe &recipe, qsizetype at, T value)
{
    const QByteArray raw = ByteWriter(recipe.order).put(value).bytes();
    block.replace(at, raw.size(), raw);
}

inline void placeText(QByteArray &block, qsizetype at, const QByteArray &text)
{
    block.replace(at, text.size(), text);
}

inline QByteArray trc(const Recipe &recipe)
{
    const bool newer = recipe.layout == "LECROY_2_3" || !recipe.layout.endsWith("1_0");
    QByteArray block(newer ? 346 : 320, '\0');
    const auto count = recipe.count.value_or(static_cast<std::int32_t>(recipe.counts.size()));
    const auto bytes = static_cast<std::int32_t>(recipe.counts.size() * (recipe.words ? 2 : 1));
    const auto triggers = static_cast<std::int32_t>(recipe.triggers.size() * sizeof(double));
    const auto put32 = [&](qsizetype at, std::int32_t value) { place(block, recipe, at, value); };
    const auto put16 = [&](qsizetype at, std::int16_t value) { place(block, recipe, at, value); };
    placeText(block, 0, "WAVEDESC");
    placeText(block, 16, recipe.layout);
    put16(32, recipe.words ? 1 : 0);
    put16(34, recipe.order == std::endian::little ? 1 : 0);
    put32(36, recipe.descriptorBytes.value_or(static_cast<std::int32_t>(block.size())));
    put32(40, recipe.textBytes);
    put32(newer ? 48 : 44, recipe.triggerBytes.value_or(triggers));
    put32(newer ? 60 : 48, recipe.wave1Bytes.value_or(bytes));
    put32(newer ? 64 : 52, recipe.wave2Bytes);
    placeText(block, newer ? 76 : 56, recipe.instrument);
    put32(newer ? 92 : 72, 4711);
    placeText(block, newer ? 96 : 76, recipe.label);
    const qsizetype at = newer ? 116 : 92;
    put32(at, count);
    put32(at + 8, recipe.firstValid);
    put32(at + 12, recipe.lastValid.value_or(count - 1));
    if (newer) {
        put32(at + 16, recipe.firstPoint);
        put32(at + 20, recipe.sparsing);
    }
    put32(newer ? 144 : 108, recipe.segments);
    place(block, recipe, newer ? 156 : 120, recipe.gain);
    place(block, recipe, newer ? 160 : 124, recipe.offset);
    put16(newer ? 172 : 132, recipe.bits);
    place(block, recipe, newer ? 176 : 134, recipe.interval);
    place(block, recipe, newer ? 180 : 138, recipe.horizontalOffset);
    placeText(block, newer ? 196 : 154, recipe.unit);
    placeText(block, newer ? 244 : 202, recipe.horizontalUnit);
    const QByteArray date = ByteWriter(recipe.order)
                                .put(7.25)
                                .put<std::uint8_t>(5)
                                .put<std::uint8_t>(14)
                                .put<std::uint8_t>(3)
                                .put<std::uint8_t>(2)
                                .put<std::int16_t>(2025)
                                .bytes();
    placeText(block, newer ? 296 : 250, date);
    put16(newer ? 316 : 270, recipe.recordType);
    if (newer)
        put16(322, recipe.risSweeps);
    place(block, recipe, newer ? 340 : 290, recipe.acquisitionOffset.value_or(recipe.offset));
    put16(newer ? 344 : 296, static_cast<std::int16_t>(recipe.source + (newer ? 0 : 1)));
    ByteWriter out(recipe.order);
    out.raw(recipe.prefix).raw(block).zeros(recipe.textBytes).putAll(recipe.triggers);
    for (const std::int16_t value : recipe.counts) {
        if (recipe.words)
            out.put(value);
        else
            out.put(static_cast<std::int8_t>(value));
    }
    return out.zeros(recipe.wave2Bytes).bytes();
}

} // namespace dyncal::testing::lecroy
