// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/gas_choice.h"

#include "core/base/ascii_text.h"

#include <array>
#include <cmath>
#include <utility>

namespace dyncal {
namespace {

constexpr double kUsualHumidityUncertainty = 0.02; ///< of a hygrometer, where none is stated

/// Where a capture states the gas of a section.
struct RecordedKeys
{
    const char *gamma;
    const char *molarMass;
    const char *name;
};
constexpr RecordedKeys kDrivenKeys{"gamma1", "M1", "driven_gas"};
constexpr RecordedKeys kDriverKeys{"gamma4", "M4", "driver_gas"};

std::optional<double> humidityOf(const ShockSettings &settings, const Environment &around)
{
    if (settings.relativeHumidity)
        return settings.relativeHumidity;
    return std::isfinite(around.relativeHumidity) ? std::optional(around.relativeHumidity)
                                                  : std::nullopt;
}

Humidity humidityFor(const std::optional<double> &known)
{
    if (known)
        return {*known, kUsualHumidityUncertainty, Distribution::Normal};
    return {0.5, 0.5 / std::sqrt(3.0), Distribution::Rectangular};
}

bool isAir(const std::string &substance)
{
    return substance == "air" || substance == kMoistAir || substance == "humid-air";
}

/// A substance at its usual constants; air as moist air, unless its heat capacity varies.
GasSettings named(const std::string &substance, const GasSettings &asked)
{
    GasSettings settings = asked;
    const bool varies = asked.heatCapacity == kVariableHeatCapacity;
    settings.substance = isAir(substance) ? (varies ? "air" : kMoistAir) : substance;
    for (const NamedGas &gas : knownGases()) {
        if (settings.substance == gas.name) {
            settings.gamma = gas.gamma;
            settings.molarMass_kg_mol = gas.molarMass_kg_mol;
        }
    }
    return settings;
}

std::string wordOf(const CaptureSet &set, const char *key)
{
    const auto found = set.tube.find(key);
    return found != set.tube.end() ? found->second : std::string();
}

/// gamma and molar mass as recorded; a heat capacity that varies has none.
std::optional<GasSettings> recordedConstants(
    const CaptureSet &set, const RecordedKeys &keys, const GasSettings &asked)
{
    const auto gamma = set.tubeNumber(keys.gamma);
    const auto mass = set.tubeNumber(keys.molarMass);
    if (!gamma || !mass || !(*gamma > 1.0 && *gamma < 2.0) || !(*mass > 0.0 && *mass < 1.0)
        || asked.heatCapacity == kVariableHeatCapacity)
        return std::nullopt;
    const std::string substance = recordedSubstance(wordOf(set, keys.name));
    return GasSettings{
        *gamma, *mass, substance.empty() ? "custom" : substance, kConstantHeatCapacity};
}

} // namespace

std::string recordedSubstance(const std::string &word)
{
    static constexpr std::array<std::pair<const char *, const char *>, 14> kWords{{{"air", "air"},
        {"dry air", "air"}, {"humid air", "air"}, {"humid-air", "air"}, {"n2", "n2"},
        {"nitrogen", "n2"}, {"he", "he"}, {"helium", "he"}, {"ar", "ar"}, {"argon", "ar"},
        {"co2", "co2"}, {"carbon dioxide", "co2"}, {"luft", "air"}, {"kväve", "n2"}}};
    const std::string lower = lowerCase(std::string(trimmed(word)));
    for (const auto &[name, substance] : kWords)
        if (lower == name)
            return substance;
    return {};
}

std::vector<GasWay> waysToDrivenGas(
    const ShockSettings &settings, const CaptureSet &set, const Environment &around)
{
    const auto known = humidityOf(settings, around);
    const Humidity humidity = humidityFor(known);
    const GasSettings &asked = settings.drivenGas;
    std::vector<GasWay> ways;
    if (asked.substance != kAutoGas)
        ways.push_back({GasSource::Recipe, asked, humidity});
    if (const auto constants = recordedConstants(set, kDrivenKeys, asked))
        ways.push_back({GasSource::RecordedConstants, *constants, humidity});
    const std::string substance = recordedSubstance(wordOf(set, "driven_gas"));
    const bool isNamed = !substance.empty();
    // A humidity alone says what the air is that no word names; "air" without one says nothing
    // that contradicts dry air.
    if (isNamed && (!isAir(substance) || known || ways.empty()))
        ways.push_back({GasSource::RecordedName, named(substance, asked), humidity});
    else if (!isNamed && known && (ways.empty() || isAir(asked.substance)))
        ways.push_back({GasSource::RecordedName, named("air", asked), humidity});
    if (ways.empty())
        ways.push_back({GasSource::Assumed, named("air", asked), humidity});
    if (settings.relativeHumidity && std::isfinite(around.relativeHumidity)) // typed over recorded
        ways.push_back(
            {GasSource::RecordedName, ways.front().settings, humidityFor(around.relativeHumidity)});
    return ways;
}

GasSettings chosenDriverGas(const ShockSettings &settings, const CaptureSet &set)
{
    const GasSettings &asked = settings.driverGas;
    if (asked.substance != kAutoGas)
        return asked;
    if (const auto constants = recordedConstants(set, kDriverKeys, asked))
        return *constants;
    const std::string substance = recordedSubstance(wordOf(set, "driver_gas"));
    GasSettings chosen = named(substance.empty() ? "air" : substance, asked);
    if (isAir(chosen.substance))
        chosen = GasSettings{};
    return chosen;
}

namespace {

/// Both are air, of two humidities or one of them dry.
bool isAboutHumidity(const GasWay &used, const GasWay &other)
{
    return used.settings == other.settings
        || (isAir(used.settings.substance) && isAir(other.settings.substance)
            && used.source == GasSource::Recipe);
}

} // namespace

std::optional<GasContradiction> gasContradiction(
    const std::vector<GasWay> &ways, const SectionState &state)
{
    constexpr double kLargest = 5e-4; // of the speed of sound
    const auto modelOf = [&](const GasWay &way) {
        SectionState its = state;
        its.relativeHumidity = way.humidity.value;
        return gasModel(way.settings, its);
    };
    const auto speedOf = [&](const GasModel &gas) {
        return std::sqrt(gas.constants.gamma * kGasConstant_J_molK * state.temperature_K
            / gas.constants.molarMass_kg_mol);
    };
    const auto used = modelOf(ways.front());
    for (std::size_t i = 1; used && i < ways.size(); ++i) {
        const auto other = modelOf(ways[i]);
        if (!other)
            continue;
        const double a = speedOf(*used);
        const double b = speedOf(*other);
        if (std::abs(b / a - 1.0) > kLargest)
            return GasContradiction{.used = ways.front(),
                .other = ways[i],
                .usedSpeed_m_s = a,
                .otherSpeed_m_s = b,
                .otherModel = *other,
                .isHumidity = isAboutHumidity(ways.front(), ways[i]),
                .isTypedHumidity = ways.front().settings == ways[i].settings};
    }
    return std::nullopt;
}

} // namespace dyncal
