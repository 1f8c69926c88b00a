// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/core/capture/formats/bytes/binary_test_support.h"

namespace dyncal::testing::rigol {

struct Setting
{
    bool enabled = true, inverted = false;
    std::int32_t scale_uV = 500000;
    std::int16_t shift = -40;
    float probe = 10.0F;
};

/// What a generated file is to be.
struct Recipe
{
    bool familyB = false;
    QByteArray model = "DS1204B"; ///< of family B
    std::vector<Setting> channels{Setting{}, Setting{true, false, 2000, 7, 1.0F}};
    std::uint32_t points = 64;
    float rate_Hz = 2.5e6F;
    std::int64_t offset_ps = 3'000'000;
    std::uint32_t rollStop = 0;
    std::uint8_t triggerMode = 0;
};

inline std::uint8_t countOf(std::size_t channel, std::uint32_t point)
{
    return static_cast<std::uint8_t>(17 * point + 100 * channel);
}

template <typename T>
void place(QByteArray &bytes, std::size_t at, T value)
{
    bytes = patched(std::move(bytes), static_cast<qsizetype>(at), value);
}

inline QByteArray wfm(const Recipe &recipe)
{
    QByteArray file(recipe.familyB ? 420 : 276, '\0');
    place<std::uint32_t>(file, 0, recipe.familyB ? 0x01A4A5A5 : 0x0000A5A5);
    if (recipe.familyB)
        file.replace(4, recipe.model.size(), recipe.model);
    place(file, recipe.familyB ? 60 : 28, recipe.points);
    for (std::size_t k = 0; k < recipe.channels.size(); ++k) {
        const Setting &setting = recipe.channels[k];
        const std::size_t at = (recipe.familyB ? 68 - 2 : 34) + 24 * k; // B lacks the first field
        place(file, at + 10, setting.probe);
        place<std::uint8_t>(file, at + (recipe.familyB ? 16 : 15), setting.enabled);
        place<std::uint8_t>(file, at + (recipe.familyB ? 17 : 16), setting.inverted);
        place(file, at + 18, setting.scale_uV);
        place(file, at + 22, setting.shift);
    }
    if (!recipe.familyB) {
        place(file, 20, recipe.rollStop);
        place(file, 142, recipe.triggerMode);
    }
    place(file, recipe.familyB ? 180 : 100, recipe.rate_Hz);
    place(file, recipe.familyB ? 172 : 112, recipe.offset_ps);
    for (std::size_t k = 0; k < recipe.channels.size(); ++k) {
        if (!recipe.channels[k].enabled && !recipe.familyB)
            continue;
        for (std::uint32_t i = 0; i < recipe.points; ++i)
            file += static_cast<char>(countOf(k, i));
    }
    return file;
}

inline Recipe familyB()
{
    Recipe recipe;
    recipe.familyB = true;
    recipe.channels = std::vector<Setting>(4);
    recipe.channels[1].enabled = false;
    recipe.points = 8192;
    return recipe;
}

} // namespace dyncal::testing::rigol
