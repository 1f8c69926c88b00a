// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/core/capture/formats/bytes/binary_test_support.h"

namespace dyncal::testing::riff {

constexpr int kPcm = 1, kFloat = 3, kExtensible = 0xFFFE;

/// What a generated file is to be.
struct Recipe
{
    QByteArray container = "RIFF";
    int tag = kPcm;
    int channels = 2;
    std::uint32_t rate_Hz = 48000;
    int bytes = 2; ///< of one sample
    int bits = 16;
    int validBits = 0; ///< extensible only
    int frames = 6;
    QByteArray before; ///< chunks between header and format
    std::optional<std::uint32_t> riffBytes, dataBytes;
    std::optional<std::uint64_t> longBytes; ///< ds64
    double byteRateFactor = 1.0;

    std::endian order() const
    {
        return container == "RIFX" ? std::endian::big : std::endian::little;
    }
};

/// Count of a sample, at both ends of the range and between.
inline std::int64_t countOf(const Recipe &recipe, int frame, int channel)
{
    const std::int64_t full = std::int64_t(1) << (8 * recipe.bytes - 1);
    const std::int64_t counts[] = {-full, full - 1, 0, 1, -1, full / 3};
    const std::int64_t count = counts[(frame + channel) % 6];
    return recipe.bytes == 1 ? count + 128 : count;
}

inline double floatOf(int frame, int channel)
{
    return (frame - 2) * 0.25 + channel * 1.5; // exact in single precision
}

inline void putSample(ByteWriter &out, const Recipe &recipe, int frame, int channel)
{
    if (recipe.tag == kFloat) {
        if (recipe.bytes == 4)
            out.put(static_cast<float>(floatOf(frame, channel)));
        else
            out.put(floatOf(frame, channel));
        return;
    }
    const auto count = static_cast<std::uint64_t>(countOf(recipe, frame, channel));
    QByteArray raw;
    for (int i = 0; i < recipe.bytes; ++i)
        raw += static_cast<char>(count >> (8 * i) & 0xFF);
    if (recipe.order() == std::endian::big)
        std::reverse(raw.begin(), raw.end());
    out.raw(raw);
}

inline QByteArray formatChunk(const Recipe &recipe)
{
    ByteWriter out(recipe.order());
    const auto frameBytes = static_cast<std::uint16_t>(recipe.channels * recipe.bytes);
    const bool extensible = recipe.validBits > 0;
    out.text("fmt ").put<std::uint32_t>(extensible ? 40 : 16);
    out.put(static_cast<std::uint16_t>(extensible ? kExtensible : recipe.tag));
    out.put(static_cast<std::uint16_t>(recipe.channels)).put(recipe.rate_Hz);
    out.put(static_cast<std::uint32_t>(recipe.rate_Hz * frameBytes * recipe.byteRateFactor));
    out.put(frameBytes).put(static_cast<std::uint16_t>(recipe.bits));
    if (extensible) {
        out.put<std::uint16_t>(22).put(static_cast<std::uint16_t>(recipe.validBits));
        out.put<std::uint32_t>(0).put(static_cast<std::uint32_t>(recipe.tag));
        out.put<std::uint16_t>(0).put<std::uint16_t>(0x10);
        out.raw(QByteArray::fromHex("800000aa00389b71"));
    }
    return out.bytes();
}

inline QByteArray wav(const Recipe &recipe)
{
    ByteWriter samples(recipe.order());
    for (int k = 0; k < recipe.frames; ++k) {
        for (int c = 0; c < recipe.channels; ++c)
            putSample(samples, recipe, k, c);
    }
    QByteArray chunks = recipe.before;
    const auto dataBytes = static_cast<std::uint32_t>(samples.size());
    if (recipe.longBytes) {
        ByteWriter ds64(recipe.order());
        ds64.text("ds64").put<std::uint32_t>(28).put<std::uint64_t>(0);
        ds64.put(*recipe.longBytes).put<std::uint64_t>(0).put<std::uint32_t>(0);
        chunks += ds64.bytes();
    }
    chunks += formatChunk(recipe);
    ByteWriter data(recipe.order());
    data.text("data").put(recipe.dataBytes.value_or(dataBytes)).raw(samples.bytes());
    if (dataBytes % 2 == 1)
        data.zeros(1);
    ByteWriter file(recipe.order());
    const auto riff = static_cast<std::uint32_t>(4 + chunks.size() + data.size());
    file.text(recipe.container).put(recipe.riffBytes.value_or(riff)).text("WAVE");
    return file.raw(chunks).raw(data.bytes()).bytes();
}

} // namespace dyncal::testing::riff
