// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/quantity_words.h"

#include <array>

namespace dyncal {
namespace {

struct Words
{
    std::string_view name;
    const char *text;
};

constexpr std::array kValues{
    Words{"sensitivity", DYNCAL_TEXT("core", "Sensitivity at the onset of the step")},
    Words{"magnitude", DYNCAL_TEXT("core", "Magnitude of the frequency response")},
    Words{"phase_rad", DYNCAL_TEXT("core", "Phase of the frequency response")},
    Words{"f0_hz", DYNCAL_TEXT("core", "Undamped natural frequency")},
    Words{"damping_ratio", DYNCAL_TEXT("core", "Damping ratio")},
    Words{"q", DYNCAL_TEXT("core", "Quality factor")},
    Words{"resonance_hz", DYNCAL_TEXT("core", "Resonance frequency (largest magnitude)")},
    Words{"resonance_gain",
        DYNCAL_TEXT("core", "Magnitude at the resonance over the level at the onset")},
    Words{"within_5_percent_hz", DYNCAL_TEXT("core", "Magnitude within 5 % up to")},
    Words{"within_10_percent_hz", DYNCAL_TEXT("core", "Magnitude within 10 % up to")},
    Words{"minus_3_db_hz", DYNCAL_TEXT("core", "Magnitude above -3 dB up to")},
    Words{"rise_time_s", DYNCAL_TEXT("core", "Rise time, 10 % to 90 %")},
    Words{"overshoot_percent", DYNCAL_TEXT("core", "Overshoot")},
    Words{"settling_time_s", DYNCAL_TEXT("core", "Settling time, within 5 %")},
};

constexpr std::array kSources{
    Words{"p1_pa", DYNCAL_TEXT("core", "initial pressure")},
    Words{"t1_k", DYNCAL_TEXT("core", "initial temperature")},
    Words{"gamma", DYNCAL_TEXT("core", "ratio of the specific heats")},
    Words{"molar_mass_kg_mol", DYNCAL_TEXT("core", "molar mass of the gas")},
    Words{"relative_humidity", DYNCAL_TEXT("core", "relative humidity")},
    Words{"carbon_dioxide_fraction", DYNCAL_TEXT("core", "share of carbon dioxide")},
    Words{"velocity_m_s", DYNCAL_TEXT("core", "shock velocity")},
    Words{"distance_m", DYNCAL_TEXT("core", "distance along the tube")},
    Words{"arrival_s", DYNCAL_TEXT("core", "time of arrival")},
    Words{"delay_s", DYNCAL_TEXT("core", "delay of a sensor")},
    Words{"step_relative", DYNCAL_TEXT("core", "pressure step, as a ratio")},
    Words{"gain_relative", DYNCAL_TEXT("core", "gain of the measuring chain")},
    Words{"linearity_relative", DYNCAL_TEXT("core", "linearity of the measuring chain")},
    Words{"mounting_relative", DYNCAL_TEXT("core", "mounting")},
    Words{"clock_relative", DYNCAL_TEXT("core", "sample clock")},
    Words{"reference_gain_relative", DYNCAL_TEXT("core", "gain of the reference's chain")},
    Words{"attenuation_per_m", DYNCAL_TEXT("core", "attenuation along the tube")},
    Words{"level_relative", DYNCAL_TEXT("core", "noise of the level")},
    Words{"scatter_of_shots", DYNCAL_TEXT("core", "scatter of the shots")},
    Words{"velocity_scatter", DYNCAL_TEXT("core", "scatter of the velocity")},
    Words{"chain_relative", DYNCAL_TEXT("core", "response of the measuring chain")},
    Words{"reference_sensitivity_relative",
        DYNCAL_TEXT("core", "certificate of the reference transducer")},
};

template <std::size_t n>
const char *textOf(const std::array<Words, n> &all, std::string_view name)
{
    for (const Words &words : all)
        if (words.name == name)
            return words.text;
    return nullptr;
}

} // namespace

Message valueWords(std::string_view of)
{
    const char *text = textOf(kValues, of);
    return text ? Message{text, {}} : Message{"%1", {std::string(of)}};
}

Message sourceWords(const std::string &quantity)
{
    const std::size_t place = quantity.find('[');
    const char *text = textOf(kSources, std::string_view(quantity).substr(0, place));
    if (!text)
        return {"%1", {quantity}};
    if (place == quantity.npos)
        return {text, {}};
    const std::size_t end = quantity.rfind(']');
    return {"%M1, %V1", {quantity.substr(place + 1, end - place - 1)}, {Message{text, {}}}};
}

} // namespace dyncal
